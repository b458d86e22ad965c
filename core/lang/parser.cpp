#include "lang/parser.h"

#include <algorithm>

#include "base/spelling.h"
#include "lang/characters.h"
#include "lang/lexer.h"

namespace trundle {
namespace {

constexpr std::size_t kNearCut = 8; ///< tokens; an error this close to the end of parsing may be caused by it
constexpr int kMaxRuns = 4;         ///< the first run and three with an assumed `}`

bool isReserved(std::string_view word) { return word == "Param" || word == "true" || word == "false" || word == "world"; }

bool isName(std::string_view word) {
    return !word.empty() && isIdentStart(word[0]) && std::all_of(word.begin(), word.end(), isIdent);
}

} // namespace

Parser::Parser(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens)
    : m_source(std::move(source)), m_file(file), m_mostTokens(mostTokens), m_lexer(m_source->bytes()) {}

std::shared_ptr<const Tree> Parser::parse() {
    m_tree = std::make_shared<Tree>();
    m_tree->m_file = m_file;
    m_tree->m_source = m_source;
    const std::string_view bytes = m_source->bytes();
    if (const std::size_t first = bytes.find_first_of("\r\n"); first != std::string_view::npos)
        m_lineEnd = bytes.substr(first, bytes.substr(first, 2) == "\r\n" ? 2 : 1);
    if (isUtf16()) endTokens(Tree::Extent::Unrecoverable);
    else readTokens();
    run();
    for (int i = 1; i < kMaxRuns && m_tree->m_extent == Tree::Extent::Whole && assume(); ++i) {}
    std::stable_sort(m_diagnostics.begin(), m_diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.range.range.begin < b.range.range.begin; });
    m_tree->m_diagnostics = std::move(m_diagnostics);
    return m_tree;
}

/// Parses all tokens once.
void Parser::run() {
    m_at = 0;
    m_open.clear();
    m_suspects.clear();
    m_onOneLine.clear();
    m_diagnostics.clear();
    m_tree->m_items.clear();
    m_early.clear();
    m_unmatchedBraces = 0;
    m_unclosed = false;
    checkBytes();
    if (isUtf16()) return;
    items(m_tree->m_items, 0);
    checkInvisible();
    checkLongWords();
    checkComments();
}

const Token& Parser::token(std::size_t ahead) const {
    return m_tree->m_tokens[m_significant[std::min(m_at + ahead, m_significant.size() - 1)].token];
}

bool Parser::newLine(std::size_t ahead) const { return m_significant[std::min(m_at + ahead, m_significant.size() - 1)].newLine; }

bool Parser::adjacent(std::size_t ahead) const {
    return m_at + ahead > 0 && m_at + ahead < m_significant.size() &&
           token(ahead).range.begin == m_tree->m_tokens[m_significant[m_at + ahead - 1].token].range.end;
}

TextRange Parser::previous() const { return m_at == 0 ? TextRange{} : m_tree->m_tokens[m_significant[m_at - 1].token].range; }

bool Parser::wrongEquals(std::size_t ahead) const {
    if (kind(ahead) != TokenKind::Unknown) return false;
    const std::string_view sign = text(ahead);
    if (sign == "==" || sign == ":=") return true;
    const std::size_t after = range(ahead).end;
    const std::string_view bytes = m_source->bytes();
    return sign == ":" && !(after < bytes.size() && (bytes[after] == '/' || bytes[after] == '\\'));
}

bool Parser::startsItem() const {
    if (kind() != TokenKind::Word) return false;
    if (text() == "Param" || kind(1) == TokenKind::Equals || kind(1) == TokenKind::OpenBrace || wrongEquals(1)) return true;
    constexpr std::size_t kLongestPath = 64;
    std::size_t i = 1;
    while (i < 2 * kLongestPath && kind(i) == TokenKind::Dot && kind(i + 1) == TokenKind::Word && adjacent(i) && adjacent(i + 1))
        i += 2;
    return i > 1 && kind(i) == TokenKind::Equals;
}

Diagnostic& Parser::report(Severity severity, Code code, TextRange r, std::string message) {
    if (m_diagnostics.size() > kMaxDiagnostics || isCutOff(r)) return m_unreported = {};
    if (m_diagnostics.size() == kMaxDiagnostics) {
        code = Code::TooManyMistakes;
        message = "too many mistakes, the rest of this file is not reported";
        severity = Severity::Error;
    }
    Diagnostic& d = m_diagnostics.emplace_back();
    d.severity = severity;
    d.code = code;
    d.message = std::move(message);
    d.range = {m_file, r};
    return d;
}

