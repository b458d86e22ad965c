#pragma once
// What every part of the parser works with: the tokens ahead and the diagnostics so far. Private to core/lang.

#include "lang/parsing/token_cursor.h"

namespace trundle {

class ParserPart {
protected:
    ParserPart(TokenCursor& tokens, SyntaxReporter& report) : m_tokens(tokens), m_report(report) {}

    [[nodiscard]] TokenKind kind(std::size_t ahead = 0) const { return m_tokens.kind(ahead); }
    [[nodiscard]] TextRange range(std::size_t ahead = 0) const { return m_tokens.range(ahead); }
    [[nodiscard]] std::string_view text(std::size_t ahead = 0) const { return m_tokens.text(ahead); }
    [[nodiscard]] Name name(std::size_t ahead = 0) const { return {std::string(text(ahead)), range(ahead)}; }
    [[nodiscard]] std::string_view slice(TextRange r) const { return m_tokens.source().slice(r); }
    [[nodiscard]] std::string_view bytes() const { return m_tokens.source().bytes(); }
    [[nodiscard]] bool newLine(std::size_t ahead = 0) const { return m_tokens.newLine(ahead); }
    [[nodiscard]] bool adjacent(std::size_t ahead = 0) const { return m_tokens.adjacent(ahead); }
    [[nodiscard]] TextRange previous() const { return m_tokens.previous(); }
    [[nodiscard]] bool atEnd() const { return m_tokens.atEnd(); }
    [[nodiscard]] std::size_t position() const { return m_tokens.position(); }
    [[nodiscard]] bool wrongEquals(std::size_t ahead) const { return m_tokens.wrongEquals(ahead); }
    [[nodiscard]] bool startsItem(std::size_t ahead = 0) const { return m_tokens.startsItem(ahead); }
    [[nodiscard]] bool startsElement() const { return m_tokens.startsElement(); }
    [[nodiscard]] bool namedBlock() const { return m_tokens.namedBlock(); }
    void advance() { m_tokens.advance(); }
    /// Whether the token touches the one before and may be meant as a part of one name with it: `r-1`.
    [[nodiscard]] bool isPieceOfName(std::size_t ahead) const {
        if (!adjacent(ahead)) return false;
        switch (kind(ahead)) {
        case TokenKind::Word:
        case TokenKind::Number:
        case TokenKind::Unit:
        case TokenKind::Dot:
        case TokenKind::Plus:
        case TokenKind::Minus:
        case TokenKind::Star:
        case TokenKind::Slash:
        case TokenKind::Caret: return true;
        case TokenKind::Unknown: return text(ahead) != ";" && !wrongEquals(ahead);
        default: return false;
        }
    }

    /// How many tokens ahead the first `{` of this line is; 0: it has none.
    [[nodiscard]] std::size_t braceInLine() const {
        constexpr std::size_t kFar = 40;
        for (std::size_t i = 1; i < kFar && !newLine(i) && kind(i) != TokenKind::End; ++i)
            if (kind(i) == TokenKind::OpenBrace) return i;
        return 0;
    }

    Diagnostic& error(Code code, TextRange r, std::string message) { return m_report.error(code, r, std::move(message)); }
    static void fix(Diagnostic& d, std::string title, std::vector<TextEdit> edits) {
        d.fixes.push_back({std::move(title), std::move(edits)});
    }
    [[nodiscard]] TextEdit edit(TextRange r, std::string text) const { return {{m_report.file(), r}, std::move(text)}; }
    void unicodeMinus(TextRange r) {
        fix(m_report.report(Severity::Warning, Code::UnicodeMinus, r, "typographic minus U+2212, read as -"), "-",
            {edit(r, "-")});
    }

    TokenCursor& m_tokens;
    SyntaxReporter& m_report;
};

} // namespace trundle
