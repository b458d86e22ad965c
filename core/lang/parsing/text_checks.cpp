#include "lang/parsing/text_checks.h"

#include <algorithm>

#include "base/utf8.h"
#include "lang/characters.h"

namespace trundle {
namespace {

constexpr std::uint32_t kShownOfLongWord = 40; // bytes covered by the range of its diagnostic

constexpr std::string_view kBlanks = " \t\r\n";

/// `DEF name Kind {`, `PROTO Name [`, `EXTERNPROTO "..."`.
bool isVrml(std::string_view text) {
    const auto word = [&text] { // takes the next word and the blanks behind it
        const std::size_t end = std::min(text.find_first_of(" \t\r\n{[\""), text.size());
        const std::string_view taken = text.substr(0, end);
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks, end), text.size()));
        return taken;
    };
    if (text.starts_with("#VRML")) return true;
    const std::string_view first = word();
    if (first == "EXTERNPROTO") return text.starts_with('"');
    if (first != "DEF" && first != "PROTO") return false;
    const bool named = !word().empty();
    if (first == "PROTO") return named && text.starts_with('[');
    return named && !word().empty() && text.starts_with('{');
}

constexpr std::size_t kHead = 4096; ///< bytes of a text that show its language

std::string_view firstLine(std::string_view text) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    return line.substr(0, line.find_last_not_of(kBlanks) + 1);
}

/// `[robot.chassis]` or `[[wheel]]`, below comments.
bool isToml(std::string_view text) {
    while (text.starts_with("# ") || text.starts_with(';')) {
        text.remove_prefix(std::min(text.find('\n'), text.size()));
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    }
    const std::string_view line = firstLine(text);
    if (line.size() < 3 || line.front() != '[' || line.back() != ']') return false;
    return std::ranges::all_of(line, [](char c) { return isIdent(c) || c == '.' || c == '-' || c == '[' || c == ']'; }) &&
           !isDigit(line[1]);
}

/// `define pioneer position` and `(`.
bool isStage(std::string_view text) {
    constexpr std::string_view kWord = "define ";
    std::string_view head = text.substr(0, kHead);
    for (std::size_t at = 0; at != std::string_view::npos; at = head.find("\ndefine ", at)) {
        if (at > 0) ++at;
        if (!head.substr(at).starts_with(kWord)) continue;
        std::string_view rest = head.substr(at + kWord.size());
        const std::size_t paren = rest.find('(');
        rest = rest.substr(0, paren);
        const bool words =
            std::ranges::all_of(rest, [](char c) { return isIdent(c) || kBlanks.find(c) != std::string_view::npos; });
        if (paren != std::string_view::npos && words) return true;
    }
    return false;
}

/// The language that the first characters of a text without blanks around it show; empty for none that is known.
std::string_view otherLanguage(std::string_view text) {
    if (isVrml(text)) return "a VRML";
    if (text.starts_with("#usda ")) return "a USD";
    if (text.starts_with("%YAML") || firstLine(text) == "---") return "a YAML";
    if (isToml(text)) return "a TOML or INI";
    if (isStage(text)) return "a Stage world";
    const std::size_t second = text.find_first_not_of(kBlanks, 1);
    if (text[0] == '<' && text.back() == '>' && (isIdentStart(text[1]) || text[1] == '?' || text[1] == '!')) {
        const std::string_view head = text.substr(0, kHead);
        if (head.find("<robot") != std::string_view::npos) return "a URDF (XML)";
        return head.find("<sdf") != std::string_view::npos ? "an SDF (XML)" : "an XML";
    }
    const bool closed = (text[0] == '{' && text.back() == '}') || (text[0] == '[' && text.back() == ']');
    return closed && (text[second] == '"' || text[second] == '{') ? "a JSON" : std::string_view();
}

std::string hexOf(std::uint32_t value, int digits) {
    std::string hex;
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) hex += "0123456789ABCDEF"[value >> shift & 0xF];
    return hex;
}

} // namespace

