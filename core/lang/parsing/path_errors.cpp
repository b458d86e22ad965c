#include "lang/parsing/path_errors.h"

#include <algorithm>

#include "lang/characters.h"

namespace trundle {
namespace {

struct Path {
    std::string meant;
    bool member = false, all = false; ///< of a Repeat
};

/// What `m[0]/q` means, `m_0.q`; nothing if it is no path or written so.
Path meantBy(std::string_view written) {
    Path path;
    std::size_t i = 0;
    const auto digitsEnd = [written](std::size_t at) {
        while (at < written.size() && isDigit(written[at])) ++at;
        return at;
    };
    const auto takeNumber = [&](std::size_t begin) {
        const std::size_t end = digitsEnd(begin);
        path.meant += "_" + std::string(written.substr(begin, end - begin));
        path.member = true;
        return end;
    };
    while (i < written.size()) {
        const std::string_view rest = written.substr(i);
        const char next = rest.size() > 1 ? rest[1] : '\0';
        if (isIdent(rest[0])) {
            path.meant += rest[0];
            ++i;
        } else if (rest.starts_with("::") || rest.starts_with("->")) {
            path.meant += '.';
            i += 2;
        } else if (rest[0] == '[' && digitsEnd(i + 1) > i + 1) {
            i = takeNumber(i + 1) + 1;
        } else if (rest[0] == '.' && isDigit(next)) {
            i = takeNumber(i + 1);
        } else if (rest[0] == '*' || rest.starts_with(".*") || rest.starts_with("[*]")) {
            path.all = true;
            if (path.meant.ends_with('_')) path.meant.pop_back();
            i += rest[0] == '*' ? 1 : rest[0] == '.' ? 2 : 3;
        } else if (rest[0] == '.' || rest[0] == '/' || rest[0] == '\\') {
            path.meant += '.';
            ++i;
        } else {
            return {};
        }
    }
    return path.meant == written ? Path{} : path;
}

/// All `name` of `$name`, where no path follows, and of `Param name`.
std::unordered_set<std::string> paramsIn(std::string_view text) {
    std::unordered_set<std::string> names;
    constexpr std::string_view kParam = "Param ";
    for (std::size_t at = text.find_first_of("$P"); at != std::string_view::npos; at = text.find_first_of("$P", at + 1)) {
        if (text[at] == 'P' && text.substr(at, kParam.size()) != kParam) continue;
        const std::size_t begin = at + (text[at] == '$' ? 1 : kParam.size());
        std::size_t end = begin;
        while (end < text.size() && isIdent(text[end])) ++end;
        const bool isPath = text[at] == '$' && end + 1 < text.size() && text[end] == '.' && isIdent(text[end + 1]);
        if (!isPath && end > begin) names.emplace(text.substr(begin, end - begin));
    }
    return names;
}

std::string messageOf(const Path& path) {
    const std::string meant = "`" + path.meant + "`";
    if (path.all) return "what is meant for all members of a Repeat has no number and no `*`: " + meant;
    if (path.member) return "a member of a Repeat has its number behind `_`: " + meant;
    return "the names of a path have `.` between them: " + meant;
}

} // namespace

bool PathErrors::names(std::vector<Name>& out) {
    const std::string_view written = text();
    if (std::ranges::all_of(written, [](char c) { return isIdent(c) || static_cast<unsigned char>(c) >= 0x80; })) return false;
    const Path path = meantBy(written);
    if (path.meant.empty()) return false;
    Diagnostic& d = error(Code::UnexpectedText, range(), messageOf(path));
    fix(d, path.meant, {edit(range(), path.meant)});
    for (std::size_t at = 0, dot = 0; dot != std::string::npos; at = dot + 1) {
        dot = path.meant.find('.', at);
        out.push_back({path.meant.substr(at, dot - at), range()});
    }
    return true;
}

bool PathErrors::element(const Element& e, std::string_view written) {
    const bool foreign = written.find("::") != std::string_view::npos || written.find('[') != std::string_view::npos;
    if (!foreign || !isIdentStart(written[0])) return false;
    const Path path = meantBy(written);
    if (path.meant.empty()) return false;
    Diagnostic& d = error(Code::UnexpectedText, e.range, messageOf(path));
    fix(d, path.meant, {edit(e.range, path.meant)});
    return true;
}

/// The tokens that touch each other, `$( )` as a whole.
void PathErrors::skipRest() {
    int parens = 0;
    while (!atEnd() && !newLine() && (parens > 0 || adjacent()) && kind() != TokenKind::OpenBrace &&
           kind() != TokenKind::CloseBrace && (parens > 0 || kind() != TokenKind::Comma)) {
        if (kind() == TokenKind::Unknown && text() == ";") return;
        parens += kind() == TokenKind::ExprOpen || kind() == TokenKind::OpenParen ? 1 : kind() == TokenKind::CloseParen ? -1 : 0;
        advance();
    }
}

bool PathErrors::computed(Element& e, Value& v) {
    const bool dollar = kind() == TokenKind::ParamRef || kind() == TokenKind::ExprOpen || isBracedParam(text());
    const bool isWord = e.kind == Element::Kind::Word && dollar;
    const bool isExpression = e.kind == Element::Kind::Expression &&
                              (kind() == TokenKind::Word || (kind() == TokenKind::Dot && kind(1) == TokenKind::Word));
    if (!adjacent() || newLine() || (!isWord && !isExpression)) return false;
    skipRest();
    e.range.end = previous().end;
    error(Code::UnexpectedText, e.range,
          "a name is not computed in part; one of several is chosen by $(element(names, index)), with `Param names = a,b,c`");
    v.broken = true;
    return true;
}

/// Whether `$name` is also used alone, or declared.
bool PathErrors::isParam(const std::string& name) {
    if (!m_params) m_params = paramsIn(bytes());
    return m_params->contains(name);
}

bool PathErrors::behindParam(Element& e, Value& v) {
    if (e.kind != Element::Kind::ParamRef || kind() != TokenKind::Dot || !adjacent() || kind(1) != TokenKind::Word ||
        !adjacent(1))
        return false;
    const bool known = isParam(e.text);
    skipRest();
    e.range.end = previous().end;
    const std::string meant(slice({e.range.begin + 1, e.range.end}));
    Diagnostic& d = error(Code::UnexpectedText, e.range,
                          known ? "`$" + e.text + "` is a whole value: what is behind it belongs into the value of the Param"
                                : "a path is written without `$`: `" + meant + "`");
    if (!known) fix(d, meant, {edit(e.range, meant)});
    v.broken = true;
    return true;
}

} // namespace trundle
