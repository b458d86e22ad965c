#pragma once
#include <memory>
#include <string>

#include <QObject>

#include "base/result.h"
#include "project/loading/project.h"

namespace trundle {

class DocumentEdits;
class DocumentLoading;
class DocumentTexts;
class ProjectAccess;
struct DocumentState;

/// Opens and closes projects.
class ProjectOpening final : public QObject {
    Q_OBJECT
public:
    ProjectOpening(DocumentState& state, DocumentTexts& texts, DocumentLoading& loading, ProjectAccess& access,
                   DocumentEdits& edits);

    /// Replaces the open project and clears its history; the caller has asked about unsaved edits. Fails and changes nothing
    /// if the file cannot be read. A text with errors opens.
    [[nodiscard]] Status open(const std::string& path);
    /// Like open(), but reads in a worker thread; opened() or failed() follows. Edits are refused until then. A later
    /// open, new or close replaces this request.
    void openLater(const std::string& path);
    [[nodiscard]] bool isOpening() const;
    void cancel(); ///< the current project stays open
    /// Opens a new, unsaved text, shown as `name`. It counts as modified once it differs from `text`.
    [[nodiscard]] Status openNew(const std::string& name, const std::string& text);
    /// Opens a file that is missing on disk, with this text; the next save writes it.
    [[nodiscard]] Status openMissing(const std::string& path, const std::string& text);
    void close();

Q_SIGNALS:
    void aboutToOpen(); ///< the file is read; opened() follows in a separate event, so that neither handler delays the other
    void cancelled();
    void failed(const QString& path, const QString& reason);
    void opened(); ///< another project, or none; the document's changed() follows

private:
    void start(const std::string& path, const std::string& name, std::shared_ptr<const LoadedProject> loaded);

    DocumentState& m_state;
    DocumentTexts& m_texts;
    DocumentLoading& m_loading;
    ProjectAccess& m_access;
    DocumentEdits& m_edits;
};

} // namespace trundle
