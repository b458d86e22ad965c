// Applies a reload to rows that a view has accessed.
//
// needs: the current rows of a node and its new rows; keys that are unique among siblings.
// assumes: most edits change few rows; a removed and an added name at the same position and of the same kind are a rename.
// method: rename in place, remove missing rows in runs, then walk along the new rows: insert runs of new rows, move rows whose
//      position changed, update the content, and report only rows that differ. Then the same for the children of fetched rows.
// data: Node::row has pointers into the loaded project, so every existing row is updated each time.

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "editor/outline/outline_model.h"
#include "editor/outline/outline_node.h"

namespace trundle {
namespace {

bool hasSameContent(const OutlineRow& a, const OutlineRow& b) {
    return a.name == b.name && a.detail == b.detail && a.problems == b.problems && a.colour == b.colour &&
           a.hasRows == b.hasRows && a.tip == b.tip && a.selectable == b.selectable && a.markable == b.markable &&
           a.matches == b.matches && a.path == b.path;
}

std::string kindWord(const OutlineRow& row) { return row.part ? row.part->block->type.text : std::string(); }

using Keys = std::unordered_set<std::string_view>;

} // namespace

std::vector<OutlineRow> OutlineModel::rowsBelow(const OutlineNode& node) const {
    if (!m_rows) return {};
    std::vector<OutlineRow> rows = node.parent ? m_rows->below(node.row) : m_rows->top();
    m_computed += rows.size();
    return rows;
}

void OutlineModel::reset() {
    beginResetModel();
    m_root = std::make_unique<OutlineNode>();
    m_index.clear();
    m_root->fetched = true;
    std::vector<OutlineRow> rows = rowsBelow(*m_root);
    for (OutlineRow& row : rows) {
        m_root->children.push_back(std::make_unique<OutlineNode>(OutlineNode{m_root.get(), 0, std::move(row), {}, false}));
        m_index.add(*m_root->children.back());
    }
    m_root->number();
    endResetModel();
}

void OutlineModel::follow(const ChangeSet& changes) {
    const bool anew = !changes.after() || !m_rows;
    const auto before = std::exchange(m_rows, nullptr); // rows point into it until each is updated
    if (changes.after()) makeRows(changes.after());
    if (anew) return reset();
    const bool isKnown = before->loaded() == changes.before() && !before->filtered() && m_model.empty();
    if (!isKnown || changes.changesObjects() || changes.changesProblems()) return update(*m_root);
    std::unordered_set<const Part*> changed;
    for (const PartChange& part : changes.parts()) changed.insert(part.now);
    if (!relink(*m_root, changed)) update(*m_root);
}

/// After an edit that kept all objects and problems: all rows get their new blocks, and those of changed blocks new contents.
bool OutlineModel::relink(OutlineNode& node, const std::unordered_set<const Part*>& changed) {
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        OutlineNode& child = *node.children[i];
        if (node.parent && !m_rows->relink(child.row, node.row, i)) return false;
        if (child.row.type == OutlineRow::Type::Object && !child.row.member && changed.contains(child.row.part)) {
            take(child, m_rows->renewed(child.row, node.row));
            ++m_computed;
        }
        if (!relink(child, changed)) return false;
    }
    return true;
}

void OutlineModel::makeRows(std::shared_ptr<const LoadedProject> loaded) {
    m_rows = std::make_unique<OutlineRows>(std::move(loaded), m_mode, m_filter, m_model);
}

void OutlineModel::showAgain(bool differs) {
    if (!differs) return;
    if (m_rows) makeRows(m_rows->loaded());
    reset();
}

bool OutlineModel::canFetchMore(const QModelIndex& parent) const {
    if (parent.column() > 0) return false;
    const OutlineNode& node = nodeOf(parent);
    return node.parent && !node.fetched && node.row.hasRows;
}

void OutlineModel::fetchMore(const QModelIndex& parent) {
    if (!canFetchMore(parent)) return;
    OutlineNode& node = nodeOf(parent);
    node.fetched = true;
    std::vector<OutlineRow> rows = rowsBelow(node);
    if (!rows.empty()) addAt(node, rows, 0);
}

