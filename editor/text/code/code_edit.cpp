#include "editor/text/code/code_edit.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QInputMethodEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QToolTip>

#include "editor/text/code/code_appearance.h"
#include "editor/text/code/splice.h"

namespace trundle {

CodeEdit::CodeEdit(QWidget* parent) : QsciScintilla(parent) {
    setUtf8(true);
    SendScintilla(SCI_SETUNDOCOLLECTION, 0UL);
    SendScintilla(SCI_SETPASTECONVERTENDINGS, 1UL);
    SendScintilla(SCI_SETMULTIPLESELECTION, 0UL);
    SendScintilla(SCI_SETSCROLLWIDTHTRACKING, 1UL);
    SendScintilla(SCI_SETSCROLLWIDTH, 1UL);
    SendScintilla(SCI_SETLAYOUTCACHE, static_cast<unsigned long>(SC_CACHE_PAGE));
    setAutoCompletionSource(AcsNone);
    setCallTipsStyle(CallTipsNone);
    setBraceMatching(SloppyBraceMatch);
    setTabIndents(true);
    setBackspaceUnindents(true);
    setWays(m_lineEnd, m_step);
    chooseKeys(*this);
    buildMargins(*this);
    applyStyle();
    connect(this, &QsciScintillaBase::SCN_MODIFIED, this,
            [this](int at, int what, const char* text, int length) { onModified(at, what, text, length); });
    connect(this, &QsciScintillaBase::SCN_STYLENEEDED, this, [this](int position) { m_styling.styleUpTo(position); });
    connect(this, &QsciScintilla::linesChanged, this, &CodeEdit::fitNumberMargin);
    connect(this, &QsciScintillaBase::SCN_ZOOM, this, &CodeEdit::fitNumberMargin);
}

void CodeEdit::load(std::string_view bytes) {
    const QScopedValueRollback<bool> own(m_own, true);
    bytes = m_text.hideBom(bytes);
    const bool locked = isReadOnly();
    setReadOnly(false);
    const long notifications = SendScintilla(SCI_GETMODEVENTMASK);
    SendScintilla(SCI_SETMODEVENTMASK, 0UL); // QScintilla would convert both texts to a QString for its notifications
    const long wrapping = SendScintilla(SCI_GETWRAPMODE);
    SendScintilla(SCI_SETWRAPMODE, static_cast<unsigned long>(SC_WRAP_NONE)); // else all lines are laid out when they are added
    SendScintilla(SCI_CLEARALL);
    SendScintilla(SCI_ALLOCATE, static_cast<unsigned long>(bytes.size() + 1024));
    SendScintilla(SCI_ADDTEXT, static_cast<unsigned long>(bytes.size()), bytes.data());
    SendScintilla(SCI_SETWRAPMODE, static_cast<unsigned long>(wrapping));
    SendScintilla(SCI_SETMODEVENTMASK, static_cast<unsigned long>(notifications));
    SendScintilla(SCI_GOTOPOS, 0UL);
    setReadOnly(locked);
    m_styling.textChanged();
    m_lastCaret = m_lastAnchor = 0;
    fitNumberMargin();
}

void CodeEdit::setPlain(bool plain) {
    if (plain == m_styling.isPlain()) return;
    const QScopedValueRollback<bool> own(m_own, true);
    m_styling.setPlain(plain);
    m_marks.setBlocksShown(!plain);
    const long document = SendScintilla(SCI_CREATEDOCUMENT, 0UL,
                                        static_cast<long>(plain ? SC_DOCUMENTOPTION_STYLES_NONE : SC_DOCUMENTOPTION_DEFAULT));
    SendScintilla(SCI_SETDOCPOINTER, 0UL, document);
    SendScintilla(SCI_RELEASEDOCUMENT, 0UL, document); // the widget holds its own reference
    setUtf8(true);                                     // a setting of the document, not of the widget
    SendScintilla(SCI_SETUNDOCOLLECTION, 0UL);
    setWays(m_lineEnd, m_step);
    m_wrapping.setPlain(plain);
}

void CodeEdit::setLanguage(CodeLanguage language, bool plain) {
    setPlain(plain);
    m_styling.setLanguage(language);
    m_marks.setBlocksShown(!m_styling.isPlain() && language == CodeLanguage::Trundle);
    applyStyle();
}

std::uint32_t CodeEdit::bring(std::string_view bytes) {
    const QScopedValueRollback<bool> own(m_own, true);
    const std::vector<Splice> splices = splicesBetween(m_text.view(), m_text.hideBom(bytes));
    if (splices.empty()) return caret();
    const bool locked = isReadOnly();
    setReadOnly(false);
    const long topLine =
        SendScintilla(SCI_DOCLINEFROMVISIBLE, static_cast<unsigned long>(SendScintilla(SCI_GETFIRSTVISIBLELINE)));
    const long top = SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(topLine));
    for (auto s = splices.rbegin(); s != splices.rend(); ++s) {
        SendScintilla(SCI_SETTARGETRANGE, static_cast<unsigned long>(s->at), static_cast<long>(s->at + s->removed));
        SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(s->text.size()), s->text.data());
    }
    const auto newTop = static_cast<unsigned long>(movedOffset(static_cast<std::size_t>(top), splices));
    const long line = SendScintilla(SCI_LINEFROMPOSITION, newTop);
    if (line != topLine && splices.front().at < static_cast<std::size_t>(top))
        SendScintilla(SCI_SETFIRSTVISIBLELINE,
                      static_cast<unsigned long>(SendScintilla(SCI_VISIBLEFROMDOCLINE, static_cast<unsigned long>(line))));
    setReadOnly(locked);
    rememberCaret();
    const Splice& last = splices.back();
    return m_text.offset(static_cast<long>(movedOffset(last.at, {splices.begin(), splices.end() - 1}) + last.text.size()));
}

