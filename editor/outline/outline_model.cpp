#include "editor/outline/outline_model.h"

#include <algorithm>

#include <QColor>

#include "editor/outline/kind_icons.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/outline/outline_node.h"
#include "editor/outline/row_members.h"
#include "editor/running/session.h"
#include "editor/widgets/strings.h"
#include "model/dotted_path.h"
#include "project/edits/insert_positions.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

QString iconOf(const OutlineRow& row) {
    switch (row.type) {
    case OutlineRow::Type::Experiment: return QStringLiteral("kind-settings");
    case OutlineRow::Type::File: return QStringLiteral("kind-file");
    case OutlineRow::Type::Module: return QStringLiteral("module");
    case OutlineRow::Type::Object:
    case OutlineRow::Type::Members:
        if (row.passive && (row.member || row.part->is(Role::Instance))) return QStringLiteral("kind-object");
        return row.member ? QStringLiteral("kind-robot") : kindIcon(row.part->kind);
    case OutlineRow::Type::Group: break;
    }
    switch (row.group) {
    case OutlineGroup::Robots: return QStringLiteral("kind-robot");
    case OutlineGroup::Objects: return QStringLiteral("kind-object");
    case OutlineGroup::Scenery: return QStringLiteral("kind-static");
    case OutlineGroup::Joints: return QStringLiteral("kind-hinge");
    case OutlineGroup::Regions: return QStringLiteral("kind-region");
    case OutlineGroup::Looks: return QStringLiteral("kind-look");
    case OutlineGroup::Radio: return QStringLiteral("kind-radio");
    case OutlineGroup::Logs: return QStringLiteral("kind-poselog");
    case OutlineGroup::Modules: return QStringLiteral("module");
    case OutlineGroup::RobotConfigs: return QStringLiteral("kind-robotconfig");
    case OutlineGroup::StaticConfigs: return QStringLiteral("kind-staticconfig");
    case OutlineGroup::PartConfigs: return QStringLiteral("kind-partconfig");
    case OutlineGroup::Materials: return QStringLiteral("kind-material");
    case OutlineGroup::Surfaces: return QStringLiteral("kind-surface");
    case OutlineGroup::Misplaced: break;
    }
    return QStringLiteral("kind-unknown");
}

QString tipOf(const OutlineRow& row, const EndedRobots* ended) {
    QStringList lines;
    if (!row.detail.empty()) lines << toQString(row.name + "  " + row.detail); // the row may elide it
    if (!row.tip.empty()) lines << toQString(row.tip);
    if (ended && row.selectable)
        if (const QString why = ended->explanation(row.path); !why.isEmpty()) lines << why;
    const auto [errors, warnings] = row.problems;
    if (errors > 0)
        lines << QStringLiteral("%1 %2").arg(QString::number(errors),
                                             errors == 1 ? OutlineModel::tr("error") : OutlineModel::tr("errors"));
    if (warnings > 0)
        lines << QStringLiteral("%1 %2").arg(QString::number(warnings),
                                             warnings == 1 ? OutlineModel::tr("warning") : OutlineModel::tr("warnings"));
    return lines.join(u'\n');
}

/// "ended", "3 ended"; empty for parts of a robot.
QString endedLabel(const OutlineRow& row, const EndedRobots* ended, const OutlineRows& rows) {
    if (!ended || ended->empty()) return {};
    if (row.type != OutlineRow::Type::Members) return row.path.empty() ? QString() : ended->label(row.path);
    const std::vector<RobotSpec>& robots = rows.loaded()->experiment->robots;
    std::size_t count = 0;
    for (std::size_t i = row.first; i < std::min(row.last, robots.size()); ++i) count += ended->countOf(robots[i].name);
    return count == 0 ? QString() : OutlineModel::tr("%1 ended").arg(count);
}

QVariant markOf(const ObjectMarks& marks, const OutlineRow& row, bool hidden) {
    if (!row.markable) return OutlineModel::NoMark;
    if ((hidden ? marks.hidden() : marks.locked()).contains(row.path)) return OutlineModel::Marked;
    return (hidden ? marks.isHidden(row.path) : marks.isLocked(row.path)) ? OutlineModel::MarkedAbove : OutlineModel::Unmarked;
}

} // namespace

OutlineModel::OutlineModel(ObjectEdits& edits, ObjectMarks& marks, QObject* parent)
    : QAbstractItemModel(parent), m_edits(edits), m_marks(marks), m_drops(edits), m_root(std::make_unique<OutlineNode>()) {
    connect(&marks, &ObjectMarks::hiddenChanged, this, &OutlineModel::marksChanged);
    connect(&marks, &ObjectMarks::lockedChanged, this, &OutlineModel::marksChanged);
}

