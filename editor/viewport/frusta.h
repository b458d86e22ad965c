#pragma once
class QPainter;

namespace trundle {

class View;

/// What cameras see, from their near to their far plane, as thin lines: of those that are selected, or of all.
void paintFrusta(QPainter& painter, const View& view, bool all);

} // namespace trundle
