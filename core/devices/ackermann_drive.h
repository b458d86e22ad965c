#pragma once
#include <trundle/drive_signals.h>

#include "devices/chassis_drive.h"

namespace trundle {

/// Drives the back wheels and steers the front wheels so that the axles of all of them meet in the centre of the turn.
class AckermannDrive final : public SidedDrive, public AckermannDriveSignals {
public:
    static void describe(Describe<AckermannDrive>& d);
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    /// A steered wheel.
    struct Steered {
        Port<ServoSignals> servo;
        JointId joint;
        double y = 0; ///< m, to the left of the middle
    };
    [[nodiscard]] Steered mountSteered(Mount& mount, const std::string& servo, double y) const;
    /// 1/m, the mean of the turns for which the steered wheels stand.
    [[nodiscard]] double curvature(const Services& world) const;

    std::string m_leftMotor, m_rightMotor, m_leftSteering, m_rightSteering;
    double m_wheelBaseM = 0, m_steeringSeparationM = 0;
    double m_maxSteeringRad = 0.5235987755982988;
    Steered m_left, m_right;
    bool m_reportedSteering = false;
};

} // namespace trundle
