#include "project/saving/file_transaction.h"

#include <filesystem>

#include "base/platform/atomic_file.h"
#include "base/platform/read_file.h"

namespace trundle {

namespace fs = std::filesystem;

Status FileTransaction::copy(const std::string& from, const std::string& to) {
    std::error_code failed;
    fs::create_directories(fs::path(to).parent_path(), failed);
    if (!fs::copy_file(from, to, failed)) {
        std::error_code none;
        if (failed != std::errc::file_exists) fs::remove(to, none); // remove an incomplete copy
        return Error{Code::FileUnwritable, from + " cannot be copied to " + to + ": " + failed.message()};
    }
    m_before.emplace_back(to, std::nullopt);
    return {};
}

Status FileTransaction::write(const std::string& path, const std::string& bytes, MissingFolder folder) {
    std::error_code none; // ignored: a missing folder makes the write fail, with the reason
    if (folder == MissingFolder::Create) fs::create_directories(fs::path(path).parent_path(), none);
    Result<std::string> old = readRegularFile(path);
    if (!old && fs::exists(path, none)) return old.error();
    if (Status written = writeFileAtomically(path, bytes); !written) return written;
    m_before.emplace_back(path, old ? std::optional(std::move(old).value()) : std::nullopt);
    return {};
}

Status FileTransaction::remove(const std::string& path) {
    std::error_code failed;
    Result<std::string> old = readRegularFile(path);
    if (old && !fs::remove(path, failed)) return Error{Code::FileUnwritable, path + " cannot be removed: " + failed.message()};
    if (old) m_before.emplace_back(path, std::move(old).value());
    return {};
}

Error FileTransaction::rollBack(Error why) {
    for (auto it = m_before.rbegin(); it != m_before.rend(); ++it) {
        const auto& [path, bytes] = *it;
        std::error_code failed;
        if (!bytes) fs::remove(path, failed);
        if (failed) why.message += "; " + path + " was created before it and cannot be removed: " + failed.message();
        const Status back = bytes ? writeFileAtomically(path, *bytes) : Status();
        if (!back) why.message += "; files already written cannot be restored: " + back.error().message;
    }
    m_before.clear();
    return why;
}

} // namespace trundle
