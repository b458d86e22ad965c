#include "lang/parsing/directive_parser.h"

#include "base/spelling.h"

namespace trundle {

void DirectiveParser::directive(std::vector<Item>& out) {
    const TextRange word = range();
    std::string_view written = text();
    const std::uint32_t line = word.begin;
    std::string meant(written);
    std::size_t reported = 0; // 1-based index of the message about #include, to which the quotes of its path belong
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
        if (include) {
            d.message += "; another file is taken in by #import and its path";
            reported = m_report.indexOf(d);
        }
        meant = near.empty() ? "" : near[0];
    } else if (!newLine()) {
        Diagnostic& d = error(Code::DirectivePlace, word, "`" + meant + "` must come first on its line");
        std::uint32_t blanks = line;
        while (blanks > 0 && (bytes()[blanks - 1] == ' ' || bytes()[blanks - 1] == '\t')) --blanks;
        std::vector<TextEdit> edits{edit({blanks, line}, m_tokens.lineEnd())};
        if (kind(1) == TokenKind::Path && kind(2) != TokenKind::End && !newLine(2))
            edits.push_back(edit({range(1).end, range(1).end}, m_tokens.lineEnd()));
        fix(d, "put it on a line of its own", std::move(edits));
    }
    advance();
    if (kind() != TokenKind::Path) {
        if (!meant.empty()) error(Code::MissingValue, word, "`" + meant + "` needs a path");
        return;
    }
    auto [path, pathRange] = this->path(word, reported);
    const std::uint32_t end = range().end;
    advance();
    if (path.empty() || meant.empty()) return;
    if (meant == "#import") out.push_back({{word.begin, end}, ImportItem{std::move(path), pathRange}});
    else out.push_back({{word.begin, end}, ModuleItem{std::move(path), pathRange}});
}

std::pair<std::string, TextRange> DirectiveParser::path(TextRange directive, std::size_t reported) {
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
        if (reported > 0) {
            Fix& whole = m_report.at(reported).fixes.back();
            whole.title = "#import " + path;
            whole.edits.push_back(edit(r, path));
            return {path, r};
        }
        Diagnostic& d = error(Code::UnexpectedText, r, "a path is written bare or in double quotes");
        fix(d, path, {edit(r, path)});
        return {path, r};
    }
    if (path.back() == ';') {
        m_report.semicolon({r.end - 1, r.end});
        path.pop_back();
        return {path, {r.begin, r.end - 1}};
    }
    return {path, r};
}

} // namespace trundle
