#pragma once
class QMimeData;
class QPointF;

namespace trundle {

class View;

/// Whether a drag brings blocks from the Library (JSON {"kind", "text", "imports"}).
[[nodiscard]] bool canDrop(const QMimeData& data);
/// Places them on what is under the cursor: robots and arenas in the world, bodies and shapes in the config of what they fall
/// on, a material onto the shape. What cannot be is said through Document::refused.
void dropBlocks(View& view, const QMimeData& data, const QPointF& at);

} // namespace trundle
