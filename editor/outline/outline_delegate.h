#pragma once
#include <QStyledItemDelegate>

namespace trundle {

/// Draws a row of the Scene tree: icon, name, kind in a faint colour, problem counts; in the other columns visibility and lock.
/// Edits names.
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

/// A theme icon as a pixmap, cached by name, size and colour.
[[nodiscard]] QPixmap drawnIcon(const QString& name, int size, qreal pixelRatio, bool selected = false);

} // namespace trundle
