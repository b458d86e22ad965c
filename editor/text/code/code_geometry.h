#pragma once
// Where on the screen the text stands, in viewport coordinates.

#include <QPoint>

#include "editor/text/code/code_styling.h"

namespace trundle {

class CodeGeometry {
public:
    static constexpr std::uint32_t kNowhere = 0xffffffffu;

    /// All must outlive this object.
    CodeGeometry(QsciScintilla& edit, const CodeText& text, CodeStyling& styling)
        : m_edit(edit), m_text(text), m_styling(styling) {}

    [[nodiscard]] std::uint32_t offsetAt(const QPoint& pos) const; ///< kNowhere outside the text
    [[nodiscard]] QPoint placeOf(std::uint32_t offset) const;      ///< below its line
    [[nodiscard]] int lineHeight() const;
    void scrollTo(TextRange range); ///< as little as needed; unfolds its first line; the caret does not move

private:
    QsciScintilla& m_edit;
    const CodeText& m_text;
    CodeStyling& m_styling;
};

} // namespace trundle
