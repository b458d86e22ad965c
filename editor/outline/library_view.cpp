#include "editor/outline/library_view.h"

#include <QApplication>
#include <QDrag>
#include <QMimeData>
#include <QPainter>
#include <QPainterPath>

#include "editor/outline/library_model.h"
#include "editor/outline/outline_delegate.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kCell = 90, kCellHeight = 84, kRow = 44; // at the default font
constexpr int kPad = 4, kIconSize = 28, kDraggedSize = 24;
constexpr QSize kListPicture(72, 34);

} // namespace

void LibrarySectionFilter::setWords(const QStringList& words) {
    m_words = words;
    invalidateFilter();
    sort(0);
}

/// 0: its title begins with the first word; 1: all words are in the title; 2: some are in its help alone.
int LibrarySectionFilter::rankOf(const QModelIndex& index) const {
    const QString title = index.data().toString();
    if (m_words.isEmpty() || title.startsWith(m_words.front(), Qt::CaseInsensitive)) return 0;
    const auto isInTitle = [&](const QString& word) { return title.contains(word, Qt::CaseInsensitive); };
    return std::ranges::all_of(m_words, isInTitle) ? 1 : 2;
}

bool LibrarySectionFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const int a = rankOf(left), b = rankOf(right);
    return a != b ? a < b : left.row() < right.row();
}

bool LibrarySectionFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex index = sourceModel()->index(row, 0, parent);
    if (index.data(LibraryModel::SectionRole).toInt() != int(m_section)) return false;
    const QString text = index.data().toString() + QLatin1Char(' ') + index.data(LibraryModel::HelpRole).toString() +
                         QLatin1Char(' ') + sectionTitle(m_section);
    return std::all_of(m_words.begin(), m_words.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

QStringList libraryTitleLines(const QString& title, const QFontMetrics& metrics, int width) {
    if (metrics.horizontalAdvance(title) <= width) return {title};
    for (qsizetype at = title.size() - 1; at > 0; --at) {
        const bool splits = title[at] == u' ' || (title[at].isUpper() && !title[at - 1].isUpper()) || title[at - 1] == u'_';
        const QString first = splits ? title.left(at).trimmed() : QString();
        if (!first.isEmpty() && metrics.horizontalAdvance(first) <= width)
            return {first, metrics.elidedText(title.mid(at).trimmed(), Qt::ElideRight, width)};
    }
    return {metrics.elidedText(title, Qt::ElideRight, width)};
}

void LibraryDelegate::paintPicture(QPainter& painter, const QStyleOptionViewItem& option, const QRect& where,
                                   const QModelIndex& index) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QPainterPath frame;
    frame.addRoundedRect(QRectF(where).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    const QVariant picture = index.data(LibraryModel::PictureRole);
    if (picture.isValid()) {
        painter.setClipPath(frame);
        const QPixmap pixmap = picture.value<QPixmap>();
        const QSize fitted = pixmap.size().scaled(where.size(), Qt::KeepAspectRatioByExpanding);
        painter.drawPixmap(QRect(where.center() - QPoint(fitted.width() / 2, fitted.height() / 2), fitted), pixmap);
        painter.setClipping(false);
    } else {
        painter.fillPath(frame, option.palette.color(QPalette::AlternateBase));
        const int size = std::min(kIconSize, where.height() - 10);
        painter.drawPixmap(where.center() - QPoint(size / 2 - 1, size / 2 - 1),
                           drawnIcon(index.data(LibraryModel::IconRole).toString(), size, painter.device()->devicePixelRatioF()));
    }
    painter.setPen(ink(Ink::Line));
    painter.drawPath(frame);
    painter.restore();
}

void LibraryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    ground.state &= ~QStyle::State_HasFocus;
    ground.showDecorationSelected = true; // fills the whole cell; the text is drawn below
    const QStyle* style = ground.widget ? ground.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);
    const bool selected = option.state & QStyle::State_Selected;
    const QRect r = option.rect.adjusted(kPad, kPad, -kPad, -kPad);
    const QFontMetrics metrics(option.font);
    painter->save();
    painter->setFont(option.font);
    painter->setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
    const QString title = index.data().toString();
    if (asList) {
        paintPicture(*painter, option, QRect(QPoint(r.left(), r.center().y() - kListPicture.height() / 2), kListPicture), index);
        const QRect text = r.adjusted(kListPicture.width() + 8, 0, 0, 0);
        const QString help = index.data(LibraryModel::HelpRole).toString();
        const QRect upper(text.left(), text.top(), text.width(), help.isEmpty() ? text.height() : text.height() / 2);
        painter->drawText(upper, Qt::AlignVCenter | Qt::AlignLeft, metrics.elidedText(title, Qt::ElideRight, text.width()));
        if (!selected) painter->setPen(ink(Ink::Faint));
        painter->drawText(text.adjusted(0, text.height() / 2, 0, 0), Qt::AlignVCenter | Qt::AlignLeft,
                          metrics.elidedText(help, Qt::ElideRight, text.width()));
    } else {
        const int height = titleLines * metrics.height();
        paintPicture(*painter, option, r.adjusted(0, 0, 0, -height - 3), index);
        painter->drawText(QRect(r.left(), r.bottom() - height, r.width(), height + 1), Qt::AlignHCenter | Qt::AlignTop,
                          libraryTitleLines(title, metrics, r.width()).join(u'\n'));
    }
    painter->restore();
}

