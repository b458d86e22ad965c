#pragma once
// Recovery from unbalanced braces: which block is open, and where, according to the indentation, its `}` is missing. Private to
// core/lang.

#include <functional>
#include <optional>

#include "lang/parsing/parser_part.h"

namespace trundle {

/// A block whose `}` has not been read yet.
struct OpenBlock {
    TextRange name;               ///< its name, otherwise its kind
    std::uint32_t openAt = 0;     ///< position of `{`
    int indent = -1;              ///< of its line; -1 if it is not first on its line
    bool indentedItems = false;   ///< an item is indented deeper than the block, so indentation is meaningful
    bool inlineItems = false;     ///< an item is on the line of `{`
    bool description = false;     ///< of a Param
    bool byIndentation = false;   ///< it has no braces, its lines are indented deeper than it
    bool bracket = false;         ///< `[` or `(` was written instead of `{`
    std::size_t bracketFault = 0; ///< 1-based index of its diagnostic; 0: none
};

class BraceBalance : ParserPart {
public:
    BraceBalance(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    /// Forgets what the run before found; the corrections assumed so far hold.
    void beginRun();
    /// If braces do not balance, parses again (`run`) with each correction that indentation and text suggest, and last with the best
    /// one, so that one brace causes one diagnostic. False if no correction is better.
    [[nodiscard]] bool assume(const std::function<void()>& run);

    void open(const OpenBlock& block) { m_open.push_back(block); }
    void close() { m_open.pop_back(); }
    [[nodiscard]] const OpenBlock& innermost() const { return m_open.back(); }
    [[nodiscard]] bool isByIndentation() const { return !m_open.empty() && m_open.back().byIndentation; }
    [[nodiscard]] bool isInDescription() const { return !m_open.empty() && m_open.back().description; }

    [[nodiscard]] int indentOf(std::uint32_t offset) const; ///< -1 if it is not first on its line
    /// Records a suspected missing `}` if the token that begins an item or closes the block is indented less than the block's items.
    void recordIndent();
    /// Records a possibly premature `}`: an item after the block that starts a line and is indented deeper than the block may still
    /// belong to it.
    void recordEarlyClose(int indent, std::size_t brace);
    void recordUnmatched();
    /// Records that the word at this position, or the words from it on, may lack a `{`.
    void recordNoBrace(std::size_t position) { m_noBrace.push_back(static_cast<std::uint32_t>(position)); }
    [[nodiscard]] bool isOpened(std::size_t position) const; ///< a `{` is assumed there
    [[nodiscard]] bool isIgnored() const; ///< the current `}`
    /// True at `]` or `)` if the block was also opened with a bracket.
    [[nodiscard]] bool foreignClose() const;
    [[nodiscard]] bool closedHere(const OpenBlock& block) const;
    void reportUnclosed(const OpenBlock& block, std::uint32_t place);

private:
    /// A position where, according to the indentation, a `}` is missing.
    struct MissingBrace {
        std::uint32_t openAt, before;
    };
    /// What may repair the braces: one of these is set.
    struct Correction {
        std::optional<MissingBrace> missing;
        std::optional<std::uint32_t> ignored, opened; ///< a superfluous `}`; where a `{` is missing
    };
    /// How well the braces of a run fit: less is better.
    struct Fit {
        int unbalanced = 0;
        std::size_t diagnostics = 0, contradictions = 0; ///< contradictions: to the indentation
        auto operator<=>(const Fit&) const = default;
    };
    [[nodiscard]] std::vector<Correction> likely() const;
    void addUnclosed(std::vector<Correction>& out) const;
    void addUnopened(std::vector<Correction>& out) const;
    [[nodiscard]] Fit fit() const;
    void apply(const Correction& c, bool take);

    std::vector<OpenBlock> m_open;
    std::vector<MissingBrace> m_suspects;  ///< of this run
    std::vector<MissingBrace> m_onOneLine; ///< of this run: a block on one line followed by an item that is not indented deeper
    std::vector<MissingBrace> m_assumed;   ///< braces assumed to exist in this run
    std::vector<std::uint32_t> m_early;    ///< `}` of this run that may be premature
    std::vector<std::uint32_t> m_ignored;  ///< `}` ignored in this run
    std::vector<std::uint32_t> m_noBrace;  ///< of this run: words that may lack a `{`
    std::vector<std::uint32_t> m_opened;   ///< of these, those read as if they had it
    std::uint32_t m_firstUnmatched = 0;    ///< the first `}` of this run without an open block
    int m_unmatchedBraces = 0;             ///< their number
    int m_unclosed = 0;                    ///< number of blocks of this run that were not closed
};

} // namespace trundle
