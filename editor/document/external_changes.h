#pragma once
#include <memory>
#include <string>

#include <QObject>

#include "base/result.h"
#include "editor/document/history.h"

namespace trundle {

class DocumentEdits;
class DocumentLoading;
class DocumentTexts;
class ProjectAccess;
struct DocumentState;

/// Changes of the project's files by other programs.
class ExternalChanges final : public QObject {
    Q_OBJECT
public:
    ExternalChanges(DocumentState& state, DocumentTexts& texts, DocumentLoading& loading, ProjectAccess& access,
                    DocumentEdits& edits);

    /// Checks whether another program changed one of the files. Also called when the file watcher reports a change.
    void check();
    enum class Resolution { Mine, Theirs };
    /// Content on disk of the files that were edited both here and by another program and cannot be merged.
    [[nodiscard]] FileTexts conflicts() const;
    /// Mine: the text stays, and the next save writes it. Theirs: the content on disk replaces it, as one history entry.
    Status resolve(const std::string& file, Resolution resolution);
    /// Handles a changed file: loads it if it was not edited here, merges if possible, else emits conflictFound().
    void apply(const std::string& path, std::shared_ptr<const std::string> bytes);

Q_SIGNALS:
    void conflictFound(const QString& file); ///< conflicts() has one more; it is not saved until resolve()

private:
    [[nodiscard]] bool isNamedStale() const;

    DocumentState& m_state;
    DocumentTexts& m_texts;
    DocumentLoading& m_loading;
    ProjectAccess& m_access;
    DocumentEdits& m_edits;
};

} // namespace trundle