OutlineModel::~OutlineModel() = default;

OutlineNode& OutlineModel::nodeOf(const QModelIndex& index) const {
    return index.isValid() ? *static_cast<OutlineNode*>(index.internalPointer()) : *m_root;
}

QModelIndex OutlineModel::indexOf(const OutlineNode& node, int column) const {
    return node.parent ? createIndex(node.place, column, &node) : QModelIndex();
}

const OutlineRow* OutlineModel::rowAt(const QModelIndex& index) const { return index.isValid() ? &nodeOf(index).row : nullptr; }

std::string OutlineModel::keyOf(const QModelIndex& index) const {
    std::string key;
    for (const OutlineNode* node = &nodeOf(index); node->parent; node = node->parent) key = "/" + node->row.key + key;
    return key;
}

/// The path with the names of Repeats, and of Grids and Scatters in them, instead of those of their members, which have one row.
static std::string withoutMembers(const ObjectLocation& place, const std::string& path) {
    std::string all;
    const DottedPath dotted(path);
    for (const std::string& word : dotted.words()) {
        const auto isMember = [&](const auto& m) {
            return (m.first->isRepeat() || !place.around.empty()) && word == m.first->name + "_" + std::to_string(m.second);
        };
        const auto it = std::ranges::find_if(place.members, isMember);
        all = pathInside(all, it == place.members.end() ? word : it->first->name);
    }
    return all;
}

QModelIndex OutlineModel::indexOf(const std::string& path) {
    if (const OutlineNode* node = m_rows ? m_index.find(path) : nullptr) return indexOf(*node);
    if (!m_rows || !placeOf(*m_rows->loaded(), path)) return {};
    if (const std::string all = withoutMembers(*placeOf(*m_rows->loaded(), path), path); all != path) return indexOf(all);
    const std::string first(firstWord(path)), inside(withoutFirstWord(path));
    if (!inside.empty()) {
        const QModelIndex above = indexOf(std::string(withoutLastWord(path)));
        if (above.isValid() && canFetchMore(above)) fetchMore(above);
        if (const OutlineNode* node = m_index.find(path)) return indexOf(*node);
    }
    const Part* layout = layoutOfMember(*m_rows->loaded()->outline, first);
    if (layout && layout->name != first) {
        if (!inside.empty()) return indexOf(pathInside(layout->name, inside)); // the member's rows were made with `above`
        const QModelIndex member = indexOfMember(layout->name, first);
        return member.isValid() ? member : indexOf(layout->name);
    }
    // Top-level objects are in a group or file whose rows may not exist yet.
    for (const auto& top : m_root->children) {
        const QModelIndex group = indexOf(*top);
        if (!withoutFirstWord(inside).empty()) break;
        if (!canFetchMore(group)) continue;
        fetchMore(group);
        if (const OutlineNode* node = m_index.find(path)) return indexOf(*node);
    }
    const std::string block = definedAt(*m_rows->loaded(), path); // in by-file mode a robot's parts have rows only in its config
    return block.empty() || block == path ? QModelIndex() : indexOf(block);
}

/// Creates the rows on the way to a member: its range of members, then the member's own row.
QModelIndex OutlineModel::indexOfMember(const std::string& layout, const std::string& name) {
    const std::size_t robot = numberOfMember(*m_rows->loaded()->experiment, name);
    QModelIndex at = indexOf(layout);
    while (at.isValid()) {
        if (canFetchMore(at)) fetchMore(at);
        QModelIndex next;
        for (const auto& child : nodeOf(at).children) {
            if (child->row.member && child->row.path == name) return indexOf(*child);
            const bool holds =
                child->row.type == OutlineRow::Type::Members && child->row.first <= robot && robot < child->row.last;
            if (holds) next = indexOf(*child);
        }
        at = next;
    }
    return {};
}

QModelIndex OutlineModel::index(int row, int column, const QModelIndex& parent) const {
    const OutlineNode& node = nodeOf(parent);
    if (row < 0 || column < 0 || column >= ColumnCount || static_cast<std::size_t>(row) >= node.children.size()) return {};
    return createIndex(row, column, node.children[std::size_t(row)].get());
}

QModelIndex OutlineModel::parent(const QModelIndex& index) const {
    const OutlineNode* parent = index.isValid() ? nodeOf(index).parent : nullptr;
    return parent ? indexOf(*parent) : QModelIndex();
}

int OutlineModel::rowCount(const QModelIndex& parent) const {
    return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent).children.size());
}

