#include "editor/outline/outline_drops.h"

#include <algorithm>

#include <QCoreApplication>
#include <QMimeData>

#include "editor/outline/block_mime.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/outline_node.h"
#include "project/edits/insert_positions.h"

namespace trundle {
namespace {

constexpr const char* kObjectsMime = "application/x-trundle-objects"; // ownerLine() of the source, then one dotted path a line

/// `parent`: path of the block to drop into; `before`: the object in it to insert before, "" for the end; `file`: file of the
/// target row, if it has one.
struct DropTarget {
    std::string parent, before;
    FileId file = kNoFile;
};

DropTarget targetOf(const OutlineNode& onto, int child) {
    DropTarget place;
    if (onto.parent && onto.row.type == OutlineRow::Type::Object) place.parent = onto.row.path;
    if (onto.parent && onto.row.type == OutlineRow::Type::File) place.file = onto.row.file;
    if (child >= 0 && static_cast<std::size_t>(child) < onto.children.size()) {
        const OutlineRow& next = onto.children[std::size_t(child)]->row;
        if (next.selectable && next.type == OutlineRow::Type::Object) place.before = next.path;
    }
    return place;
}

} // namespace

QByteArray OutlineDrops::ownerLine() const {
    return QByteArray::number(QCoreApplication::applicationPid()) + ' ' + QByteArray::number(quintptr(this), 16);
}

/// Paths of a drag that began in this tree; empty for a drag from another window, whose objects are inserted as text.
std::vector<std::string> OutlineDrops::pathsIn(const QMimeData& mime) const {
    std::vector<std::string> paths;
    QByteArrayList lines = mime.data(QLatin1String(kObjectsMime)).split('\n');
    if (lines.takeFirst() != ownerLine()) return paths;
    for (const QByteArray& line : lines)
        if (!line.isEmpty()) paths.push_back(line.toStdString());
    return paths;
}

QStringList OutlineDrops::mimeTypes() {
    return {QLatin1String(kObjectsMime), QLatin1String(kLibraryMime), QStringLiteral("text/plain")};
}

QMimeData* OutlineDrops::dragged(const LoadedProject& loaded, const std::vector<std::string>& paths) const {
    QMimeData* mime = mimeOf(loaded, paths);
    QByteArray lines = ownerLine() + '\n';
    for (const std::string& path : paths) lines += QByteArray::fromStdString(path) + '\n';
    mime->setData(QLatin1String(kObjectsMime), lines);
    return mime;
}

bool OutlineDrops::accepts(const LoadedProject& loaded, const QMimeData& mime, const OutlineNode& onto, int child) const {
    if (onto.row.type == OutlineRow::Type::Module) return false;
    const std::string parent = targetOf(onto, child).parent;
    const std::vector<std::string> paths = pathsIn(mime);
    if (paths.empty()) return mime.hasFormat(QLatin1String(kLibraryMime)) || mime.hasText();
    const Kind* into = kindAt(loaded, parent);
    return std::all_of(paths.begin(), paths.end(), [&](const std::string& path) {
        const Kind* kind = kindAt(loaded, path);
        return kind && path != parent && isAllowedInside(*kind, into ? std::string_view(into->name) : std::string_view());
    });
}

bool OutlineDrops::drop(const QMimeData& mime, Qt::DropAction action, const OutlineNode& onto, int child) {
    const DropTarget place = targetOf(onto, child);
    const std::vector<std::string> paths = pathsIn(mime);
    if (!paths.empty() && action == Qt::MoveAction) return m_edits.move(paths, place.parent, place.before, place.file).ok();
    return m_edits.insertFrom(mime, place.parent, place.file == kNoFile ? FileId{0} : place.file).ok();
}

} // namespace trundle
