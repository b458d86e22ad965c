#include "editor/outline/outline_view.h"

#include <QDrag>
#include <QDragMoveEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QToolTip>

#include "editor/outline/outline_delegate.h"
#include "editor/outline/outline_model.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"

namespace trundle {

static constexpr int kMaxUnfolded = 300; ///< maximum of rows expanded by a filter: a swarm has a thousand matches

OutlineView::OutlineView(OutlineModel& model, QWidget* parent) : QTreeView(parent), m_model(model) {
    setObjectName(QStringLiteral("outlineTree"));
    setModel(&model);
    setItemDelegate(new OutlineDelegate(this));
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setIndentation(14);
    setSelectionMode(ExtendedSelection);
    setSelectionBehavior(SelectRows);
    setEditTriggers(EditKeyPressed);
    setExpandsOnDoubleClick(false);
    setDragEnabled(true);
    setAcceptDrops(true);
    setDropIndicatorShown(true);
    setDefaultDropAction(Qt::MoveAction);
    setDragDropMode(DragDrop);
    setAutoScroll(true);
    setMouseTracking(true);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(16);
    header()->setSectionResizeMode(OutlineModel::NameColumn, QHeaderView::Stretch);
    for (const int column : {OutlineModel::VisibleColumn, OutlineModel::LockedColumn}) {
        header()->setSectionResizeMode(column, QHeaderView::Fixed);
        header()->resizeSection(column, 20);
    }
    connect(this, &QTreeView::expanded, this, [this](const QModelIndex& index) {
        remember(index, true);
        m_model.fetchMore(index);
    });
    connect(this, &QTreeView::collapsed, this, [this](const QModelIndex& index) { remember(index, false); });
    connect(&model, &OutlineModel::arrowsChanged, this, [this] { scheduleDelayedItemsLayout(); });
    connect(&model, &OutlineModel::renamed, this,
            [this](const std::string&, const std::string&, const std::string& from, const std::string& to) { rekey(from, to); });
    connect(&model, &QAbstractItemModel::rowsInserted, this, [this](const QModelIndex& parent, int first, int last) {
        if (m_unfolding) return;
        for (int row = first; row <= last; ++row) {
            const QModelIndex index = m_model.index(row, 0, parent);
            if (m_open.contains(m_model.keyOf(index)) && m_model.filter().empty()) expand(index);
        }
    });
    forgetFolds();
}

void OutlineView::forgetFolds() { m_open = {"/Robots", "/Objects", "/Scenery", "/Logs"}; }

void OutlineView::remember(const QModelIndex& index, bool open) {
    if (m_unfolding || !m_model.filter().empty()) return;
    if (open) m_open.insert(m_model.keyOf(index));
    else m_open.erase(m_model.keyOf(index));
}

void OutlineView::rekey(const std::string& from, const std::string& to) {
    std::set<std::string> keys;
    for (const std::string& key : m_open)
        keys.insert(key == from || key.starts_with(from + "/") ? to + key.substr(from.size()) : key);
    m_open = std::move(keys);
}

void OutlineView::unfold() {
    const QScopedValueRollback guard(m_unfolding, true);
    int budget = m_model.filter().empty() ? 1 << 20 : kMaxUnfolded;
    unfoldBelow({}, budget);
}

void OutlineView::unfoldBelow(const QModelIndex& parent, int& budget) {
    for (int row = 0; row < m_model.rowCount(parent) && budget > 0; ++row) {
        const QModelIndex index = m_model.index(row, 0, parent);
        const bool open = m_model.filter().empty() ? m_open.contains(m_model.keyOf(index)) : m_model.rowAt(index)->leadsToMatch;
        if (!open) continue;
        --budget;
        m_model.fetchMore(index);
        expand(index);
        unfoldBelow(index, budget);
    }
}

void OutlineView::reveal(const QModelIndex& index) {
    if (!index.isValid()) return;
    for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) expand(above);
    scrollTo(index);
}

void OutlineView::setEmptyText(const QString& text) {
    m_emptyText = text;
    viewport()->update();
}

bool OutlineView::onMark(QMouseEvent* event, QModelIndex& index) const {
    index = indexAt(event->position().toPoint());
    return event->button() == Qt::LeftButton && index.isValid() && index.column() != OutlineModel::NameColumn &&
           index.data(OutlineModel::MarkRole).toInt() != OutlineModel::NoMark;
}

void OutlineView::mousePressEvent(QMouseEvent* event) {
    QModelIndex index;
    if (onMark(event, index)) Q_EMIT markClicked(index);
    else QTreeView::mousePressEvent(event);
}

void OutlineView::mouseDoubleClickEvent(QMouseEvent* event) {
    QModelIndex index;
    if (onMark(event, index)) Q_EMIT markClicked(index); // a fast second click arrives as a double click
    else QTreeView::mouseDoubleClickEvent(event);
}

