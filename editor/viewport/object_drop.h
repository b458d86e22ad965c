#pragma once
// Rows of the scene tree dropped into a view: the objects go where they fall, with Ctrl a copy of them.

class QMimeData;
class QPointF;

namespace trundle {

class View;

/// Whether what is dragged are the selected objects of this window, and objects that can be moved, or at least told why not.
[[nodiscard]] bool canMoveHere(const View& view, const QMimeData& data);
/// The one selected last stands on what is under the cursor, the others beside it as they did. One edit; while a world runs
/// they are placed there. What cannot be is said through Document::refused.
void moveHere(View& view, const QPointF& at);
/// The same with copies of them, in the text.
void copyHere(View& view, const QPointF& at);

} // namespace trundle