/// Whether an error may only be caused by parsing having stopped there.
bool Parser::isCutOff(TextRange r) const {
    if (m_tree->m_extent == Tree::Extent::Whole || m_significant.size() <= kNearCut) return false;
    return r.begin >= m_tree->m_tokens[m_significant[m_significant.size() - kNearCut].token].range.begin;
}

Diagnostic* Parser::lastAt(TextRange r) {
    return !m_diagnostics.empty() && m_diagnostics.back().range.range == r ? &m_diagnostics.back() : nullptr;
}

void Parser::fix(Diagnostic& d, std::string title, std::vector<TextEdit> edits) const {
    d.fixes.push_back({std::move(title), std::move(edits)});
}

Name Parser::name(std::size_t ahead) const { return {std::string(text(ahead)), range(ahead)}; }

void Parser::rejectReserved(const Name& name, std::string_view use) {
    if (isReserved(name.text))
        error(Code::ReservedWord, name.range, "`" + name.text + "` is reserved and cannot be " + std::string(use));
    else if (!isName(name.text))
        error(Code::UnexpectedText, name.range, "`" + name.text + "` cannot be " + std::string(use) + ": only A-Z a-z 0-9 and _");
}

void Parser::items(std::vector<Item>& out, int depth) {
    while (!atEnd()) {
        m_itemAt = m_at;
        if (depth > 0 && closedHere(m_open.back())) return;
        if (depth > 0 && foreignClose()) return;
        if (depth > 0) recordIndent();
        switch (kind()) {
        case TokenKind::CloseBrace:
            if (depth > 0 && !ignoredBrace()) return;
            strayBrace(depth > 0);
            break;
        case TokenKind::Directive: directive(out); break;
        case TokenKind::Word: item(out, depth); break;
        default: unexpected(depth); break;
        }
    }
}

void Parser::item(std::vector<Item>& out, int depth) {
    const TokenKind second = kind(1);
    const auto opensBlock = [this](std::size_t i) { // `chassis = { Mass=1 }`; with a number inside, it is a list in braces
        return (kind(i) == TokenKind::Equals || wrongEquals(i)) && kind(i + 1) == TokenKind::OpenBrace &&
               (kind(i + 2) == TokenKind::Word || kind(i + 2) == TokenKind::CloseBrace);
    };
    if (text() == "Param" && second == TokenKind::Word) return param(out);
    if (second == TokenKind::OpenBrace) return block(out, depth, 0);
    if (second == TokenKind::Word && kind(2) == TokenKind::OpenBrace) return block(out, depth, 1);
    for (std::size_t i = 1; i <= (second == TokenKind::Word ? 2u : 1u); ++i) {
        if (!opensBlock(i)) continue;
        Diagnostic& d = error(Code::UnexpectedText, range(i), "a block has no `=` before its `{`");
        fix(d, "remove `=`", {edit(range(i), "")});
        return block(out, depth, i);
    }
    if (second == TokenKind::Equals || second == TokenKind::Dot || wrongEquals(1)) return assignment(out);
    strayWord(out, depth);
}

void Parser::assignment(std::vector<Item>& out) {
    AssignmentItem node;
    const std::uint32_t begin = range().begin;
    node.path.push_back(name());
    advance();
    while (kind() == TokenKind::Dot && kind(1) == TokenKind::Word && !newLine() && !newLine(1)) {
        node.path.push_back(name(1));
        advance();
        advance();
    }
    node.pathRange = {begin, node.path.back().range.end};
    if (kind() == TokenKind::OpenBrace) {
        error(Code::UnexpectedText, node.pathRange,
              "a block has no dotted name; to change a property write `" + std::string(slice(node.pathRange)) +
                  ".Property = value`");
        advance();
        return skipBlockBody();
    }
    if (kind() != TokenKind::Equals && !wrongEquals(0)) {
        Diagnostic& d =
            error(Code::UnexpectedText, node.pathRange, "`=` expected after `" + std::string(slice(node.pathRange)) + "`");
        if (kind() == TokenKind::Dot) d.range.range.end = range().end;
        // The rest of the line belongs to the unreadable text.
        while (!atEnd() && !newLine() && !startsItem() && !namedBlock() && kind() != TokenKind::CloseBrace &&
               kind() != TokenKind::OpenBrace && kind() != TokenKind::Directive)
            advance();
        return;
    }
    for (const Name& part : node.path) rejectReserved(part, "a key");
    if (wrongEquals(0)) {
        Diagnostic& d = error(Code::UnexpectedText, range(), "`=` expected, not `" + std::string(text()) + "`");
        fix(d, "=", {edit(range(), text() == ":" && !adjacent() ? "=" : text() == ":" ? " =" : "=")});
    }
    const TextRange equals = range();
    advance();
    const std::string path(slice(node.pathRange));
    const TextRange pathRange = node.pathRange;
    node.value = value(path, pathRange, equals);
    out.push_back({{begin, std::max(equals.end, node.value.range.end)}, std::move(node)});
}

