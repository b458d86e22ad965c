#pragma once
#include <string>
#include <vector>

#include <QObject>

#include "base/result.h"
#include "project/saving/companions.h"

namespace trundle {

class DocumentEdits;
class DocumentLoading;
class DocumentRecovery;
class DocumentTexts;
class ExternalChanges;
class ProjectAccess;
struct DocumentState;
struct SaveEnvironment;
struct SavePlan;

/// Save and Save As of the open project.
class DocumentSaving final : public QObject {
    Q_OBJECT
public:
    struct Parts {
        DocumentState& state;
        DocumentTexts& texts;
        DocumentLoading& loading;
        ProjectAccess& access;
        DocumentEdits& edits;
        ExternalChanges& disk;
        DocumentRecovery& recovery;
    };
    explicit DocumentSaving(const Parts& parts) : m_parts(parts), m_state(parts.state) {}

    /// Writes every modified file atomically, or none if one of them cannot be written. The error gives the file and the
    /// reason: a sample, a read-only file, or a file whose content on disk was not loaded here.
    [[nodiscard]] Status save();
    [[nodiscard]] Status save(const std::vector<std::string>& modified); ///< the same for some of the modified files
    /// Writes the opened file to another path and continues with it there; the history is kept. Imported files that would not
    /// be found from the new location, and edited samples, are written next to it, where its imports find them; meshes,
    /// images and modules are copied likewise. notice() lists them. Fails, having written nothing, if one of those files
    /// would overwrite another. For the current path it equals save(), except that edited samples are copied.
    [[nodiscard]] Status saveAs(const std::string& path, ModuleCopies modules = ModuleCopies::Make);
    [[nodiscard]] Result<Companions> companionsAt(const std::string& path) const; ///< what saveAs() would copy

private:
    [[nodiscard]] Status checkSaveTarget(const std::string& target) const;
    [[nodiscard]] Result<SavePlan> planFor(const std::string& target, ModuleCopies modules) const;
    [[nodiscard]] SaveEnvironment saveEnvironment();
    [[nodiscard]] Status followMoves(const SavePlan& plan); ///< continues with the files at their new paths
    void notifyMoved(const SavePlan& save);

    Parts m_parts;
    DocumentState& m_state;
};

} // namespace trundle
