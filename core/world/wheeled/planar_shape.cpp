#include "world/wheeled/planar_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trundle {

namespace {

constexpr double kSame = 1e-9; // m
constexpr double kClearlyFar =
    1e-4; // m: by this the second shape's edge must be farther to become the reference, so that it does not flicker

// Cosines and sines of sixteenths of a turn, the same on every machine.
constexpr std::array<double, 5> kCosines = {1, 0.92387953251128674, 0.70710678118654752, 0.38268343236508977, 0};

Vec2 onCircle(int sixteenth) {
    const auto at = [](int k) { return kCosines[static_cast<std::size_t>(k)]; };
    const int k = sixteenth % 16, r = k % 4;
    switch (k / 4) {
    case 0: return {at(r), at(4 - r)};
    case 1: return {-at(4 - r), at(r)};
    case 2: return {-at(r), -at(4 - r)};
    default: return {at(4 - r), -at(r)};
    }
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Points whose hull is the shape's, in its own frame; for round ones a prism of sixteen sides.
std::vector<Vec3> pointsOf(const GeomSpec& geom) {
    std::vector<Vec3> points;
    if (geom.shape == GeomShape::Box) {
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                for (const double z : {-0.5, 0.5}) points.push_back(geom.size.cwiseProduct(Vec3(x, y, z)));
    } else if (geom.shape == GeomShape::Cylinder || geom.shape == GeomShape::Capsule) {
        for (int k = 0; k < 16; ++k) {
            const Vec2 rim = geom.radius * onCircle(k);
            for (const double end : {-0.5, 0.5}) points.emplace_back(rim.x(), rim.y(), end * geom.length);
        }
        const double tip = geom.length / 2 + geom.radius;
        if (geom.shape == GeomShape::Capsule)
            for (const double end : {-1., 1.}) points.emplace_back(0, 0, end * tip);
    } else if (geom.hull) {
        for (const auto& v : geom.hull->points) points.emplace_back(v[0], v[1], v[2]);
    }
    return points;
}

void makeCircle(PlanarShape& out, double radius, double half, double height) {
    out.radius = out.bound = radius;
    out.low = height - half;
    out.high = height + half;
}

struct Edges {
    std::array<Vec2, kMostCorners> cornerList, outwardList; // not set beyond count
    std::size_t count = 0;

    [[nodiscard]] std::span<const Vec2> corners() const { return {cornerList.data(), count}; }
    [[nodiscard]] std::span<const Vec2> outwards() const { return {outwardList.data(), count}; }
};

/// The second shape in the frame of the first.
void seeFrom(const PlanarShape& b, const PlanarPose& atB, const PlanarPose& atA, Edges& out) {
    const PlanarPose in{atA.turnBack(atB.at - atA.at), atA.c * atB.c + atA.s * atB.s, atA.c * atB.s - atA.s * atB.c};
    out.count = b.corners.size();
    for (std::size_t i = 0; i < out.count; ++i) {
        out.cornerList[i] = in.at + in.turn(b.corners[i]);
        out.outwardList[i] = in.turn(b.outwards[i]);
    }
}

struct Separation {
    double gap = -1e300;
    std::size_t edge = 0;
};

/// Of an edge of `a`, behind which all of `b` lies the farthest, or the first one with more than `enough` between them.
Separation separation(std::span<const Vec2> corners, std::span<const Vec2> outwards, std::span<const Vec2> other, double enough) {
    Separation best;
    for (std::size_t i = 0; i < corners.size() && best.gap <= enough; ++i) {
        double least = 1e300;
        for (const Vec2& p : other) {
            least = std::min(least, outwards[i].dot(p - corners[i]));
            if (least <= best.gap) break; // another edge is better
        }
        if (least > best.gap) best = {least, i};
    }
    return best;
}

struct Segment {
    Vec2 from, to;
};

Segment edgeOf(std::span<const Vec2> corners, std::size_t i) { return {corners[i], corners[(i + 1) % corners.size()]}; }

/// The part of a segment over the reference edge.
bool clip(Segment& s, const Vec2& origin, const Vec2& along, double length) {
    const double t0 = along.dot(s.from - origin), t1 = along.dot(s.to - origin);
    if (std::max(t0, t1) < 0 || std::min(t0, t1) > length) return false;
    const Vec2 from = s.from, way = s.to - s.from;
    const auto at = [&](double t) { return Vec2(from + (t - t0) / (t1 - t0) * way); };
    if (t0 < 0) s.from = at(0);
    if (t0 > length) s.from = at(length);
    if (t1 < 0) s.to = at(0);
    if (t1 > length) s.to = at(length);
    return true;
}

/// In the frame of `a`.
PlanarTouch polygons(const PlanarShape& a, const Edges& b, double margin) {
    PlanarTouch out;
    const Separation mine = separation(a.corners, a.outwards, b.corners(), margin);
    if (mine.gap > margin) return out;
    const Separation theirs = separation(b.corners(), b.outwards(), a.corners, margin);
    if (theirs.gap > margin) return out;
    const bool flip = theirs.gap > mine.gap + kClearlyFar;
    const std::span<const Vec2> reference = flip ? b.corners() : a.corners, incident = flip ? a.corners : b.corners(),
                                facing = flip ? a.outwards : b.outwards();
    const std::size_t edge = flip ? theirs.edge : mine.edge;
    const Vec2 normal = flip ? b.outwards()[edge] : a.outwards[edge];
    const Segment face = edgeOf(reference, edge);
    const double length = (face.to - face.from).norm();
    std::size_t most = 0;
    for (std::size_t i = 1; i < incident.size(); ++i)
        if (facing[i].dot(normal) < facing[most].dot(normal)) most = i;
    Segment other = edgeOf(incident, most);
    out.normal = flip ? Vec2(-normal) : normal;
    const auto add = [&](const Vec2& p) {
        const double gap = normal.dot(p - face.from);
        if (gap > margin || (out.count == 1 && (p - out.points[0]).squaredNorm() < kSame)) return;
        out.points[out.count] = p - 0.5 * gap * normal;
        out.gaps[out.count++] = gap;
    };
    if (!clip(other, face.from, (face.to - face.from) / length, length)) {
        const Vec2& p =
            std::abs(normal.dot(other.from - face.from)) < std::abs(normal.dot(other.to - face.from)) ? other.from : other.to;
        add(p);
        return out;
    }
    add(other.from);
    add(other.to);
    return out;
}

/// A circle at `centre` in the frame of the polygon; the normal is from the polygon to the circle.
PlanarTouch circleOnPolygon(const PlanarShape& polygon, const Vec2& centre, double radius, double margin) {
    PlanarTouch out;
    const Vec2 only[1] = {centre};
    const Separation s = separation(polygon.corners, polygon.outwards, only, radius + margin);
    if (s.gap > radius + margin) return out;
    const Segment face = edgeOf(polygon.corners, s.edge);
    const Vec2 way = face.to - face.from;
    const double t = std::clamp(way.dot(centre - face.from) / way.squaredNorm(), 0., 1.);
    const Vec2 nearest = face.from + t * way, from = centre - nearest;
    const double distance = from.norm();
    out.normal = s.gap > kSame && distance > kSame ? Vec2(from / distance) : polygon.outwards[s.edge];
    const double gap = (s.gap > kSame ? distance : s.gap) - radius;
    if (gap > margin) return out;
    out.count = 1;
    out.gaps[0] = gap;
    out.points[0] = centre - (radius + 0.5 * gap) * out.normal;
    return out;
}

PlanarTouch circles(const Vec2& a, double radiusA, const Vec2& b, double radiusB, double margin) {
    PlanarTouch out;
    const Vec2 way = b - a;
    const double distance = way.norm(), gap = distance - radiusA - radiusB;
    if (gap > margin) return out;
    if (distance > kSame) out.normal = way / distance;
    out.count = 1;
    out.gaps[0] = gap;
    out.points[0] = a + (radiusA + 0.5 * gap) * out.normal;
    return out;
}

/// Whether a circle at `centre`, in the frame of the polygon, lies beyond one of its edges by more than the margin.
bool isBeyond(const PlanarShape& polygon, const Vec2& centre, double radius, double margin) {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i)
        if (polygon.outwards[i].dot(centre - polygon.corners[i]) > radius + margin) return true;
    return false;
}

PlanarTouch inWorld(PlanarTouch touch, const PlanarPose& frame) {
    touch.normal = frame.turn(touch.normal);
    for (int i = 0; i < touch.count; ++i) touch.points[i] = frame.at + frame.turn(touch.points[i]);
    return touch;
}

} // namespace

