#pragma once
#include <memory>
#include <vector>

#include <QWidget>

#include "base/diagnostic.h"
#include "project/project.h"

class QLabel;
class QLineEdit;
class QToolButton;
class QTreeView;

namespace trundle {

class Document;
class ModelChecker;
class ProblemsModel;
class Selection;

/// Everything that is wrong with the texts and with the run; a click goes there, a fix is an edit like any other.
class ProblemsPanel final : public QWidget {
    Q_OBJECT
public:
    ProblemsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    [[nodiscard]] int errors() const;
    [[nodiscard]] int warnings() const;
    /// Shows the next or the one before, as F8 does.
    void goTo(int step);

public Q_SLOTS:
    /// Why a run ended, or what it complained of. `texts`: those it was built from; where null, those of now.
    void addRunProblem(const trundle::Diagnostic& problem);
    void setRunProblems(const std::vector<trundle::Diagnostic>& problems, const std::shared_ptr<const trundle::Loaded>& texts);
    void clearRunProblems();
    void fixCurrent();

Q_SIGNALS:
    void jumpTo(const std::string& file, const trundle::SourceRange& range);
    void countsChanged(int errors, int warnings);
    /// What the model check found in these texts, soon after the last edit.
    void modelChecked(const std::shared_ptr<const trundle::Loaded>& texts, const std::vector<trundle::Diagnostic>& found);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeBar();
    void follow();
    void applyFilter();
    void showCounts();
    void showFix();
    void go(const QModelIndex& index);
    void applyFix(const QModelIndex& index);
    void openMenu(const QPoint& place);

    Document& m_document;
    Selection& m_selection;
    ProblemsModel* m_model;
    ModelChecker* m_checker;
    QTreeView* m_view;
    QLabel* m_none;
    QToolButton *m_errors, *m_warnings, *m_order, *m_fix;
    QLineEdit* m_words;
    std::vector<Diagnostic> m_run;
    std::shared_ptr<const Loaded> m_runTexts;
};

} // namespace trundle
