#pragma once
#include <array>
#include <optional>
#include <string>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Draws a line on what is below a point of a body while it is down. The line is in its signals, so memory is bounded: points that are
/// in line with others are merged, and of more than MaxPoints the oldest are dropped.
class Pen final : public Device, public PenSignals {
public:
    static void describe(Describe<Pen>& d);
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    [[nodiscard]] std::optional<Vec3> tipOnGround(const Sensing& world) const;
    void add(const Vec3& point, bool begins);
    void draw(const Vec3& point);
    [[nodiscard]] bool continuesLine(const Vec3& point);
    [[nodiscard]] Vec3 at(std::int64_t index) const;
    void put(std::int64_t index, const Vec3& point, bool begins);

    std::string m_bodyName;
    std::array<double, 3> m_position{0, 0, 0}, m_colour{0.1, 0.1, 0.1};
    double m_width = 0.01, m_reach = 0.2; ///< m
    int m_maxPoints = 500;
    bool m_startsDown = true;

    BodyId m_body;
    std::int64_t m_count = 0;
    bool m_isDrawing = false;
    double m_least = 0, m_most = 0, m_length = 0; ///< rad: where points in line with the last segment are; m
};

} // namespace trundle
