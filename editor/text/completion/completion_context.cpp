#include "editor/text/completion/completion_context.h"

#include <algorithm>

#include "lang/characters.h"
#include "model/dotted_path.h"

namespace trundle {
namespace {

using Where = CompletionContext::Where;

class ContextParser {
public:
    ContextParser(const Tree& tree, std::uint32_t offset) : m_text(tree.source().bytes()), m_at(offset) {
        for (const Token& token : tree.tokens()) {
            if (token.range.begin >= offset || token.kind == TokenKind::End) break;
            m_touching = token;
            if (!isTrivia(token.kind)) m_before.push_back(token);
        }
    }

    CompletionContext updateMatches() {
        m_context.word = {m_at, m_at};
        if (directive()) return m_context;
        if (inComment()) return m_context;
        if (inString()) return m_context;
        takeWord();
        place();
        splitPath();
        return m_context;
    }

private:
    [[nodiscard]] std::string_view slice(TextRange r) const { return m_text.substr(r.begin, r.size()); }
    [[nodiscard]] TokenKind last(std::size_t back = 0) const {
        return back < m_before.size() ? m_before[m_before.size() - 1 - back].kind : TokenKind::End;
    }
    [[nodiscard]] const Token& token(std::size_t back) const { return m_before[m_before.size() - 1 - back]; }

    bool directive() {
        std::size_t begin = m_at;
        while (begin > 0 && m_text[begin - 1] != '\n' && m_text[begin - 1] != '\r') --begin;
        while (begin < m_at && isBlank(m_text[begin])) ++begin;
        if (begin >= m_at || m_text[begin] != '#') return false;
        if (m_touching.kind == TokenKind::BlockComment || m_touching.kind == TokenKind::LineComment) return false;
        std::size_t end = begin + 1;
        while (end < m_at && isIdent(m_text[end])) ++end;
        const std::string_view name = m_text.substr(begin + 1, end - begin - 1);
        if (end == m_at) {
            m_context.where = Where::DirectiveName;
            m_context.word.begin = static_cast<std::uint32_t>(begin);
            return true;
        }
        m_context.where = name == "import" ? Where::Import : name == "loadModule" ? Where::Module : Where::Nowhere;
        while (end < m_at && isBlank(m_text[end])) ++end;
        if (end < m_at && m_text[end] == '"') ++end;
        m_context.word.begin = static_cast<std::uint32_t>(end);
        return true;
    }

    /// True also directly after its last character.
    [[nodiscard]] bool inComment() const {
        return m_touching.kind == TokenKind::LineComment || m_touching.kind == TokenKind::BlockComment;
    }

    /// Only names in values may be quoted.
    bool inString() {
        if (m_touching.kind != TokenKind::String) return false;
        const std::string_view text = slice(m_touching.range);
        const bool closed = text.size() > 1 && text.ends_with('"');
        if (m_at >= m_touching.range.end && closed) return false;
        m_context.word = {m_touching.range.begin + 1, std::max(m_at, m_touching.range.end - (closed ? 1u : 0u))};
        m_context.quoted = true;
        m_before.pop_back();
        if (last() == TokenKind::Equals || last() == TokenKind::Comma) value();
        return true;
    }

    /// The word at the caret is the one being typed, not part of what precedes it.
    void takeWord() {
        if (!m_before.empty() && m_before.back().range.end >= m_at) takeToken();
        const std::uint32_t begin = m_context.word.begin;
        m_context.blank = begin > 0 && (isBlank(m_text[begin - 1]) || m_text[begin - 1] == '\n');
    }

