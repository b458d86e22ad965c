#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/platform/read_file.h"
#include "project/loading/project.h"

namespace trundle {

/// Finds the files of a project that place a config. A file on disk is read again only after it has changed.
class ConfigUsers {
public:
    /// Absolute paths, sorted, of the files that place `config` ("Robot r { Config=Rover }") and import its file: the loaded ones
    /// with their loaded text, and the others in the project's folder. Examines at most 5,000 entries of the folder.
    [[nodiscard]] std::vector<std::string> of(const LoadedProject& loaded, const Part& config);

    /// Absolute paths, sorted, of the files in the project's folder that import one of `files` (absolute), directly or
    /// indirectly, and that are not loaded.
    [[nodiscard]] std::vector<std::string> dependentsOutside(const LoadedProject& loaded, const std::set<std::string>& files);
    /// Absolute paths of the source files below a folder, without hidden files and folders; examines at most 5,000 entries.
    [[nodiscard]] static std::vector<std::string> textsIn(const std::string& folder);

private:
    /// Imports and configs of one file.
    struct Text {
        std::vector<std::string> imports;
        std::set<std::string> configs; ///< configs that it places
    };
    struct OnDisk {
        FileStamp stamp;
        Text text;
    };
    [[nodiscard]] static Text textOf(const Tree& tree);
    [[nodiscard]] const Text* read(const LoadedProject& loaded, const std::string& path);
    [[nodiscard]] bool reaches(const LoadedProject& loaded, const std::string& from, const std::string& file,
                               std::set<std::string>& seen);

    std::map<std::string, OnDisk> m_onDisk;
    std::map<std::string, Text> m_ofLoad; ///< files of the loaded project of the current query
};

} // namespace trundle
