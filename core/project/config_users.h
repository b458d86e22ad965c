#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/platform/read_file.h"
#include "project/project.h"

namespace trundle {

/// Finds the texts of a project that place a config. A text on the disk is read again only after it has changed.
class ConfigUsers {
public:
    /// Absolute paths, sorted, of the texts that place `config` ("Robot r { Config=Rover }") and import its file: those of the load as
    /// they are there, and those in the project's folder. At most 5,000 entries of the folder are looked at.
    [[nodiscard]] std::vector<std::string> of(const Loaded& loaded, const Part& config);

    /// Absolute paths, sorted, of the texts in the project's folder that import one of `files` (absolute), directly or not, and that the
    /// load does not have.
    [[nodiscard]] std::vector<std::string> dependentsOutside(const Loaded& loaded, const std::set<std::string>& files);
    /// Absolute paths of the texts below a folder, hidden ones and folders not; at most 5,000 entries are looked at.
    [[nodiscard]] static std::vector<std::string> textsIn(const std::string& folder);

private:
    /// What one text says.
    struct Text {
        std::vector<std::string> imports;
        std::set<std::string> configs; ///< that it places
    };
    struct OnDisk {
        FileStamp stamp;
        Text text;
    };
    [[nodiscard]] static Text textOf(const Tree& tree);
    [[nodiscard]] const Text* read(const Loaded& loaded, const std::string& path);
    [[nodiscard]] bool reaches(const Loaded& loaded, const std::string& from, const std::string& file,
                               std::set<std::string>& seen);

    std::map<std::string, OnDisk> m_onDisk;
    std::map<std::string, Text> m_ofLoad; ///< of the load that is asked about
};

} // namespace trundle