bool OutlineModel::hasChildren(const QModelIndex& parent) const {
    if (parent.column() > 0) return false;
    const OutlineNode& node = nodeOf(parent);
    return node.fetched || !node.parent ? !node.children.empty() : node.row.hasRows;
}

void OutlineModel::showEnded(const EndedRobots& ended) {
    m_ended = &ended;
    connect(&ended, &EndedRobots::changed, this, &OutlineModel::marksChanged);
    marksChanged();
}

bool OutlineModel::isFaint(const OutlineRow& row) const {
    if ((row.markable && m_marks.isHidden(row.path)) || (!m_filter.empty() && !row.matches)) return true;
    return m_ended && row.selectable && m_ended->hasEnded(row.path);
}

QVariant OutlineModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const OutlineRow& row = nodeOf(index).row;
    if (index.column() != NameColumn) {
        const bool hidden = index.column() == VisibleColumn;
        if (role == MarkRole) return markOf(m_marks, row, hidden);
        if (role != Qt::ToolTipRole || !row.markable) return {};
        if (hidden) return m_marks.isHidden(row.path) ? tr("Hidden: click to show") : tr("Click to hide in the 3D views");
        return m_marks.isLocked(row.path) ? tr("Locked: click to unlock") : tr("Click to lock against moving and deleting");
    }
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return toQString(row.name);
    case Qt::ToolTipRole: return tipOf(row, m_ended);
    case Qt::AccessibleTextRole:
        return (toQString(row.name + " " + row.detail) + u' ' + endedLabel(row, m_ended, *m_rows)).trimmed();
    case DetailRole: return toQString(row.detail);
    case IconRole: return iconOf(row);
    case ErrorsRole: return row.problems.errors;
    case WarningsRole: return row.problems.warnings;
    case ColourRole:
        return row.colour ? QVariant(QColor::fromRgbF(float((*row.colour)[0]), float((*row.colour)[1]), float((*row.colour)[2])))
                          : QVariant();
    case FaintRole: return isFaint(row);
    case EndedRole: return endedLabel(row, m_ended, *m_rows);
    default: return {};
    }
}

QString OutlineModel::nameProblem(const QModelIndex& index, const QString& name) const {
    const OutlineRow* row = rowAt(index);
    return row ? m_edits.nameProblem(row->path, name.trimmed().toStdString()) : QString();
}

bool OutlineModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const OutlineRow* row = rowAt(index);
    if (!row || role != Qt::EditRole || !row->selectable || index.column() != NameColumn) return false;
    const std::string path = row->path, name = value.toString().trimmed().toStdString();
    return name == row->name || m_edits.rename(path, name).ok(); // the edit may have replaced the row
}

Qt::ItemFlags OutlineModel::flags(const QModelIndex& index) const {
    const OutlineRow* row = rowAt(index);
    if (!row) return Qt::ItemIsDropEnabled;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsDropEnabled;
    if (!row->selectable) return flags;
    flags |= Qt::ItemIsSelectable;
    if (row->type != OutlineRow::Type::Object || row->member) return flags;
    flags |= Qt::ItemIsDragEnabled;
    return index.column() == NameColumn ? flags | Qt::ItemIsEditable : flags;
}

QMimeData* OutlineModel::mimeData(const QModelIndexList& indexes) const {
    std::vector<std::string> paths;
    for (const QModelIndex& index : indexes)
        if (const OutlineRow* row = rowAt(index); row && index.column() == NameColumn && row->selectable)
            paths.push_back(row->path);
    return paths.empty() || !m_rows ? nullptr : m_drops.dragged(*m_rows->loaded(), paths);
}

bool OutlineModel::canDropMimeData(const QMimeData* mime, Qt::DropAction, int row, int, const QModelIndex& parent) const {
    return mime && m_rows && m_drops.accepts(*m_rows->loaded(), *mime, nodeOf(parent), row);
}

bool OutlineModel::dropMimeData(const QMimeData* mime, Qt::DropAction action, int row, int column, const QModelIndex& parent) {
    if (action == Qt::IgnoreAction) return true;
    return canDropMimeData(mime, action, row, column, parent) && m_drops.drop(*mime, action, nodeOf(parent), row);
}

void OutlineModel::marksChanged() {
    const auto say = [this](const auto& self, const OutlineNode& node) -> void {
        if (node.children.empty()) return;
        Q_EMIT dataChanged(index(0, 0, indexOf(node)), index(rowCount(indexOf(node)) - 1, ColumnCount - 1, indexOf(node)));
        for (const auto& child : node.children) self(self, *child);
    };
    say(say, *m_root);
}

} // namespace trundle
