#include "project/loading/folder_names.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr int kManyMissing = 100;
constexpr std::size_t kMostNames = 100'000; ///< a larger folder is not listed
constexpr std::size_t kMostFolders = 1000;

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

} // namespace

bool FolderNames::mayExist(const std::filesystem::path& file) const {
    const auto folder = m_folders.find(file.parent_path().string());
    if (folder == m_folders.end() || !folder->second.names) return true;
    const std::string name = file.filename().string();
    return name == "." || name == ".." || !isAscii(name) || folder->second.names->contains(inLowerCase(name));
}

void FolderNames::addMissing(const std::filesystem::path& file) {
    const std::string path = file.parent_path().string();
    if (m_folders.size() >= kMostFolders && !m_folders.contains(path)) return;
    Folder& folder = m_folders[path];
    if (++folder.missing == kManyMissing) folder.names = namesIn(file.parent_path());
}

} // namespace trundle
