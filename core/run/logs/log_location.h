#pragma once
#include <string>
#include <utility>

namespace trundle {

/// The folder for a run's logs.
struct LogLocation {
    LogLocation() = default;
    /// `folder`: chosen or owned by the user; may be reached through links. `below`: subfolders, "logs/linear_motion", that may
    /// belong to a project from someone else, so links in it are refused.
    LogLocation(std::string folder, std::string below = {}) : folder(std::move(folder)), below(std::move(below)) {}

    [[nodiscard]] bool empty() const { return folder.empty(); }
    [[nodiscard]] std::string path() const { return below.empty() ? folder : folder + "/" + below; }

    std::string folder, below;
    std::string experiment; ///< the whole path of its file: logs of others are not deleted. Empty: not known, and they are
};

/// The log folder of an experiment: `chosen`, else `logs/<name of its file>` inside the given folder; links in that are refused.
[[nodiscard]] LogLocation logsOf(const std::string& projectFolder, const std::string& experimentFile,
                                 const std::string& chosen = {});
/// The name of the experiment's file without the ending; "experiment" if that is not a valid folder name.
[[nodiscard]] std::string experimentName(const std::string& experimentFile);

} // namespace trundle
