#include "model/dotted_path.h"

#include <algorithm>
#include <charconv>

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

std::optional<MemberName> memberName(std::string_view name) {
    const std::size_t bar = name.rfind('_');
    if (bar == std::string_view::npos || bar == 0 || bar + 1 == name.size()) return std::nullopt;
    const std::string_view digits = name.substr(bar + 1);
    if (digits.size() > 1 && digits[0] == '0') return std::nullopt;
    MemberName member{name.substr(0, bar), 0};
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), member.index);
    if (failure != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return member;
}

bool isMemberOf(std::string_view name, std::string_view of) {
    const std::optional<MemberName> member = memberName(name);
    return member && member->stem == of;
}

std::optional<std::string_view> restBehind(std::string_view path, std::string_view name) {
    while (!name.empty()) {
        const std::string_view word = firstWord(path), wanted = firstWord(name);
        if (word != wanted && !isMemberOf(wanted, word)) return std::nullopt;
        path = withoutFirstWord(path);
        name = withoutFirstWord(name);
    }
    return path;
}

} // namespace trundle
