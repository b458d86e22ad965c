#pragma once
#include "base/source_range.h"

namespace trundle {

enum class TokenKind {
    // trivia
    Bom,
    Space,
    LineEnd,
    LineComment,
    BlockComment,
    // words and values
    Word,   ///< names, keys, kinds and word values (which may contain . / \ -)
    Number, ///< without its unit
    Unit,
    String,
    ParamRef, ///< $name
    ExprOpen, ///< $(
    // punctuation
    OpenBrace,
    CloseBrace,
    OpenParen,
    CloseParen,
    Equals,
    Comma,
    Dot,
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Directive, ///< #import or #loadModule
    Path,      ///< the rest of a directive's line
    Unknown,   ///< bytes that match no rule; kept unchanged
    End,
};

/// Tokens cover a file without gaps: the first begins at 0, each begins where the last ended.
struct Token {
    TokenKind kind = TokenKind::Unknown;
    TextRange range;
};

[[nodiscard]] inline bool isTrivia(TokenKind kind) { return kind <= TokenKind::BlockComment; }

/// Whether a word, number, path or quoted text exceeds the length limit.
[[nodiscard]] inline bool isTooLong(const Token& token) {
    constexpr std::uint32_t kLongestWord = 4096, kLongestString = 65536; // bytes
    if (isTrivia(token.kind)) return false;
    return token.range.size() > (token.kind == TokenKind::String ? kLongestString : kLongestWord);
}

} // namespace trundle