QSize LibraryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const auto* list = qobject_cast<const QListView*>(option.widget);
    return {std::max(scaledToFont(kCell), list ? list->gridSize().width() : 0), height(option.fontMetrics)};
}

int LibraryDelegate::height(const QFontMetrics& metrics) const {
    return asList ? scaledToFont(kRow) : scaledToFont(kCellHeight) + (titleLines - 1) * metrics.height();
}

LibraryList::LibraryList(QWidget* parent) : QListView(parent), m_delegate(new LibraryDelegate(this)) {
    setItemDelegate(m_delegate);
    setUniformItemSizes(true);
    setResizeMode(Adjust);
    setMovement(Static);
    setDragEnabled(true);
    setDragDropMode(DragOnly);
    setSelectionMode(SingleSelection);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(NoFrame);
    setAsList(false);
}

void LibraryList::setAsList(bool list) {
    m_delegate->asList = list;
    setViewMode(list ? ListMode : IconMode);
    setMovement(Static);
    setDragEnabled(true);
    setWrapping(!list);
    setFlow(list ? TopToBottom : LeftToRight);
    fit();
}

void LibraryList::fit() {
    const int count = model() ? model()->rowCount() : 0, cell = scaledToFont(kCell);
    const int room = std::max(viewport()->width() - 1, cell); // less one: at the exact width the last column would not fit
    const int columns = m_delegate->asList ? 1 : std::max(1, room / cell);
    m_delegate->titleLines = titleLines(room / columns);
    const int height = m_delegate->height(fontMetrics());
    setGridSize(QSize(room / columns, height));
    setFixedHeight((count + columns - 1) / columns * height + 2);
    doItemsLayout(); // now: the delayed layout would use the old width
}

/// Two if a title does not fit into one line of a cell.
int LibraryList::titleLines(int cell) const {
    for (int row = 0; model() && row < model()->rowCount(); ++row)
        if (fontMetrics().horizontalAdvance(model()->index(row, 0).data().toString()) > cell - 2 * kPad) return 2;
    return 1;
}

void LibraryList::resizeEvent(QResizeEvent* event) {
    QListView::resizeEvent(event);
    if (event->size().width() != event->oldSize().width()) fit();
}

void LibraryList::changeEvent(QEvent* event) {
    QListView::changeEvent(event);
    if (event->type() == QEvent::FontChange) fit();
}

void LibraryList::keyPressEvent(QKeyEvent* event) {
    const QModelIndex before = currentIndex();
    QListView::keyPressEvent(event);
    if (currentIndex() != before) return;
    if (event->key() == Qt::Key_Down) Q_EMIT leftBehind(1);
    if (event->key() == Qt::Key_Up) Q_EMIT leftBehind(-1);
}

void LibraryList::startDrag(Qt::DropActions) {
    const QModelIndex index = currentIndex();
    QMimeData* mime = index.isValid() ? model()->mimeData({index}) : nullptr;
    if (!mime) return;
    auto* drag = new QDrag(this);
    drag->setMimeData(mime);
    // Small and next to the cursor: the viewport shows a preview of the object itself.
    drag->setPixmap(drawnIcon(index.data(LibraryModel::IconRole).toString(), kDraggedSize, devicePixelRatioF()));
    drag->setHotSpot(QPoint(-kDraggedSize / 2, -kDraggedSize / 2));
    drag->exec(Qt::CopyAction);
}

} // namespace trundle
