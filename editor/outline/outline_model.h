#pragma once
// The rows of the scene tree as Qt's views take them. Children are made when they are first looked at; a new load changes only
// the rows that differ, so what is expanded and selected stays so.

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <QAbstractItemModel>

#include "editor/outline/outline_rows.h"

namespace trundle {

class ObjectEdits;
class ObjectMarks;

class OutlineModel final : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { NameColumn, VisibleColumn, LockedColumn, ColumnCount };
    enum Role { DetailRole = Qt::UserRole + 1, IconRole, ErrorsRole, WarningsRole, ColourRole, MarkRole, FaintRole };
    enum Mark { NoMark, Unmarked, Marked, MarkedAbove }; ///< of the eye and the lock, under MarkRole

    OutlineModel(ObjectEdits& edits, ObjectMarks& marks, QObject* parent = nullptr);
    ~OutlineModel() override;

    /// The next load of the same project; nullptr: nothing is open.
    void setLoaded(std::shared_ptr<const Loaded> loaded);
    // Both begin anew: the model is reset.
    void setMode(OutlineMode mode);
    void setFilter(const std::string& filter);
    [[nodiscard]] OutlineMode mode() const { return m_mode; }
    [[nodiscard]] const std::string& filter() const { return m_filter; }

    [[nodiscard]] const OutlineRow* rowAt(const QModelIndex& index) const; ///< nullptr: no row. Good until the next change
    /// Keys from the top down, joined: the same from load to load.
    [[nodiscard]] std::string keyOf(const QModelIndex& index) const;
    /// The row of an object, made where it has not been looked at yet.
    [[nodiscard]] QModelIndex indexOf(const std::string& path);
    /// Why a row's object cannot be called so; empty where it can.
    [[nodiscard]] QString nameRefusal(const QModelIndex& index, const QString& name) const;
    /// Rows made so far.
    [[nodiscard]] std::size_t made() const { return m_made; }

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
    bool hasChildren(const QModelIndex& parent = {}) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    Qt::DropActions supportedDragActions() const override { return Qt::MoveAction | Qt::CopyAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool canDropMimeData(const QMimeData* mime, Qt::DropAction action, int row, int column,
                         const QModelIndex& parent) const override;
    bool dropMimeData(const QMimeData* mime, Qt::DropAction action, int row, int column, const QModelIndex& parent) override;

Q_SIGNALS:
    /// A row that nobody has looked into has got its first rows below it, or lost its last.
    void arrowsChanged();
    /// The row of one object is now that of another of the same place: it has a new name.
    void renamed(const std::string& fromPath, const std::string& toPath, const std::string& fromKey, const std::string& toKey);

private:
    struct Node;
    [[nodiscard]] Node& nodeOf(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(const Node& node, int column = 0) const;
    [[nodiscard]] QModelIndex indexOfMember(const std::string& layout, const std::string& name);
    [[nodiscard]] std::vector<OutlineRow> rowsBelow(const Node& node) const;
    [[nodiscard]] QVariant markOf(const OutlineRow& row, bool hidden) const;
    void reset();
    void update(Node& node);
    void dropGone(Node& node, const std::vector<OutlineRow>& rows);
    void addAt(Node& node, std::vector<OutlineRow>& rows, std::size_t at);
    void take(Node& node, OutlineRow row);
    void enlist(const Node& node);
    void strike(const Node& node);
    void marksChanged();
    struct DropPlace;
    [[nodiscard]] DropPlace dropPlace(int row, const QModelIndex& parent) const;

    ObjectEdits& m_edits;
    ObjectMarks& m_marks;
    std::unique_ptr<OutlineRows> m_rows; // nullptr: nothing is open
    OutlineMode m_mode = OutlineMode::ByOwner;
    std::string m_filter;
    std::unique_ptr<Node> m_root;
    std::unordered_map<std::string, const Node*> m_byPath;
    std::size_t m_made = 0;
};

} // namespace trundle