void CodeEdit::setWays(const std::string& lineEnd, const std::string& step) {
    m_lineEnd = lineEnd;
    m_step = step;
    SendScintilla(SCI_SETEOLMODE, static_cast<unsigned long>(lineEnd == "\r\n" ? SC_EOL_CRLF
                                                             : lineEnd == "\r" ? SC_EOL_CR
                                                                               : SC_EOL_LF));
    const bool tabs = step == "\t";
    setIndentationsUseTabs(tabs);
    setTabWidth(4);
    setIndentationWidth(tabs ? 0 : static_cast<int>(std::clamp<std::size_t>(step.size(), 1, 16)));
}

void CodeEdit::select(TextRange range, bool scroll) {
    const QScopedValueRollback<bool> own(m_own, true);
    SendScintilla(SCI_SETEMPTYSELECTION, static_cast<unsigned long>(m_text.position(range.end)));
    SendScintilla(SCI_SETANCHOR, static_cast<unsigned long>(m_text.position(range.begin)));
    if (scroll) m_geometry.scrollTo(range);
    rememberCaret();
}

void CodeEdit::onModified(int at, int what, const char* text, int length) {
    if (what & (SC_MOD_INSERTTEXT | SC_MOD_DELETETEXT)) m_styling.textChanged();
    if (m_own || m_composing || (what & SC_PERFORMED_UNDO)) return; // undo: an input method removes its preedit text
    if (!(what & (SC_MOD_INSERTTEXT | SC_MOD_DELETETEXT))) return;
    const std::string_view changed(text ? text : "", text ? static_cast<std::size_t>(length) : 0);
    const std::size_t place = m_text.offset(at);
    if (what & SC_MOD_INSERTTEXT) Q_EMIT edited(place, {}, changed);
    else Q_EMIT edited(place, changed, {});
}

void CodeEdit::type(TextRange range, std::string_view text, std::uint32_t caretAfter) {
    Q_EMIT actionBegins();
    apply({{static_cast<std::size_t>(m_text.position(range.begin)),
            static_cast<std::size_t>(m_text.position(range.end) - m_text.position(range.begin)), std::string(text)},
           static_cast<std::size_t>(m_text.position(caretAfter)),
           static_cast<std::size_t>(m_text.position(caretAfter))});
    const auto place =
        static_cast<unsigned long>(m_text.position(caretAfter)); // computed after the edit: the old text may be shorter
    SendScintilla(SCI_SETEMPTYSELECTION, place);
    updateCaret();
}

void CodeEdit::apply(const LineEdit& edit) {
    if (isReadOnly()) return;
    SendScintilla(SCI_SETTARGETRANGE, static_cast<unsigned long>(edit.splice.at),
                  static_cast<long>(edit.splice.at + edit.splice.removed));
    SendScintilla(SCI_REPLACETARGET, static_cast<unsigned long>(edit.splice.text.size()), edit.splice.text.data());
    SendScintilla(SCI_SETSEL, static_cast<unsigned long>(edit.anchor), static_cast<long>(edit.caret));
    SendScintilla(SCI_SCROLLCARET);
    SendScintilla(SCI_CHOOSECARETX);
}

void CodeEdit::removeForward() {
    Q_EMIT actionBegins();
    SendScintilla(SCI_CLEAR);
    updateCaret();
}

void CodeEdit::changeLines(const std::function<std::optional<LineEdit>(std::string_view, std::size_t, std::size_t)>& command) {
    Q_EMIT actionBegins();
    const auto anchor = static_cast<std::size_t>(m_text.anchor()), caret = static_cast<std::size_t>(m_text.caret());
    if (const auto edit = command(m_text.view(), anchor, caret)) apply(*edit);
}

