#pragma once
#include <string>
#include <utility>

namespace trundle {

/// The folder that a run's logs go to.
struct LogLocation {
    LogLocation() = default;
    /// `folder`: chosen by the user, or known to be the user's own; may be reached through links. `below`: folders in it,
    /// "logs/linear_motion", where a link is refused: they may have come with a project of somebody else.
    LogLocation(std::string folder, std::string below = {}) : folder(std::move(folder)), below(std::move(below)) {}

    [[nodiscard]] bool empty() const { return folder.empty(); }
    [[nodiscard]] std::string path() const { return below.empty() ? folder : folder + "/" + below; }

    std::string folder, below;
};

/// Where the logs of an experiment go unless the user says otherwise: `logs/<name of its file>` really inside the given folder.
[[nodiscard]] LogLocation defaultLogs(const std::string& projectFolder, const std::string& experimentFile);
/// The name of its file without the ending; "experiment" where that could not name a folder.
[[nodiscard]] std::string experimentName(const std::string& experimentFile);

} // namespace trundle
