#include "editor/text/code/code_edit.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QInputMethodEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QToolTip>

#include "base/utf8.h"
#include "editor/text/code/code_appearance.h"
#include "editor/text/code/splice.h"
#include "lang/lexer.h"

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
    connect(this, &QsciScintillaBase::SCN_STYLENEEDED, this, &CodeEdit::styleUpTo);
    connect(this, &QsciScintilla::linesChanged, this, &CodeEdit::fitNumberMargin);
    connect(this, &QsciScintillaBase::SCN_ZOOM, this, &CodeEdit::fitNumberMargin);
}

std::string_view CodeEdit::view() const {
    const auto length = static_cast<std::size_t>(SendScintilla(SCI_GETLENGTH));
    const auto* text = static_cast<const char*>(SendScintillaPtrResult(SCI_GETCHARACTERPOINTER));
    return {text ? text : "", text ? length : 0};
}

std::string CodeEdit::bytes() const {
    std::string all(kBom.substr(0, m_bom));
    all += view();
    return all;
}

void CodeEdit::load(std::string_view bytes) {
    const QScopedValueRollback<bool> own(m_own, true);
    m_bom = bytes.starts_with(kBom) ? static_cast<std::uint32_t>(kBom.size()) : 0;
    m_marks.setBom(m_bom);
    bytes.remove_prefix(m_bom);
    const bool locked = isReadOnly();
    setReadOnly(false);
    const long notifications = SendScintilla(SCI_GETMODEVENTMASK);
    SendScintilla(SCI_SETMODEVENTMASK, 0UL); // QScintilla would convert both texts to a QString for its notifications
    SendScintilla(SCI_CLEARALL);
    SendScintilla(SCI_ALLOCATE, static_cast<unsigned long>(bytes.size() + 1024));
    SendScintilla(SCI_ADDTEXT, static_cast<unsigned long>(bytes.size()), bytes.data());
    SendScintilla(SCI_SETMODEVENTMASK, static_cast<unsigned long>(notifications));
    SendScintilla(SCI_GOTOPOS, 0UL);
    setReadOnly(locked);
    m_stale = true;
    m_lastCaret = m_lastAnchor = 0;
    fitNumberMargin();
}

void CodeEdit::setPlain(bool plain) {
    if (plain == m_plain) return;
    const QScopedValueRollback<bool> own(m_own, true);
    m_plain = plain;
    m_marks.setBlocksShown(!plain);
    m_stale = true;
    m_styles = {};
    const long document = SendScintilla(SCI_CREATEDOCUMENT, 0UL,
                                        static_cast<long>(plain ? SC_DOCUMENTOPTION_STYLES_NONE : SC_DOCUMENTOPTION_DEFAULT));
    SendScintilla(SCI_SETDOCPOINTER, 0UL, document);
    SendScintilla(SCI_RELEASEDOCUMENT, 0UL, document); // the widget holds its own reference
    setUtf8(true);                                     // a setting of the document, not of the widget
    SendScintilla(SCI_SETUNDOCOLLECTION, 0UL);
    setWays(m_lineEnd, m_step);
    fitWrap();
}

std::uint32_t CodeEdit::bring(std::string_view bytes) {
    const QScopedValueRollback<bool> own(m_own, true);
    const std::uint32_t bom = bytes.starts_with(kBom) ? static_cast<std::uint32_t>(kBom.size()) : 0;
    bytes.remove_prefix(bom);
    m_bom = bom;
    m_marks.setBom(bom);
    const std::vector<Splice> splices = splicesBetween(view(), bytes);
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
    m_lastCaret = SendScintilla(SCI_GETCURRENTPOS);
    m_lastAnchor = SendScintilla(SCI_GETANCHOR);
    const Splice& last = splices.back();
    return offset(static_cast<long>(movedOffset(last.at, {splices.begin(), splices.end() - 1}) + last.text.size()));
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

long CodeEdit::position(std::uint32_t offset) const {
    const long place = offset > m_bom ? static_cast<long>(offset - m_bom) : 0;
    return std::min(place, SendScintilla(SCI_GETLENGTH));
}

std::uint32_t CodeEdit::caret() const { return offset(SendScintilla(SCI_GETCURRENTPOS)); }

TextRange CodeEdit::selection() const {
    return {offset(SendScintilla(SCI_GETSELECTIONSTART)), offset(SendScintilla(SCI_GETSELECTIONEND))};
}

void CodeEdit::select(TextRange range, bool scroll) {
    const QScopedValueRollback<bool> own(m_own, true);
    SendScintilla(SCI_SETEMPTYSELECTION, static_cast<unsigned long>(position(range.end)));
    SendScintilla(SCI_SETANCHOR, static_cast<unsigned long>(position(range.begin)));
    if (scroll) scrollTo(range);
    m_lastCaret = SendScintilla(SCI_GETCURRENTPOS);
    m_lastAnchor = SendScintilla(SCI_GETANCHOR);
}

void CodeEdit::scrollTo(TextRange range) {
    readTokens();
    const long first = SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position(range.begin)));
    const long last = SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position(range.end)));
    SendScintilla(SCI_ENSUREVISIBLE, static_cast<unsigned long>(first));
    const long top = SendScintilla(SCI_GETFIRSTVISIBLELINE), rows = std::max(1L, SendScintilla(SCI_LINESONSCREEN));
    const long from = SendScintilla(SCI_VISIBLEFROMDOCLINE, static_cast<unsigned long>(first));
    const long to = SendScintilla(SCI_VISIBLEFROMDOCLINE, static_cast<unsigned long>(last));
    if (from >= top && std::min(to, from + rows - 1) < top + rows) return;
    const long spare = std::max(0L, rows - (to - from + 1)) / 3; // places the range slightly above the middle
    SendScintilla(SCI_SETFIRSTVISIBLELINE, static_cast<unsigned long>(std::max(0L, from - spare)));
}

