#include "editor/text/code/code_styling.h"

#include <algorithm>
#include <vector>

#include "lang/lexer.h"

namespace trundle {

using Sci = QsciScintillaBase;

void CodeStyling::setPlain(bool plain) {
    m_plain = plain;
    m_stale = true;
    m_styles = {};
}

void CodeStyling::setLanguage(CodeLanguage language) {
    m_language = language;
    m_stale = true;
    useLexer(m_edit, m_plain ? CodeLanguage::None : language);
}

void CodeStyling::update() {
    const bool isOurs = !m_plain && m_language == CodeLanguage::Trundle;
    // The widget may scroll, and need styles, before it reports what was inserted or deleted; each of these changes the length.
    if (!m_stale && (!isOurs || m_styles.size() == static_cast<std::size_t>(m_text.size()))) return;
    m_stale = false;
    if (!isOurs) return;
    const std::string_view text = m_text.view();
    const std::vector<Token> tokens = Lexer(text).lex();
    m_styles = stylesOf(text, tokens);
    const std::vector<FoldLine> lines = foldLinesOf(text, tokens);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int level = std::min(Sci::SC_FOLDLEVELBASE + lines[i].level, static_cast<int>(Sci::SC_FOLDLEVELNUMBERMASK)) |
                          (lines[i].opens ? Sci::SC_FOLDLEVELHEADERFLAG : 0);
        if (m_edit.SendScintilla(Sci::SCI_GETFOLDLEVEL, static_cast<unsigned long>(i)) != level)
            m_edit.SendScintilla(Sci::SCI_SETFOLDLEVEL, static_cast<unsigned long>(i), static_cast<long>(level));
    }
}

void CodeStyling::styleUpTo(int position) {
    constexpr long kLinesBefore = 3; // the style of a word may depend on the next line
    if (m_language != CodeLanguage::Trundle) return;
    update();
    const long styled = m_edit.SendScintilla(Sci::SCI_GETENDSTYLED);
    const long line =
        std::max(0L, m_edit.SendScintilla(Sci::SCI_LINEFROMPOSITION, static_cast<unsigned long>(styled)) - kLinesBefore);
    const auto from = static_cast<std::size_t>(m_edit.SendScintilla(Sci::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line)));
    const std::size_t to = std::min(static_cast<std::size_t>(std::max(0, position)), m_styles.size());
    if (from >= to) return;
    m_edit.SendScintilla(Sci::SCI_STARTSTYLING, static_cast<unsigned long>(from), 0L);
    m_edit.SendScintilla(Sci::SCI_SETSTYLINGEX, static_cast<unsigned long>(to - from), m_styles.data() + from);
}

TextStyle CodeStyling::styleAt(std::uint32_t offset) {
    update();
    const auto at = static_cast<std::size_t>(m_text.position(offset));
    return at < m_styles.size() ? static_cast<TextStyle>(m_styles[at]) : TextStyle::Plain;
}

void CodeStyling::foldEverything(bool folded) {
    update();
    m_edit.SendScintilla(Sci::SCI_FOLDALL,
                         static_cast<unsigned long>(folded ? Sci::SC_FOLDACTION_CONTRACT : Sci::SC_FOLDACTION_EXPAND));
}

} // namespace trundle
