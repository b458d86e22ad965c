#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Draws what the selected inertial sensors measure in a run as arrows at their places: acceleration, and angular velocity along its
/// axis.
void paintMotionArrows(QPainter& painter, const ToolView& view);

} // namespace trundle
