#include "project/loading/search.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/clean_text.h"
#include "base/spelling.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxEntries = 2000; ///< entries of a folder examined for suggestions

bool liesUnder(const fs::path& file, const fs::path& folder) {
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    (void)rest;
    return end == folder.end() || (std::next(end) == folder.end() && end->empty());
}

bool isLoop(const std::error_code& ec) { return ec == std::errc::too_many_symbolic_link_levels; }

constexpr std::size_t kLongestName = 255; // bytes of one part of a path, as of ext4, XFS, APFS and NTFS

void normalise(std::string& written) { std::replace(written.begin(), written.end(), '\\', '/'); }

} // namespace

std::string projectFolderOf(const std::string& file) {
    std::error_code ec;
    const fs::path own = fs::path(canonicalPath(file)).parent_path();
    for (fs::path folder = own;; folder = folder.parent_path()) {
        if (folder.filename() == "configs" || fs::is_directory(folder / ".trundle", ec)) return folder.string();
        if (folder == folder.parent_path() || folder.empty()) break;
    }
    return own.string();
}

std::string canonicalPath(const std::string& path) {
    std::error_code ec;
    const fs::path absolute = fs::absolute(path.empty() ? "." : path, ec);
    const fs::path canonical = fs::weakly_canonical(ec ? fs::path(path) : absolute, ec);
    return ec ? path : canonical.string();
}

bool isInside(const std::string& file, const std::vector<std::string>& folders) {
    if (!fs::path(file).is_absolute() || file.find('\0') != std::string::npos) return false;
    const fs::path real = canonicalPath(file);
    fs::path part; // a remaining link is dangling: writing would create a file at its target
    for (const fs::path& name : real) {
        std::error_code none;
        part /= name;
        if (name == ".." || fs::is_symlink(fs::symlink_status(part, none))) return false;
    }
    return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
        return !folder.empty() && real != fs::path(canonicalPath(folder)) && liesUnder(real, canonicalPath(folder));
    });
}

std::string shownPath(const std::string& absolute, const std::string& from) {
    std::error_code ec;
    const fs::path here = from.empty() ? fs::current_path(ec) : fs::path(from);
    if (ec || here.empty() || !liesUnder(absolute, here)) return absolute;
    return fs::path(absolute).lexically_relative(here).string();
}

std::string shownInProject(const std::string& absolute, const std::string& folder) {
    if (folder.empty()) return absolute;
    if (const std::string shown = shownPath(absolute, folder); shown != absolute) return shown;
    const std::string own = projectFolderOf(absolute);
    const bool bare = fs::path(own) == fs::path(absolute).parent_path(); // the file name alone would be ambiguous
    return bare ? absolute : shownPath(absolute, own);
}

bool FileSearch::onlyAsText(const std::string& path, std::string& canonical) const {
    if (!m_texts || m_texts->empty()) return false;
    canonical = canonicalPath(path);
    return m_texts->contains(canonical);
}

const FileSearch::Roots& FileSearch::roots(const std::string& folder) const {
    const auto [at, isNew] = m_roots.try_emplace(folder);
    Roots& roots = at->second;
    if (!isNew) return roots;
    roots.folders.push_back(canonicalPath(folder));
    for (const std::string& f : m_folders) {
        if (f.empty()) continue;
        std::string path = canonicalPath(f);
        if (std::ranges::find(roots.folders, path) == roots.folders.end()) roots.folders.push_back(std::move(path));
    }
    for (const std::string& root : roots.folders) roots.shown += (roots.shown.empty() ? "" : ", ") + shownPath(root);
    std::ranges::replace(roots.shown, '\n', ' ');
    return roots;
}

bool canBeFile(std::string_view path) {
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find_first_of("/\\", begin), path.size());
        if (end - begin > kLongestName) return false;
        begin = end + 1;
    }
    return true;
}

