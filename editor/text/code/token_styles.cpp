#include "editor/text/code/token_styles.h"

#include <algorithm>

namespace trundle {
namespace {

/// Classifies words by their neighbouring tokens.
class Words {
public:
    Words(std::string_view text, const std::vector<Token>& tokens) : m_text(text), m_tokens(tokens) {
        for (std::size_t i = 0; i < tokens.size(); ++i)
            if (!isTrivia(tokens[i].kind)) m_significant.push_back(i);
    }

    /// Writes the style of each token into `styles`.
    void style(std::string& styles) {
        for (m_at = 0; m_at < m_significant.size(); ++m_at) {
            const Token& token = m_tokens[m_significant[m_at]];
            noteBrackets(token.kind);
            fill(styles, token, styleOf(token));
        }
        for (const Token& token : m_tokens)
            if (token.kind == TokenKind::LineComment || token.kind == TokenKind::BlockComment)
                fill(styles, token, TextStyle::Comment);
    }

private:
    static void fill(std::string& styles, const Token& token, TextStyle style) {
        const std::size_t end = std::min<std::size_t>(token.range.end, styles.size());
        for (std::size_t i = token.range.begin; i < end; ++i) styles[i] = static_cast<char>(style);
    }

    [[nodiscard]] TokenKind kind(std::ptrdiff_t ahead) const {
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(m_at) + ahead;
        if (at < 0 || at >= static_cast<std::ptrdiff_t>(m_significant.size())) return TokenKind::End;
        return m_tokens[m_significant[static_cast<std::size_t>(at)]].kind;
    }
    [[nodiscard]] std::string_view word(std::ptrdiff_t ahead) const {
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(m_at) + ahead;
        if (at < 0 || at >= static_cast<std::ptrdiff_t>(m_significant.size())) return {};
        const TextRange r = m_tokens[m_significant[static_cast<std::size_t>(at)]].range;
        return m_text.substr(r.begin, r.size());
    }

    void noteBrackets(TokenKind kind) {
        if (kind == TokenKind::ExprOpen || (m_parens > 0 && kind == TokenKind::OpenParen)) ++m_parens;
        if (kind == TokenKind::CloseParen && m_parens > 0) --m_parens;
        if (kind == TokenKind::OpenBrace || kind == TokenKind::CloseBrace || kind == TokenKind::Equals) m_parens = 0;
    }

    [[nodiscard]] TextStyle wordStyle() const {
        if (m_parens > 0) return kind(1) == TokenKind::OpenParen ? TextStyle::Keyword : TextStyle::Param;
        if (kind(-1) == TokenKind::Equals || kind(-1) == TokenKind::Comma)
            return word(0) == "true" || word(0) == "false" ? TextStyle::Keyword : TextStyle::Word;
        if (kind(-1) == TokenKind::Word && word(-1) == "Param" && kind(1) == TokenKind::Equals) return TextStyle::Name;
        if (word(0) == "Param" && kind(1) == TokenKind::Word) return TextStyle::Keyword;
        if (kind(1) == TokenKind::Equals || kind(1) == TokenKind::Dot || kind(-1) == TokenKind::Dot) return TextStyle::Key;
        if (kind(1) == TokenKind::OpenBrace) return m_afterKind ? TextStyle::Name : TextStyle::Kind;
        if (kind(1) == TokenKind::Word && kind(2) == TokenKind::OpenBrace) return TextStyle::Kind;
        return TextStyle::Plain;
    }

    [[nodiscard]] TextStyle styleOf(const Token& token) {
        switch (token.kind) {
        case TokenKind::Word: {
            const TextStyle style = wordStyle();
            m_afterKind = style == TextStyle::Kind && kind(1) == TokenKind::Word;
            return style;
        }
        case TokenKind::Number: return TextStyle::Number;
        case TokenKind::Unit: return TextStyle::Unit;
        case TokenKind::String: return TextStyle::String;
        case TokenKind::ParamRef: return TextStyle::Param;
        case TokenKind::ExprOpen: return TextStyle::Param;
        case TokenKind::Directive: return TextStyle::Directive;
        case TokenKind::Path: return TextStyle::Path;
        case TokenKind::Unknown: return TextStyle::Wrong;
        case TokenKind::End: return TextStyle::Plain;
        default: return TextStyle::Mark;
        }
    }

    std::string_view m_text;
    const std::vector<Token>& m_tokens;
    std::vector<std::size_t> m_significant;
    std::size_t m_at = 0;
    int m_parens = 0;
    bool m_afterKind = false; ///< the previous word is a kind, so a block name follows
};

/// The offsets at which lines begin.
std::vector<std::size_t> lineStarts(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'))) starts.push_back(i + 1);
    }
    return starts;
}

} // namespace

std::string stylesOf(std::string_view text, const std::vector<Token>& tokens) {
    std::string styles(text.size(), static_cast<char>(TextStyle::Plain));
    Words(text, tokens).style(styles);
    return styles;
}

std::vector<FoldLine> foldLinesOf(std::string_view text, const std::vector<Token>& tokens) {
    const std::vector<std::size_t> starts = lineStarts(text);
    std::vector<int> change(starts.size() + 1, 0); // change of the depth after each line
    std::vector<FoldLine> lines(starts.size());
    std::size_t line = 0;
    const auto lineOf = [&](std::size_t offset) {
        while (line + 1 < starts.size() && starts[line + 1] <= offset) ++line;
        return line;
    };
    std::vector<std::size_t> open;
    for (const Token& token : tokens) {
        if (token.kind == TokenKind::OpenBrace) open.push_back(lineOf(token.range.begin));
        std::size_t from = 0, to = 0;
        if (token.kind == TokenKind::CloseBrace && !open.empty()) {
            from = open.back();
            to = lineOf(token.range.begin);
            open.pop_back();
        } else if (token.kind == TokenKind::BlockComment) {
            from = lineOf(token.range.begin);
            to = lineOf(token.range.end - 1);
        }
        if (from >= to) continue;
        lines[from].opens = true;
        ++change[from + 1];
        --change[to + 1];
    }
    for (const std::size_t from : open) { // unclosed: up to the end
        if (from + 1 >= lines.size()) continue;
        lines[from].opens = true;
        ++change[from + 1];
    }
    int depth = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        depth += change[i];
        lines[i].level = depth;
    }
    return lines;
}

} // namespace trundle
