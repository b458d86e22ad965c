// Triangles and colours of wheels drawn with spokes.

#include <numbers>

#include "model/shortest_turn.h"
#include "scene/shapes/spokes.h"

namespace trundle {
namespace {

using Parts = std::array<ShapeMesh, kWheelPaints>;

constexpr int kSpokes = 5;
constexpr double kPitch = 2 * std::numbers::pi / kSpokes; // rad between spokes
constexpr int kLeastTreadSegments = 8, kLeastRimSegments = 12, kLeastNotchSegments = 18;

// Fractions of the radius.
constexpr double kShoulder = 0.90, kRimOuter = 0.74, kRimInner = 0.66, kHub = 0.25, kCap = 0.11;
constexpr double kSpokeHalfAtRim = 0.085, kSpokeHalfAtHub = 0.115;

/// Segments per pitch around the wheel; the first `spoke` of them form the spoke.
struct Division {
    int pitch, spoke;
    explicit Division(int segments)
        : pitch(std::max(2, (segments + kSpokes / 2) / kSpokes)), spoke(std::max(1, (3 * pitch + 5) / 10)) {}
    [[nodiscard]] int count() const { return kSpokes * pitch; }
    /// Half the angle of a spoke if all segments are equal (rad).
    [[nodiscard]] double evenHalf() const { return 0.5 * kPitch * spoke / pitch; }
    /// Angle of the corner that starts a segment, with spokes of half-width `half` (rad).
    [[nodiscard]] double angle(int corner, double half) const {
        const int in = corner % pitch;
        const double within =
            in <= spoke ? half * (2.0 * in / spoke - 1) : half + (kPitch - 2 * half) * double(in - spoke) / (pitch - spoke);
        return kPitch * (corner / pitch) + within;
    }
};

/// A circle about z, with the direction of its normals.
struct Circle {
    double radius, z, spokeHalf; ///< m, m, rad
    double out, up;              ///< normal components, not normalised
};

/// Colours of the tread: a stripe at each spoke. One stripe is brighter, so that full rotations can be counted.
WheelPaint treadPaint(const Division& division, int segment) {
    const int width = (division.spoke + 1) / 2, first = (division.spoke - width) / 2, in = segment % division.pitch - first;
    if (in < 0 || in >= width) return WheelPaint::Tyre;
    return segment < division.pitch ? WheelPaint::Metal : WheelPaint::Mean;
}

template <class PaintOf> void addBand(Parts& parts, const Division& division, const Circle& a, const Circle& b, PaintOf paintOf) {
    const auto corner = [&](ShapeMesh& mesh, const Circle& circle, int i) {
        const double angle = division.angle(i, circle.spokeHalf), c = std::cos(angle), s = std::sin(angle);
        return mesh.addPoint(Eigen::Vector3d(circle.radius * c, circle.radius * s, circle.z).cast<float>(),
                             Eigen::Vector3d(circle.out * c, circle.out * s, circle.up).normalized().cast<float>());
    };
    std::uint32_t lastA = 0, lastB = 0;
    for (int i = 0; i < division.count(); ++i) {
        const WheelPaint paint = paintOf(i);
        ShapeMesh& mesh = parts[std::size_t(paint)];
        if (i == 0 || paintOf(i - 1) != paint) lastA = corner(mesh, a, i), lastB = corner(mesh, b, i);
        const std::uint32_t nextA = corner(mesh, a, i + 1);
        mesh.addTriangle(lastA, nextA, lastB);
        lastA = nextA;
        if (!(b.radius > 0)) continue; // all corners coincide at the centre
        const std::uint32_t nextB = corner(mesh, b, i + 1);
        mesh.addTriangle(nextA, nextB, lastB);
        lastB = nextB;
    }
}

/// Normals imitate a round tyre, a recessed rim and a protruding hub, although all vertices lie in one plane.
void addFace(Parts& parts, const Division& division, double radius, double z, double up) {
    const auto isSpoke = [&](int i) { return i % division.pitch < division.spoke; };
    const auto spokeHalf = [](double half, double at) { return std::asin(half / at); };
    const double even = division.evenHalf();
    const auto circle = [&](double share, double half, double out) { return Circle{share * radius, z, half, out, up}; };
    const auto tyre = [](int) { return WheelPaint::Tyre; };
    const auto metal = [](int) { return WheelPaint::Metal; };
    const auto spokes = [&](int i) { return isSpoke(i) ? WheelPaint::Metal : WheelPaint::Gap; };
    const auto notch = [&](int i) { return treadPaint(division, i) == WheelPaint::Metal ? WheelPaint::Metal : WheelPaint::Tyre; };
    if (division.count() < kLeastRimSegments) {
        addBand(parts, division, circle(1, even, 0.4), circle(kRimOuter, even, 0), tyre);
        addBand(parts, division, circle(kRimOuter, even, 0), circle(0, even, 0), spokes);
        return;
    }
    const double atRim = spokeHalf(kSpokeHalfAtRim, kRimInner), atHub = spokeHalf(kSpokeHalfAtHub, kHub);
    if (division.count() < kLeastNotchSegments) {
        addBand(parts, division, circle(1, even, 0.6), circle(kRimOuter, even, -0.2), tyre);
    } else {
        addBand(parts, division, circle(1, even, 0.9), circle(kShoulder, even, 0.2), notch);
        addBand(parts, division, circle(kShoulder, even, 0.2), circle(kRimOuter, even, -0.4), tyre);
    }
    addBand(parts, division, circle(kRimOuter, even, 0.5), circle(kRimInner, atRim, -0.7), metal);
    addBand(parts, division, circle(kRimInner, atRim, -0.1), circle(kHub, atHub, 0), spokes);
    if (division.count() < kLeastNotchSegments) {
        addBand(parts, division, circle(kHub, atHub, 0.4), circle(0, even, 0), metal);
    } else {
        addBand(parts, division, circle(kHub, atHub, 0.7), circle(kCap, even, 0.1), metal);
        addBand(parts, division, circle(kCap, even, 0.3), circle(0, even, 0), [](int) { return WheelPaint::Gap; });
    }
}

void addFlatFace(Parts& parts, const Division& division, double radius, double z, double up, WheelPaint paint) {
    const double even = division.evenHalf();
    addBand(parts, division, {radius, z, even, 0, up}, {0, z, even, 0, up}, [=](int) { return paint; });
}

Parts spokedCylinder(const GeomSpec& geom, const SpokePattern& pattern, int segments) {
    Parts parts;
    const Division division(segments);
    const bool fine = segments >= kLeastTreadSegments;
    const double half = 0.5 * geom.length, even = division.evenHalf();
    addBand(parts, division, {geom.radius, -half, even, 1, 0}, {geom.radius, half, even, 1, 0},
            [&](int i) { return fine ? treadPaint(division, i) : WheelPaint::Tyre; });
    for (const auto& [z, spoked] : {std::pair{half, pattern.top}, std::pair{-half, pattern.bottom}}) {
        if (spoked && fine) addFace(parts, division, geom.radius, z, z > 0 ? 1 : -1);
        else addFlatFace(parts, division, geom.radius, z, z > 0 ? 1 : -1, spoked ? WheelPaint::Mean : WheelPaint::Tyre);
    }
    return parts;
}

/// Stripes from pole to pole, for shapes without flat faces.
Parts stripedShape(const GeomSpec& geom, const SpokePattern& pattern, int segments) {
    const Division division(segments);
    const auto radius = float(geom.radius);
    const bool isSphere = geom.shape == GeomShape::Sphere;
    const ShapeMesh whole =
        isSphere ? sphereMesh(radius, division.count()) : capsuleMesh(radius, float(geom.length), division.count());
    // A sphere may have any orientation in its body; its poles are placed on the axis.
    const Vec3 pole = isSphere ? pattern.axis : Vec3::UnitZ();
    const Eigen::Matrix3f turn = shortestTurn(Vec3::UnitZ(), pole).toRotationMatrix().cast<float>();
    Parts parts;
    for (std::size_t i = 0; i + 2 < whole.indices.size(); i += 3) {
        const std::uint32_t a = whole.indices[i], b = whole.indices[i + 1], c = whole.indices[i + 2];
        const Eigen::Vector3f middle = whole.points[a] + whole.points[b] + whole.points[c];
        const double angle = std::atan2(double(middle.y()), double(middle.x()));
        const int segment =
            int(std::floor(angle / (2 * std::numbers::pi) * division.count()) + division.count()) % division.count();
        ShapeMesh& mesh = parts[std::size_t(segments < kLeastTreadSegments ? WheelPaint::Mean : treadPaint(division, segment))];
        for (const std::uint32_t corner : {a, b, c})
            mesh.indices.push_back(mesh.addPoint(turn * whole.points[corner], turn * whole.normals[corner]));
    }
    return parts;
}

} // namespace

Parts spokedShapeOf(const GeomSpec& geom, const SpokePattern& pattern, Fineness fineness) {
    if (shapeOf(geom, fineness).indices.empty()) return {}; // cannot be drawn
    const int segments = segmentsFor(geom.radius, fineness);
    return geom.shape == GeomShape::Cylinder ? spokedCylinder(geom, pattern, segments) : stripedShape(geom, pattern, segments);
}

MaterialSpec paintedMaterial(const MaterialSpec& tyre, WheelPaint paint) {
    constexpr std::array<double, 3> kAluminium{0.74, 0.75, 0.77};
    constexpr double kLight = 0.45, kMetalOfMean = 0.35;
    const auto& c = tyre.colour;
    const bool isLight = 0.30 * c[0] + 0.59 * c[1] + 0.11 * c[2] >= kLight;
    MaterialSpec painted = tyre;
    for (std::size_t i = 0; i < 3; ++i) {
        const double metal = isLight ? 0.42 * c[i] : 0.15 * c[i] + 0.85 * kAluminium[i], gap = (isLight ? 0.75 : 0.5) * c[i];
        switch (paint) {
        case WheelPaint::Tyre: break;
        case WheelPaint::Metal: painted.colour[i] = metal; break;
        case WheelPaint::Gap: painted.colour[i] = gap; break;
        case WheelPaint::Mean: painted.colour[i] = kMetalOfMean * metal + (1 - kMetalOfMean) * c[i]; break;
        }
    }
    if (paint == WheelPaint::Metal) painted.shininess = std::max(painted.shininess, 0.4);
    return painted;
}

} // namespace trundle
