#pragma once
// Marks in a text: problems, matches of a search, the selected block, a link.

#include <vector>

#include "base/diagnostic.h"
#include "editor/text/code/code_text.h"

namespace trundle {

/// Numbers by which QScintilla knows margins, indicators and markers; a line shows its highest marker.
enum CodeMargin { kNumberMargin = 0, kBlockMargin = 1, kSymbolMargin = 2, kFoldMargin = 3 };
enum CodeIndicator { kErrorRange = 8, kWarningRange = 9, kHintRange = 10, kMatchRange = 11, kBlockRange = 12, kLinkRange = 13 };
enum CodeMarker { kHintMark = 1, kWarningMark = 2, kErrorMark = 3, kBlockMark = 4 };

class CodeMarks {
public:
    /// Both must outlive this object.
    CodeMarks(QsciScintilla& edit, const CodeText& text) : m_edit(edit), m_text(text) {}

    void setBlocksShown(bool shown) { m_blocksShown = shown; } ///< false for large texts

    void showProblems(const std::vector<Diagnostic>& problems); ///< diagnostics of this text
    void showMatches(const std::vector<TextRange>& matches);
    void showBlock(TextRange block); ///< with a faint background; empty: none
    void showLink(TextRange link);   ///< underlines what Ctrl+click opens

private:
    void mark(int indicator, long from, long to);
    void mark(int indicator, TextRange range) { mark(indicator, m_text.position(range.begin), m_text.position(range.end)); }
    void clear(int indicator);

    QsciScintilla& m_edit;
    const CodeText& m_text;
    bool m_blocksShown = true;
};

} // namespace trundle
