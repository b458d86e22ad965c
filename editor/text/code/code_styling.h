#pragma once
// Colours and folds of a text, from the tokens of the language's own lexer. They are computed when the widget needs them.

#include <string>

#include "editor/text/code/code_text.h"
#include "editor/text/code/token_styles.h"

namespace trundle {

class CodeStyling {
public:
    /// Both must outlive this object.
    CodeStyling(QsciScintilla& edit, const CodeText& text) : m_edit(edit), m_text(text) {}

    void textChanged() { m_stale = true; }
    void setPlain(bool plain); ///< no colours and no folds: for large texts
    [[nodiscard]] bool isPlain() const { return m_plain; }

    void update(); ///< reads the tokens of a changed text, and folds it by them
    void styleUpTo(int position);
    [[nodiscard]] TextStyle styleAt(std::uint32_t offset); ///< for tests
    void foldEverything(bool folded);

private:
    QsciScintilla& m_edit;
    const CodeText& m_text;
    std::string m_styles; ///< of the text without the BOM
    bool m_plain = false;
    bool m_stale = true; ///< m_styles must be recomputed
};

} // namespace trundle