void TextChecks::checkTokens() {
    checkInvisible();
    checkLongWords();
    checkComments();
}

bool TextChecks::isUtf16() const { return bytes().starts_with("\xFF\xFE") || bytes().starts_with("\xFE\xFF"); }

bool TextChecks::isOtherLanguage() {
    const std::string_view all = bytes();
    const std::size_t bom = all.starts_with(kBom) ? kBom.size() : 0;
    const std::size_t first = all.find_first_not_of(kBlanks, bom), last = all.find_last_not_of(kBlanks);
    if (first == std::string_view::npos || last == first) return false;
    const std::string_view text = all.substr(first, last + 1 - first);
    const std::string_view language = otherLanguage(text);
    if (language.empty()) return false;
    constexpr std::size_t kShown = 40;
    std::size_t end = std::min({text.find_first_of("\r\n"), text.size(), kShown});
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end; // not within a code point
    error(Code::UnexpectedText, {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(first + end)},
          "this is " + std::string(language) + " file; here blocks are written as `Robot rover { Config=Rover Pos=0,0,0 }`");
    return true;
}

void TextChecks::checkInvisible() {
    for (const std::uint32_t i : m_tokens.invisible()) {
        const TextRange r = m_tokens.all()[i].range;
        const CodePoint point = codePointAt(bytes(), r.begin);
        if (!point.valid || point.value == 0) continue;
        Diagnostic& d = error(Code::UnexpectedText, r, "invisible sign U+" + hexOf(point.value, 4) + " instead of a blank");
        fix(d, "a blank", {edit(r, " ")});
    }
}

void TextChecks::checkBytes() {
    const std::string_view bytes = this->bytes();
    if (isUtf16()) {
        error(Code::InvalidBytes, {0, 2}, "this file is UTF-16, save it as UTF-8");
        return;
    }
    bool inRun = false;
    for (std::size_t i = 0; i < bytes.size() && !m_report.isFull();) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        const CodePoint point = byte < 0x80 ? CodePoint{byte, 1, byte != 0} : codePointAt(bytes, i);
        if (!point.valid && !inRun) {
            const std::uint32_t at = static_cast<std::uint32_t>(i);
            if (byte == 0) error(Code::InvalidBytes, {at, at + 1}, "a NUL byte in the text");
            else error(Code::InvalidBytes, {at, at + 1}, "byte 0x" + hexOf(byte, 2) + " is no UTF-8 text");
        }
        inRun = !point.valid;
        i += point.length;
    }
}

void TextChecks::checkComments() {
    const std::vector<Token>& tokens = m_tokens.all();
    if (tokens.size() < 2) return;
    const Token& last = tokens[tokens.size() - 2]; // only the last token can be unterminated
    const std::string_view comment = slice(last.range);
    if (last.kind != TokenKind::BlockComment || (comment.size() >= 4 && comment.ends_with("*/"))) return;
    const TextRange start{last.range.begin, last.range.begin + 2};
    const bool wildcard = start.begin > 0 && isWordChar(bytes()[start.begin - 1]);
    if (wildcard) {
        error(Code::UnclosedComment, start, "`/*` begins a comment; a text with * is written in double quotes");
        return;
    }
    Diagnostic& d = error(Code::UnclosedComment, start, "this comment is never closed");
    fix(d, "add `*/` at the end", {edit({last.range.end, last.range.end}, " */")});
}

void TextChecks::checkLongWords() {
    for (const std::uint32_t i : m_tokens.tooLong()) {
        const Token& token = m_tokens.all()[i];
        error(Code::TooLarge, {token.range.begin, std::min(token.range.end, token.range.begin + kShownOfLongWord)},
              std::to_string(token.range.size()) +
                  " bytes without a blank; a word, a number or a path may have 4096, a quoted text 65536");
    }
}

} // namespace trundle
