#pragma once
// Colours and folds of a text, from the tokens of the language's own lexer, computed when the widget needs them; for other languages
// the widget's lexer makes them.

#include <string>

#include "editor/text/code/code_language.h"
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
    /// Of a text that is not plain. Other languages than Trundle's are coloured and folded by the widget itself.
    void setLanguage(CodeLanguage language);
    [[nodiscard]] CodeLanguage language() const { return m_language; }

    void update(); ///< reads the tokens of a changed text, and folds it by them
    void styleUpTo(int position);
    [[nodiscard]] TextStyle styleAt(std::uint32_t offset); ///< for tests
    void foldEverything(bool folded);

private:
    QsciScintilla& m_edit;
    const CodeText& m_text;
    std::string m_styles; ///< of the text without the BOM
    CodeLanguage m_language = CodeLanguage::Trundle;
    bool m_plain = false;
    bool m_stale = true; ///< m_styles must be recomputed
};

} // namespace trundle
