#include "lang/source_text.h"

#include <algorithm>

#include "base/utf8.h"

namespace trundle {

SourceText::SourceText(std::string path, std::string bytes) : m_path(std::move(path)), m_bytes(std::move(bytes)) {
    m_lineStarts.push_back(0);
    for (std::size_t i = 0; i < m_bytes.size(); ++i) {
        const bool crOfCrLf = m_bytes[i] == '\r' && i + 1 < m_bytes.size() && m_bytes[i + 1] == '\n';
        if ((m_bytes[i] == '\n' || m_bytes[i] == '\r') && !crOfCrLf) m_lineStarts.push_back(static_cast<std::uint32_t>(i + 1));
    }
}

std::string_view SourceText::slice(TextRange range) const {
    const std::size_t begin = std::min<std::size_t>(range.begin, m_bytes.size());
    const std::size_t end = std::clamp<std::size_t>(range.end, begin, m_bytes.size());
    return std::string_view(m_bytes).substr(begin, end - begin);
}

LineColumn SourceText::position(std::uint32_t offset) const {
    offset = std::min(offset, static_cast<std::uint32_t>(m_bytes.size()));
    const auto next = std::upper_bound(m_lineStarts.begin(), m_lineStarts.end(), offset);
    LineColumn place{static_cast<std::uint32_t>(next - m_lineStarts.begin()), 1};
    std::size_t at = *(next - 1);
    if (at == 0 && std::string_view(m_bytes).starts_with(kBom)) at = kBom.size();
    while (at < offset) {
        at += codePointAt(m_bytes, at).length;
        if (at <= offset) ++place.column; // an offset inside a code point is that code point's
    }
    return place;
}

std::string_view SourceText::line(std::uint32_t line) const {
    if (line == 0 || line > m_lineStarts.size()) return {};
    const std::uint32_t begin = m_lineStarts[line - 1];
    std::uint32_t end = line < m_lineStarts.size() ? m_lineStarts[line] : static_cast<std::uint32_t>(m_bytes.size());
    while (end > begin && (m_bytes[end - 1] == '\n' || m_bytes[end - 1] == '\r')) --end;
    return std::string_view(m_bytes).substr(begin, end - begin);
}

FileId SourceTable::add(std::shared_ptr<const SourceText> text, SourceRange importedFrom) {
    m_entries.push_back({std::move(text), importedFrom});
    return static_cast<FileId>(m_entries.size() - 1);
}

void SourceTable::replace(FileId file, std::shared_ptr<const SourceText> text) { m_entries[file].text = std::move(text); }

std::string_view SourceTable::slice(const SourceRange& range) const {
    if (range.file >= m_entries.size()) return {};
    return m_entries[range.file].text->slice(range.range);
}

} // namespace trundle