std::uint32_t CodeEdit::offsetAt(const QPoint& pos) const {
    const long at = SendScintilla(SCI_POSITIONFROMPOINTCLOSE, static_cast<unsigned long>(pos.x()), static_cast<long>(pos.y()));
    return at < 0 ? kNowhere : offset(at);
}

QPoint CodeEdit::placeOf(std::uint32_t offset) const {
    const long at = position(offset);
    return {static_cast<int>(SendScintilla(SCI_POINTXFROMPOSITION, 0UL, at)),
            static_cast<int>(SendScintilla(SCI_POINTYFROMPOSITION, 0UL, at)) + lineHeight()};
}

int CodeEdit::lineHeight() const { return static_cast<int>(SendScintilla(SCI_TEXTHEIGHT, 0UL)); }

void CodeEdit::onModified(int at, int what, const char* text, int length) {
    if (what & (SC_MOD_INSERTTEXT | SC_MOD_DELETETEXT)) m_stale = true;
    if (m_own || m_composing || (what & SC_PERFORMED_UNDO)) return; // undo: an input method removes its preedit text
    if (!(what & (SC_MOD_INSERTTEXT | SC_MOD_DELETETEXT))) return;
    const std::string_view changed(text ? text : "", text ? static_cast<std::size_t>(length) : 0);
    const std::size_t place = static_cast<std::size_t>(at) + m_bom;
    if (what & SC_MOD_INSERTTEXT) Q_EMIT edited(place, {}, changed);
    else Q_EMIT edited(place, changed, {});
}

void CodeEdit::readTokens() {
    if (!m_stale) return;
    m_stale = false;
    if (m_plain) return;
    const std::string_view text = view();
    const std::vector<Token> tokens = Lexer(text).lex();
    m_styles = stylesOf(text, tokens);
    const std::vector<FoldLine> lines = foldLinesOf(text, tokens);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int level = std::min(SC_FOLDLEVELBASE + lines[i].level, static_cast<int>(SC_FOLDLEVELNUMBERMASK)) |
                          (lines[i].opens ? SC_FOLDLEVELHEADERFLAG : 0);
        if (SendScintilla(SCI_GETFOLDLEVEL, static_cast<unsigned long>(i)) != level)
            SendScintilla(SCI_SETFOLDLEVEL, static_cast<unsigned long>(i), static_cast<long>(level));
    }
}

void CodeEdit::styleUpTo(int position) {
    constexpr long kLinesBefore = 3; // the style of a word may depend on the next line
    readTokens();
    const long styled = SendScintilla(SCI_GETENDSTYLED);
    const long line = std::max(0L, SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(styled)) - kLinesBefore);
    const auto from = static_cast<std::size_t>(SendScintilla(SCI_POSITIONFROMLINE, static_cast<unsigned long>(line)));
    const std::size_t to = std::min(static_cast<std::size_t>(std::max(0, position)), m_styles.size());
    if (from >= to) return;
    SendScintilla(SCI_STARTSTYLING, static_cast<unsigned long>(from), 0L);
    SendScintilla(SCI_SETSTYLINGEX, static_cast<unsigned long>(to - from), m_styles.data() + from);
}

TextStyle CodeEdit::styleAt(std::uint32_t offset) {
    readTokens();
    const auto at = static_cast<std::size_t>(position(offset));
    return at < m_styles.size() ? static_cast<TextStyle>(m_styles[at]) : TextStyle::Plain;
}

