#include "project/saving/open_files.h"

#include <algorithm>
#include <utility>

namespace trundle {

void OpenFiles::take(const std::string& path, SharedText bytes) {
    const auto [at, isNew] = m_files.try_emplace(path);
    if (!isNew) return;
    at->second.disk = bytes;
    at->second.text = std::move(bytes);
}

void OpenFiles::make(const std::string& path) {
    take(path, std::make_shared<const std::string>());
    m_files.at(path).made = true;
}

void OpenFiles::rename(const std::string& from, const std::string& to) {
    const OpenFile moved = m_files.at(from);
    m_files.erase(from);
    take(to, moved.text);
    m_files.at(to).made |= moved.made;
}

OpenFile* OpenFiles::find(const std::string& path) {
    const auto at = m_files.find(path);
    return at == m_files.end() ? nullptr : &at->second;
}

const OpenFile* OpenFiles::find(const std::string& path) const {
    const auto at = m_files.find(path);
    return at == m_files.end() ? nullptr : &at->second;
}

SharedText OpenFiles::text(const std::string& path) const {
    const OpenFile* file = find(path);
    return file ? file->text : nullptr;
}

void OpenFiles::setTexts(const TextOverlay& texts) {
    for (const auto& [path, text] : texts)
        if (OpenFile* file = find(path)) file->text = text;
}

TextOverlay OpenFiles::texts() const {
    TextOverlay texts;
    for (const auto& [path, file] : m_files) texts.emplace(path, file.text);
    return texts;
}

std::vector<std::string> OpenFiles::modified() const {
    std::vector<std::string> paths;
    for (const auto& [path, file] : m_files)
        if (file.modified()) paths.push_back(path);
    return paths;
}

std::vector<std::string> OpenFiles::inWritingOrder() const {
    std::vector<std::string> paths;
    for (const auto& [path, file] : m_files) paths.push_back(path);
    std::ranges::stable_sort(paths, {}, [this](const std::string& path) {
        const OpenFile& file = m_files.at(path);
        return file.isRemoved() ? 2 : file.made ? 0 : 1;
    });
    return paths;
}

} // namespace trundle
