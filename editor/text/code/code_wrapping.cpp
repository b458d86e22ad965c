#include "editor/text/code/code_wrapping.h"

#include "editor/text/code/code_marks.h"

namespace trundle {

void CodeWrapping::setMode(WrapLines mode) {
    m_mode = mode;
    update();
}

void CodeWrapping::setPlain(bool plain) {
    m_plain = plain;
    update();
}

void CodeWrapping::update() {
    constexpr int kNarrow = 80; // columns
    int room = m_edit.viewport()->width();
    for (const int margin : {kNumberMargin, kBlockMargin, kSymbolMargin, kFoldMargin}) room -= m_edit.marginWidth(margin);
    const long column =
        m_edit.SendScintilla(QsciScintillaBase::SCI_TEXTWIDTH, static_cast<unsigned long>(QsciScintillaBase::STYLE_DEFAULT), "9");
    const bool narrow = room < kNarrow * column;
    const bool wraps = !m_plain && (m_mode == WrapLines::Always || (m_mode == WrapLines::InNarrowPanes && narrow));
    if (wraps == m_wraps) return;
    m_wraps = wraps;
    m_edit.setWrapMode(wraps ? QsciScintilla::WrapWhitespace : QsciScintilla::WrapNone);
    Q_EMIT changed();
}

} // namespace trundle
