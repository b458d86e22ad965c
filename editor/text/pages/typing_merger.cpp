#include "editor/text/pages/typing_merger.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>

#include "base/utf8.h"

namespace trundle {
namespace {

bool isBlankText(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
}
bool isOneCharacter(std::string_view text) { return !text.empty() && codePointAt(text, 0).length == text.size(); }
bool isLineEnd(std::string_view text) { return text == "\n" || text == "\r\n" || text == "\r"; }

} // namespace

bool TypingMerger::joins(std::size_t at, std::size_t removed, std::string_view inserted) const {
    if (m_sort == Sort::None || m_sort == Sort::Other) return false;
    if (inserted.empty()) return m_sort == Sort::Deleting && (at + removed == m_end || at == m_end);
    if (m_sort != Sort::Typing || at != m_end || !isOneCharacter(inserted)) return false;
    return !isLineEnd(inserted) && (!m_blank || isBlankText(inserted));
}

bool TypingMerger::startsEntry(std::size_t at, std::size_t removed, std::string_view inserted) {
    if (!m_newAction) return false;
    m_newAction = false;
    if (m_wanted.isEmpty() && joins(at, removed, inserted)) return false;
    m_next = inserted.empty() ? Sort::Deleting : isOneCharacter(inserted) || isLineEnd(inserted) ? Sort::Typing : Sort::Other;
    if (m_dirty) return true;
    begin();
    return false;
}

void TypingMerger::close(std::string bytes) {
    m_closed.push_back({name(), std::move(bytes), key(), !m_name.isEmpty()});
    begin();
}

void TypingMerger::begin() {
    ++m_serial;
    m_sort = m_next;
    m_name = std::exchange(m_wanted, {});
    m_blank = m_dirty = false;
}

void TypingMerger::changed(std::size_t at, std::string_view inserted) {
    m_dirty = true;
    m_end = at + inserted.size();
    if (inserted.empty()) return;
    m_blank = isBlankText(inserted);
    if (m_sort == Sort::Deleting) m_sort = Sort::Typing; // a selection replaced by typing
}

QString TypingMerger::name() const {
    if (!m_name.isEmpty()) return m_name;
    switch (m_sort) {
    case Sort::Deleting: return QCoreApplication::translate("Typing", "Delete Text");
    case Sort::Other: return QCoreApplication::translate("Typing", "Insert Text");
    default: return QCoreApplication::translate("Typing", "Type");
    }
}

std::vector<TypingMerger::Entry> TypingMerger::take(std::string now) {
    std::vector<Entry> entries = std::move(m_closed);
    m_closed.clear();
    if (m_dirty) entries.push_back({name(), std::move(now), key(), !m_name.isEmpty()});
    m_dirty = false;
    return entries;
}

void TypingMerger::joinAll() {
    m_dirty = m_dirty || !m_closed.empty();
    m_closed.clear();
}

void TypingMerger::drop() {
    m_closed.clear();
    m_dirty = false;
    m_wanted.clear();
    endWord();
}

} // namespace trundle
