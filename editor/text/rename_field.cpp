#include "editor/text/rename_field.h"

#include <algorithm>

#include <QCheckBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "editor/widgets/theme.h"

namespace trundle {

RenameField::RenameField(QWidget* viewport)
    : QFrame(viewport), m_name(new QLineEdit(this)), m_others(new QCheckBox(this)), m_error(new QLabel(this)) {
    setObjectName(QStringLiteral("renameField"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    m_name->setObjectName(QStringLiteral("renameText"));
    m_name->setAccessibleName(tr("New name"));
    m_name->setToolTip(tr("Enter renames it everywhere, Esc cancels"));
    useMonospaceFont(*m_name);
    m_error->setObjectName(QStringLiteral("renameError"));
    m_error->setTextFormat(Qt::PlainText);
    m_error->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(3, 3, 3, 3);
    layout->setSpacing(3);
    m_others->setObjectName(QStringLiteral("renameOthers"));
    m_others->setFocusPolicy(Qt::TabFocus); // a click keeps the focus in the line edit
    m_others->hide();
    layout->addWidget(m_name);
    layout->addWidget(m_others);
    layout->addWidget(m_error);
    connect(m_name, &QLineEdit::textEdited, this, [this] {
        m_error->hide();
        fit();
    });
    m_name->installEventFilter(this);
    hide();
}

void RenameField::open(const QPoint& topLeft, const QString& name) {
    m_at = topLeft;
    m_name->setText(name);
    m_error->hide();
    show();
    raise();
    fit();
    m_name->setFocus();
    m_name->selectAll();
}

void RenameField::offerOthers(const QString& sentence, const QString& tip) {
    m_others->setText(sentence);
    m_others->setToolTip(tip);
    m_others->setChecked(true);
    m_others->show();
    fit();
}

bool RenameField::renamesOthers() const { return !m_others->isHidden() && m_others->isChecked(); }

void RenameField::showError(const QString& sentence) {
    m_error->setStyleSheet(QStringLiteral("color: %1").arg(ink(Ink::Error).name()));
    m_error->setText(sentence);
    m_error->show();
    fit();
    m_name->setFocus();
}

/// As wide as the name or the sentence needs, limited to the viewport.
void RenameField::fit() {
    constexpr int kNarrowest = 200, kWidest = 420;
    const QRect room = parentWidget()->rect().adjusted(2, 2, -2, -2);
    const int name = m_name->fontMetrics().horizontalAdvance(m_name->text()) + 40;
    const int sentence = m_error->isHidden() ? 0 : m_error->fontMetrics().horizontalAdvance(m_error->text()) + 20;
    const int others = m_others->isHidden() ? 0 : m_others->sizeHint().width() + 10;
    const int wide =
        std::min(std::max(others, std::clamp(std::max(name, std::min(sentence, kWidest)), kNarrowest, kWidest)), room.width());
    setFixedWidth(wide);
    const int high = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(wide) : layout()->totalSizeHint().height();
    resize(wide, high);
    move(std::clamp(m_at.x(), room.left(), std::max(room.left(), room.right() + 1 - wide)),
         std::clamp(m_at.y(), room.top(), std::max(room.top(), room.bottom() + 1 - high)));
}

void RenameField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        Q_EMIT renameRequested(m_name->text().trimmed());
    } else if (event->key() == Qt::Key_Escape) {
        hide();
        Q_EMIT closed();
    }
    // Other keys are not passed on to the text.
}

bool RenameField::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_name && event->type() == QEvent::FocusOut) {
        const auto reason = static_cast<QFocusEvent*>(event)->reason();
        if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason) hide(); // not for its menu or another window
    }
    if (watched == m_name && event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QFrame::eventFilter(watched, event);
}

} // namespace trundle
