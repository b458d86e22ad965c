#pragma once
#include <string>
#include <vector>

#include <QObject>

#include "base/result.h"
#include "project/journal/journal.h"

namespace trundle {

class DocumentEdits;
class DocumentTexts;
class ExternalChanges;
class ProjectOpening;
struct DocumentState;

/// Unsaved edits of a window that crashed.
class DocumentRecovery final : public QObject {
    Q_OBJECT
public:
    DocumentRecovery(DocumentState& state, DocumentTexts& texts, DocumentEdits& edits, ExternalChanges& disk,
                     ProjectOpening& opening);

    /// Journals of the open project, or of new texts if nothing is open, with edits that are not on disk; newest first.
    [[nodiscard]] std::vector<Recovery> recoveries() const;
    /// Whether recover() would close the project that is open now.
    [[nodiscard]] bool isReplacedBy(const Recovery& recovery) const;
    /// The text that recover() would restore for a file, given its current content on disk.
    [[nodiscard]] static std::string recoveredText(const std::string& path, const RecoveredText& kept);
    /// Opens the project of a journal and restores its texts as one history entry, except of files outside foldersOf().
    Status recover(const Recovery& recovery);
    [[nodiscard]] std::vector<std::string> foldersOf(const std::string& project) const; ///< whose files may be written

private:
    [[nodiscard]] Status openFor(const Recovery& recovery);

    DocumentState& m_state;
    DocumentTexts& m_texts;
    DocumentEdits& m_edits;
    ExternalChanges& m_disk;
    ProjectOpening& m_opening;
};

} // namespace trundle
