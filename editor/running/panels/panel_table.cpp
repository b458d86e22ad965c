#include "editor/running/panels/panel_table.h"

#include <algorithm>

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <QTreeWidget>

namespace trundle {
namespace {

/// Adds space between the columns, keeps the ends of paths, and keeps long texts from using the room of the other columns.
class SpacedColumns final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.data(kIsPathRole).toBool()) option->textElideMode = Qt::ElideLeft;
    }
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        constexpr int kGap = 18, kMostCharacters = 60;
        const QSize size = QStyledItemDelegate::sizeHint(option, index);
        return {std::min(size.width(), kMostCharacters * option.fontMetrics.averageCharWidth()) + kGap, size.height()};
    }
};

} // namespace

QTreeWidget* panelTable(const char* name, const QStringList& columns) {
    auto* made = new QTreeWidget;
    made->setObjectName(QLatin1String(name));
    made->setHeaderLabels(columns);
    made->setRootIsDecorated(false);
    made->setUniformRowHeights(true);
    made->setAllColumnsShowFocus(true);
    made->setItemDelegate(new SpacedColumns(made));
    made->header()->setStretchLastSection(true);
    return made;
}

ChangedTogether::ChangedTogether(const QTreeWidget& table) : m_model(*table.model()), m_quiet(&m_model) {}

ChangedTogether::~ChangedTogether() {
    m_quiet.unblock();
    const int rows = m_model.rowCount();
    if (rows > 0) Q_EMIT m_model.dataChanged(m_model.index(0, 0), m_model.index(rows - 1, m_model.columnCount() - 1));
}

} // namespace trundle
