#pragma once
#include <optional>

#include <trundle/device.h>
#include <trundle/device_signals.h>

namespace trundle {

/// Counts of an encoder on a joint: floor(angle CPR / 2 pi), four edges per line if Quadrature is set. It publishes only counted values; the
/// way between two counts is lost, as on real hardware. On a slider a line is Pitch wide, and CountsPerRevolution lines are from one index
/// mark to the next. What passes faster than MaxFrequency is not counted. An absolute encoder reads its position, so it loses nothing.
class Encoder final : public Device, public EncoderSignals {
public:
    static void describe(Describe<Encoder>& d);
    /// Fails if what only one type has is given to the other.
    void setup(Mount& mount) override;
    void sense(Sensing& world) override;

private:
    /// What of the counts that passed in a tick is counted.
    [[nodiscard]] double countedOf(double passed, const Services& world);

    std::string m_jointName, m_kindName = "incremental";
    double m_countsPerRevolution = 512;
    bool m_quadrature = false;
    bool m_hasIndex = false;
    std::optional<double> m_pitchM, m_maxFrequency; ///< Hz
    double m_offset = 0;                            ///< rad

    JointId m_joint;
    double m_perTurn = 0; ///< counts
    double m_turn = 0;    ///< rad or m
    bool m_isAbsolute = false;
    double m_count = 0, m_lastPassed = 0; ///< counted; where the joint was, in counts
    double m_lastTurn = 0;
    double m_left = 1; ///< counts that MaxFrequency allows beyond those counted
    bool m_isTooFast = false;
    double m_missed = 0;
};

/// The count at an angle (rad). Edges are shifted 1e-9 counts early, so that rounding does not toggle the count at rest on an
/// edge.
[[nodiscard]] double encoderCount(double angle, double countsPerTurn);

} // namespace trundle