void CodeEdit::cut() {
    Q_EMIT actionBegins();
    QsciScintilla::cut();
    updateCaret();
}

void CodeEdit::paste() {
    Q_EMIT actionBegins();
    QsciScintilla::paste();
    updateCaret();
}

void CodeEdit::updateCaret() {
    if (m_text.caret() == m_lastCaret && m_text.anchor() == m_lastAnchor) return;
    rememberCaret();
    Q_EMIT caretMovedByHand();
}

void CodeEdit::rememberCaret() {
    m_lastCaret = m_text.caret();
    m_lastAnchor = m_text.anchor();
}

void CodeEdit::fitNumberMargin() {
    const int digits = std::max(2, static_cast<int>(QString::number(lines()).size()));
    setMarginWidth(kNumberMargin, QString(digits + 1, QLatin1Char('9')));
    m_wrapping.update();
}

void CodeEdit::applyStyle() {
    applyAppearance(*this, m_styling.language());
    fitNumberMargin();
}

// --- events ---

void CodeEdit::keyPressEvent(QKeyEvent* event) {
    Q_EMIT actionBegins();
    const bool plain = !(event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const auto at = static_cast<std::size_t>(m_text.caret()), anchor = static_cast<std::size_t>(m_text.anchor());
    if (plain && enter && !isReadOnly()) {
        apply(newLine(m_text.view(), anchor, at, m_lineEnd, m_step, m_styling.language() == CodeLanguage::Python));
    } else if (const auto closed = event->text() == QLatin1String("}") && at == anchor && !isReadOnly()
                                       ? closeBrace(m_text.view(), at)
                                       : std::nullopt) {
        apply(*closed);
    } else if (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) {
        QKeyEvent command(event->type(), event->key(), event->modifiers()); // without text: a shortcut must not type
        QsciScintilla::keyPressEvent(&command);
        event->setAccepted(command.isAccepted());
    } else {
        QsciScintilla::keyPressEvent(event);
    }
    updateCaret();
}

void CodeEdit::inputMethodEvent(QInputMethodEvent* event) {
    Q_EMIT actionBegins();
    const bool composing = !event->preeditString().isEmpty();
    if (composing && !event->commitString().isEmpty()) { // commit first, then compose
        QInputMethodEvent done;
        done.setCommitString(event->commitString(), event->replacementStart(), event->replacementLength());
        inputMethodEvent(&done);
        event->setCommitString({});
    }
    // The widget removes preedit text by its own undo, so undo collection must be on until composing ends.
    if (composing) SendScintilla(SCI_SETUNDOCOLLECTION, 1UL);
    m_composing = composing;
    QsciScintilla::inputMethodEvent(event);
    if (!composing) {
        SendScintilla(SCI_SETUNDOCOLLECTION, 0UL);
        SendScintilla(SCI_EMPTYUNDOBUFFER);
    }
    updateCaret();
}

bool CodeEdit::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        m_pointer.rested(*static_cast<QHelpEvent*>(event));
        return true;
    }
    return QsciScintilla::viewportEvent(event);
}

void CodeEdit::mousePressEvent(QMouseEvent* event) {
    if (m_pointer.isOnLink(*event)) {
        setFocus();
        return m_pointer.follow(*event);
    }
    Q_EMIT actionBegins();
    QsciScintilla::mousePressEvent(event);
    updateCaret();
}

void CodeEdit::mouseMoveEvent(QMouseEvent* event) {
    QsciScintilla::mouseMoveEvent(event);
    if (event->buttons() & Qt::LeftButton) updateCaret();
    m_pointer.moved(*event);
}

void CodeEdit::mouseReleaseEvent(QMouseEvent* event) {
    QsciScintilla::mouseReleaseEvent(event);
    updateCaret();
}

void CodeEdit::mouseDoubleClickEvent(QMouseEvent* event) {
    QsciScintilla::mouseDoubleClickEvent(event);
    updateCaret();
}

void CodeEdit::contextMenuEvent(QContextMenuEvent* event) {
    Q_EMIT m_pointer.menuRequested(event->globalPos());
    event->accept();
}

void CodeEdit::dropEvent(QDropEvent* event) {
    Q_EMIT actionBegins();
    QsciScintilla::dropEvent(event);
    updateCaret();
}

void CodeEdit::focusOutEvent(QFocusEvent* event) {
    QsciScintilla::focusOutEvent(event);
    Q_EMIT left();
}

void CodeEdit::changeEvent(QEvent* event) {
    QsciScintilla::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) applyStyle();
}

void CodeEdit::resizeEvent(QResizeEvent* event) {
    QsciScintilla::resizeEvent(event);
    m_wrapping.update();
}

void CodeEdit::wheelEvent(QWheelEvent* event) {
    QToolTip::hideText();
    QsciScintilla::wheelEvent(event);
}

} // namespace trundle
