#include "model/dotted_path.h"

#include <algorithm>

namespace trundle {

DottedPath::DottedPath(std::string_view text, int) : m_text(text) {
    if (text.empty()) return;
    for (;;) {
        m_words.emplace_back(firstWord(text));
        if (text.find('.') == std::string_view::npos) return;
        text = withoutFirstWord(text);
    }
}

bool DottedPath::isComplete() const {
    return std::ranges::none_of(m_words, [](const std::string& word) { return word.empty(); });
}

std::string_view firstWord(std::string_view path) { return path.substr(0, path.find('.')); }

std::string_view withoutFirstWord(std::string_view path) {
    const std::size_t dot = path.find('.');
    return dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
}

std::string_view lastWord(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string_view withoutLastWord(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

bool startsWithPath(std::string_view path, std::string_view start) {
    return path.starts_with(start) && (path.size() == start.size() || start.empty() || path[start.size()] == '.');
}

std::string pathInside(std::string_view path, std::string_view word) {
    return path.empty() ? std::string(word) : std::string(path) + "." + std::string(word);
}

} // namespace trundle
