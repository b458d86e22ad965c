#pragma once
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/view/view.h"
#include "editor/viewport/view_window.h"

namespace trundle {

/// Drags a handle of the gizmo at `origin` (in W) by `by` along its axis or plane. False if there is no such handle.
inline bool dragHandle(ViewWindow& window, const GizmoHandle& handle, const Vec3& by, const Vec3& origin,
                       Qt::KeyboardModifiers modifiers = {}) {
    View& view = window.view();
    const auto spot = view.tools().gizmo().spot(handle);
    if (!spot) return false;
    // The point under the handle's pixel, on its axis or plane.
    const ViewRay ray = view.camera().rayAt(*spot);
    Vec3 start;
    if (handle.kind == GizmoHandle::Kind::Plane) {
        start = ray.origin + (origin - ray.origin)[handle.axis] / ray.direction[handle.axis] * ray.direction;
    } else {
        const Vec3 axis = by.normalized();
        const Vec3 between = origin - ray.origin;
        const double b = axis.dot(ray.direction), n = 1 - b * b;
        start = origin + (b * ray.direction.dot(between) - axis.dot(between)) / n * axis;
    }
    window.drag(*spot, view.camera().pixelOf(start + by).value(), Qt::LeftButton, modifiers);
    return true;
}

} // namespace trundle
