#pragma once
// Item model of the diagnostics of document and run: top-level rows are diagnostics, their children notes and fixes.

#include <memory>
#include <vector>

#include <QAbstractItemModel>

#include "project/loading/project.h"

namespace trundle {

struct ProblemsInCode;

enum class ProblemOrder { Place, Severity };

class ProblemsModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    using QAbstractItemModel::QAbstractItemModel;
    enum Column { Message, CodeColumn, Place, ColumnCount };

    /// Sets the project with the current diagnostics. Null: none. `isSame`: they differ from those before at most in their places.
    void setLoaded(std::shared_ptr<const LoadedProject> loaded, bool isSame = false);
    /// Sets the diagnostics of a run and the project it was built from.
    void setRun(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> texts);
    /// Sets the diagnostics of the model check and the project that it checked. They are shown until the next call or until the
    /// texts change.
    void setModelProblems(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> texts);
    /// Sets the messages of a build of modules and the sources that they are about.
    void setBuild(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> sources);
    void setFilter(bool errors, bool warnings, const QString& words);
    void setOrder(ProblemOrder order);

    [[nodiscard]] int errors() const { return m_errors; } ///< not affected by the filter
    [[nodiscard]] int warnings() const { return m_warnings; }

    /// The diagnostic of a row or its parent; null if there is none.
    [[nodiscard]] const Diagnostic* diagnosticAt(const QModelIndex& index) const;
    /// The source range of a row, in textsAt().
    [[nodiscard]] SourceRange placeAt(const QModelIndex& index) const;
    [[nodiscard]] std::shared_ptr<const LoadedProject> textsAt(const QModelIndex& index) const;
    /// The fix of a child row, or the first fix of a diagnostic; null if there is none or it is for outdated texts. Without edits it
    /// means trust in the folder of a module.
    [[nodiscard]] const Fix* fixAt(const QModelIndex& index) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    void countsChanged(int errors, int warnings);

private:
    enum class Source { Texts, Code, Model, Run, Build };
    struct Entry {
        const Diagnostic* diagnostic = nullptr;
        Source source = Source::Texts;
        std::vector<const Fix*> fixes; ///< those that can be applied
    };
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& textsOf(const Entry& entry) const;
    void rebuild();
    void rebuildAfter(const std::vector<Entry>& before, bool isSame = false);
    [[nodiscard]] bool looksAs(const std::vector<Entry>& before) const;
    [[nodiscard]] bool wanted(const Diagnostic& diagnostic) const;
    [[nodiscard]] const Entry* entryAt(const QModelIndex& index) const;
    [[nodiscard]] std::size_t childCount(const Entry& entry) const;
    [[nodiscard]] QVariant childData(const Diagnostic& d, const Entry& entry, int row, int column, int role) const;
    [[nodiscard]] QString placeText(const SourceRange& place, const Entry& entry) const;

    std::shared_ptr<const LoadedProject> m_loaded, m_runTexts, m_modelTexts, m_buildTexts;
    std::vector<Diagnostic> m_run, m_modelProblems, m_build;
    std::shared_ptr<const ProblemsInCode> m_inCode; ///< those of m_loaded with a place in the source of a module, there
    std::vector<Entry> m_entries; ///< shown, in order
    const Fix m_trust{tr("Trust…").toStdString(), {}}; ///< of a module in a folder that is not trusted: no edit of a text
    int m_errors = 0, m_warnings = 0;
    bool m_showErrors = true, m_showWarnings = true;
    QString m_words;
    ProblemOrder m_order = ProblemOrder::Place;
};

/// "robots/simple_robot.sim:22:7", relative to the project; empty if the range is in no text.
[[nodiscard]] QString problemPlace(const LoadedProject& loaded, const SourceRange& place);

} // namespace trundle
