#include "editor/text/completion/completion_popup.h"

#include <algorithm>

#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kMaxRows = 10, kWidest = 620, kHelpMargin = 6, kMaxHelpLines = 4, kBadge = 16;

/// A letter in a coloured square for the sort of a completion.
QPixmap badge(CompletionSort sort, qreal scale, bool selected) {
    struct Look {
        char letter;
        Ink ink;
    };
    const auto look = [&]() -> Look {
        switch (sort) {
        case CompletionSort::Key: return {'k', Ink::Hint};
        case CompletionSort::Kind: return {'B', Ink::Type};
        case CompletionSort::Word: return {'#', Ink::Keyword};
        case CompletionSort::Value: return {'v', Ink::String};
        case CompletionSort::Reference: return {'r', Ink::Accent};
        case CompletionSort::Param: return {'$', Ink::Keyword};
        case CompletionSort::Unit: return {'u', Ink::Number};
        case CompletionSort::File: return {'f', Ink::String};
        }
        return {' ', Ink::Text};
    }();
    const int size = scaledToFont(kBadge);
    QPixmap pixmap(QSize(size, size) * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = selected ? QGuiApplication::palette().color(QPalette::HighlightedText) : ink(look.ink);
    const QColor letter = fill;
    fill.setAlpha(46);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(0.5, 0.5, size - 1, size - 1), 3, 3);
    QFont font = monospaceFont();
    font.setPixelSize(scaledToFont(11));
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(letter);
    painter.drawText(QRect(0, 0, size, size), Qt::AlignCenter, QString(QLatin1Char(look.letter)));
    return pixmap;
}

/// What fits into some lines, with an ellipsis for the rest.
QString fitted(const QString& text, const QFontMetrics& metrics, const QRect& room) {
    const auto fits = [&](const QString& some) {
        return metrics.boundingRect(QRect(0, 0, room.width(), 10000), Qt::TextWordWrap, some).height() <= room.height();
    };
    if (fits(text)) return text;
    qsizetype length = 0;
    for (qsizetype step = text.size(); step > 0; step = step > 1 ? (step + 1) / 2 : 0)
        if (length + step < text.size() && fits(text.left(length + step) + QChar(0x2026))) length += step;
    return text.left(length).trimmed() + QChar(0x2026);
}

} // namespace

CompletionPopup::CompletionPopup(QWidget* owner)
    : QFrame(owner), m_owner(owner), m_list(new QTreeWidget(this)), m_help(new QLabel(this)) {
    setObjectName(QStringLiteral("completionPopup"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setFocusPolicy(Qt::NoFocus);
    m_list->setObjectName(QStringLiteral("completionList"));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setColumnCount(2);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->header()->setStretchLastSection(true);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Fixed);
    m_help->setObjectName(QStringLiteral("completionHelp"));
    m_help->setWordWrap(true);
    m_help->setTextFormat(Qt::PlainText);
    m_help->setMargin(kHelpMargin);
    m_help->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_help->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0); // the frame reserves room for its border
    layout->setSpacing(0);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_help);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &CompletionPopup::showHelp);
    connect(m_list, &QTreeWidget::itemClicked, this, &CompletionPopup::clicked);
    hide();
}

void CompletionPopup::showItems(const std::vector<const Completion*>& items, const QPoint& place, int lineHeight) {
    const int badgeSize = scaledToFont(kBadge);
    m_list->setIconSize({badgeSize, badgeSize});
    m_list->clear();
    m_helps.clear();
    QList<QTreeWidgetItem*> rows;
    for (const Completion* item : items) {
        auto* row = new QTreeWidgetItem({QString::fromStdString(item->label), QString::fromStdString(item->detail)});
        QIcon icon(badge(item->sort, devicePixelRatioF(), false));
        icon.addPixmap(badge(item->sort, devicePixelRatioF(), true), QIcon::Selected);
        row->setIcon(0, icon);
        row->setFont(0, monospaceFont());
        row->setForeground(1, ink(Ink::Faint));
        rows << row;
        m_helps.push_back(item->help);
    }
    m_list->addTopLevelItems(rows);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    fitTo(place, lineHeight);
}

