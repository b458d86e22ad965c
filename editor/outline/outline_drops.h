#pragma once
// Drag and drop of the Scene tree.

#include <string>
#include <vector>

#include <QByteArray>
#include <QStringList>

#include "project/loading/project.h"

class QMimeData;

namespace trundle {

class ObjectEdits;
struct OutlineNode;

class OutlineDrops {
public:
    /// `edits` must outlive this object.
    explicit OutlineDrops(ObjectEdits& edits) : m_edits(edits) {}

    [[nodiscard]] static QStringList mimeTypes();
    [[nodiscard]] QMimeData* dragged(const LoadedProject& loaded, const std::vector<std::string>& paths) const;
    // A drop on a row, or on the tree, before its child number `child`; -1: at the end.
    [[nodiscard]] bool accepts(const LoadedProject& loaded, const QMimeData& mime, const OutlineNode& onto, int child) const;
    [[nodiscard]] bool drop(const QMimeData& mime, Qt::DropAction action, const OutlineNode& onto, int child);

private:
    [[nodiscard]] QByteArray ownerLine() const;
    [[nodiscard]] std::vector<std::string> pathsIn(const QMimeData& mime) const;

    ObjectEdits& m_edits;
};

} // namespace trundle
