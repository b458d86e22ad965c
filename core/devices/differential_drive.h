#pragma once
#include "devices/chassis_drive.h"

namespace trundle {

/// A base with one driven wheel on each side.
class DifferentialDrive final : public ChassisDrive {
public:
    static void describe(Describe<DifferentialDrive>& d);
    void setup(Mount& mount) override;

private:
    std::string m_leftMotor, m_rightMotor;
};

/// A base with any number of driven wheels on each side, which skid when it turns.
class SkidDrive final : public ChassisDrive {
public:
    static void describe(Describe<SkidDrive>& d);
    /// Fails if a motor is given twice.
    void setup(Mount& mount) override;

private:
    std::vector<std::string> m_leftMotors, m_rightMotors;
};

} // namespace trundle
