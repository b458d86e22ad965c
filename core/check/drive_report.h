#pragma once
// Private to core/check. What the checks of one drive share: where its wheels are in the text, and fixes of their axes.

#include "base/diagnostic.h"
#include "check/drive_wheels.h"
#include "project/loading/project.h"

namespace trundle {

struct SwappedKeys {
    const char *left, *right; ///< keys of the drive, as "LeftMotor"
};

class DriveReport {
public:
    /// All are to outlive it.
    DriveReport(const LoadedProject& loaded, const RobotConfigSpec& config, const ComponentSpec& drive, Diagnostics& diagnostics)
        : loaded(loaded), config(config), drive(drive), m_diagnostics(diagnostics) {}

    Diagnostic& warn(const SourceRange& range, std::string text) {
        return m_diagnostics.warning(Code::WheelGeometry, range.known() ? range : drive.nameRange, std::move(text));
    }
    [[nodiscard]] const JointSpec* jointOf(const DriveWheel& wheel) const;
    [[nodiscard]] const std::string& bodyOf(const DriveWheel& wheel) const { return config.bodies[wheel.body].name; }

    /// Sets the axes of joints. Not of those in a Part or Repeat, whose text may be that of several.
    void addAxisFix(Diagnostic& d, const std::string& title, const std::vector<const JointSpec*>& joints,
                    const std::vector<Vec3>& axes) const;
    void addReversal(Diagnostic& d, const std::vector<DriveWheel>& wheels) const;
    /// Warns that two values of the drive are each the other's; the fix exchanges them.
    void reportSwapped(const SwappedKeys& keys, const std::string& what);
    /// The same of two motors, of which each is in the key of the other.
    void reportExchanged(const DriveMotor& motor, const DriveWheel& wheel, const DriveMotor& other, const std::string& where);
    /// Warns of a wheel that is not where the motor's key says; `where`: "on the left".
    void reportPlace(const DriveMotor& motor, const DriveWheel& wheel, const std::string& where);

    const LoadedProject& loaded;
    const RobotConfigSpec& config;
    const ComponentSpec& drive;

private:
    Diagnostics& m_diagnostics;
};

/// Whether a value is literal text in a file, not set by a Param or on the command line.
[[nodiscard]] bool isWritten(const LoadedProject& loaded, const ResolvedValue& value);
[[nodiscard]] std::string axisText(const Vec3& axis);

} // namespace trundle
