#pragma once
#include <QSignalBlocker>
#include <QStringList>

class QAbstractItemModel;
class QTreeWidget;

namespace trundle {

constexpr int kIsPathRole = Qt::UserRole + 1; ///< true: the end of the text matters most

/// A table without a tree's decoration, whose columns have space between them. Paths (kIsPathRole) keep their ends.
[[nodiscard]] QTreeWidget* panelTable(const char* name, const QStringList& columns);

/// Changes of many rows reach the view as one: otherwise each of them measures the columns again.
class ChangedTogether {
public:
    explicit ChangedTogether(const QTreeWidget& table);
    ~ChangedTogether();
    ChangedTogether(const ChangedTogether&) = delete;
    ChangedTogether& operator=(const ChangedTogether&) = delete;

private:
    QAbstractItemModel& m_model;
    QSignalBlocker m_quiet;
};

} // namespace trundle
