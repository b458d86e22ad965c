#include "lang/parsing/value_parser.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/utf8.h"
#include "lang/characters.h"

namespace trundle {
namespace {

bool numberLike(const Element& e) {
    return e.kind == Element::Kind::Number || e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression;
}

/// The number as from_chars requires it: ASCII hyphen instead of a typographic minus, no leading `+`.
std::string plainNumber(std::string_view written) {
    std::string plain;
    if (written.starts_with(kUnicodeMinus)) {
        plain = "-";
        written.remove_prefix(kUnicodeMinus.size());
    } else if (written.starts_with('+')) {
        written.remove_prefix(1);
    }
    return plain.append(written);
}

/// from_chars reports "out of range" for both overflow and underflow: the exponent of the first non-zero digit decides which.
bool isTiny(std::string_view number) {
    const std::size_t e = number.find_first_of("eE");
    const std::string_view mantissa = number.substr(0, e);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    const double lead = static_cast<double>(point) - static_cast<double>(first);
    if (e == std::string_view::npos) return lead < 0;
    if (number[e + 1] == '-' && number.size() - e > 12) return true;
    double exponent = 0;
    for (const char c : number.substr(e + 1))
        if (isDigit(c)) exponent = std::min(exponent * 10 + (c - '0'), 1e15);
    return lead + (number[e + 1] == '-' ? -exponent : exponent) < 0;
}

/// `nearest` to what is written; or the next one, where it is rounded down to the largest whole number that a property may have.
double notBelow(const std::string& plain, double nearest) {
    constexpr double kLargestWhole = 9007199254740992.0; // 2^53
    long double written = 0;
    if (std::abs(nearest) != kLargestWhole) return nearest;
    const bool read = std::from_chars(plain.data(), plain.data() + plain.size(), written).ec == std::errc();
    return read && std::abs(written) > kLargestWhole ? std::nextafter(nearest, 2 * nearest) : nearest;
}

/// False for `"abc` and for `"abc\"`, whose last quote is escaped.
bool isClosedString(std::string_view written) {
    if (written.size() < 2 || written.back() != '"') return false;
    std::size_t backslashes = 0;
    while (written[written.size() - 2 - backslashes] == '\\') ++backslashes;
    return backslashes % 2 == 0;
}

/// Where a string that its line does not close is closed in a line below, if what is between them can only be text; npos: nowhere.
std::size_t quoteBelow(std::string_view text, TextRange open) {
    constexpr std::size_t kFar = 4096, kNone = std::string_view::npos;
    const std::size_t quote = text.substr(0, open.end + kFar).find('"', open.end);
    if (quote == kNone || (text[open.end] != '\n' && text[open.end] != '\r')) return kNone;
    const std::string_view all = text.substr(open.begin, quote - open.begin), below = text.substr(open.end, quote - open.end);
    const std::string_view behind = text.substr(quote + 1, std::min(text.find_first_of("\r\n", quote), text.size()) - quote - 1);
    const bool comments = all.find("//") != kNone || all.find("/*") != kNone || text[open.end - 1] == '\\';
    return comments || below.find_first_of("={}#\\") != kNone || behind.find('"') != kNone ? kNone : quote;
}

} // namespace

bool ValueParser::openBracket() const {
    if (kind() == TokenKind::OpenParen || (kind() == TokenKind::Unknown && text() == "[")) return true;
    return kind() == TokenKind::OpenBrace && (kind(1) == TokenKind::Number || kind(1) == TokenKind::String);
}

/// How many tokens `(x * 2)` has, in one line; 0 for a list in brackets, `(1, 2)`, and for what is not closed.
std::size_t ValueParser::termInParens() const {
    if (kind() != TokenKind::OpenParen || newLine()) return 0;
    std::size_t depth = 1, i = 1;
    for (; depth > 0; ++i) {
        const TokenKind k = kind(i);
        if (k == TokenKind::OpenParen || k == TokenKind::ExprOpen) ++depth;
        else if (k == TokenKind::CloseParen) --depth;
        else if (depth == 1 && k == TokenKind::Comma) return 0;
        else if (k != TokenKind::Number && k != TokenKind::Unit && k != TokenKind::Word && k != TokenKind::ParamRef &&
                 k != TokenKind::Comma && !isOperator(k))
            return 0;
        if (newLine(i)) return 0;
    }
    return i > 2 ? i : 0; // not of `()`
}

Value ValueParser::value(std::string_view key, TextRange keyRange, TextRange equals) {
    Value v;
    v.range = {equals.end, equals.end};
    std::vector<TextRange> gaps; // where a comma is missing: the end of an element, or a `;` written instead
    TextRange bracket;
    skipEquals(v);
    const std::size_t term = termInParens(); // `(x),1,1`
    const bool isTerm = term > 0 && !newLine(term) && (kind(term) == TokenKind::Comma || isOperator(kind(term)));
    if (!isTerm && openBracket()) {
        bracket = range();
        v.broken = true;
        advance();
    }
    bool commas = false; // an element before a comma was already reported as missing
    while (true) {
        const std::size_t before = position();
        if (!blockBegins(v) && element(v)) {
            if (position() == before) break; // not expected; guards against an endless loop
            if (!v.elements.empty() && m_errors.unitBehindParam(v.elements.back())) v.broken = true;
            const bool keyed = bracket.size() == 0 && keyFollows(v, !gaps.empty());
            if (keyed) m_keyAt = position();
            if (keyed || !afterElement(v, gaps)) break;
            continue;
        }
        v.broken = true;
        if (kind() == TokenKind::Comma) {
            error(Code::MissingValue, range(), "an element is missing before this comma");
            commas = true;
            while (kind() == TokenKind::Comma) advance();
            if (newLine() || !startsElement()) break;
            continue;
        }
        if (!commas) reportNone(v, key, keyRange, equals);
        break;
    }
    if (!v.elements.empty()) v.range = {v.elements.front().range.begin, v.elements.back().range.end};
    if (bracket.size() && v.elements.empty()) m_errors.skipBrackets(bracket);
    else if (bracket.size()) m_errors.reportBrackets(v, bracket, gaps);
    else if (!gaps.empty()) m_errors.reportGaps(v, gaps, key);
    return v;
}

/// Whether another block begins where an element could be, as `Box b {` on the next line or behind a comma.
bool ValueParser::blockBegins(const Value& v) const {
    if (!namedBlock()) return false;
    const bool none = v.elements.empty(), numbers = !none && numberLike(v.elements.back());
    if (newLine() && (none || numbers)) return true;
    if (!isCapital(text()) || (isCapital(text(1)) && !numbers)) return false; // a word, and a block without a name
    return none ? m_mayBeDescribed : slice(previous()) == ",";
}

/// Reports that an element is missing here.
void ValueParser::reportNone(const Value& v, std::string_view key, TextRange keyRange, TextRange equals) {
    const TextRange place = previous();
    const bool comma = slice(place) == ",";
    if (v.elements.empty() && !comma) {
        error(Code::MissingValue, equals.size() ? TextRange{equals.end, equals.end} : keyRange,
              "`" + std::string(key) + "` has no value");
    } else if (v.elements.empty()) {
        error(Code::MissingValue, place, "an element is missing after this comma");
    } else if (comma && kind() == TokenKind::Word && !newLine()) {
        m_report.separator(place, adjacent() ? " " : "");
    } else if (comma) {
        m_report.comma(place, "an element is missing after this comma", Code::MissingValue);
    }
}

void ValueParser::skipEquals(Value& v) {
    if (kind() != TokenKind::Equals) return;
    Diagnostic& d = error(Code::UnexpectedText, range(), "one `=` is enough");
    fix(d, "remove `=`", {edit(range(), "")});
    while (kind() == TokenKind::Equals) advance();
    v.broken = true;
}

Value ValueParser::paramValue(std::string_view key, TextRange keyRange, TextRange equals) {
    m_mayBeDescribed = true;
    Value v = value(key, keyRange, equals);
    m_mayBeDescribed = false;
    return v;
}

/// Whether the current word is a key whose `=` is missing: it begins with a capital letter and has a value behind it. Only capital
/// words, and words after a gap, are one text without quotes.
bool ValueParser::keyFollows(const Value& v, bool gaps) const {
    if (kind() != TokenKind::Word || newLine() || newLine(1) || startsItem() || namedBlock()) return false;
    const std::string_view word = text();
    const std::size_t dot = word.rfind('.');
    if (!isCapital(dot == std::string_view::npos ? word : word.substr(dot + 1))) return false;
    if (!std::ranges::all_of(word, [](char c) { return isIdent(c) || c == '.'; })) return false;
    switch (kind(1)) {
    case TokenKind::Number:
    case TokenKind::String:
    case TokenKind::ParamRef:
    case TokenKind::ExprOpen: break;
    case TokenKind::Word:
        if (startsItem(1)) return false;
        break;
    default: return false;
    }
    const auto isWord = [](const Element& e) { return e.kind == Element::Kind::Word; };
    if (kind(1) != TokenKind::Word || text(1) == "true" || text(1) == "false" || !std::ranges::all_of(v.elements, isWord))
        return true;
    const bool capital = dot == std::string_view::npos && isCapital(text(1)) &&
                         std::ranges::all_of(v.elements, [&](const Element& e) { return isCapital(e.text); });
    return !capital && !gaps;
}

/// True if another element follows. The current token is the one after an element.
bool ValueParser::afterElement(Value& v, std::vector<TextRange>& gaps) {
    if (kind() == TokenKind::Comma) {
        advance();
        return true;
    }
    const bool semicolon = kind() == TokenKind::Unknown && text() == ";" && !newLine() && !newLine(1);
    const bool isWord = kind(1) == TokenKind::Word && !startsItem(1) && v.elements.back().kind == Element::Kind::Word;
    if (semicolon && (kind(1) == TokenKind::Number || kind(1) == TokenKind::ParamRef || kind(1) == TokenKind::ExprOpen ||
                      kind(1) == TokenKind::String || isWord)) {
        gaps.push_back(range());
        advance();
        return true;
    }
    if (newLine() || atEnd() || !(startsElement() && !namedBlock())) return false;
    const std::uint32_t end = v.elements.back().range.end;
    gaps.push_back({end, end});
    return true;
}

bool ValueParser::element(Value& v) {
    Element e;
    e.range = range();
    switch (kind()) {
    case TokenKind::Number: numberElement(e, v); break;
    case TokenKind::String: stringElement(e, v); break;
    case TokenKind::ExprOpen: m_expressions.element(e, v); break;
    case TokenKind::ParamRef:
        e.kind = Element::Kind::ParamRef;
        e.text = text().substr(1);
        advance();
        break;
    case TokenKind::Word:
        if (startsItem() && !(m_mayBeDescribed && !newLine() && kind(1) == TokenKind::OpenBrace)) return false;
        wordElement(e);
        break;
    case TokenKind::Plus:
    case TokenKind::Minus:
        if (kind(1) != TokenKind::Number && kind(1) != TokenKind::ParamRef && kind(1) != TokenKind::ExprOpen &&
            kind(1) != TokenKind::Word)
            return false;
        if (newLine(1)) return false;
        m_errors.signedElement(e, v);
        break;
    case TokenKind::OpenBrace:
        if (kind(1) != TokenKind::OpenBrace || !adjacent(1)) return false;
        m_errors.doubleBraces(e, v);
        break;
    case TokenKind::OpenParen:
        if (termInParens() == 0) return false;
        m_errors.arithmetic(e, v);
        break;
    case TokenKind::Dot:
    case TokenKind::Slash:
    case TokenKind::Star: m_errors.unquotedText(e, v); break;
    case TokenKind::Unknown:
        if (wrongEquals(0) || text() == ";" || text() == "]" || text() == "[" || text() == "*/") return false;
        if (isBracedParam(text())) m_errors.bracedParam(e, v);
        else if (text() == "$" && kind(1) == TokenKind::Word && !newLine(1) && std::ranges::all_of(text(1), isIdent))
            m_errors.spacedParam(e, v);
        else if (foreignQuoteEnd(bytes(), range().begin) == range().end) m_errors.foreignQuotes(e, v);
        else m_errors.unquotedText(e, v);
        break;
    default: return false;
    }
    m_errors.continuesAt(e, v);
    v.elements.push_back(std::move(e));
    return true;
}

void ValueParser::wordElement(Element& e) {
    e.text = text();
    e.kind = e.text == "true" || e.text == "false" ? Element::Kind::Boolean : Element::Kind::Word;
    e.boolean = e.text == "true";
    advance();
    const bool foreign = std::any_of(e.text.begin(), e.text.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    if (!foreign || (adjacent() && kind() == TokenKind::Unknown)) return; // the text continues and is reported as a whole
    Diagnostic& d = error(Code::UnexpectedText, e.range, "a word with other letters than A-Z and a-z needs double quotes");
    fix(d, "\"" + e.text + "\"", {edit(e.range, "\"" + e.text + "\"")});
    e.kind = Element::Kind::String;
}

void ValueParser::numberElement(Element& e, Value& v) {
    e.kind = Element::Kind::Number;
    const TextRange digits = range();
    if (slice(digits).starts_with(kUnicodeMinus))
        unicodeMinus({digits.begin, digits.begin + static_cast<std::uint32_t>(kUnicodeMinus.size())});
    const std::string plain = plainNumber(slice(digits));
    const auto [end, fault] = std::from_chars(plain.data(), plain.data() + plain.size(), e.number);
    if (fault == std::errc::result_out_of_range) {
        e.number = 0;
        if (!isTiny(plain)) {
            error(Code::BadNumber, digits, "this number is too large");
            v.broken = true;
        }
    } else if (fault != std::errc() || end != plain.data() + plain.size()) {
        error(Code::BadNumber, digits, "`" + plain + "` is no number");
        v.broken = true;
    }
    e.number = notBelow(plain, e.number);
    advance();
    if (kind() != TokenKind::Unit) return;
    e.unit = text();
    e.unitRange = range();
    e.range.end = range().end;
    if (adjacent()) m_errors.checkNumberTail(e, v);
    struct Sign {
        std::string_view written, unit;
    };
    constexpr Sign kSigns[] = {{"\u00B0", "deg"}, {"\u03A9", "ohm"}, {"\u2126", "ohm"}, {"\u00B5m", "um"},
                               {"\u03BCm", "um"}, {"\u00B5s", "us"}, {"\u03BCs", "us"}};
    for (const Sign& sign : kSigns) {
        if (e.unit != sign.written) continue;
        Diagnostic& d = error(Code::UnknownUnit, e.unitRange, "the unit `" + e.unit + "` is written " + std::string(sign.unit));
        fix(d, std::string(sign.unit), {edit(e.unitRange, std::string(sign.unit))});
        e.unit = sign.unit;
    }
    advance();
    m_errors.unitWithoutPower(e);
}

void ValueParser::stringElement(Element& e, Value& v) {
    e.kind = Element::Kind::String;
    const std::string_view written = text();
    const bool closed = isClosedString(written);
    const std::string_view inner = written.substr(1, written.size() - (closed ? 2 : 1));
    for (std::size_t i = 0; i < inner.size(); ++i) {
        if (inner[i] != '\\' || i + 1 == inner.size()) {
            e.text += inner[i];
            continue;
        }
        const char c = inner[++i];
        if (c == 'n' || c == '"' || c == '\\') {
            e.text += c == 'n' ? '\n' : c;
            continue;
        }
        const std::uint32_t at = e.range.begin + 1 + static_cast<std::uint32_t>(i) - 1;
        Diagnostic& d = error(Code::UnexpectedText, {at, at + 1}, "a lone \\ in a string; there are \\\\, \\\" and \\n");
        fix(d, "\\\\", {edit({at, at + 1}, "\\\\")});
        e.text += '\\';
        e.text += c;
    }
    if (closed) return advance();
    v.broken = true;
    const std::size_t quote = quoteBelow(bytes(), range());
    if (quote == std::string_view::npos) openString(e);
    else stringOfLines(e, quote);
}

void ValueParser::openString(Element& e) {
    // The quote belongs before the end of the block, the trailing spaces and the comment in the line.
    const std::string_view written = text();
    const std::size_t length = std::min({written.find(" //"), written.find(" }"), written.size()});
    std::uint32_t end = e.range.begin + static_cast<std::uint32_t>(length);
    while (end > e.range.begin + 1 && isBlank(bytes()[end - 1])) --end;
    Diagnostic& d = error(Code::UnclosedString, {e.range.begin, end}, "this string lacks its closing quote");
    fix(d, "add `\"`", {edit({end, end}, "\"")});
    advance();
}

/// `quote`: where it ends, in a line below.
void ValueParser::stringOfLines(Element& e, std::size_t quote) {
    Diagnostic& d = error(Code::UnclosedString, range(), "a string is written in one line; \\n in it begins another one");
    std::vector<TextEdit> edits;
    for (std::uint32_t at = range().end; at < quote; ++at) {
        const std::string_view rest = bytes().substr(at);
        const bool two = rest.starts_with("\r\n"), ends = two || rest[0] == '\n' || rest[0] == '\r';
        e.text += ends ? '\n' : rest[0];
        if (ends) edits.push_back(edit({at, at + (two ? 2 : 1)}, "\\n"));
        if (two) ++at;
    }
    fix(d, "put it in one line", std::move(edits));
    while (!atEnd() && range().begin <= quote) advance();
    e.range.end = static_cast<std::uint32_t>(quote) + 1;
}

} // namespace trundle