    void takeToken() {
        const Token token = m_before.back();
        if (token.kind == TokenKind::Unknown && slice(token.range) == "$") {
            m_context.where = Where::ParamUse;
            m_context.word.begin = token.range.begin;
            m_before.pop_back();
        } else if (token.kind == TokenKind::ParamRef) {
            m_context.where = Where::ParamUse;
            m_context.word = {token.range.begin, token.range.end};
            m_before.pop_back();
        } else if (token.kind == TokenKind::Word || token.kind == TokenKind::Unit || token.kind == TokenKind::Unknown) {
            const std::string_view typed = m_text.substr(token.range.begin, m_at - token.range.begin);
            std::size_t begin = typed.size();
            while (begin > 0 && isIdent(typed[begin - 1])) --begin;
            std::size_t end = m_at;
            while (end < m_text.size() && isIdent(m_text[end])) ++end;
            m_context.word = {token.range.begin + static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
            m_context.before = std::string(typed.substr(0, begin));
            m_before.pop_back();
        }
        while (!m_before.empty() && m_before.back().kind == TokenKind::Unknown) m_before.pop_back();
    }

    [[nodiscard]] bool inExpression() const {
        int closed = 0;
        for (auto t = m_before.rbegin(); t != m_before.rend(); ++t) {
            switch (t->kind) {
            case TokenKind::CloseParen: ++closed; break;
            case TokenKind::OpenParen:
                if (closed > 0) --closed;
                break;
            case TokenKind::ExprOpen:
                if (closed == 0) return true;
                --closed;
                break;
            case TokenKind::Equals:
            case TokenKind::OpenBrace:
            case TokenKind::CloseBrace:
            case TokenKind::Directive: return false;
            default: break;
            }
        }
        return false;
    }

    /// Removes the value before the caret and reads its key.
    void value() {
        while (!m_before.empty() && last() != TokenKind::Equals) {
            if (last() == TokenKind::OpenBrace || last() == TokenKind::CloseBrace) return;
            m_before.pop_back();
        }
        if (m_before.empty()) return;
        m_before.pop_back();
        std::vector<std::string> words;
        while (last() == TokenKind::Word) {
            words.emplace_back(slice(token(0).range));
            m_before.pop_back();
            if (last() != TokenKind::Dot) break;
            m_before.pop_back();
        }
        if (words.empty()) return;
        std::reverse(words.begin(), words.end());
        m_context.ofParam = last() == TokenKind::Word && slice(token(0).range) == "Param";
        m_context.path = std::move(words);
        if (m_context.where == Where::Nowhere) m_context.where = Where::Value;
    }

    void place() {
        if (inExpression()) {
            m_context.where = Where::Expression;
            return;
        }
        if (m_context.where == Where::ParamUse) return value();
        switch (last()) {
        case TokenKind::Equals:
        case TokenKind::Comma: return value();
        case TokenKind::Number: return number();
        case TokenKind::Dot: return overriding();
        case TokenKind::Word: return afterWord();
        case TokenKind::ParamRef:
        case TokenKind::String:
        case TokenKind::Unit:
        case TokenKind::CloseParen: m_context.where = m_context.blank ? Where::Statement : Where::Nowhere; return;
        default: m_context.where = Where::Statement;
        }
    }

    /// `leftMotor.` may be a single token.
    void splitPath() {
        if (m_context.where != Where::Statement || m_context.before.empty()) return;
        m_context.where = m_context.before.ends_with('.') ? Where::Override : Where::Nowhere;
        const std::vector<std::string> words = DottedPath(m_context.before).words();
        m_context.path.insert(m_context.path.end(), words.begin(), words.end() - 1); // the last one is being typed
    }

    void number() {
        if (m_context.before.ends_with('.')) { // units contain no dots: `Pos=1,1,0 leftMotor.|`
            m_context.where = Where::Statement;
            return;
        }
        const std::uint32_t end = token(0).range.end;
        const std::string_view between = m_text.substr(end, m_context.word.begin - end);
        const bool sameLine = between.find_first_of("\r\n") == std::string_view::npos;
        m_context.where = sameLine ? Where::Nowhere : Where::Statement;
        m_context.blank = !between.empty();
        if (!sameLine) return;
        value();
        m_context.where = Where::Number;
    }

    void overriding() {
        std::vector<std::string> words;
        while (last() == TokenKind::Dot) {
            m_before.pop_back();
            if (last() != TokenKind::Word && last() != TokenKind::Unit) return; // after a number a word is lexed as its unit
            words.emplace_back(slice(token(0).range));
            m_before.pop_back();
        }
        std::reverse(words.begin(), words.end());
        m_context.path = std::move(words);
        m_context.where = Where::Override;
    }

    /// After a value that is a word a statement begins; after a single word a block name.
    void afterWord() {
        const bool value = last(1) == TokenKind::Equals || last(1) == TokenKind::Comma;
        const std::uint32_t end = token(0).range.end;
        const bool newLine = m_text.substr(end, m_context.word.begin - end).find_first_of("\r\n") != std::string_view::npos;
        if (value || newLine) m_context.where = Where::Statement;
    }

    std::string_view m_text;
    std::uint32_t m_at;
    Token m_touching;            ///< the last token that begins before the caret
    std::vector<Token> m_before; ///< without trivia
    CompletionContext m_context;
};

} // namespace

CompletionContext completionContext(const Tree& tree, std::uint32_t offset) {
    return ContextParser(tree, offset).updateMatches();
}

} // namespace trundle
