#pragma once
// The one folder a run writes into, and the files it opened there.

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "base/platform/buffered_file.h"
#include "base/platform/folder_handle.h"
#include "base/result.h"
#include "run/log_location.h"

namespace trundle {

/// A file being written, through a buffer. The first failure (a full disk) is kept and ends all writing.
class LogFile {
public:
    LogFile(std::string name, std::string path, std::FILE* file);
    ~LogFile();
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

    void write(std::string_view bytes);
    void flush();
    /// Flushes and closes. Gives the first failure of its whole life.
    Status close();

    [[nodiscard]] const std::string& name() const { return m_name; } ///< inside the folder
    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

private:
    void note(int errorNumber);

    std::string m_name, m_path;
    BufferedFile m_file;
    std::optional<Error> m_failure;
};

/// The list of a run's log files, in the log folder.
inline constexpr std::string_view kLogList = ".trundle-logs";

/// `name` with forward slashes and no idle parts. Fails for what could leave the folder: an absolute path, `..`, control bytes;
/// and for kLogList.
[[nodiscard]] Result<std::string> cleanLogName(std::string_view name);

class LogFolder {
public:
    /// Made on disk only when the first file is opened. An empty location refuses every file.
    explicit LogFolder(LogLocation location) : m_location(std::move(location)) {}

    /// Opens a new file in place of one that an earlier run left there. Refused: a name already open in this run, a name that
    /// leaves the folder, a way through a symbolic link (also one that is made meanwhile), anything in its place that is no regular
    /// file.
    [[nodiscard]] Result<LogFile*> create(std::string_view name);

    /// Removes a file that create() gave and that is closed.
    void remove(const LogFile& file);

    /// Removes what an earlier run wrote and this one did not, going by the list that run left, and leaves a list of its own. Only
    /// regular files right inside the folder are removed, whatever the list says. Files are to be closed before.
    void settle();

    [[nodiscard]] const std::vector<std::unique_ptr<LogFile>>& files() const { return m_files; }

private:
    /// The folder that a clean name's file is in, opened part by part; made where it is missing if `make`.
    [[nodiscard]] Result<FolderHandle> folderOf(const std::string& name, bool make) const;

    LogLocation m_location;
    std::vector<std::unique_ptr<LogFile>> m_files;
    std::unordered_set<std::string> m_names; ///< of them; pictures may be many
};

} // namespace trundle
