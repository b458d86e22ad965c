#include "editor/text/search/results_list.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/widgets/middle_elided.h"
#include "editor/widgets/theme.h"

namespace trundle {
ResultsList::ResultsList(const QString& name, QWidget* parent)
    : QWidget(parent), m_title(new QLabel(this)), m_list(new QTreeWidget(this)) {
    setObjectName(name + QStringLiteral("Panel"));
    m_title->setObjectName(name + QStringLiteral("Title"));
    m_title->setTextFormat(Qt::PlainText);
    m_list->setObjectName(name + QStringLiteral("List"));
    setFocusProxy(m_list);
    m_list->setColumnCount(2);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setAllColumnsShowFocus(true);
    m_list->setItemDelegateForColumn(0, new MiddleElided(m_list));
    m_list->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_list->viewport()->installEventFilter(this);
    auto* shut = new QToolButton(this);
    shut->setObjectName(name + QStringLiteral("Close"));
    shut->setIcon(themedIcon(QStringLiteral("close")));
    shut->setIconSize({14, 14});
    shut->setToolTip(tr("Close (Esc)"));
    shut->setAutoRaise(true);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(8, 2, 4, 2);
    head->addWidget(m_title, 1);
    head->addWidget(shut);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(head);
    auto* below = new QHBoxLayout;
    below->setContentsMargins(6, 0, 0, 0);
    below->addWidget(m_list);
    layout->addLayout(below, 1);
    connect(shut, &QToolButton::clicked, this, &ResultsList::closeByHand);
    connect(m_list, &QTreeWidget::itemClicked, this, [this] { choose(false); });
    connect(m_list, &QTreeWidget::itemActivated, this, [this] { choose(true); });
    hide();
}

void ResultsList::showRows(const QString& title, std::vector<Row> rows) {
    m_rows = std::move(rows);
    m_title->setText(title);
    m_list->clear();
    for (const Row& row : m_rows) {
        std::string text = row.text;
        text.erase(0, std::min(text.size(), text.find_first_not_of(" \t")));
        auto* item = new QTreeWidgetItem(
            {QString::fromStdString(row.shown) + QLatin1Char(':') + QString::number(row.line), QString::fromStdString(text)});
        item->setForeground(0, ink(Ink::Faint));
        item->setFont(1, monospaceFont());
        item->setToolTip(0, row.given ? tr("%1, defined here").arg(item->text(0)) : item->text(0));
        QFont font = m_list->font();
        font.setWeight(row.given ? QFont::DemiBold : QFont::Normal);
        item->setFont(0, font);
        m_list->addTopLevelItem(item);
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
    show();
    fitColumns();
}

/// The texts get at least half of the width; longer places are elided in the middle.
void ResultsList::fitColumns() {
    const QAbstractItemView& list = *m_list; // public there
    m_list->setColumnWidth(0, std::min(list.sizeHintForColumn(0) + 4, m_list->viewport()->width() / 2));
}

bool ResultsList::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) fitColumns();
    return QWidget::eventFilter(watched, event);
}

QSize ResultsList::sizeHint() const { return {QWidget::sizeHint().width(), 170}; }

void ResultsList::setCurrent(int row) {
    QTreeWidgetItem* item = m_list->topLevelItem(row);
    m_list->setCurrentItem(item);
    if (item) m_list->scrollToItem(item);
}

void ResultsList::closeByHand() {
    hide();
    Q_EMIT closed();
}

void ResultsList::choose(bool focus) {
    const int at = m_list->indexOfTopLevelItem(m_list->currentItem());
    if (at < 0 || at >= static_cast<int>(m_rows.size())) return;
    const Row row = m_rows[static_cast<std::size_t>(at)];
    Q_EMIT chosen(row.file, row.range, focus);
}

void ResultsList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) closeByHand();
    else QWidget::keyPressEvent(event);
}

} // namespace trundle
