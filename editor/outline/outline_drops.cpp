// Drag and drop of the Scene tree.

#include <algorithm>

#include <QCoreApplication>
#include <QMimeData>

#include "editor/outline/block_mime.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_node.h"
#include "project/edits/insert_positions.h"

namespace trundle {
namespace {

constexpr const char* kObjectsMime = "application/x-trundle-objects"; // ownerLine() of the source, then one dotted path a line

QByteArray ownerLine(const OutlineModel& model) {
    return QByteArray::number(QCoreApplication::applicationPid()) + ' ' + QByteArray::number(quintptr(&model), 16);
}

/// Paths of a drag that began in this tree; empty for a drag from another window, whose objects are inserted as text.
std::vector<std::string> pathsIn(const QMimeData& mime, const OutlineModel& model) {
    std::vector<std::string> paths;
    QByteArrayList lines = mime.data(QLatin1String(kObjectsMime)).split('\n');
    if (lines.takeFirst() != ownerLine(model)) return paths;
    for (const QByteArray& line : lines)
        if (!line.isEmpty()) paths.push_back(line.toStdString());
    return paths;
}

} // namespace

/// `parent`: path of the block to drop into; `before`: the object in it to insert before, "" for the end; `file`: file of the
/// target row, if it has one.
struct OutlineModel::DropTarget {
    bool known = false;
    std::string parent, before;
    FileId file = kNoFile;
};

OutlineModel::DropTarget OutlineModel::dropTarget(int row, const QModelIndex& parent) const {
    const OutlineNode& node = nodeOf(parent);
    DropTarget place;
    place.known = m_rows != nullptr && node.row.type != OutlineRow::Type::Module;
    if (node.parent && node.row.type == OutlineRow::Type::Object) place.parent = node.row.path;
    if (node.parent && node.row.type == OutlineRow::Type::File) place.file = node.row.file;
    if (row >= 0 && static_cast<std::size_t>(row) < node.children.size()) {
        const OutlineRow& next = node.children[std::size_t(row)]->row;
        if (next.selectable && next.type == OutlineRow::Type::Object) place.before = next.path;
    }
    return place;
}

QStringList OutlineModel::mimeTypes() const {
    return {QLatin1String(kObjectsMime), QLatin1String(kLibraryMime), QStringLiteral("text/plain")};
}

QMimeData* OutlineModel::mimeData(const QModelIndexList& indexes) const {
    std::vector<std::string> paths;
    for (const QModelIndex& index : indexes)
        if (const OutlineRow* row = rowAt(index); row && index.column() == NameColumn && row->selectable)
            paths.push_back(row->path);
    if (paths.empty() || !m_rows) return nullptr;
    QMimeData* mime = mimeOf(*m_rows->loaded(), paths);
    QByteArray lines = ownerLine(*this) + '\n';
    for (const std::string& path : paths) lines += QByteArray::fromStdString(path) + '\n';
    mime->setData(QLatin1String(kObjectsMime), lines);
    return mime;
}

bool OutlineModel::canDropMimeData(const QMimeData* mime, Qt::DropAction, int row, int, const QModelIndex& parent) const {
    const DropTarget place = dropTarget(row, parent);
    if (!place.known || !mime) return false;
    const LoadedProject& loaded = *m_rows->loaded();
    const std::vector<std::string> paths = pathsIn(*mime, *this);
    if (paths.empty()) return mime->hasFormat(QLatin1String(kLibraryMime)) || mime->hasText();
    const Kind* into = kindAt(loaded, place.parent);
    return std::all_of(paths.begin(), paths.end(), [&](const std::string& path) {
        const Kind* kind = kindAt(loaded, path);
        return kind && path != place.parent && isAllowedInside(*kind, into ? std::string_view(into->name) : std::string_view());
    });
}

bool OutlineModel::dropMimeData(const QMimeData* mime, Qt::DropAction action, int row, int column, const QModelIndex& parent) {
    if (action == Qt::IgnoreAction) return true;
    if (!mime || !canDropMimeData(mime, action, row, column, parent)) return false;
    const DropTarget place = dropTarget(row, parent);
    const std::vector<std::string> paths = pathsIn(*mime, *this);
    if (!paths.empty() && action == Qt::MoveAction) return m_edits.move(paths, place.parent, place.before, place.file).ok();
    return m_edits.insertFrom(*mime, place.parent, place.file == kNoFile ? FileId{0} : place.file).ok();
}

} // namespace trundle