void OutlineView::keyPressEvent(QKeyEvent* event) {
    const bool plain = state() != EditingState && event->modifiers() == Qt::NoModifier;
    if (plain && event->key() == Qt::Key_Delete) Q_EMIT deleteRequested();
    else if (plain && event->key() == Qt::Key_F2) Q_EMIT renameRequested();
    else QTreeView::keyPressEvent(event);
}

/// Shows a label next to the pointer: an image of the rows would hide the drop indicator.
void OutlineView::startDrag(Qt::DropActions actions) {
    const QModelIndexList rows = selectionModel()->selectedRows();
    QMimeData* mime = rows.isEmpty() ? nullptr : m_model.mimeData(rows);
    if (!mime) return;
    const QString words = rows.size() == 1 ? rows.front().data().toString() : tr("%1 objects").arg(rows.size());
    const QRect box(0, 0, fontMetrics().horizontalAdvance(words) + 16, fontMetrics().height() + 6);
    QPixmap label(box.size() * devicePixelRatioF());
    label.setDevicePixelRatio(devicePixelRatioF());
    label.fill(palette().color(QPalette::Highlight));
    QPainter painter(&label);
    painter.setFont(font());
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(box, Qt::AlignCenter, words);
    painter.end();
    auto* drag = new QDrag(this);
    drag->setMimeData(mime);
    drag->setPixmap(label);
    drag->setHotSpot({-16, -12});
    drag->exec(actions, defaultDropAction());
}

/// Over a row that cannot contain the dragged objects, drops before or after it.
template <class Event> void OutlineView::adjustDropIndicator(Event& event, void (OutlineView::*take)(Event*)) {
    QPoint at = event.position().toPoint();
    const QModelIndex row = indexAt(at);
    if (row.isValid() && !m_model.canDropMimeData(event.mimeData(), event.dropAction(), -1, -1, row)) {
        const QRect box = visualRect(row), next = visualRect(row.sibling(row.row() + 1, OutlineModel::NameColumn));
        const bool behindParts = isExpanded(row.siblingAtColumn(OutlineModel::NameColumn)) && viewport()->rect().contains(next);
        at.setY(at.y() < box.center().y() ? box.top() : behindParts ? next.top() : box.bottom());
    }
    Event meant(at, event.possibleActions(), event.mimeData(), event.buttons(), event.modifiers());
    meant.setDropAction(event.dropAction());
    (this->*take)(&meant);
    event.setDropAction(meant.dropAction());
    event.setAccepted(meant.isAccepted());
}

void OutlineView::dragMoveEvent(QDragMoveEvent* event) { adjustDropIndicator(*event, &OutlineView::moveInTree); }

void OutlineView::dropEvent(QDropEvent* event) { adjustDropIndicator(*event, &OutlineView::dropInTree); }

/// HTML if there is more text than the model's; line breaks are kept.
OutlineView::Tip OutlineView::tipAt(const QModelIndex& index) const {
    const QString always = index.data(Qt::ToolTipRole).toString();
    const OutlineRow* row = m_model.rowAt(index);
    const bool named = row && row->selectable && index.column() == OutlineModel::NameColumn;
    const QString more = named && m_moreTip ? m_moreTip(row->path) : QString();
    if (more.isEmpty()) return {always, false};
    return {
        (always.isEmpty() ? QString() : QStringLiteral("<p style='white-space:pre-wrap'>%1</p>").arg(always.toHtmlEscaped())) +
            more,
        true};
}

bool OutlineView::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QTreeView::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    m_tipRow = indexAt(help->pos());
    m_tipPlace = help->globalPos();
    m_tip = tipAt(m_tipRow);
    showTip();
    return true;
}

void OutlineView::showTip() {
    (m_tip.isHtml ? showHtmlToolTip : showToolTip)(m_tipPlace, m_tip.text, viewport(), visualRect(m_tipRow));
}

void OutlineView::renewTip() {
    if (m_tip.text.isEmpty() || !m_tipRow.isValid() || !QToolTip::isVisible() || QToolTip::text() != m_tip.text) return;
    Tip tip = tipAt(m_tipRow);
    if (tip.text == m_tip.text) return;
    m_tip = std::move(tip);
    showTip();
}

void OutlineView::paintEvent(QPaintEvent* event) {
    QTreeView::paintEvent(event);
    if (m_emptyText.isEmpty() || m_model.rowCount() > 0) return;
    QPainter painter(viewport());
    painter.setPen(ink(Ink::Faint));
    painter.drawText(viewport()->rect().adjusted(16, 24, -16, -16), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                     m_emptyText);
}

} // namespace trundle
