#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "base/result.h"
#include "base/text_edit.h"
#include "editor/document/document_loading.h"
#include "editor/document/history.h"
#include "project/edits/plans.h"

namespace trundle {

class DocumentTexts;
class ProjectAccess;
class Selection;
struct DocumentState;

/// The only place that changes a text. Each edit adds one entry to the history, or extends the last one if that has the same
/// merge key.
class DocumentEdits final : public QObject {
    Q_OBJECT
public:
    DocumentEdits(DocumentState& state, DocumentTexts& texts, DocumentLoading& loading, ProjectAccess& access);

    using Validator = DocumentLoading::Validator;
    /// Changes texts. Fails, emits refused() and changes nothing if the edits do not apply, change an imported sample file, or are
    /// rejected.
    Status edit(const QString& name, const FileEdits& edits, const std::string& mergeKey = {}, const Validator& validate = {});
    /// Replaces the whole text of a file, or of several files as one entry, including files added by addText().
    Status replaceText(const QString& name, const std::string& file, std::string bytes, const std::string& mergeKey = {});
    Status replaceTexts(const QString& name, const FileTexts& texts, const std::vector<std::string>& selects = {});
    /// Applies a plan and selects the blocks that it created.
    Status apply(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey = {});
    [[nodiscard]] Status addText(const std::string& file); ///< adds a file of the project's folder that nothing imports
    void endMerge(); ///< ends a drag: the next edit gets its own entry whatever its merge key
    /// Discards the edits made under this key since the last entry with another key, and restores what could be redone before
    /// them. Does nothing after endMerge().
    void discardMerge(const std::string& mergeKey);

    [[nodiscard]] const History& history() const;
    void undo();
    void redo();
    void moveTo(std::size_t position); ///< position in the history
    /// Undo and redo restore the selection where objects of it disappear, or were only there then. It must outlive this object.
    void restoreSelection(const Selection& selection) { m_selection = &selection; }
    [[nodiscard]] std::vector<std::string> selectedPaths() const; ///< of that selection

    /// Replaces whole texts as one entry, without asking whether they may be edited: for what was found on disk or in a journal.
    [[nodiscard]] Status enter(const QString& name, FileTexts after, const std::string& mergeKey = {},
                               const Validator& validate = {});
    void notifyEdited();

Q_SIGNALS:
    void historyChanged();

private:
    [[nodiscard]] Result<FileTexts> textsAfter(const FileEdits& edits) const;
    [[nodiscard]] Status mayChange(const FileEdits& edits) const; ///< fails if one edit changes an imported sample file

    void keepSelection();
    void selectAgain(const LoadedProject& was);

    DocumentState& m_state;
    DocumentTexts& m_texts;
    DocumentLoading& m_loading;
    ProjectAccess& m_access;
    const Selection* m_selection = nullptr;
    std::map<std::size_t, std::vector<std::string>> m_selected; // when each position of the history was left
};

} // namespace trundle
