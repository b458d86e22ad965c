#include "editor/viewport/context/tool_view.h"

#include <algorithm>
#include <cmath>

#include <QWidget>

#include "editor/viewport/context/viewport_scene.h"

namespace trundle {

std::optional<QPointF> ToolView::shownPixelOf(const Vec3& point) const {
    if (rendered().image.isNull()) return camera().pixelOf(point);
    const auto at = project(rendered().camera, std::uint32_t(std::max(1, widget().width())),
                            std::uint32_t(std::max(1, widget().height())), point);
    return at ? std::optional(QPointF(at->x, at->y)) : std::nullopt;
}

const BodyPoses& ToolView::shownPoses() const {
    return rendered().poses && rendered().objects == context().world.objects() ? *rendered().poses : *context().world.poses();
}

CameraView ToolView::shownCamera() const { return rendered().image.isNull() ? camera().view() : rendered().camera; }

double ToolView::metresPerPixel(const Vec3& at, const Vec3& along) const {
    constexpr double kSmall = 1e-3; // m
    const auto from = camera().pixelOf(at), to = camera().pixelOf(at + kSmall * along);
    const double pixels = from && to ? std::hypot(to->x() - from->x(), to->y() - from->y()) : 0;
    return pixels > 0 ? kSmall / pixels : HUGE_VAL;
}

} // namespace trundle