void Parser::param(std::vector<Item>& out) {
    ParamItem node;
    const std::uint32_t begin = range().begin;
    advance();
    node.name = name();
    rejectReserved(node.name, "a Param");
    advance();
    if (kind() == TokenKind::OpenBrace) {
        error(Code::UnexpectedText, node.name.range, "a Param is no block; write `Param " + node.name.text + " = value`");
        advance();
        return skipBlockBody();
    }
    TextRange equals = {node.name.range.end, node.name.range.end};
    if (kind() == TokenKind::Equals) {
        equals = range();
        advance();
    } else {
        const bool wrong = wrongEquals(0);
        Diagnostic& d = error(Code::UnexpectedText, wrong ? range() : node.name.range,
                              wrong ? "`=` expected, not `" + std::string(text()) + "`"
                                    : "`=` expected after `Param " + node.name.text + "`");
        if (wrong) fix(d, "=", {edit(range(), "=")});
        else if (!newLine() && startsElement()) fix(d, node.name.text + " =", {edit({equals.end, equals.end}, " =")});
        if (wrong) {
            equals = range();
            advance();
        } else if (newLine() || !startsElement()) {
            return;
        }
    }
    const std::string key = node.name.text;
    node.value = value(key, node.name.range, equals);
    out.push_back({{begin, std::max(equals.end, node.value.range.end)}, std::move(node)});
}

/// `Type {`, with `extra` tokens before the brace: a name, or unexpected tokens that were already reported.
void Parser::block(std::vector<Item>& out, int depth, std::size_t extra) {
    BlockItem node;
    const std::uint32_t begin = range().begin;
    OpenBlock open;
    open.indent = indentOf(begin);
    node.type = name();
    if (isReserved(node.type.text) || !isName(node.type.text)) rejectReserved(node.type, "a kind");
    advance();
    if (extra > 0 && kind() != TokenKind::Equals && !wrongEquals(0)) {
        const bool two = extra > 1 && kind(1) != TokenKind::Equals && !wrongEquals(1);
        const TextRange r{range().begin, range(two ? extra - 1 : 0).end};
        node.name = {std::string(slice(r)), r};
        if (kind() == TokenKind::String) std::erase(node.name->text, '"');
        if (kind() == TokenKind::Word && !two) rejectReserved(*node.name, "a name"); // otherwise it was already reported
    }
    for (std::size_t i = 0; i < extra; ++i) advance();
    open.name = node.name ? node.name->range : node.type.range;
    open.openAt = static_cast<std::uint32_t>(m_at);
    open.bracket = kind() != TokenKind::OpenBrace;
    if (open.bracket) {
        Diagnostic& d =
            error(Code::UnexpectedText, range(), "a block is written in { }, not in " + std::string(text() == "[" ? "[ ]" : "( )"));
        fix(d, "{", {edit(range(), "{")});
        if (!m_diagnostics.empty() && &d == &m_diagnostics.back()) open.bracketFault = m_diagnostics.size();
    }
    node.open = range();
    advance();
    if (depth + 1 > kMaxBlockDepth) {
        error(Code::TooDeep, node.type.range, "blocks nest deeper than " + std::to_string(kMaxBlockDepth));
        skipBlockBody();
        node.close = previous();
    } else {
        m_open.push_back(open);
        blockBody(node, depth);
        m_open.pop_back();
    }
    out.push_back({{begin, std::max(node.close.end, node.open.end)}, std::move(node)});
}

