#pragma once
// What a body or shape that is dragged by the gizmo snaps to, besides steps: the rest of its robot or scenery.

#include <array>
#include <vector>

#include "scene/queries/extent_snap.h"

class QPainter;

namespace trundle {

class GizmoDrag;
class ToolView;
class TransformSelection;

/// From the press of a handle to its release. What is selected in further robots or scenery follows; whole ones do not snap, nor
/// does anything during a run.
class MoveSnap {
public:
    /// `axes`: of the gizmo, in W.
    MoveSnap(const ToolView& view, const TransformSelection& dragged, const Mat3& axes);

    /// Moves what is dragged to what it is near to in the picture.
    void apply(GizmoDrag& drag, const Vec3& origin);
    void clear() { m_guides.clear(); }
    [[nodiscard]] bool hasSnapped() const { return !m_guides.empty(); }
    void paint(QPainter& painter) const; ///< lines to what it has snapped to

private:
    const ToolView& m_view;
    SnapExtents m_extents;
    std::vector<std::array<Vec3, 2>> m_guides;
};

} // namespace trundle
