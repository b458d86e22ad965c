#include "editor/document/texts_with_code.h"

#include <algorithm>
#include <utility>

#include "base/platform/read_file.h"
#include "project/loading/loader.h"

namespace trundle {

std::optional<SourceRange> TextsWithCode::lineAt(const std::string& file, int line) {
    if (line < 1 || !file.starts_with(m_all->projectFolder + "/")) return std::nullopt;
    const std::optional<FileId> id = idOf(file);
    if (!id) return std::nullopt;
    const SourceText& text = *m_all->sources[*id].text;
    if (static_cast<std::uint32_t>(line) > text.lineCount()) return std::nullopt; // it has been changed since it was built
    const std::string_view words = text.line(static_cast<std::uint32_t>(line));
    const auto start = static_cast<std::size_t>(words.data() - text.bytes().data());
    const std::size_t first = std::min(words.find_first_not_of(" \t"), words.size());
    const std::size_t last = words.find_last_not_of(" \t\r\n");
    const std::size_t end = last == std::string_view::npos ? first : last + 1;
    return SourceRange{*id, {static_cast<std::uint32_t>(start + first), static_cast<std::uint32_t>(start + end)}};
}

std::optional<FileId> TextsWithCode::idOf(const std::string& path) {
    const auto known = std::ranges::find(m_all->paths, path);
    if (known != m_all->paths.end()) return static_cast<FileId>(known - m_all->paths.begin());
    Result<std::string> bytes = readRegularFile(path, kMaxTextBytes);
    if (!bytes) return std::nullopt;
    m_all->paths.resize(m_all->sources.size()); // by FileId
    m_all->paths.push_back(path);
    return m_all->sources.add(std::make_shared<const SourceText>(path, std::move(bytes).value()));
}

} // namespace trundle
