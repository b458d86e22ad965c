#include "scan_points.h"

#include <cmath>
#include <numbers>

namespace collect {

namespace {

constexpr double kJump = 0.1; // m: between two beams, from one thing to the next
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMeanDepth = std::numbers::pi / 4; // of a circle's front before its middle, averaged over its width, in radii

} // namespace

double length(double x, double y) { return std::sqrt(x * x + y * y); }
double Point::range() const { return length(x, y); }
double Point::bearing() const { return std::atan2(y, x); }

ScanPoints::ScanPoints(std::span<const double> ranges, double fieldOfView, double ahead, double maxRange)
    : m_ranges(ranges), m_step(ranges.size() > 1 ? fieldOfView / static_cast<double>(ranges.size() - 1) : 0),
      m_first(-fieldOfView / 2), m_ahead(ahead), m_maxRange(maxRange) {
    m_points.reserve(ranges.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const double bearing = m_first + static_cast<double>(i) * m_step;
        m_points.push_back({ahead + ranges[i] * std::cos(bearing), ranges[i] * std::sin(bearing)});
    }
}

std::vector<Point> ScanPoints::cylinders(double radius) const {
    std::vector<Point> found;
    const std::size_t count = m_ranges.size();
    for (std::size_t first = 0, next = 0; first < count; first = next) {
        for (next = first + 1; next < count && std::abs(m_ranges[next] - m_ranges[next - 1]) < kJump;) ++next;
        if (first == 0 || next == count || next - first < 3) continue;
        if (m_ranges[first - 1] < m_ranges[first] || m_ranges[next] < m_ranges[next - 1]) continue; // something hides its edge
        const double middle = m_first + m_step * static_cast<double>(first + next - 1) / 2;
        double along = 0;
        for (std::size_t i = first; i < next; ++i)
            along += m_ranges[i] * std::cos(m_first + m_step * static_cast<double>(i) - middle);
        along /= static_cast<double>(next - first);
        const double width = along * m_step * static_cast<double>(next - first); // each beam stands for a step
        if (along >= m_maxRange || width < 1.2 * radius || width > 2.8 * radius) continue;
        along += kMeanDepth * radius;
        found.push_back({m_ahead + along * std::cos(middle), along * std::sin(middle)});
    }
    return found;
}

bool ScanPoints::isFree(double bearing, double reach, double width, Point ignored, double ignoredRadius) const {
    const double c = std::cos(bearing), s = std::sin(bearing);
    for (const Point& p : m_points) {
        const double along = c * p.x + s * p.y, aside = c * p.y - s * p.x;
        if (along < 0 || along > reach || std::abs(aside) > width / 2) continue;
        if (length(p.x - ignored.x, p.y - ignored.y) >= ignoredRadius) return false;
    }
    return true;
}

double ScanPoints::freeBearing(double desired, double reach, double width, Point ignored, double ignoredRadius) const {
    for (int i = 0; i <= 18; ++i)
        for (const int side : {1, -1})
            if (const double bearing = desired + side * i * 5 * kDegree; isFree(bearing, reach, width, ignored, ignoredRadius))
                return bearing;
    return desired;
}

} // namespace collect
