// needs       the point below the tip in each tick
// assumptions the floor is level enough that a line is straight where it is straight seen from above
// method      cone intersection (Williams 1978): from the last but one point, all points that a segment stands for are within a
//             tolerance of it as long as the next one is in the cone that they leave
// data        four numbers for each point in the signal `line`: x, y, z in the world, and whether a stroke begins there
#include "devices/pen.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace trundle {

namespace {

constexpr double kTolerance = 0.1; // of Width: how far a merged point may be from the line
constexpr std::uint32_t kNumbers = 4;

} // namespace

void Pen::describe(Describe<Pen>& d) {
    d.help("Draws a line on the floor below it while it is down; seen in the 3D view and by cameras.").independent();
    d.field("Body", &Pen::m_bodyName, reference("Body").required(), "The body it is fixed to.");
    d.field("Pos", &Pen::m_position, metres().within(-1e5, 1e5), "Its position in the body.");
    d.field("ColorRGB", &Pen::m_colour, number().within(0, 1), "Red, green and blue.");
    d.field("Width", &Pen::m_width, metres().within(1e-4, 10), "Of its line.");
    d.field("Reach", &Pen::m_reach, metres().above(0).atMost(100), "How far below it the floor may be, along the body's z axis.");
    d.field("Down", &Pen::m_startsDown, flag(), "Whether it draws from the start; then its command says.");
    d.field("MaxPoints", &Pen::m_maxPoints, number().within(2, 10000), "Of its line; more drop the oldest.");
    PenSignals::describe(d);
}

void Pen::setup(Mount& mount) {
    m_body = mount.body(m_bodyName);
    down.set(m_startsDown);
}

std::optional<Vec3> Pen::tipOnGround(const Sensing& world) const {
    const TrundleBodyState body = world.bodyState(m_body);
    const double* q = body.quaternion;
    const Quat turn(q[0], q[1], q[2], q[3]);
    const Vec3 tip = Vec3(body.position) + turn * Vec3(m_position.data()), below = -(turn * Vec3::UnitZ());
    TrundleHit hit{};
    if (!world.ray(tip, below, m_reach, hit)) return std::nullopt;
    return Vec3(tip + hit.distance * below);
}

void Pen::sense(Sensing& world) {
    const std::optional<Vec3> point = down.get() != 0 ? tipOnGround(world) : std::nullopt;
    if (!point) {
        m_isDrawing = false;
        return;
    }
    if (std::exchange(m_isDrawing, true)) draw(*point);
    else add(*point, true);
    points.set(double(m_count));
    length.set(m_length);
}

void Pen::draw(const Vec3& point) {
    const Vec3 last = at(m_count - 1);
    const double way = (point - last).norm();
    if (way < kTolerance * m_width) return;
    m_length += way;
    const bool isFirst = m_count < 2 || line.get(std::uint32_t(m_count - 1) * kNumbers + 3) != 0;
    if (!isFirst && continuesLine(point)) return put(m_count - 1, point, false);
    add(point, false);
    m_least = -HUGE_VAL;
    m_most = HUGE_VAL;
    (void)continuesLine(point);
}

/// Whether a point and all before it, back to the last but one, are in line; then the next ones have to be, too.
bool Pen::continuesLine(const Vec3& point) {
    const Vec3 from = at(m_count - 2), end = at(m_count - 1), to = point - from;
    const double far = to.head<2>().norm();
    if (far < (end - from).head<2>().norm() || !(far > 0)) return false;
    const double slack = std::asin(std::min(1.0, kTolerance * m_width / far));
    double bearing = std::atan2(to.y(), to.x());
    if (std::isfinite(m_least)) { // of the turns of the circle the one that is nearest to the cone
        const double middle = (m_least + m_most) / 2, turns = std::round((middle - bearing) / (2 * std::numbers::pi));
        bearing += 2 * std::numbers::pi * turns;
    }
    if (bearing < m_least || bearing > m_most) return false;
    m_least = std::max(m_least, bearing - slack);
    m_most = std::min(m_most, bearing + slack);
    return true;
}

void Pen::add(const Vec3& point, bool begins) {
    if (m_count == m_maxPoints) {
        for (std::int64_t i = 1; i < m_count; ++i) put(i - 1, at(i), i == 1 || line.get(std::uint32_t(i) * kNumbers + 3) != 0);
        --m_count;
    }
    put(m_count++, point, begins);
}

Vec3 Pen::at(std::int64_t index) const {
    const auto first = std::uint32_t(index) * kNumbers;
    return {line.get(first), line.get(first + 1), line.get(first + 2)};
}

void Pen::put(std::int64_t index, const Vec3& point, bool begins) {
    const auto first = std::uint32_t(index) * kNumbers;
    for (std::uint32_t k = 0; k < 3; ++k) line.set(first + k, point[k]);
    line.set(first + 3, begins ? 1 : 0);
}

} // namespace trundle