void Parser::blockBody(BlockItem& node, int depth) {
    items(node.items, depth + 1);
    const OpenBlock& open = m_open.back();
    if (foreignClose() && !closedHere(open)) {
        node.close = range();
        if (open.bracketFault > 0) {
            Fix& both = m_diagnostics[open.bracketFault - 1].fixes.back();
            both.title = "{ }";
            both.edits.push_back(edit(range(), "}"));
        }
        advance();
        return;
    }
    if (kind() == TokenKind::CloseBrace && !closedHere(open)) {
        node.close = range();
        advance();
        recordEarlyClose(open.indent, m_at - 1);
        return;
    }
    const std::uint32_t end = previous().end;
    node.close = {end, end};
    reportUnclosed(open, atEnd() ? static_cast<std::uint32_t>(m_source->bytes().size()) : range().begin);
}

/// Skips to the `}` of a block whose `{` has been consumed, without parsing its content.
void Parser::skipBlockBody() {
    std::size_t depth = 1;
    while (!atEnd() && depth > 0) {
        if (kind() == TokenKind::OpenBrace) ++depth;
        if (kind() == TokenKind::CloseBrace) --depth;
        advance();
    }
}

void Parser::directive(std::vector<Item>& out) {
    const TextRange word = range();
    std::string_view written = text();
    const std::uint32_t line = word.begin;
    std::string meant(written);
    if (written != "#import" && written != "#loadModule") {
        std::vector<std::string> known{"#import", "#loadModule"};
        const bool include =
            written.size() == 8 && (written[1] == 'i' || written[1] == 'I') && (written[3] == 'c' || written[3] == 'C');
        std::vector<std::string> near = include ? std::vector<std::string>{"#import"} : nearestWords(written, known, 1);
        Diagnostic& d = error(Code::UnexpectedText, word,
                              near.empty() ? "unknown directive `" + std::string(written) +
                                                 "`, there are #import and #loadModule; a comment begins with //"
                                           : "unknown directive `" + std::string(written) + "`");
        d.suggestions = near;
        if (!near.empty()) fix(d, near[0], {edit(word, near[0])});
        meant = near.empty() ? "" : near[0];
    } else if (!newLine()) {
        Diagnostic& d = error(Code::DirectivePlace, word, "`" + meant + "` must come first on its line");
        std::uint32_t blanks = line;
        while (blanks > 0 && (m_source->bytes()[blanks - 1] == ' ' || m_source->bytes()[blanks - 1] == '\t')) --blanks;
        std::vector<TextEdit> edits{edit({blanks, line}, lineEnd())};
        if (kind(1) == TokenKind::Path && kind(2) != TokenKind::End && !newLine(2))
            edits.push_back(edit({range(1).end, range(1).end}, lineEnd()));
        fix(d, "put it on a line of its own", std::move(edits));
    }
    advance();
    if (kind() != TokenKind::Path) {
        if (!meant.empty()) error(Code::MissingValue, word, "`" + meant + "` needs a path");
        return;
    }
    auto [path, pathRange] = directivePath(word);
    const std::uint32_t end = range().end;
    advance();
    if (path.empty() || meant.empty()) return;
    if (meant == "#import") out.push_back({{word.begin, end}, ImportItem{std::move(path), pathRange}});
    else out.push_back({{word.begin, end}, ModuleItem{std::move(path), pathRange}});
}

std::pair<std::string, TextRange> Parser::directivePath(TextRange directive) {
    const TextRange r = range();
    std::string path(text());
    const auto unquoted = [&] { return path.size() < 2 ? std::string() : path.substr(1, path.size() - 2); };
    if (path[0] == '"') {
        if (path.size() > 1 && path.back() == '"') {
            path = unquoted();
            if (path.empty()) error(Code::MissingValue, r, "`" + std::string(slice(directive)) + "` needs a path");
            return {path, r};
        }
        Diagnostic& d = error(Code::UnclosedString, r, "the path lacks its closing quote");
        fix(d, "add `\"`", {edit({r.end, r.end}, "\"")});
        return {path.substr(1), r};
    }
    const bool angled = path[0] == '<' && path.back() == '>';
    const bool single = path[0] == '\'' && path.back() == '\'' && path.size() > 1;
    if (angled || single) {
        path = unquoted();
        Diagnostic& d = error(Code::UnexpectedText, r, "a path is written bare or in double quotes");
        fix(d, path, {edit(r, path)});
        return {path, r};
    }
    if (path.back() == ';') {
        Diagnostic& d = error(Code::UnexpectedText, {r.end - 1, r.end}, "no `;` is needed");
        fix(d, "remove `;`", {edit({r.end - 1, r.end}, "")});
        path.pop_back();
        return {path, {r.begin, r.end - 1}};
    }
    return {path, r};
}

} // namespace trundle
