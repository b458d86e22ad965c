#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "model/resolve/footprint.h"
#include "model/resolve/obstacle_grid.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

/// The places of the members of all Scatters. They are chosen after everything else has its pose, which they keep clear of; one Scatter
/// after another.
class ScatterPlaces {
public:
    /// `moving`: what moves in the scenery.
    ScatterPlaces(ResolveContext& context, std::vector<RobotSpec>& moving) : m_context(context), m_moving(moving) {}

    /// Its members follow, by addStatic() or addRobot(), with any pose. `disc`: of the largest.
    void add(const ExpandedPart& scatter, const Record& record, const RobotDisc& disc);
    /// The last static, and if it moves the last in `moving`, is this member of the part, if that is a Scatter.
    void addStatic(const ExpandedPart& part, std::size_t member, bool moves);
    /// The same for the last robot.
    void addRobot(const ExpandedPart& part, std::size_t member);
    /// Sets the poses of its members, if the part is a Scatter. Where there is no place (E317), all of them are left out.
    void place(const ExpandedPart& part);
    /// Removes those left out; indices change.
    void removeLeftOut();

private:
    struct Member {
        std::size_t number = 0;
        std::optional<std::size_t> still, moving, robot; ///< indices
    };
    struct Scatter {
        Record record;
        RobotDisc disc;
        std::vector<Member> members;
    };
    [[nodiscard]] std::vector<Pose> poses(const ExpandedPart& part, const Scatter& scatter) const;
    [[nodiscard]] ObstacleGrid obstacles(const ExpandedPart& part, const Pose& origin, const std::array<double, 4>& area,
                                         double radius) const;

    ResolveContext& m_context;
    std::vector<RobotSpec>& m_moving;
    std::map<const ExpandedPart*, Scatter> m_scatters;
    std::vector<bool> m_stillWaits, m_movingWaits, m_robotWaits; // by index: no pose yet; at the end: left out
};

} // namespace trundle
