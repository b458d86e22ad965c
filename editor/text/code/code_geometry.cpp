#include "editor/text/code/code_geometry.h"

#include <algorithm>

namespace trundle {

using Sci = QsciScintillaBase;

std::uint32_t CodeGeometry::offsetAt(const QPoint& pos) const {
    const long at =
        m_edit.SendScintilla(Sci::SCI_POSITIONFROMPOINTCLOSE, static_cast<unsigned long>(pos.x()), static_cast<long>(pos.y()));
    return at < 0 ? kNowhere : m_text.offset(at);
}

QPoint CodeGeometry::placeOf(std::uint32_t offset) const {
    const long at = m_text.position(offset);
    return {static_cast<int>(m_edit.SendScintilla(Sci::SCI_POINTXFROMPOSITION, 0UL, at)),
            static_cast<int>(m_edit.SendScintilla(Sci::SCI_POINTYFROMPOSITION, 0UL, at)) + lineHeight()};
}

int CodeGeometry::lineHeight() const { return static_cast<int>(m_edit.SendScintilla(Sci::SCI_TEXTHEIGHT, 0UL)); }

void CodeGeometry::scrollTo(TextRange range) {
    m_styling.update(); // knows the folds
    const unsigned long first = m_text.lineAt(range.begin), last = m_text.lineAt(range.end);
    m_edit.SendScintilla(Sci::SCI_ENSUREVISIBLE, first);
    const long top = m_edit.SendScintilla(Sci::SCI_GETFIRSTVISIBLELINE),
               rows = std::max(1L, m_edit.SendScintilla(Sci::SCI_LINESONSCREEN));
    const long from = m_edit.SendScintilla(Sci::SCI_VISIBLEFROMDOCLINE, first);
    const long to = m_edit.SendScintilla(Sci::SCI_VISIBLEFROMDOCLINE, last);
    if (from >= top && std::min(to, from + rows - 1) < top + rows) return;
    const long spare = std::max(0L, rows - (to - from + 1)) / 3; // places the range slightly above the middle
    m_edit.SendScintilla(Sci::SCI_SETFIRSTVISIBLELINE, static_cast<unsigned long>(std::max(0L, from - spare)));
}

} // namespace trundle
