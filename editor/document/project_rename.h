#pragma once
// A rename in all texts of a project: those that the document has, and those that import them and that no part of the experiment loads.

#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "project/config_users.h"
#include "project/project.h"

namespace trundle {

class Document;

class ProjectRename {
public:
    /// `path` of the block or Param, as planRename() takes it. Reads other texts of the project that import what is renamed, at most
    /// kMostTexts; valid until the document changes.
    ProjectRename(Document& document, std::string path, const std::string& oldName);

    static constexpr std::size_t kMostTexts = 200;

    struct Use {
        std::string file; ///< absolute
        std::size_t count = 0;
    };
    /// Texts that name it and that the document has not loaded, in alphabetical order; none where it is of an imported file that came
    /// with the program: apply() refuses to rename that.
    [[nodiscard]] const std::vector<Use>& usesOutside() const { return m_uses; }
    [[nodiscard]] bool isComplete() const { return m_complete; } ///< false: there are more texts than were read

    /// Gives it another name as one entry of the history: in the document's texts, and in the others where `everywhere`. Fails, and
    /// changes nothing, where the name cannot be had in one of them.
    [[nodiscard]] Status apply(const QString& title, const std::string& name, bool everywhere);

private:
    using FilePlans = std::map<std::string, std::vector<TextEdit>>; ///< by absolute path
    [[nodiscard]] Result<FilePlans> planOutside(const Loaded& other, const std::string& name) const;

    Document& m_document;
    std::string m_path;
    std::vector<std::shared_ptr<const Loaded>> m_others;
    std::vector<Use> m_uses;
    bool m_complete = true;
};

} // namespace trundle
