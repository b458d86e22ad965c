#include "project/loading/folder_names.h"

#include <algorithm>
#include <filesystem>

namespace trundle {

namespace {

constexpr int kManyMissing = 100;
constexpr std::size_t kMostNames = 100'000; ///< a larger folder is not listed
constexpr std::size_t kMostFolders = 1000;
constexpr std::size_t kLongestName = 255; ///< bytes; no file system of Linux has longer names

bool isAscii(const std::string& name) {
    return std::ranges::all_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string inLowerCase(std::string name) {
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return name;
}

std::optional<std::unordered_set<std::string>> namesIn(const std::filesystem::path& folder) {
    std::unordered_set<std::string> names;
    std::error_code ec;
    for (std::filesystem::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
        names.insert(inLowerCase(it->path().filename().string()));
        if (names.size() > kMostNames) return std::nullopt;
    }
    const bool none = ec == std::errc::no_such_file_or_directory || ec == std::errc::not_a_directory;
    if (ec && !none) return std::nullopt; // for example a folder that may be entered, but not listed
    return names;
}

/// Everything before the last slash. std::filesystem takes ten times as long, and texts may name a hundred thousand files.
std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

} // namespace

bool FolderNames::mayExist(const std::string& path) const {
    if (path.size() - std::min(path.size(), path.rfind('/') + 1) > kLongestName) return false;
    const auto folder = m_folders.find(folderOf(path));
    if (folder == m_folders.end() || !folder->second.names) return true;
    const std::string name = path.substr(folder->first.size() + (folder->first.empty() ? 0 : 1));
    return name == "." || name == ".." || !isAscii(name) || folder->second.names->contains(inLowerCase(name));
}

void FolderNames::addMissing(const std::string& path) {
    if (!mayExist(path)) return;
    const std::string place = folderOf(path);
    if (m_folders.size() >= kMostFolders && !m_folders.contains(place)) return;
    Folder& folder = m_folders[place];
    if (++folder.missing == kManyMissing) folder.names = namesIn(place.empty() ? "/" : place);
}

} // namespace trundle
