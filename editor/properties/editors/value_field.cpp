#include "editor/properties/editors/value_field.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPointer>
#include <QStyleOptionFrame>

#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"

namespace trundle {

namespace {
constexpr int kRoom = 44;      ///< pixels left for the text next to a long suffix
constexpr int kTextMargin = 2; ///< pixels; QLineEdit's own margin on both sides of its text
} // namespace

ValueField::ValueField(QWidget* parent) : QLineEdit(parent) {
    connect(this, &QLineEdit::textEdited, this, [this] {
        clearError(); // it was about the text before
        colour();
    });
}

void ValueField::setValue(const QString& text) {
    const bool typing = (isModified() && hasFocus()) || refused();
    const bool same = text == m_value;
    m_value = text;
    if (typing && (same || hasFocus())) return;
    clearError();
    if (this->text() != text) setText(text);
    setCursorPosition(0);
    colour();
}

void ValueField::setSuffix(const QString& suffix) {
    if (m_suffix == suffix) return;
    m_suffix = suffix;
    placeSuffix();
}

void ValueField::setFaint(bool faint) {
    m_faint = faint;
    colour();
}

void ValueField::setMixed(bool mixed) {
    m_mixed = mixed;
    setPlaceholderText(mixed ? tr("mixed") : QString());
}

void ValueField::setCompact(bool compact) {
    m_compact = compact;
    colour();
}

void ValueField::setError(const QString& reason) {
    m_reason = reason.isEmpty() ? tr("Invalid value") : reason;
    setModified(true);
    colour();
    Q_EMIT refusedChanged(m_reason);
}

void ValueField::clearError() {
    if (!refused()) return;
    m_reason.clear();
    colour();
    Q_EMIT refusedChanged({});
}

void ValueField::restore() {
    clearError();
    setText(m_value);
    setModified(false);
    colour();
}

void ValueField::enter() {
    if (!isModified()) return;
    if (text() == m_value && !m_mixed) return restore();
    if (text().isEmpty() && m_mixed) return restore();
    m_reason.clear(); // setError() sets it again if it still applies
    setModified(false);
    const QString typed = text();
    Q_EMIT entered(typed);
    if (!refused()) Q_EMIT refusedChanged({});
    colour();
}

/// Closes the completion popup and accepts its highlighted name. The popup sends keys to the field without calling event
/// filters.
void ValueField::closeList() {
    if (!completer() || !completer()->popup()->isVisible()) return;
    completer()->popup()->hide();
    setModified(text() != m_value);
}

bool ValueField::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && isElided()) {
        showToolTip(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore(); // nothing is being typed: let the document undo
            return true;
        }
    }
    return QLineEdit::event(event);
}

void ValueField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        closeList();
        enter();
        if (!refused()) selectAll();
        return event->accept();
    case Qt::Key_Escape:
        closeList();
        if (!isModified() && !refused()) break;
        restore();
        selectAll();
        return event->accept();
    case Qt::Key_Up: Q_EMIT stepped(1); return event->accept();
    case Qt::Key_Down: Q_EMIT stepped(-1); return event->accept();
    case Qt::Key_PageUp: Q_EMIT stepped(10); return event->accept();
    case Qt::Key_PageDown: Q_EMIT stepped(-10); return event->accept();
    default: return QLineEdit::keyPressEvent(event);
    }
    event->ignore(); // nothing to cancel: let the window handle Esc
}

void ValueField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::PopupFocusReason || refused()) return;
    enter();
    if (isElided()) setCursorPosition(0); // show the start of the text
}

void ValueField::colour() {
    if (m_colouring) return;
    m_colouring = true;
    QPalette p;
    const bool faint = m_faint && !isModified();
    if (faint) p.setColor(QPalette::Text, ink(Ink::Faint));
    setPalette(p);
    QString sheet; // the style sheet draws the border, so it also sets these properties
    if (m_compact) sheet = QStringLiteral("padding: 2px 1px;");
    if (isReadOnly()) sheet += QStringLiteral("background: transparent; border-color: transparent;");
    if (refused()) sheet += QStringLiteral("border-color: %1; color: %1;").arg(ink(Ink::Error).name());
    if (!sheet.isEmpty()) sheet = QStringLiteral("QLineEdit { %1 }").arg(sheet);
    if (styleSheet() != sheet) setStyleSheet(sheet);
    m_colouring = false;
    update();
}

void ValueField::placeSuffix() {
    const int wide = m_suffix.isEmpty() ? 0 : fontMetrics().horizontalAdvance(m_suffix) + 6;
    const int most = std::max(0, width() - kRoom);
    setTextMargins(0, 0, std::min(wide, most), 0);
    update();
}

QRect ValueField::textRect() const {
    QStyleOptionFrame option;
    initStyleOption(&option);
    const QMargins margins = textMargins();
    return style()
        ->subElementRect(QStyle::SE_LineEditContents, &option, this)
        .adjusted(margins.left() + kTextMargin, 0, -margins.right() - kTextMargin, 0);
}

int ValueField::wholeWidth() const {
    return fontMetrics().horizontalAdvance(m_mixed ? placeholderText() : m_value) + 1 + width() -
           textRect().width(); // 1: the cursor
}

bool ValueField::isElided() const {
    return !hasFocus() && !text().isEmpty() && fontMetrics().horizontalAdvance(text()) > textRect().width();
}

void ValueField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    if (isElided()) { // part of a number could be misread
        const QString more = QStringLiteral("…");
        QRect end = textRect();
        end.setLeft(end.right() + 1 - fontMetrics().horizontalAdvance(more));
        painter.fillRect(end.adjusted(-1, 1, kTextMargin, -1), palette().color(isReadOnly() ? QPalette::Window : QPalette::Base));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(end, Qt::AlignVCenter | Qt::AlignLeft, more);
    }
    if (m_suffix.isEmpty()) return;
    const int room = textMargins().right();
    painter.setPen(ink(Ink::Faint));
    const QRect box = rect().adjusted(width() - room - 6, 0, -6, 0);
    painter.drawText(box, Qt::AlignVCenter | Qt::AlignRight, fontMetrics().elidedText(m_suffix, Qt::ElideRight, box.width()));
}

void ValueField::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange) placeSuffix();
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::ReadOnlyChange ||
        event->type() == QEvent::ApplicationPaletteChange)
        colour();
}

void ValueField::resizeEvent(QResizeEvent* event) {
    QLineEdit::resizeEvent(event);
    placeSuffix();
}

QSize ValueField::sizeHint() const { return {60, QLineEdit::sizeHint().height()}; }
QSize ValueField::minimumSizeHint() const { return {30, QLineEdit::minimumSizeHint().height()}; }

void commitTyped(const QWidget& panel) {
    QList<QPointer<ValueField>> typed; // committing one may delete others
    for (ValueField* field : panel.findChildren<ValueField*>())
        if (field->isModified() && !field->refused()) typed.append(field);
    for (const QPointer<ValueField>& field : typed)
        if (field) field->enter();
}

} // namespace trundle
