#include "lang/text_scanner.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/units.h"
#include "base/utf8.h"

namespace trundle {
namespace {

constexpr int kLongestPath = 64; ///< longest key path examined, which bounds the lookahead

} // namespace

bool isDirectiveLike(std::string_view name) {
    std::string lower;
    for (const char c : name.substr(0, 12)) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    constexpr std::array<std::string_view, 6> kLike{"import", "imports", "include", "loadmodule", "loadmodules", "load_module"};
    return std::find(kLike.begin(), kLike.end(), lower) != kLike.end();
}

std::string unitWithPower(std::string_view written) {
    std::string meant;
    for (std::size_t i = 0; i < written.size(); ++i) {
        const std::string_view rest = written.substr(i);
        if (rest.starts_with("\u00B2") || rest.starts_with("\u00B3")) {
            meant += rest.starts_with("\u00B2") ? "^2" : "^3";
            ++i;
            continue;
        }
        if (isDigit(written[i]) && !meant.empty() && isIdentStart(meant.back())) meant += '^';
        meant += written[i];
    }
    return meant != written && findUnit(meant) ? meant : std::string();
}

std::size_t foreignQuoteEnd(std::string_view text, std::size_t at) {
    constexpr std::size_t kLongestQuoted = 200; // bounds the search: text with only opening quotes stays linear
    struct Quotes {
        std::string_view open, close;
    };
    constexpr std::array<Quotes, 7> kQuotes{{{"'", "'"},
                                             {"`", "`"},
                                             {"\u201C", "\u201D"},
                                             {"\u201D", "\u201D"},
                                             {"\u201E", "\u201C"},
                                             {"\u2018", "\u2019"},
                                             {"\u00AB", "\u00BB"}}};
    for (const auto& [open, close] : kQuotes) {
        if (text.compare(at, open.size(), open) != 0) continue;
        std::string_view rest = text.substr(0, at + kLongestQuoted);
        rest = rest.substr(0, rest.find_first_of("\r\n", at));
        const std::size_t found = rest.find(close, at + open.size());
        if (found != std::string_view::npos) return found + close.size();
    }
    return at;
}

std::size_t TextScanner::lineEnd(std::size_t from) const {
    while (from < m_text.size() && m_text[from] != '\n' && m_text[from] != '\r') ++from;
    return from;
}

std::size_t TextScanner::skipBlanks(std::size_t from) const {
    while (isBlank(at(from))) ++from;
    return from;
}

std::size_t TextScanner::skipTrivia(std::size_t from) const {
    while (from < m_text.size()) {
        const char c = m_text[from];
        if (isBlank(c) || c == '\n' || c == '\r') {
            ++from;
        } else if (startsWith(from, "//")) {
            from = lineEnd(from);
        } else if (startsWith(from, "/*")) {
            const std::size_t close = m_text.find("*/", from + 2);
            from = close == std::string_view::npos ? m_text.size() : close + 2;
        } else {
            break;
        }
    }
    return from;
}

std::size_t TextScanner::blankLinesEnd(std::size_t from) const {
    std::size_t end = from;
    for (std::size_t i = skipBlanks(from); at(i) == '\n' || at(i) == '\r'; i = skipBlanks(end)) end = afterLineEnd(i);
    return end;
}

std::size_t TextScanner::commentsEnd(std::size_t from) const {
    std::size_t lastLineEnd = std::string_view::npos, i = from;
    while (i < m_text.size()) {
        const char c = at(i);
        if (isBlank(c)) {
            i = skipBlanks(i);
        } else if (c == '\n' || c == '\r') {
            lastLineEnd = i;
            i = afterLineEnd(i);
        } else if (startsWith(i, "//")) {
            i = lineEnd(i);
        } else {
            const std::size_t close = startsWith(i, "/*") ? m_text.find("*/", i + 2) : std::string_view::npos;
            if (close == std::string_view::npos) break;
            i = close + 2;
        }
    }
    return lastLineEnd == std::string_view::npos ? i : lastLineEnd;
}

std::size_t TextScanner::letterAt(std::size_t i) const {
    if (isIdent(at(i))) return 1;
    if (static_cast<unsigned char>(at(i)) < 0x80) return 0;
    const CodePoint point = codePointAt(m_text, i);
    return point.valid && isForeignLetter(point.value) ? point.length : 0;
}

std::size_t TextScanner::invisibleAt(std::size_t i) const {
    if (static_cast<unsigned char>(at(i)) < 0x80) return 0;
    const CodePoint point = codePointAt(m_text, i);
    return point.valid && isInvisible(point.value) ? point.length : 0;
}

std::size_t TextScanner::identEnd(std::size_t from) const {
    while (const std::size_t letter = letterAt(from)) from += letter;
    return from;
}

std::size_t TextScanner::wordEnd(std::size_t from) const {
    while (!commentAt(from)) {
        const std::size_t letter = isWordChar(at(from)) ? 1 : letterAt(from);
        if (letter == 0) break;
        from += letter;
    }
    return from;
}

std::size_t TextScanner::numberEnd(std::size_t from, bool sign) const {
    std::size_t i = from;
    if (sign && (at(i) == '+' || at(i) == '-')) ++i;
    else if (sign && startsWith(i, kUnicodeMinus)) i += kUnicodeMinus.size();
    if (!isDigit(at(i)) && !(at(i) == '.' && isDigit(at(i + 1)))) return from;
    // `1.2.3` and `1..2` are one malformed number, not two adjacent ones.
    while (isDigit(at(i)) || at(i) == '.') ++i;
    if (at(i) == 'e' || at(i) == 'E') {
        const std::size_t exponent = i + 1 + (at(i + 1) == '+' || at(i + 1) == '-' ? 1 : 0);
        if (isDigit(at(exponent)))
            for (i = exponent; isDigit(at(i));) ++i;
    }
    return i;
}

std::size_t TextScanner::otherPathEnd(std::size_t from) const {
    constexpr std::size_t kLongest = 200; // bounds the lookahead
    std::size_t i = identEnd(from);
    bool other = false;
    while (i < from + kLongest) {
        const char c = at(i), next = at(i + 1);
        if ((c == '.' || ((c == '/' || c == '\\') && !commentAt(i))) && isIdentStart(next)) {
            other = other || c != '.';
            i = identEnd(i + 1);
            continue;
        }
        std::size_t end = i;
        if ((startsWith(i, "::") || startsWith(i, "->")) && isIdentStart(at(i + 2))) end = identEnd(i + 2);
        else if (c == '.' && isDigit(next))
            for (end = i + 1; isDigit(at(end));) ++end;
        else if (c == '*' && next != '*') end = i + 1;
        else if (c == '.' && next == '*') end = i + 2;
        else if (c == '[' && (isDigit(next) || next == '*')) {
            for (end = i + 2; isDigit(at(end));) ++end;
            if (at(end++) != ']') return from;
        }
        if (end == i) break;
        other = true;
        i = end;
    }
    const std::size_t equals = skipBlanks(i);
    return other && at(equals) == '=' && at(equals + 1) != '=' ? i : from;
}

std::size_t TextScanner::unitEnd(std::size_t from) const {
    if (at(from) == '%') return from + 1;
    for (const std::string_view sign :
         {"\u00B0", "\u03A9", "\u2126", "\u00B5m", "\u03BCm", "\u00B5s", "\u03BCs"}) // degree, ohm, micro
        if (startsWith(from, sign)) return from + sign.size();
    if (!wordStartsAt(from)) return from;
    const std::size_t ident = identEnd(from);
    // `Param r = 5 cm { Min=...`: what follows a unit describes the Param; `a == 5 cm == b`
    const std::size_t after = skipBlanks(ident);
    const bool isUnit = (at(after) == '{' || startsWith(after, "==")) && findUnit(m_text.substr(from, ident - from));
    if (isBlank(at(from - 1)) && otherPathEnd(from) > from) return from;
    if (isReservedWord(from, ident) || (!isUnit && isKeyOrKind(from, ident))) return from;

    const auto powerAt = [this](std::size_t i) { return startsWith(i, "\u00B2") || startsWith(i, "\u00B3"); };
    std::size_t run = from;
    while ((letterAt(run) || powerAt(run) || ((at(run) == '/' || at(run) == '^') && letterAt(run + 1))) && !commentAt(run))
        run += powerAt(run) ? 2 : std::max<std::size_t>(letterAt(run), 1);
    constexpr std::size_t kLongestUnit = 12;
    if (run - from <= kLongestUnit && !unitWithPower(m_text.substr(from, run - from)).empty()) return run;
    for (std::size_t end = std::min(run, from + kLongestUnit); end > from; --end)
        if (!letterAt(end) && findUnit(m_text.substr(from, end - from))) return end;
    const bool touches = from > 0 && !isBlank(at(from - 1));
    if (!touches && (isNamedBlock(ident) || isKeyWithoutEquals(from))) return from;
    return run;
}

bool TextScanner::isKeyWithoutEquals(std::size_t from) const {
    std::size_t last = from, end = identEnd(from);
    for (int parts = 0; parts < kLongestPath && at(end) == '.' && wordStartsAt(end + 1); ++parts) {
        last = end + 1;
        end = identEnd(last);
    }
    const std::size_t value = skipBlanks(end);
    if (at(last) < 'A' || at(last) > 'Z' || value == end) return false;
    if (at(value) == '"' || at(value) == '$' || numberEnd(value, true) > value) return true;
    return wordStartsAt(value) && !isKeyOrKind(value, identEnd(value)) && !isNamedBlock(identEnd(value));
}

std::size_t TextScanner::bracedParamEnd(std::size_t i) const {
    constexpr std::size_t kLongest = 200;
    if (!startsWith(i, "${")) return i;
    const std::size_t first = skipBlanks(i + 2);
    if (!letterAt(first) && at(first) != '(' && at(first) != '$') return i;
    for (std::size_t end = first; end < i + kLongest; ++end) {
        if (at(end) == '}') return end + 1;
        if (at(end) == '\0' || std::string_view("{=\"\n\r").find(at(end)) != std::string_view::npos) return i;
    }
    return i;
}

bool TextScanner::isReservedWord(std::size_t from, std::size_t end) const {
    const std::string_view word = m_text.substr(from, end - from);
    return word == "Param" || word == "true" || word == "false";
}

bool TextScanner::isKeyOrKind(std::size_t from, std::size_t end) const {
    if (m_text.substr(from, end - from) == "Param") return true;
    std::size_t i = skipTrivia(end);
    if (at(i) == '=' || at(i) == '{') return true;
    // `Key: value` is a common mistake, but C:\maps and http://... are texts with missing quotes.
    if (at(i) == ':') return at(i + 1) != '/' && at(i + 1) != '\\' && !(at(i + 1) == ':' && i == end);
    // A key path contains no spaces: in `File=a.csv. Key=1` the word ends at the dot.
    i = end;
    for (int parts = 0; parts < kLongestPath && at(i) == '.' && wordStartsAt(i + 1); ++parts) i = identEnd(i + 1);
    return i > end && at(skipTrivia(i)) == '=';
}

bool TextScanner::isNamedBlock(std::size_t end) const {
    const std::size_t name = skipTrivia(end);
    if (!wordStartsAt(name)) return false;
    return at(skipTrivia(identEnd(name))) == '{';
}

} // namespace trundle
