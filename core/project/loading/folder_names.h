#pragma once
// Needs: a text may name tens of thousands of files that are missing, each searched in many folders under several names.
// Method: a folder in which many were missing is listed once; then only names that are in the list are looked up.

#include <map>
#include <optional>
#include <string>
#include <unordered_set>

namespace trundle {

/// What is known of folders during one load.
class FolderNames {
public:
    /// False only if the file is certainly missing.
    [[nodiscard]] bool mayExist(const std::string& path) const;
    void addMissing(const std::string& path);

private:
    struct Folder {
        int missing = 0;
        std::optional<std::unordered_set<std::string>> names; ///< in lower case, since file systems may ignore it
    };
    std::map<std::string, Folder> m_folders;
};

} // namespace trundle
