#pragma once
// Outlines of the shadows that convex solids cast on a plane in parallel light. Independent of OSG.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "model/body_spec.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {

/// A convex geom in the frame of its body: the sum (Minkowski) of up to three straight pieces and of a disc or a ball.
struct ShadowSolid {
    std::uint32_t geom = 0;
    Vec3 centre = Vec3::Zero();
    std::array<Vec3, 3> halves{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; ///< half of each straight piece
    double radius = 0;
    std::optional<std::array<Vec3, 2>> disc; ///< the disc's radii, orthogonal; otherwise the radius is a ball's
    bool isHull = false;                     ///< none of these: only its mesh says what it is
    std::shared_ptr<const ShapeMesh> mesh;   ///< coarse; for hulls, and for solids that go through the plane
};

/// nullopt for shapes that are not convex.
[[nodiscard]] std::optional<ShadowSolid> shadowSolidOf(const GeomSpec& geom, std::uint32_t index);

class ShadowPlane {
public:
    using Outline = std::vector<Eigen::Vector2d>;
    struct Frame {
        Vec3 position = Vec3::Zero();
        Mat3 turn = Mat3::Identity();
    };

    /// The plane z = 0 of `frame`; `light` leads to the light, and is not along the plane.
    ShadowPlane(const Pose& frame, const Vec3& light);

    /// Where the shadow of a ball around `centre` (world) is, in the frame of the plane, and its largest radius.
    [[nodiscard]] Eigen::Vector2d shadowOf(const Vec3& centre) const { return m_onto * (centre - m_origin); }
    [[nodiscard]] double stretch() const { return m_stretch; }
    /// Replaces `outline` by the shadow's, counter-clockwise in the frame of the plane; empty if there is none. What lies below
    /// the plane casts none. Round edges are as fine as `pixelsPerMetre` asks for.
    void cast(const ShadowSolid& solid, const Frame& body, double pixelsPerMetre, Outline& outline);

private:
    void castSum(const ShadowSolid& solid, const Mat3& turn, const Vec3& centre, double pixelsPerMetre, Outline& outline);
    void castMesh(const ShapeMesh& mesh, const Frame& body, Outline& outline);
    void addEdge(const Eigen::Vector2d& edge);

    Vec3 m_origin, m_normal;
    Eigen::Matrix<double, 2, 3> m_onto;    // projects along the light, into the frame of the plane
    std::array<Eigen::Vector2d, 2> m_ball; // half axes of the shadow of a ball of radius 1
    double m_stretch = 1;
    std::vector<Eigen::Vector2d> m_edges; // scratch: half the edges of a sum
    std::vector<Vec3> m_points;           // scratch: of a mesh, relative to the origin
};

} // namespace trundle
