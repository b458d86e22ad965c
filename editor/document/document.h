#pragma once
// The document of the window: one experiment (or robot, or arena) and every file that it imports, as texts. Its parts do the work;
// texts change only in edits().

#include <cstdint>
#include <memory>
#include <string>

#include <QObject>
#include <QString>

#include "app/application.h"
#include "editor/document/document_edits.h"
#include "editor/document/document_loading.h"
#include "editor/document/document_recovery.h"
#include "editor/document/document_saving.h"
#include "editor/document/document_texts.h"
#include "editor/document/edited_model.h"
#include "editor/document/external_changes.h"
#include "editor/document/project_access.h"
#include "editor/document/project_opening.h"
#include "project/edits/change_set.h"
#include "project/edits/value_edits.h"

namespace trundle {

struct DocumentState;
class StructureEdits;

class Document final : public QObject {
    Q_OBJECT
public:
    explicit Document(Application& application, QObject* parent = nullptr);
    ~Document() override;

    [[nodiscard]] bool isOpen() const { return loaded() != nullptr; }
    /// The project as loaded from the current texts; never null while open. Immutable: callers may keep it.
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& loaded() const;
    /// The newest version of the experiment without errors; null if there was none.
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& lastValid() const;
    [[nodiscard]] std::uint64_t revision() const; ///< increases with every change of any text
    [[nodiscard]] std::string path() const; ///< absolute path of the opened file; a name while it is new; "" if nothing is open
    [[nodiscard]] bool isNew() const;       ///< not saved to a file yet

    /// Sets the trusted modules and the search folders for imports, also for later projects. Reloads the open project.
    void setOptions(const OpenOptions& options);
    [[nodiscard]] const OpenOptions& options() const;

    [[nodiscard]] ProjectOpening& opening() { return *m_opening; }
    [[nodiscard]] DocumentLoading& loading() { return *m_loading; }
    [[nodiscard]] const DocumentTexts& texts() const { return *m_texts; }
    [[nodiscard]] DocumentEdits& edits() { return *m_edits; }
    [[nodiscard]] const DocumentEdits& edits() const { return *m_edits; }
    /// Edits that insert, remove, move or rename blocks; also decides in which block a value is written.
    [[nodiscard]] StructureEdits& structure();
    [[nodiscard]] ProjectAccess& access() { return *m_access; }
    [[nodiscard]] ExternalChanges& disk() { return *m_disk; }
    [[nodiscard]] DocumentSaving& saving() { return *m_saving; }
    [[nodiscard]] DocumentRecovery& recovery() { return *m_recovery; }
    [[nodiscard]] EditedModel& editedModel() { return *m_model; }
    [[nodiscard]] const EditedModel& editedModel() const { return *m_model; }

Q_SIGNALS:
    void opened(); ///< another project, or none; changed() follows
    /// loaded() returns another object. If a slot edits, all slots get the later changes first and these after them: then
    /// changes.after() is not loaded() any more.
    void changed(const ChangeSet& changes);
    void selectionRequested(const std::vector<std::string>& paths); ///< an edit created or renamed these
    void refused(const QString& reason);                            ///< an edit was refused
    void notice(const QString& text);                               ///< information for the user; no decision is needed

private:
    std::unique_ptr<DocumentState> m_state;
    std::unique_ptr<DocumentTexts> m_texts;
    std::unique_ptr<DocumentLoading> m_loading;
    std::unique_ptr<ProjectAccess> m_access;
    std::unique_ptr<DocumentEdits> m_edits;
    std::unique_ptr<ProjectOpening> m_opening;
    std::unique_ptr<ExternalChanges> m_disk;
    std::unique_ptr<DocumentRecovery> m_recovery;
    std::unique_ptr<DocumentSaving> m_saving;
    std::unique_ptr<EditedModel> m_model;
    std::shared_ptr<StructureEdits> m_structure; ///< shared_ptr: its type is not known here
};

} // namespace trundle
