#pragma once
// What a level lidar sees, as points around the robot.

#include <span>
#include <vector>

namespace collect {

/// The root of x^2 + y^2, in the same bits as in Python.
[[nodiscard]] double length(double x, double y);

/// A point on the floor in the robot's frame: m, x ahead, y to the left.
struct Point {
    double x = 0, y = 0;
    [[nodiscard]] double range() const;
    [[nodiscard]] double bearing() const; ///< rad, positive to the left
};

/// The scan of a lidar that faces ahead on the robot's x axis.
class ScanPoints {
public:
    /// `ranges` in m, from -fieldOfView/2 (rad) counter-clockwise; `ahead`: of the lidar, from the axle, m; beams that hit nothing have
    /// at least `maxRange`.
    ScanPoints(std::span<const double> ranges, double fieldOfView, double ahead, double maxRange);

    /// Middles of free-standing round things with about this radius (m): runs of at least three beams, as wide as the thing, that are
    /// nearer than the beams on both sides.
    [[nodiscard]] std::vector<Point> cylinders(double radius) const;
    /// The bearing nearest to the desired one (rad) along which nothing is within `reach` m in a lane of `width` m. Things within
    /// `ignoredRadius` of `ignored` do not count. The desired bearing itself if all are blocked.
    [[nodiscard]] double freeBearing(double desired, double reach, double width, Point ignored, double ignoredRadius) const;
    /// Whether nothing is in such a lane.
    [[nodiscard]] bool isFree(double bearing, double reach, double width, Point ignored, double ignoredRadius) const;

private:
    std::span<const double> m_ranges;
    std::vector<Point> m_points; ///< of each beam
    double m_step, m_first, m_ahead, m_maxRange;
};

} // namespace collect
