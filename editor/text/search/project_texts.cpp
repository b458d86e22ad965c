#include "editor/text/search/project_texts.h"

#include <algorithm>

#include "editor/text/symbols/project_files.h"
#include "project/loading/search.h"

namespace trundle {

std::vector<ProjectTexts::Text> ProjectTexts::in(const std::string& folder) {
    m_left = 0;
    std::vector<Text> texts;
    if (folder.empty()) return texts;
    std::size_t bytes = 0;
    for (const std::string& name : filesBelow({folder}, {"sim", "txt", "md", "h", "hpp", "c", "cpp", "cmake", "py"})) {
        if (name.starts_with("logs/") || name.starts_with("build/")) continue;
        const std::string path = canonicalPath(folder + "/" + name);
        if (!isInside(path, {folder})) continue;
        const std::shared_ptr<const std::string> text = read(path);
        if (!text || bytes + text->size() > kMaxBytes) {
            ++m_left;
            continue;
        }
        if (text->find('\0') != std::string::npos) continue;
        bytes += text->size();
        texts.push_back({path, text});
    }
    return texts;
}

/// Null if it is too large or cannot be read.
std::shared_ptr<const std::string> ProjectTexts::read(const std::string& path) {
    const Result<FileStamp> stamp = regularFileStamp(path);
    if (!stamp || stamp.value().size > kLargest) return nullptr;
    Known& known = m_known[path];
    if (known.bytes && known.stamp == stamp.value()) return known.bytes;
    Result<std::string> bytes = readRegularFile(path, kLargest);
    if (!bytes) return nullptr;
    known = {stamp.value(), std::make_shared<const std::string>(std::move(bytes).value())};
    return known.bytes;
}

} // namespace trundle
