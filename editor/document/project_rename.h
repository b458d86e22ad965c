#pragma once
// Renames an object in all texts of a project: those that the document has loaded, and other texts that import the object.

#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "project/loading/project.h"
#include "project/objects/config_users.h"

namespace trundle {

class Document;

class ProjectRename {
public:
    /// `path` of the block or Param, as for planRename(). Reads at most kMaxTexts other texts of the project that import the
    /// renamed object; valid until the document changes.
    ProjectRename(Document& document, std::string path, const std::string& oldName);

    static constexpr std::size_t kMaxTexts = 200;

    struct Use {
        std::string file; ///< absolute
        std::size_t count = 0;
    };
    /// Texts that refer to the object and that the document has not loaded, in alphabetical order. Empty for an object of a shipped
    /// file: apply() refuses to rename it.
    [[nodiscard]] const std::vector<Use>& usesOutside() const { return m_uses; }
    [[nodiscard]] bool isComplete() const { return m_complete; } ///< false: the project has more texts than were read

    /// Renames as one entry of the history: in the document's texts, and with `everywhere` also in the others. Fails and
    /// changes nothing if the name is already used in one of them; the failure is also reported by Document::refused().
    [[nodiscard]] Status apply(const QString& title, const std::string& name, bool everywhere);

private:
    using FilePlans = std::map<std::string, std::vector<TextEdit>>; ///< by absolute path
    [[nodiscard]] Result<FilePlans> planOutside(const LoadedProject& other, const std::string& name) const;

    Document& m_document;
    std::string m_path;
    std::vector<std::shared_ptr<const LoadedProject>> m_others;
    std::vector<Use> m_uses;
    bool m_complete = true;
};

} // namespace trundle
