#include "run/logs/signal_columns.h"

#include <charconv>
#include <numbers>

#include <trundle/geometry.h>

namespace trundle {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// Those of GroundTruthSignals and of the drives. Other components and controllers may mean something else by these names.
struct ShapedSignal {
    std::string_view name, unit;
    std::uint32_t count;
    SignalDirection direction;
    SignalShape shape;
};
constexpr ShapedSignal kShapedSignals[] = {
    {"pose", "m", 7, SignalDirection::Truth, SignalShape::Pose},
    {"velocity", "m/s", 6, SignalDirection::Truth, SignalShape::Velocity},
    {"pose", "", 3, SignalDirection::Truth, SignalShape::PlanePose},
    {"odometry", "", 3, SignalDirection::Output, SignalShape::PlanePose},
};

} // namespace

double readableDegrees(double radians) {
    const double degrees = radians * kDegrees;
    char digits[64];
    const auto written = std::to_chars(digits, digits + sizeof digits, degrees, std::chars_format::general, 14);
    double rounded = degrees;
    std::from_chars(digits, written.ptr, rounded);
    return rounded;
}

SignalShape shapeOf(const SignalEntry& entry) {
    const std::string_view name = std::string_view(entry.path).substr(entry.path.rfind('/') + 1); // all of a path without a slash
    for (const ShapedSignal& each : kShapedSignals)
        if (each.name == name && each.unit == entry.unit && each.count == entry.count && each.direction == entry.direction)
            return each.shape;
    return SignalShape::Plain;
}

SignalColumns::SignalColumns(const SignalEntry& entry) : m_shape(shapeOf(entry)), m_offset(entry.offset), m_count(entry.count) {
    const auto add = [&](std::initializer_list<const char*> parts) {
        for (const char* part : parts) m_names.push_back(entry.path + "/" + part);
    };
    if (m_shape == SignalShape::Pose) {
        add({"x [m]", "y [m]", "z [m]", "heading [deg]", "pitch [deg]", "roll [deg]"});
        return;
    }
    if (m_shape == SignalShape::Velocity) {
        add({"x [m/s]", "y [m/s]", "z [m/s]", "x [rad/s]", "y [rad/s]", "z [rad/s]"});
        return;
    }
    if (m_shape == SignalShape::PlanePose) {
        add({"x [m]", "y [m]", "heading [deg]"});
        return;
    }

    m_isAngle = entry.unit == "rad";
    const std::string unit = m_isAngle ? "deg" : entry.unit;
    const std::string suffix = unit.empty() ? "" : " [" + unit + "]";
    for (std::uint32_t i = 0; i < m_count; ++i)
        m_names.push_back(m_count == 1 ? entry.path + suffix : entry.path + "/" + std::to_string(i) + suffix);
}

void SignalColumns::read(std::span<const double> slots, std::vector<double>& numbers) const {
    const std::span<const double> own = slots.subspan(m_offset, m_count);
    if (m_shape == SignalShape::PlanePose) {
        numbers.insert(numbers.end(), {own[0], own[1], readableDegrees(own[2])});
        return;
    }
    if (m_shape != SignalShape::Pose) {
        for (const double value : own) numbers.push_back(m_isAngle ? readableDegrees(value) : value);
        return;
    }
    const Vec3 hpr = hprFromRotation(Quat(own[3], own[4], own[5], own[6])).unaryExpr(&readableDegrees);
    numbers.insert(numbers.end(), {own[0], own[1], own[2], hpr.x(), hpr.y(), hpr.z()});
}

} // namespace trundle
