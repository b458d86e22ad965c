#pragma once
class QPainter;

namespace trundle {

class ToolView;

/// Of a view through a robot's camera: dims the area outside the camera's own image and names the camera.
void paintThroughFrame(QPainter& painter, const ToolView& view);

} // namespace trundle