void CompletionPopup::fitTo(const QPoint& place, int lineHeight) {
    setStyleSheet(QStringLiteral("#completionPopup { border: 1px solid %1; background: %2; }")
                      .arg(ink(Ink::Faint).name(), palette().color(QPalette::Base).name()));
    QWidget* window = m_owner->window();
    if (parentWidget() != window) setParent(window);
    int label = 80, detail = 0;
    const QFontMetrics mono(monospaceFont()), plain(m_list->font());
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* row = m_list->topLevelItem(i);
        label = std::max(label, mono.horizontalAdvance(row->text(0)) + 40);
        detail = std::max(detail, plain.horizontalAdvance(row->text(1)) + 24);
    }
    const int rowHeight = std::max(20, m_list->sizeHintForRow(0));
    const int count = std::min(kMaxRows, m_list->topLevelItemCount());
    const int width = std::clamp(label + detail + 20, 320, std::min(kWidest, std::max(200, window->width() - 8)));
    m_list->setColumnWidth(0, std::min(label, width - std::min(detail, 160) - 20));
    m_list->setFixedHeight(count * rowHeight + 4);
    // Height of the longest help text, so that the popup keeps its size while the user steps through the list.
    const QFontMetrics metrics(m_help->font());
    const QRect room(0, 0, width - 2 * kHelpMargin - 2, kMaxHelpLines * metrics.lineSpacing());
    int high = 0;
    for (const std::string& help : m_helps)
        if (!help.empty())
            high = std::max({high, 2 * metrics.lineSpacing(),
                             metrics.boundingRect(room, Qt::TextWordWrap, QString::fromStdString(help)).height()});
    m_help->setVisible(high > 0);
    if (high > 0) high = std::min(high, room.height()) + 2 * kHelpMargin + 2;
    m_help->setFixedHeight(high);
    resize(width, m_list->height() + high + 2);
    QPoint at = window->mapFromGlobal(place);
    if (at.y() + height() > window->height() && at.y() - lineHeight - height() >= 0) at.ry() -= lineHeight + height();
    at.setX(std::clamp(at.x(), 0, std::max(0, window->width() - width)));
    move(at);
    show();
    raise();
    showHelp();
}

int CompletionPopup::current() const { return m_list->indexOfTopLevelItem(m_list->currentItem()); }

int CompletionPopup::rows() const { return kMaxRows; }

void CompletionPopup::step(int by) {
    const int count = m_list->topLevelItemCount();
    if (count == 0) return;
    int next = current() + by;
    if (by == 1 && next >= count) next = 0;
    if (by == -1 && next < 0) next = count - 1;
    m_list->setCurrentItem(m_list->topLevelItem(std::clamp(next, 0, count - 1)));
}

void CompletionPopup::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    qApp->installEventFilter(this);
}

void CompletionPopup::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    qApp->removeEventFilter(this);
}

bool CompletionPopup::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::NonClientAreaMouseButtonPress) {
        const auto* widget = qobject_cast<QWidget*>(watched); // QWindow gets each event before the widget
        if (widget && widget != this && !isAncestorOf(widget)) Q_EMIT left();
    }
    return QFrame::eventFilter(watched, event);
}

void CompletionPopup::showHelp() {
    const int at = current();
    const QString help = at >= 0 && at < static_cast<int>(m_helps.size())
                             ? QString::fromStdString(m_helps[static_cast<std::size_t>(at)])
                             : QString();
    m_help->setText(fitted(help, m_help->fontMetrics(),
                           {0, 0, width() - 2 * kHelpMargin - 2, kMaxHelpLines * m_help->fontMetrics().lineSpacing()}));
}

} // namespace trundle
