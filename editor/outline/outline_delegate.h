#pragma once
#include <QStyledItemDelegate>

namespace trundle {

/// Draws a row of the scene tree: icon, name, kind in a faint colour, problems; in the other columns eye and lock. Edits names.
class OutlineDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    void paintName(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
    void paintMark(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
};

/// An icon of the theme as a picture, drawn once for each size and colour.
[[nodiscard]] QPixmap drawnIcon(const QString& name, int size, qreal pixelRatio, bool selected = false);

} // namespace trundle
