#pragma once
#include <memory>
#include <string>
#include <vector>

#include <QWidget>

#include "base/diagnostic.h"
#include "editor/problems/robots_check.h"
#include "project/edits/change_set.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;
class QTreeView;

namespace trundle {

class Document;
class ModelChecker;
class ProblemsModel;
class Selection;

/// Lists all diagnostics of texts and run. A click shows the location in the text; a fix is an ordinary edit.
class ProblemsPanel final : public QWidget {
    Q_OBJECT
public:
    ProblemsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    [[nodiscard]] int errors() const;
    [[nodiscard]] int warnings() const;
    /// Selects the next or previous diagnostic, for F8.
    void goTo(int step);
    /// Also shows what a run would refuse when it sets up robots; `program` is the path of trundle-cli.
    void checkRobotsWith(std::string program, double seconds = 10);

public Q_SLOTS:
    /// Replaces the diagnostics of the run: why it ended, and warnings. `texts`: the project it was built from.
    void setRunProblems(const std::vector<trundle::Diagnostic>& problems,
                        const std::shared_ptr<const trundle::LoadedProject>& texts);
    void clearRunProblems();
    /// Replaces the messages of a build of modules. `sources`: the texts that they are about.
    void setBuildProblems(const std::vector<trundle::Diagnostic>& problems,
                          const std::shared_ptr<const trundle::LoadedProject>& sources);
    void fixCurrent();

Q_SIGNALS:
    void jumpTo(const std::string& file, const trundle::SourceRange& range);
    void countsChanged(int errors, int warnings);
    void trustRequested(const trundle::SourceRange& module); ///< its path in a #loadModule
    /// The diagnostics of the model check for these texts, emitted shortly after the last edit.
    void modelChecked(const std::shared_ptr<const trundle::LoadedProject>& texts, const std::vector<trundle::Diagnostic>& found);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] RobotsCheck robotsCheck() const;
    void makeBar();
    void follow(const ChangeSet& changes);
    void applyFilter();
    void showCounts();
    void fitColumns();
    void showFix();
    void go(const QModelIndex& index);
    void activate(const QModelIndex& index); ///< by a click or Enter: applies the fix of its row, or goes to the place
    void applyFix(const QModelIndex& index);
    void openMenu(const QPoint& place);

    Document& m_document;
    Selection& m_selection;
    ProblemsModel* m_model;
    ModelChecker* m_checker;
    QTreeView* m_view;
    QLabel* m_none;
    QToolButton *m_errors, *m_warnings, *m_fix;
    QCheckBox* m_order;
    QLineEdit* m_words;
    std::vector<Diagnostic> m_run;
    RobotsCheck m_robots;
    std::shared_ptr<const LoadedProject> m_runTexts, m_shown;
    bool m_fitting = false, m_ownColumns = false; // the user has set the widths
};

} // namespace trundle
