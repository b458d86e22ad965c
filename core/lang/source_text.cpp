#include "lang/source_text.h"

#include <algorithm>

#include "base/utf8.h"

namespace trundle {

namespace {

constexpr std::uint32_t kMarkEvery = 4096; // bytes

} // namespace

SourceText::SourceText(std::string path, std::string bytes)
    : SourceText(std::move(path), std::make_shared<const std::string>(std::move(bytes))) {}

SourceText::SourceText(std::string path, std::shared_ptr<const std::string> bytes)
    : m_path(std::move(path)), m_bytes(std::move(bytes)) {
    Mark at;
    if (m_bytes->starts_with(kBom)) at.offset = static_cast<std::uint32_t>(kBom.size());
    m_marks.push_back({0, at.place});
    if (at.offset > 0) m_marks.push_back(at);
    for (std::uint32_t next = kMarkEvery; at.offset < m_bytes->size(); step(at))
        if (at.offset >= next) {
            m_marks.push_back(at);
            next = at.offset + kMarkEvery;
        }
    m_lines = at.place.line;
}

/// Advances by one code point.
void SourceText::step(Mark& mark) const {
    const std::string& bytes = *m_bytes;
    const char c = bytes[mark.offset];
    const bool crOfCrLf = c == '\r' && mark.offset + 1 < bytes.size() && bytes[mark.offset + 1] == '\n';
    mark.offset += static_cast<unsigned char>(c) < 0x80 ? 1 : codePointAt(bytes, mark.offset).length;
    if ((c == '\n' || c == '\r') && !crOfCrLf) mark.place = {mark.place.line + 1, 1};
    else ++mark.place.column;
}

const SourceText::Mark& SourceText::markBefore(std::uint32_t offset) const {
    const auto after = [](std::uint32_t o, const Mark& mark) { return o < mark.offset; };
    return *(std::upper_bound(m_marks.begin(), m_marks.end(), offset, after) - 1);
}

std::string_view SourceText::slice(TextRange range) const {
    const std::size_t begin = std::min<std::size_t>(range.begin, m_bytes->size());
    const std::size_t end = std::clamp<std::size_t>(range.end, begin, m_bytes->size());
    return std::string_view(*m_bytes).substr(begin, end - begin);
}

LineColumn SourceText::position(std::uint32_t offset) const {
    offset = std::min(offset, static_cast<std::uint32_t>(m_bytes->size()));
    if (offset < kBom.size() && m_bytes->starts_with(kBom)) return {};
    Mark at = markBefore(offset);
    while (at.offset < offset) {
        Mark next = at;
        step(next);
        if (next.offset > offset) break; // an offset inside a code point counts as that code point
        at = next;
    }
    return at.place;
}

std::string_view SourceText::line(std::uint32_t line) const {
    if (line == 0 || line > m_lines) return {};
    const auto earlier = [](const Mark& mark, std::uint32_t l) { return mark.place.line < l; };
    const auto later = std::lower_bound(m_marks.begin(), m_marks.end(), line, earlier); // the first mark on the line or after it
    Mark at = later == m_marks.begin() ? m_marks.front() : *(later - 1);
    while (at.place.line < line && at.offset < m_bytes->size()) step(at);
    const auto beyond = std::lower_bound(m_marks.begin(), m_marks.end(), line + 1, earlier);
    const std::size_t limit = beyond == m_marks.end() ? m_bytes->size() : beyond->offset;
    const std::size_t search = std::max(at.offset, beyond == m_marks.begin() ? 0 : (beyond - 1)->offset);
    std::size_t end = std::min(m_bytes->find_first_of("\r\n", search), limit);
    if (end > at.offset && (*m_bytes)[end - 1] == '\r') --end; // the search began between CR and LF
    return std::string_view(*m_bytes).substr(at.offset, end - at.offset);
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
