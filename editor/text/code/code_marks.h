#pragma once
// Marks in a text: problems, matches of a search, the selected block, a link.

#include <cstdint>
#include <vector>

#include "base/diagnostic.h"
#include "editor/text/code/qscintilla.h"

namespace trundle {

/// Numbers by which QScintilla knows margins, indicators and markers; a line shows its highest marker.
enum CodeMargin { kNumberMargin = 0, kBlockMargin = 1, kSymbolMargin = 2, kFoldMargin = 3 };
enum CodeIndicator { kErrorRange = 8, kWarningRange = 9, kHintRange = 10, kMatchRange = 11, kBlockRange = 12, kLinkRange = 13 };
enum CodeMarker { kHintMark = 1, kWarningMark = 2, kErrorMark = 3, kBlockMark = 4 };

class CodeMarks {
public:
    /// `edit` must outlive this object.
    explicit CodeMarks(QsciScintilla& edit) : m_edit(edit) {}

    void setBom(std::uint32_t bytes) { m_bom = bytes; }        ///< length of the hidden BOM, which offsets include
    void setBlocksShown(bool shown) { m_blocksShown = shown; } ///< false for large texts

    void showProblems(const std::vector<Diagnostic>& problems); ///< diagnostics of this text
    void showMatches(const std::vector<TextRange>& matches);
    void showBlock(TextRange block); ///< with a faint background; empty: none
    void showLink(TextRange link);   ///< underlines what Ctrl+click opens

private:
    [[nodiscard]] long position(std::uint32_t offset) const;
    [[nodiscard]] unsigned long lineAt(std::uint32_t offset) const;
    void mark(int indicator, long from, long to);
    void mark(int indicator, TextRange range) { mark(indicator, position(range.begin), position(range.end)); }
    void clear(int indicator);

    QsciScintilla& m_edit;
    std::uint32_t m_bom = 0;
    bool m_blocksShown = true;
};

} // namespace trundle