/// Inserts all rows consecutively before the child at `at`.
void OutlineModel::addAt(OutlineNode& node, std::vector<OutlineRow>& rows, std::size_t at) {
    beginInsertRows(indexOf(node), static_cast<int>(at), static_cast<int>(at + rows.size()) - 1);
    std::vector<std::unique_ptr<OutlineNode>> fresh;
    for (OutlineRow& row : rows) {
        fresh.push_back(std::make_unique<OutlineNode>(OutlineNode{&node, 0, std::move(row), {}, false}));
        m_index.add(*fresh.back());
    }
    node.children.insert(node.children.begin() + std::ptrdiff_t(at), std::make_move_iterator(fresh.begin()),
                         std::make_move_iterator(fresh.end()));
    node.number(at);
    endInsertRows();
}

void OutlineModel::take(OutlineNode& node, OutlineRow row) {
    const bool same = hasSameContent(node.row, row);
    const OutlineRow old = std::exchange(node.row, std::move(row));
    m_index.update(node, old);
    if (!same) Q_EMIT dataChanged(indexOf(node), indexOf(node, ColumnCount - 1));
    if (!node.fetched && old.hasRows != node.row.hasRows) Q_EMIT arrowsChanged();
}

/// Removes children that are not in `rows`, except renamed ones.
void OutlineModel::dropGone(OutlineNode& node, const std::vector<OutlineRow>& rows) {
    Keys now;
    std::unordered_set<std::string> before; // copies: the rows change below
    for (const OutlineRow& row : rows) now.insert(row.key);
    for (const auto& child : node.children) before.insert(child->row.key);
    for (std::size_t i = 0; i < node.children.size() && i < rows.size() && node.children.size() == rows.size(); ++i) {
        OutlineNode& child = *node.children[i];
        if (now.contains(child.row.key) || before.contains(rows[i].key) || kindWord(child.row) != kindWord(rows[i])) continue;
        if (child.row.type != OutlineRow::Type::Object || rows[i].type != OutlineRow::Type::Object) continue;
        const std::string fromKey = keyOf(indexOf(child)), fromPath = child.row.path;
        take(child, rows[i]);
        Q_EMIT renamed(fromPath, child.row.path, fromKey, keyOf(indexOf(child)));
    }
    for (std::size_t end = node.children.size(); end > 0;) {
        std::size_t begin = end;
        while (begin > 0 && !now.contains(node.children[begin - 1]->row.key)) --begin;
        if (begin == end) {
            --end;
            continue;
        }
        beginRemoveRows(indexOf(node), static_cast<int>(begin), static_cast<int>(end) - 1);
        const auto first = node.children.begin() + std::ptrdiff_t(begin), last = node.children.begin() + std::ptrdiff_t(end);
        for (auto it = first; it != last; ++it) m_index.remove(**it);
        node.children.erase(first, last);
        node.number(begin);
        endRemoveRows();
        end = begin;
    }
}

void OutlineModel::update(OutlineNode& node) {
    if (node.parent && !node.fetched) return;
    std::vector<OutlineRow> rows = rowsBelow(node);
    dropGone(node, rows);
    std::unordered_set<std::string> kept;
    for (const auto& child : node.children) kept.insert(child->row.key);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!kept.contains(rows[i].key)) {
            std::size_t end = i + 1;
            while (end < rows.size() && !kept.contains(rows[end].key)) ++end;
            std::vector<OutlineRow> fresh(rows.begin() + std::ptrdiff_t(i), rows.begin() + std::ptrdiff_t(end));
            addAt(node, fresh, i);
            i = end - 1;
            continue;
        }
        std::size_t from = i;
        while (node.children[from]->row.key != rows[i].key) ++from;
        if (from != i) {
            beginMoveRows(indexOf(node), static_cast<int>(from), static_cast<int>(from), indexOf(node), static_cast<int>(i));
            std::rotate(node.children.begin() + std::ptrdiff_t(i), node.children.begin() + std::ptrdiff_t(from),
                        node.children.begin() + std::ptrdiff_t(from) + 1);
            node.number(i);
            endMoveRows();
        }
        take(*node.children[i], std::move(rows[i]));
    }
    for (const auto& child : node.children) update(*child);
    if (node.parent && node.children.empty()) node.fetched = false; // later children are fetched again
}

} // namespace trundle
