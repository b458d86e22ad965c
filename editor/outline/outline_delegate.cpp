#include "editor/outline/outline_delegate.h"

#include <QApplication>
#include <QLineEdit>
#include <QPainter>
#include <QPixmapCache>
#include <QTreeView>

#include "editor/outline/outline_model.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kIcon = 16, kGap = 6, kRowHeight = 24, kBadgeHeight = 15, kLeastOfKind = 4; // of an elided kind, characters

QColor textColour(const QStyleOptionViewItem& option, bool faint) {
    if (option.state & QStyle::State_Selected) return option.palette.color(QPalette::HighlightedText);
    return faint ? ink(Ink::Faint) : option.palette.color(QPalette::Text);
}

/// Paints a rounded label with a count, its right edge at `right`. Returns its left edge.
int paintBadge(QPainter& painter, const QRect& row, int right, int count, const QColor& colour) {
    if (count <= 0) return right;
    const QString text = count > 99 ? QStringLiteral("99+") : QString::number(count);
    QFont font = painter.font();
    font.setPixelSize(scaledToFont(10));
    const int height = scaledToFont(kBadgeHeight);
    font.setWeight(QFont::DemiBold);
    const int width = std::max(height, QFontMetrics(font).horizontalAdvance(text) + 8);
    const QRect badge(right - width, row.center().y() - height / 2, width, height);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(badge, height / 2.0, height / 2.0);
    painter.setFont(font);
    painter.setPen(currentTheme() == ThemeKind::Dark ? QColor(Qt::black) : QColor(Qt::white));
    painter.drawText(badge, Qt::AlignCenter, text);
    painter.restore();
    return badge.left() - 4;
}

void paintSwatch(QPainter& painter, const QRect& where, const QColor& colour) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(ink(Ink::Faint));
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(where).adjusted(1.5, 1.5, -1.5, -1.5), 3, 3);
    painter.restore();
}

} // namespace

QPixmap drawnIcon(const QString& name, int size, qreal pixelRatio, bool selected) {
    const QString key =
        QStringLiteral("outline/%1/%2/%3/%4/%5").arg(size).arg(pixelRatio).arg(int(currentTheme())).arg(selected).arg(name);
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) return picture;
    picture = QPixmap(QSize(size, size) * pixelRatio);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    themedIcon(name).paint(&painter, QRect(0, 0, size, size), Qt::AlignCenter, selected ? QIcon::Selected : QIcon::Normal);
    painter.end();
    QPixmapCache::insert(key, picture);
    return picture;
}

void OutlineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    ground.icon = {};
    ground.state &= ~QStyle::State_HasFocus;
    const QStyle* style = ground.widget ? ground.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);
    if (index.column() == OutlineModel::NameColumn) paintName(*painter, ground, index);
    else paintMark(*painter, ground, index);
}

/// The text of a row without visible marks continues over the columns of the marks.
static int widthOfUnusedMarks(const QStyleOptionViewItem& option, const QModelIndex& index) {
    const auto* tree = qobject_cast<const QTreeView*>(option.widget);
    if (!tree || (option.state & (QStyle::State_MouseOver | QStyle::State_Selected))) return 0;
    int width = 0;
    for (const int column : {int(OutlineModel::VisibleColumn), int(OutlineModel::LockedColumn)}) {
        const int mark = index.siblingAtColumn(column).data(OutlineModel::MarkRole).toInt();
        if (mark != OutlineModel::NoMark && mark != OutlineModel::Unmarked) return 0;
        width += tree->columnWidth(column);
    }
    return width;
}