/// Method: the monotone chain of A. M. Andrew (1979).
std::vector<Vec2> convexHullOf(std::vector<Vec2> points) {
    std::ranges::sort(points, [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Vec2> hull;
    const auto add = [&hull](const Vec2& p, std::size_t least) {
        while (hull.size() > least && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= kSame * kSame)
            hull.pop_back();
        if (hull.empty() || (p - hull.back()).squaredNorm() > kSame * kSame) hull.push_back(p);
    };
    for (const Vec2& p : points) add(p, 1);
    const std::size_t lower = hull.size();
    for (auto p = points.rbegin(); p != points.rend(); ++p) add(*p, lower);
    while (hull.size() > 1 && (hull.back() - hull.front()).squaredNorm() <= kSame * kSame) hull.pop_back();
    return hull;
}

void addPointsBelow(const GeomSpec& geom, const Pose& pose, double height, std::vector<Vec2>& to) {
    for (const Vec3& p : pointsOf(geom))
        if (const Vec3 at = pose * p; at.z() <= height) to.emplace_back(at.x(), at.y());
}

Result<PlanarShape> planarShapeOf(const GeomSpec& geom, const Pose& pose) {
    PlanarShape out;
    out.surface = geom.surface;
    out.centre = pose.position.head<2>();
    if (geom.shape == GeomShape::Sphere) {
        makeCircle(out, geom.radius, geom.radius, pose.position.z());
        return out;
    }
    const Vec3 axis = pose.rotation * Vec3::UnitZ();
    if (geom.shape == GeomShape::Cylinder && std::abs(axis.z()) > 1 - kSame) {
        makeCircle(out, geom.radius, geom.length / 2, pose.position.z());
        out.upright = true;
        return out;
    }
    out.upright = geom.shape == GeomShape::Box && pose.rotation.toRotationMatrix().cwiseAbs()(2, 2) > 1 - kSame;
    std::vector<Vec2> points;
    out.low = 1e300;
    out.high = -1e300;
    for (const Vec3& p : pointsOf(geom)) {
        const Vec3 at = pose * p;
        points.emplace_back(at.x(), at.y());
        out.low = std::min(out.low, at.z());
        out.high = std::max(out.high, at.z());
    }
    out.corners = convexHullOf(std::move(points));
    if (out.corners.size() < 3 || out.corners.size() > kMostCorners)
        return Error{Code::NotInEngine, "its shape has no footprint"};
    for (std::size_t i = 0; i < out.corners.size(); ++i) {
        const Segment edge = edgeOf(out.corners, i);
        const Vec2 way = (edge.to - edge.from).normalized();
        out.outwards.emplace_back(way.y(), -way.x());
        out.bound = std::max(out.bound, (edge.from - out.centre).norm());
    }
    return out;
}

PlanarTouch touchOf(const PlanarShape& a, const PlanarPose& atA, const PlanarShape& b, const PlanarPose& atB, double margin) {
    const Vec2 centreA = atA.at + atA.turn(a.centre), centreB = atB.at + atB.turn(b.centre);
    const double reach = a.bound + b.bound + margin;
    if ((centreB - centreA).squaredNorm() > reach * reach) return {};
    if (a.isCircle() && b.isCircle()) return circles(centreA, a.radius, centreB, b.radius, margin);
    if (a.isCircle()) {
        PlanarTouch touch = inWorld(circleOnPolygon(b, atB.turnBack(centreA - atB.at), a.radius, margin), atB);
        touch.normal = -touch.normal;
        return touch;
    }
    if (b.isCircle()) return inWorld(circleOnPolygon(a, atA.turnBack(centreB - atA.at), b.radius, margin), atA);
    if (isBeyond(a, atA.turnBack(centreB - atA.at), b.bound, margin) || isBeyond(b, atB.turnBack(centreA - atB.at), a.bound, margin))
        return {};
    Edges seen;
    seeFrom(b, atB, atA, seen);
    return inWorld(polygons(a, seen, margin), atA);
}

} // namespace trundle