void CodeEdit::type(TextRange range, std::string_view text, std::uint32_t caretAfter) {
    Q_EMIT actionBegins();
    apply({{static_cast<std::size_t>(position(range.begin)),
            static_cast<std::size_t>(position(range.end) - position(range.begin)), std::string(text)},
           static_cast<std::size_t>(position(caretAfter)),
           static_cast<std::size_t>(position(caretAfter))});
    const auto place = static_cast<unsigned long>(position(caretAfter)); // computed after the edit: the old text may be shorter
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

void CodeEdit::toggleComment() {
    Q_EMIT actionBegins();
    if (const auto edit = trundle::toggleComment(view(), static_cast<std::size_t>(SendScintilla(SCI_GETANCHOR)),
                                                 static_cast<std::size_t>(SendScintilla(SCI_GETCURRENTPOS))))
        apply(*edit);
}

void CodeEdit::duplicateLines() {
    Q_EMIT actionBegins();
    if (const auto edit = trundle::duplicateLines(view(), static_cast<std::size_t>(SendScintilla(SCI_GETANCHOR)),
                                                  static_cast<std::size_t>(SendScintilla(SCI_GETCURRENTPOS)), m_lineEnd))
        apply(*edit);
}

void CodeEdit::moveLines(int direction) {
    Q_EMIT actionBegins();
    if (const auto edit = trundle::moveLines(view(), static_cast<std::size_t>(SendScintilla(SCI_GETANCHOR)),
                                             static_cast<std::size_t>(SendScintilla(SCI_GETCURRENTPOS)), direction))
        apply(*edit);
}

void CodeEdit::foldEverything(bool folded) {
    readTokens();
    SendScintilla(SCI_FOLDALL, static_cast<unsigned long>(folded ? SC_FOLDACTION_CONTRACT : SC_FOLDACTION_EXPAND));
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
    const long caret = SendScintilla(SCI_GETCURRENTPOS), anchor = SendScintilla(SCI_GETANCHOR);
    if (caret == m_lastCaret && anchor == m_lastAnchor) return;
    m_lastCaret = caret;
    m_lastAnchor = anchor;
    Q_EMIT caretMovedByHand();
}

void CodeEdit::fitNumberMargin() {
    const int digits = std::max(2, static_cast<int>(QString::number(lines()).size()));
    setMarginWidth(kNumberMargin, QString(digits + 1, QLatin1Char('9')));
    fitWrap();
}

void CodeEdit::setWrapLines(WrapLines wrap) {
    m_wrap = wrap;
    fitWrap();
}

void CodeEdit::fitWrap() {
    constexpr int kNarrow = 80; // columns
    int room = viewport()->width();
    for (const int margin : {kNumberMargin, kBlockMargin, kSymbolMargin, kFoldMargin}) room -= marginWidth(margin);
    const bool narrow = room < kNarrow * SendScintilla(SCI_TEXTWIDTH, static_cast<unsigned long>(STYLE_DEFAULT), "9");
    const bool wraps = !m_plain && (m_wrap == WrapLines::Always || (m_wrap == WrapLines::InNarrowPanes && narrow));
    if (wraps == m_wraps) return;
    m_wraps = wraps;
    setWrapMode(wraps ? WrapWhitespace : WrapNone);
    Q_EMIT wrapsLinesChanged();
}

void CodeEdit::applyStyle() {
    applyAppearance(*this);
    fitNumberMargin();
}

// --- events ---

void CodeEdit::keyPressEvent(QKeyEvent* event) {
    Q_EMIT actionBegins();
    const bool plain = !(event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier));
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const auto at = static_cast<std::size_t>(SendScintilla(SCI_GETCURRENTPOS)),
               anchor = static_cast<std::size_t>(SendScintilla(SCI_GETANCHOR));
    if (plain && enter && !isReadOnly()) {
        apply(newLine(view(), anchor, at, m_lineEnd, m_step));
    } else if (const auto closed =
                   event->text() == QLatin1String("}") && at == anchor && !isReadOnly() ? closeBrace(view(), at) : std::nullopt) {
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
        const auto* help = static_cast<QHelpEvent*>(event);
        Q_EMIT hoverRequested(offsetAt(help->pos()), help->globalPos());
        return true;
    }
    return QsciScintilla::viewportEvent(event);
}

void CodeEdit::mousePressEvent(QMouseEvent* event) {
    const std::uint32_t at = offsetAt(event->pos());
    if (event->button() == Qt::LeftButton && event->modifiers() == Qt::ControlModifier && at != kNowhere) {
        setFocus();
        Q_EMIT linkFollowed(at);
        return;
    }
    Q_EMIT actionBegins();
    QsciScintilla::mousePressEvent(event);
    updateCaret();
}

void CodeEdit::mouseMoveEvent(QMouseEvent* event) {
    QsciScintilla::mouseMoveEvent(event);
    if (event->buttons() & Qt::LeftButton) updateCaret();
    const bool looking = event->modifiers() == Qt::ControlModifier && event->buttons() == Qt::NoButton;
    if (looking || m_looking) Q_EMIT linkRequested(looking ? offsetAt(event->pos()) : kNowhere);
    m_looking = looking;
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
    Q_EMIT menuRequested(event->globalPos());
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
    fitWrap();
}

void CodeEdit::wheelEvent(QWheelEvent* event) {
    QToolTip::hideText();
    QsciScintilla::wheelEvent(event);
}

} // namespace trundle
