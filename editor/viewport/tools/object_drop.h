#pragma once
// Rows of the Scene tree dropped into a view: moves the objects to the drop position, or with Ctrl copies them there.

class QMimeData;
class QPointF;

namespace trundle {

class ToolView;

/// True if the drag contains the selected objects of this window and they can be moved, or a reason can be reported.
[[nodiscard]] bool canMoveHere(const ToolView& view, const QMimeData& data);
/// The object selected last is placed under the cursor, the others keep their offsets from it. One edit of the text; during a run
/// the objects are moved in the running world. Failures are reported through Document::refused.
void moveHere(ToolView& view, const QPointF& at);
/// The same with copies of the objects; always edits the text.
void copyHere(ToolView& view, const QPointF& at);

} // namespace trundle