Result<std::string> FileSearch::find(std::string written, const std::string& folder, std::span<const std::string> endings) const {
    normalise(written);
    if (written.empty() || written.find('\0') != std::string::npos) return Error{Code::ImportNotFound, "a file name is missing"};
    if (!canBeFile(written)) return Error{Code::ImportNotFound, written + " is not found: no file has so long a name"};
    const auto& [folders, shown] = roots(folder);
    std::vector<std::string> names{written};
    for (const std::string& ending : endings) names.push_back(written + "." + ending);
    bool outside = false, unplain = false, loop = false, denied = false;
    std::string directory;
    for (const std::string& root : folders) {
        for (const std::string& name : names) {
            std::error_code ec;
            const std::string path = name.starts_with('/') ? name : root + '/' + name;
            const fs::file_status status =
                m_names.mayExist(path) ? fs::status(path, ec) : fs::file_status(fs::file_type::not_found);
            if (!fs::exists(status)) m_names.addMissing(path);
            loop = loop || isLoop(ec);
            denied = denied || ec == std::errc::permission_denied;
            std::string real;
            if (fs::is_regular_file(status)) {
                real = fs::canonical(path, ec).string();
                if (ec) continue;
            } else if (!onlyAsText(path, real)) {
                if (fs::is_directory(status) && directory.empty()) directory = shownPath(path);
                unplain = unplain || (fs::exists(status) && !fs::is_directory(status));
                continue;
            }
            const bool allowed = std::ranges::any_of(folders, [&real](const std::string& f) { return liesUnder(real, f); });
            if (allowed) return real;
            outside = true;
        }
    }
    if (outside) return Error{Code::ImportOutside, written + " lies outside the project and the folders that are searched"};
    if (unplain) return Error{Code::FileUnreadable, written + " is not a plain file"};
    if (loop) return Error{Code::FileUnreadable, written + " is a link that leads back to itself"};
    if (denied) return Error{Code::FileUnreadable, written + " cannot be read: its folder may not be entered"};
    const std::string why = directory.empty() ? "" : ": " + cleanLine(directory) + " is a folder";
    return Error{Code::ImportNotFound, written + " is not found" + why + "; looked in " + shown};
}

std::vector<std::string> FileSearch::nearest(std::string written, const std::string& folder, const std::string& ending) const {
    normalise(written);
    const fs::path wanted(written);
    std::vector<std::string> names;
    for (const std::string& root : roots(folder).folders) {
        std::error_code ec;
        const fs::path place = (fs::path(root) / wanted).parent_path();
        int looked = 0;
        for (fs::directory_iterator it(place, ec), end; !ec && it != end && ++looked < kMaxEntries; it.increment(ec)) {
            std::error_code status;
            if (it->is_regular_file(status)) names.push_back(it->path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::vector<std::string> near = nearestWords(wanted.filename().string(), names);
    const std::string whole = wanted.filename().string() + "." + ending;
    if (!ending.empty() && std::ranges::binary_search(names, whole)) {
        std::erase(near, whole);
        near.insert(near.begin(), whole);
    }
    const std::string before = written.substr(0, written.size() - wanted.filename().string().size());
    for (std::string& name : near) name = before + name;
    return near;
}

Result<std::string> readFile(const std::string& path, std::size_t most, const std::string& shown) {
    const std::string& name = shown.empty() ? path : shown;
    std::error_code ec;
    const fs::file_status status = fs::status(path, ec);
    if (isLoop(ec)) return Error{Code::FileUnreadable, name + " is a link that leads back to itself"};
    if (ec == std::errc::permission_denied)
        return Error{Code::FileUnreadable, name + " cannot be read: its folder may not be entered"};
    if (!fs::exists(status)) return Error{Code::FileUnreadable, name + " does not exist"};
    if (fs::is_directory(status)) return Error{Code::FileUnreadable, name + " is a folder"};
    if (!fs::is_regular_file(status)) return Error{Code::FileUnreadable, name + " is not a plain file"};
    const std::uintmax_t size = fs::file_size(path, ec);
    if (!ec && size > most) return Error{Code::TooLarge, name + " is too large: an experiment may hold 64 MiB of text"};
    std::ifstream file(path, std::ios::binary);
    if (!file) return Error{Code::FileUnreadable, name + " cannot be opened: " + std::strerror(errno)};
    std::string bytes;
    if (!ec) bytes.reserve(static_cast<std::size_t>(size));
    char buffer[65536];
    while (file.read(buffer, sizeof buffer), file.gcount() > 0) {
        bytes.append(buffer, static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > most) return Error{Code::TooLarge, name + " is too large: an experiment may hold 64 MiB of text"};
    }
    if (file.bad()) return Error{Code::FileUnreadable, name + " cannot be read"};
    return bytes;
}

} // namespace trundle
