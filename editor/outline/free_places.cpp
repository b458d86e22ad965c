#include "editor/outline/free_places.h"

#include <algorithm>
#include <cmath>

#include "lang/number_text.h"
#include "project/edits/plan_targets.h"
#include "project/objects/part_values.h"
#include "scene/queries/drop_placement.h"

namespace trundle {
namespace {

constexpr double kGridStep = 0.05, kLevel = 1e-5; ///< m; a smaller vertical way is ignored
constexpr double kWheelRoom = 0.06;               ///< m

/// The inserted instances, layouts and Repeats, with the shapes of all of them.
class Inserted {
public:
    Inserted(const LoadedProject& before, const LoadedProject& now)
        : m_now(now), m_objects(now.experiment), m_poses(startPoses(*now.experiment)) {
        for (const Part* part : now.outline->world.all())
            if ((isPlaced(*part) || part->isRepeat()) && !before.outline->world.find(part->name)) m_parts.push_back(part);
        if (m_parts.empty()) return;
        m_from = positionOf(*m_parts.front());
        const ExperimentSpec& e = *now.experiment;
        for (std::uint32_t r = 0; r < e.robots.size(); ++r)
            for (std::uint32_t b = 0; isNew({ObjectKind::Robot, r}) && !e.robots[r].scenery && e.robots[r].config &&
                                      b < e.robots[r].config->bodies.size();
                 ++b)
                add(e.robots[r].config->bodies[b].geoms, m_objects.poseOf({ObjectKind::Body, r, b}, m_poses));
        addWheelRoom(before);
        m_onlyStatics = m_geoms.empty();
        for (std::uint32_t s = 0; s < e.statics.size(); ++s)
            if (isNew({ObjectKind::Static, s}) && e.statics[s].geoms) add(*e.statics[s].geoms, e.statics[s].pose);
    }

    /// How far they all have to move.
    [[nodiscard]] Vec3 way(const std::optional<Vec3>& near) const {
        if (m_geoms.empty()) return Vec3::Zero();
        Vec3 from = m_from;
        for (int k = 0; near && k < 2; ++k) from[k] = kGridStep * std::round((*near)[k] / kGridStep);
        const auto obstructs = [this](const ObjectRef& geom) { return !isNew(geom) && !(m_onlyStatics && isGround(geom)); };
        if (!near && DropPlacement(m_objects, m_poses, obstructs).isFree(m_geoms, m_from)) return Vec3::Zero();
        const DropPlacement placement(m_objects, m_poses, [this](const ObjectRef& geom) { return !isNew(geom); });
        const auto to = placement.placeOnFloor(m_geoms, from, kGridStep);
        Vec3 way = to ? Vec3(*to - m_from) : Vec3(Vec3::Zero());
        if (std::abs(way.z()) < kLevel) way.z() = 0; // keeps the number in the text
        return way;
    }

    [[nodiscard]] std::vector<ValueEdit> movedBy(const Vec3& way) const {
        std::vector<ValueEdit> edits;
        for (const Part* part : m_parts) {
            const Vec3 from = positionOf(*part), to = from + way;
            const SourceAssignment* written = part->assignments.find("Pos");
            const std::string text(written ? m_now.outline->texts().slice(written->valueRange()) : std::string_view());
            edits.push_back({part->name + ".Pos", withNumbers(text, {from.data(), 3}, {to.data(), 3}, "m", 1e-6)});
        }
        return edits;
    }

private:
    [[nodiscard]] Vec3 positionOf(const Part& part) const { return poseAt(m_now, *placeOf(m_now, part.name)).position; }
    [[nodiscard]] bool isNew(const ObjectRef& object) const {
        const RobotSpec* robot = m_objects.robotOf(object);
        const SourceRange& block = robot ? robot->range : m_objects.staticOf(object)->range;
        return std::ranges::any_of(m_parts, [&](const Part* part) { return isWithin(block, part->range); });
    }
    [[nodiscard]] bool isGround(const ObjectRef& object) const {
        const GeomSpec* geom = m_objects.geomOf(object);
        return geom && (geom->shape == GeomShape::Plane || geom->shape == GeomShape::Heightfield);
    }
    /// A robot that is built from here on is a hull above its floor: its wheels need the room between them and beside it.
    void addWheelRoom(const LoadedProject& before) {
        const Part* config = m_parts.size() == 1 ? configOf(m_now, *m_parts.front()) : nullptr;
        const bool isBegun = config && !before.outline->configs.find(config->name) && m_geoms.size() == 1 &&
                             m_geoms.front().geom.shape == GeomShape::Box;
        if (!isBegun) return;
        PlacementGeom room = m_geoms.front();
        const Vec3 middle = room.body * room.geom.pose.position;
        const double top = middle.z() + room.geom.size.z() / 2;
        if (!(middle.z() - room.geom.size.z() / 2 > kLevel)) return;
        room.geom.size = {room.geom.size.x() + 2 * kWheelRoom, room.geom.size.y() + 2 * kWheelRoom, top};
        room.geom.pose.position.z() += top / 2 - middle.z();
        m_geoms.push_back(room);
    }
    void add(const std::vector<GeomSpec>& geoms, Pose owner) {
        owner.position -= m_from;
        for (const GeomSpec& geom : geoms) m_geoms.push_back({geom, owner});
    }

    const LoadedProject& m_now;
    ObjectIndex m_objects;
    BodyPoses m_poses;
    std::vector<const Part*> m_parts;
    std::vector<PlacementGeom> m_geoms; ///< relative to m_from
    Vec3 m_from = Vec3::Zero();
    bool m_onlyStatics = false;
};

} // namespace

std::vector<ValueEdit> freePlaces(const LoadedProject& before, const LoadedProject& now, const std::optional<Vec3>& near) {
    const Inserted inserted(before, now);
    const Vec3 way = inserted.way(near);
    return way.isZero() ? std::vector<ValueEdit>() : inserted.movedBy(way);
}

} // namespace trundle
