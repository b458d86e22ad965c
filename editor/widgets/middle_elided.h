#pragma once
#include <QStyledItemDelegate>

namespace trundle {

/// Long texts of a column are shortened in the middle, so that both ends of a path and line stay readable.
class MiddleElided final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->textElideMode = Qt::ElideMiddle;
    }
};

} // namespace trundle