void OutlineDelegate::paintName(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const bool selected = option.state & QStyle::State_Selected;
    const bool faint = index.data(OutlineModel::FaintRole).toBool();
    QRect rest = option.rect.adjusted(2, 0, -4, 0);
    const QRect icon(rest.left(), rest.center().y() - kIcon / 2 + 1, kIcon, kIcon);
    painter.save();
    if (faint && !selected) painter.setOpacity(0.55);
    if (const QVariant colour = index.data(OutlineModel::ColourRole); colour.isValid())
        paintSwatch(painter, icon, colour.value<QColor>());
    else
        painter.drawPixmap(icon.topLeft(), drawnIcon(index.data(OutlineModel::IconRole).toString(), kIcon,
                                                     painter.device()->devicePixelRatioF(), selected));
    painter.restore();
    rest.setLeft(icon.right() + kGap);

    int right = paintBadge(painter, rest, rest.right(), index.data(OutlineModel::WarningsRole).toInt(), ink(Ink::Warning));
    right = paintBadge(painter, rest, right, index.data(OutlineModel::ErrorsRole).toInt(), ink(Ink::Error));
    rest.setRight(right == rest.right() ? right + widthOfUnusedMarks(option, index)
                                        : right); // a label with a count stays in place

    painter.save();
    const QString name = index.data().toString(), detail = index.data(OutlineModel::DetailRole).toString();
    const QFontMetrics metrics(option.font);
    const QString shown = metrics.elidedText(name, Qt::ElideRight, rest.width());
    painter.setFont(option.font);
    painter.setPen(textColour(option, faint));
    painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft, shown);
    rest.setLeft(rest.left() + metrics.horizontalAdvance(shown) + kGap + 2);
    if (const QString ended = index.data(OutlineModel::EndedRole).toString(); !ended.isEmpty() && shown == name) {
        painter.setPen(selected ? option.palette.color(QPalette::HighlightedText) : ink(Ink::Error));
        painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft, ended);
        rest.setLeft(rest.left() + metrics.horizontalAdvance(ended) + kGap + 2);
    }
    const QString kind = shown == name ? metrics.elidedText(detail, Qt::ElideRight, rest.width()) : QString();
    if (kind == detail || kind.size() > kLeastOfKind) { // else only in the tooltip
        painter.setPen(textColour(option, true));
        if (selected) painter.setOpacity(0.8);
        painter.drawText(rest, Qt::AlignVCenter | Qt::AlignLeft, kind);
    }
    painter.restore();
}

void OutlineDelegate::paintMark(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int mark = index.data(OutlineModel::MarkRole).toInt();
    if (mark == OutlineModel::NoMark) return;
    const bool eye = index.column() == OutlineModel::VisibleColumn, set = mark != OutlineModel::Unmarked;
    const bool near = option.state & (QStyle::State_MouseOver | QStyle::State_Selected);
    if (!set && !near) return;
    const QString name = eye ? (set ? QStringLiteral("eye-off") : QStringLiteral("eye"))
                             : (set ? QStringLiteral("lock") : QStringLiteral("unlock"));
    painter.save();
    painter.setOpacity(mark == OutlineModel::Marked ? 1.0 : option.state & QStyle::State_Selected ? 0.8 : 0.5);
    const QRect& r = option.rect;
    painter.drawPixmap(r.center().x() - kIcon / 2 + 1, r.center().y() - kIcon / 2 + 1,
                       drawnIcon(name, kIcon, painter.device()->devicePixelRatioF(), option.state & QStyle::State_Selected));
    painter.restore();
}

QSize OutlineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const int high = std::max(kRowHeight, option.fontMetrics.height() + 6);
    if (index.column() != OutlineModel::NameColumn) return {kRowHeight, high};
    return {kIcon + 3 * kGap + option.fontMetrics.horizontalAdvance(index.data().toString()), high};
}

QWidget* OutlineDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    auto* line = new QLineEdit(parent);
    line->setObjectName(QStringLiteral("renameEditor"));
    QObject::connect(line, &QLineEdit::textEdited, line, [line, at = QPersistentModelIndex(index)](const QString& typed) {
        const auto* model = qobject_cast<const OutlineModel*>(at.model());
        const QString reason = model ? model->nameProblem(at, typed) : QString();
        line->setToolTip(reason);
        showToolTip(line->mapToGlobal(QPoint(0, line->height())), reason, line); // an empty reason hides the tool tip
    });
    return line;
}

void OutlineDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const {
    editor->setGeometry(option.rect.adjusted(kIcon + kGap - 2, 0, 0, 0));
}

} // namespace trundle
