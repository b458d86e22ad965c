#pragma once
// The folder that a run writes into, and the files that it opened there.

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
#include "run/logs/log_location.h"

namespace trundle {

/// A buffered log file. After the first failure, such as a full disk, nothing more is written.
class LogFile {
public:
    LogFile(std::string name, std::string path, std::FILE* file);
    ~LogFile();
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

    void write(std::string_view bytes);
    void flush();
    /// Flushes and closes the file. Returns the first failure since it was opened.
    Status close();

    [[nodiscard]] const std::string& name() const { return m_name; } ///< relative to the log folder
    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

private:
    void note(int errorNumber);

    std::string m_name, m_path;
    BufferedFile m_file;
    std::optional<Error> m_failure;
};

/// File in the log folder that lists the log files of the last run.
inline constexpr std::string_view kLogList = ".trundle-logs";

/// `name` with forward slashes and without redundant parts. Fails for names that could leave the folder (absolute paths, `..`,
/// control characters) and for kLogList.
[[nodiscard]] Result<std::string> cleanLogName(std::string_view name);

class LogFolder {
public:
    /// The folder is created when the first file is opened. An empty location refuses every file.
    explicit LogFolder(LogLocation location) : m_location(std::move(location)) {}

    /// Opens a new file; replaces one from an earlier run. Fails for a name already open in this run, a name outside the folder,
    /// a folder that another run writes to, a path through a symbolic link (even one created in the meantime), and an existing path that is not a regular file.
    [[nodiscard]] Result<LogFile*> create(std::string_view name);

    /// Removes a closed file that create() returned.
    void remove(const LogFile& file);

    /// Another run may write there again. Call it when all files are closed.
    void release() { m_locked.reset(); }

    /// Removes the files that an earlier run of the same experiment listed and this one did not write, and writes a new list. Removes only regular files
    /// directly in the folder, whatever the list contains. All files must be closed.
    void settle();

    [[nodiscard]] const std::vector<std::unique_ptr<LogFile>>& files() const { return m_files; }

private:
    /// Keeps other runs out, of other programs too: the files of both may have the same names.
    [[nodiscard]] Status lock();
    /// The folder that contains a file with a clean name, opened component by component; created if missing and `make` is set.
    [[nodiscard]] Result<FolderHandle> folderOf(const std::string& name, bool make) const;

    LogLocation m_location;
    std::optional<FolderHandle> m_locked;
    std::vector<std::unique_ptr<LogFile>> m_files;
    std::unordered_set<std::string> m_names; ///< names of m_files, for fast lookup
};

} // namespace trundle
