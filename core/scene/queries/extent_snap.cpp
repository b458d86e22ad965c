#include "scene/queries/extent_snap.h"

#include <algorithm>
#include <cmath>

namespace trundle {
namespace {

constexpr double kAlike = 1e-6; // m, between the sizes of a thing and of what it can be the mirror image of

using Lines = std::vector<std::array<Vec3, 2>>;

/// Bounds along axes, and those of the mirror image in the plane y = 0 of the model.
class AxesBounds {
public:
    AxesBounds(const Mat3& axes, const Pose& X_WM) : m_axes(axes.transpose()) {
        const Vec3 left = X_WM.rotation * Vec3::UnitY();
        const Mat3 mirror = Mat3::Identity() - 2 * left * left.transpose();
        m_turn = Quat(Mat3(-m_axes * mirror)); // a mirror is a half turn and a reflection in the origin
        m_offset = 2 * left.dot(X_WM.position) * m_axes * left;
    }
    [[nodiscard]] Bounds of(const GeomSpec& geom, const Pose& owner) const {
        return boundsOf(geom, Pose{Vec3::Zero(), Quat(m_axes)} * owner);
    }
    [[nodiscard]] Bounds mirrored(const GeomSpec& geom, const Pose& owner) const {
        const Bounds turned = boundsOf(geom, Pose{Vec3::Zero(), m_turn} * owner);
        return turned.empty() ? turned : Bounds{m_offset - turned.high, m_offset - turned.low};
    }

private:
    Mat3 m_axes;
    Quat m_turn;
    Vec3 m_offset;
};

/// Geoms of a robot or static, with those of what moves in that.
std::vector<ObjectRef> geomsOf(const ObjectIndex& objects, const ObjectRef& whole) {
    std::vector<ObjectRef> geoms;
    if (const StaticSpec* fixed = objects.staticOf(whole); fixed && fixed->geoms)
        for (std::uint32_t i = 0; i < fixed->geoms->size(); ++i) geoms.push_back({ObjectKind::StaticGeom, whole.instance, 0, i});
    const auto robot = objects.bodiesOf(whole);
    const auto config = robot ? objects.experiment().robots[*robot].config : nullptr;
    for (std::uint32_t i = 0; config && i < config->bodies.size(); ++i)
        for (std::uint32_t k = 0; k < config->bodies[i].geoms.size(); ++k) geoms.push_back({ObjectKind::Geom, *robot, i, k});
    return geoms;
}

struct Image {
    Bounds bounds, source;
};

void addTo(std::vector<SnapExtents::Target>& targets, const Image& image, const Vec3& size) {
    if (!image.bounds.empty() && (image.bounds.size() - size).cwiseAbs().maxCoeff() < kAlike)
        targets.push_back({image.bounds, image.source});
}

/// A line from a source to its mirror image, or a rectangle.
void addGuides(const SnapExtents& extents, const SnapExtents::Target& target, const Vec3& by, int axis, double at,
               Lines& guides) {
    const Bounds thing{extents.thing.low + by, extents.thing.high + by};
    if (target.source) return guides.push_back({extents.axes * target.source->centre(), extents.axes * thing.centre()});
    Bounds around = target.bounds;
    around.add(thing);
    std::array<Vec3, 4> corners;
    for (const int i : {0, 1, 2, 3}) {
        Vec3 corner;
        corner[axis] = at;
        corner[(axis + 1) % 3] = (i == 1 || i == 2 ? around.high : around.low)[(axis + 1) % 3];
        corner[(axis + 2) % 3] = (i >= 2 ? around.high : around.low)[(axis + 2) % 3];
        corners[std::size_t(i)] = extents.axes * corner;
    }
    for (std::size_t i = 0; i < 4; ++i) guides.push_back({corners[i], corners[(i + 1) % 4]});
}

struct Caught {
    const SnapExtents::Target* target = nullptr;
    double by = 0, at = 0, distance = HUGE_VAL;
};

/// The nearest place along one axis. A middle at an end counts only where no two ends and no two middles are near.
Caught nearestOf(const SnapExtents& extents, int axis, double by, double near) {
    const auto places = [&](const Bounds& b) { return std::array{b.centre()[axis], b.low[axis], b.high[axis]}; };
    const std::array<double, 3> own = places(extents.thing);
    Caught alike, mixed;
    for (const SnapExtents::Target& target : extents.targets) {
        const std::array<double, 3> at = places(target.bounds);
        const bool isPoint = at[1] == at[2];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                if (target.source && (i > 0 || k > 0)) continue;
                const double distance = std::abs(at[i] - own[k] - by);
                Caught& nearest = isPoint || (i > 0) == (k > 0) ? alike : mixed;
                if (distance < nearest.distance - 1e-9) nearest = {&target, at[i] - own[k], at[i], distance};
            }
    }
    return alike.distance < near ? alike : mixed;
}

} // namespace

SnapExtents SnapExtents::of(const ObjectIndex& objects, const BodyPoses& poses, const std::vector<ObjectRef>& moved,
                            const std::function<bool(const ObjectRef& geom)>& counts, const Mat3& axes) {
    SnapExtents extents{axes, {}, {}};
    if (moved.empty()) return extents;
    const ObjectRef whole = objects.wholeOf(moved.front());
    const Pose X_WM = objects.poseOf(whole, poses);
    const AxesBounds bounds(axes, X_WM);
    const auto isMoved = [&](const ObjectRef& object) { return std::ranges::find(moved, object) != moved.end(); };
    std::vector<Image> bodies, geoms;
    std::optional<ObjectRef> last;
    for (const ObjectRef& ref : geomsOf(objects, whole)) {
        const GeomSpec& geom = *objects.geomOf(ref);
        const Pose owner = objects.frameOf(ref, poses);
        const Bounds own = bounds.of(geom, owner);
        const ObjectRef body = *objects.ownerOf(ref);
        if (isMoved(ref) || (geom.visible && isMoved(body))) extents.thing.add(own);
        if (isMoved(ref) || isMoved(body) || !geom.visible || own.empty() || !counts(ref)) continue;
        extents.targets.push_back({own, {}});
        geoms.push_back({bounds.mirrored(geom, owner), own});
        if (last != body || ref.kind != ObjectKind::Geom) bodies.emplace_back();
        bodies.back().bounds.add(geoms.back().bounds);
        bodies.back().source.add(own);
        last = body;
    }
    const Vec3 origin = axes.transpose() * X_WM.position;
    extents.targets.push_back({{origin, origin}, {}});
    for (const auto& images : {bodies, geoms})
        for (const Image& image : images) addTo(extents.targets, image, extents.thing.size());
    return extents;
}

ExtentSnap snapExtents(const SnapExtents& extents, const ExtentSnapOptions& options) {
    ExtentSnap snap{options.stepped, {}};
    if (extents.thing.empty()) return snap;
    std::array<Caught, 3> caught;
    for (int k = 0; k < 3; ++k) {
        const Caught nearest = nearestOf(extents, k, options.by[k], options.near[k]);
        const double toStep = std::abs(options.stepped[k] - options.by[k]);
        if (nearest.distance >= options.near[k] || nearest.distance - options.favour[k] > toStep) continue;
        snap.by[k] = nearest.by;
        caught[std::size_t(k)] = nearest;
    }
    for (int k = 0; k < 3; ++k)
        if (const Caught& c = caught[std::size_t(k)]; c.target) addGuides(extents, *c.target, snap.by, k, c.at, snap.guides);
    return snap;
}

} // namespace trundle
