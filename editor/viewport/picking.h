#pragma once
#include <string>
#include <vector>

#include <QRectF>

#include "scene/ray_cast.h"

namespace trundle {

class ShownWorld;
class View;

/// What repeated clicks at one place select, in order: of each hit the robot or static, the body, the geom; then what lies
/// behind. "" is nothing: bare floor means that first.
[[nodiscard]] std::vector<std::string> pickChain(const ShownWorld& world, const std::vector<RayHit>& hits);

/// Robots whose middle lies in a rectangle of the view, and statics that lie in it whole. Nothing hidden or locked.
[[nodiscard]] std::vector<std::string> boxPick(const View& view, const QRectF& box);

/// Remembers the last click, so that the next one at the same place goes on along the chain.
class PickCycle {
public:
    /// What a click selects now.
    [[nodiscard]] std::string next(const QPointF& at, std::vector<std::string> chain, const std::string& selected);

private:
    QPointF m_at;
    std::vector<std::string> m_chain;
    std::size_t m_index = 0;
};

} // namespace trundle
