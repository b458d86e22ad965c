#pragma once
// The item model of the Scene tree. Rows are created on first access; a reload changes only the rows that differ, so that
// expanded and selected rows stay.

#include <memory>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include <QAbstractItemModel>

#include "editor/outline/outline_drops.h"
#include "editor/outline/outline_index.h"
#include "editor/outline/outline_rows.h"
#include "project/edits/change_set.h"

namespace trundle {

class EndedRobots;
class ObjectEdits;
class ObjectMarks;

class OutlineModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { NameColumn, VisibleColumn, LockedColumn, ColumnCount };
    enum Role { DetailRole = Qt::UserRole + 1, IconRole, ErrorsRole, WarningsRole, ColourRole, MarkRole, FaintRole, EndedRole };
    enum Mark { NoMark, Unmarked, Marked, MarkedAbove }; ///< under MarkRole; MarkedAbove: an enclosing object is

    OutlineModel(ObjectEdits& edits, ObjectMarks& marks, QObject* parent = nullptr);
    ~OutlineModel() override;

    /// Marks the robots of a run that have ended by a fault, and everything in them. They must outlive the model.
    void showEnded(const EndedRobots& ended);
    /// The project after an edit. Only the rows of what has changed are computed again.
    void follow(const ChangeSet& changes);
    // They reset the model.
    void setMode(OutlineMode mode) { showAgain(std::exchange(m_mode, mode) != mode); }
    void setFilter(const std::string& filter) { showAgain(std::exchange(m_filter, filter) != filter); }
    /// Shows a config alone; empty: everything.
    void setModel(const std::string& path) { showAgain(std::exchange(m_model, path) != path); }
    [[nodiscard]] OutlineMode mode() const { return m_mode; }
    [[nodiscard]] const std::string& filter() const { return m_filter; }

    [[nodiscard]] const OutlineRow* rowAt(const QModelIndex& index) const; ///< nullptr: no row. Valid until the next change
    /// The keys of the row and its ancestors, joined; stable across reloads.
    [[nodiscard]] std::string keyOf(const QModelIndex& index) const;
    /// The row of an object; created if it does not exist yet.
    [[nodiscard]] QModelIndex indexOf(const std::string& path);
    /// Why the row's object cannot have this name; empty if it can.
    [[nodiscard]] QString nameProblem(const QModelIndex& index, const QString& name) const;
    struct Work {                 ///< for tests
        std::size_t made = 0;     ///< rows that exist
        std::size_t computed = 0; ///< rows whose contents were computed so far
    };
    [[nodiscard]] Work work() const { return {m_index.size(), m_computed}; }

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool canDropMimeData(const QMimeData* mime, Qt::DropAction, int row, int, const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* mime, Qt::DropAction action, int row, int column, const QModelIndex& parent) override;

Q_SIGNALS:
    /// A row whose children have not been fetched gained its first child or lost its last, so its expand arrow changes.
    void arrowsChanged();
    /// An object was renamed; its row now has another path and key.
    void renamed(const std::string& fromPath, const std::string& toPath, const std::string& fromKey, const std::string& toKey);

protected: // called by views
    int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
    bool hasChildren(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    Qt::DropActions supportedDragActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    QStringList mimeTypes() const override { return OutlineDrops::mimeTypes(); }

private:
    [[nodiscard]] OutlineNode& nodeOf(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(const OutlineNode& node, int column = 0) const;
    [[nodiscard]] QModelIndex indexOfMember(const std::string& layout, const std::string& name);
    [[nodiscard]] std::vector<OutlineRow> rowsBelow(const OutlineNode& node) const;
    [[nodiscard]] bool isFaint(const OutlineRow& row) const;
    void reset();
    void showAgain(bool differs);
    void makeRows(std::shared_ptr<const LoadedProject> loaded);
    void update(OutlineNode& node);
    [[nodiscard]] bool relink(OutlineNode& node, const std::unordered_set<const Part*>& changed);
    void dropGone(OutlineNode& node, const std::vector<OutlineRow>& rows);
    void addAt(OutlineNode& node, std::vector<OutlineRow>& rows, std::size_t at);
    void take(OutlineNode& node, OutlineRow row);
    void marksChanged();

    ObjectEdits& m_edits;
    ObjectMarks& m_marks;
    OutlineDrops m_drops;
    const EndedRobots* m_ended = nullptr;
    std::unique_ptr<OutlineRows> m_rows; // nullptr: nothing is open
    OutlineMode m_mode = OutlineMode::ByOwner;
    std::string m_filter, m_model; // m_model: path of the config that is shown alone; empty: none
    std::unique_ptr<OutlineNode> m_root;
    OutlineIndex m_index;
    mutable std::size_t m_computed = 0;
};

} // namespace trundle
