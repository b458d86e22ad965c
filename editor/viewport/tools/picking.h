#pragma once
#include <string>
#include <vector>

#include <QRectF>

#include "scene/queries/ray_cast.h"

namespace trundle {

class ViewportScene;
class ToolView;

/// The selection sequence of repeated clicks at one place: for each hit the robot or static, the body, the geom; then the hits
/// behind it. "" clears the selection; it is the first entry on bare floor. In the edited model it begins with the body.
[[nodiscard]] std::vector<std::string> pickChain(const ViewportScene& world, const std::vector<RayHit>& hits);

/// Robots whose centre is inside a rectangle of the view, and statics that are completely inside; in the edited model bodies, and
/// geoms of a static. Hidden and locked objects are skipped.
[[nodiscard]] std::vector<std::string> boxPick(const ToolView& view, const QRectF& box);

/// Advances along the selection sequence when clicks are repeated at the same place.
class PickCycle {
public:
    /// The path that a click selects.
    [[nodiscard]] std::string next(const QPointF& at, std::vector<std::string> chain, const std::string& selected);

private:
    QPointF m_at;
    std::vector<std::string> m_chain;
    std::size_t m_index = 0;
};

} // namespace trundle
