#pragma once
// What lies at a place of a text: where blanks, comments, words, numbers and units end, and whether a word is a key. Has no state: the
// lexer decides what that means. All positions are byte offsets.

#include <string_view>

#include "lang/characters.h"

namespace trundle {

class TextScanner {
public:
    explicit TextScanner(std::string_view text) : m_text(text) {}

    [[nodiscard]] char at(std::size_t i) const { return i < m_text.size() ? m_text[i] : '\0'; }
    [[nodiscard]] bool startsWith(std::size_t i, std::string_view what) const {
        return m_text.compare(i, what.size(), what) == 0;
    }
    [[nodiscard]] bool commentAt(std::size_t i) const { return at(i) == '/' && (at(i + 1) == '/' || at(i + 1) == '*'); }
    [[nodiscard]] std::size_t lineEnd(std::size_t from) const;
    [[nodiscard]] std::size_t afterLineEnd(std::size_t i) const { return i + (at(i) == '\r' && at(i + 1) == '\n' ? 2 : 1); }
    [[nodiscard]] std::size_t blankLinesEnd(std::size_t from) const; ///< after the last consecutive blank line
    [[nodiscard]] std::size_t commentsEnd(std::size_t from) const;   ///< last line end within consecutive blanks and comments
    [[nodiscard]] std::size_t skipBlanks(std::size_t from) const;
    [[nodiscard]] std::size_t skipTrivia(std::size_t from) const;
    [[nodiscard]] std::size_t letterAt(std::size_t i) const; ///< bytes of the letter or digit at `i`; 0 for anything else
    [[nodiscard]] bool wordStartsAt(std::size_t i) const { return letterAt(i) > 0 && !isDigit(at(i)); }
    [[nodiscard]] std::size_t invisibleAt(std::size_t i) const; ///< bytes of the invisible character at `i`
    [[nodiscard]] std::size_t identEnd(std::size_t from) const;
    [[nodiscard]] std::size_t wordEnd(std::size_t from) const;
    [[nodiscard]] std::size_t numberEnd(std::size_t from, bool sign) const; ///< `from` if no number begins there
    /// End of a key path that is written as in another language, `m[0]/q =`; `from` if there is none.
    [[nodiscard]] std::size_t otherPathEnd(std::size_t from) const;
    [[nodiscard]] std::size_t unitEnd(std::size_t from) const;              ///< `from` if no unit begins there
    [[nodiscard]] std::size_t bracedParamEnd(std::size_t i) const; ///< after `${name}` of other languages; `i` if there is none
    /// True for a word before `=`, `.key =` or `{`: it begins a new item and is never part of a value.
    [[nodiscard]] bool isKeyOrKind(std::size_t from, std::size_t end) const;
    /// True for a kind as in `Kind name {`, where the kind ends at `end`.
    [[nodiscard]] bool isNamedBlock(std::size_t end) const;

private:
    /// True for a word with a capital letter, or a path to one, that has a value behind it on its line: its `=` is missing.
    [[nodiscard]] bool isKeyWithoutEquals(std::size_t from) const;
    [[nodiscard]] bool isReservedWord(std::size_t from, std::size_t end) const;

    std::string_view m_text;
};

} // namespace trundle
