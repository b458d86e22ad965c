#include "editor/outline/kind_icons.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace trundle {

// Kinds that have an icon. Must be sorted, for the binary search.
// clang-format off
static constexpr auto kDrawn = std::to_array<std::string_view>({
    "AckermannDrive", "Ball", "Battery", "Belt", "Body", "Box", "Camera", "Capsule", "Charger", "Compass", "ContactLog", "Convex", "Cylinder",
    "DifferentialDrive", "Encoder", "EnergyLog", "Fixed", "ForceSensor", "Gear", "Gps", "Grid", "Gripper", "GroundSensor", "Heightfield",
    "Hinge", "Imu", "Latch", "Led", "Lidar", "LightSensor", "LinearMotor", "Material", "MecanumDrive", "Mesh", "OmniDrive", "Part", "PartConfig", "Pen", "Plane",
    "PoseLog", "RangeSensor", "Region", "Robot", "RobotConfig", "RotaryMotor", "Scatter", "Servo", "SignalLog", "SkidDrive",
    "Slider", "Sphere", "Spring", "Static", "StaticConfig", "Surface", "Suspension", "TouchSensor", "Track", "TrackDrive", "Transceiver", "Universal",
    "View"
});
// clang-format on

QString roleIcon(Role role) {
    switch (role) {
    case Role::Settings: return QStringLiteral("kind-settings");
    case Role::Material: return QStringLiteral("kind-material");
    case Role::Surface: return QStringLiteral("kind-surface");
    case Role::Look: return QStringLiteral("kind-look");
    case Role::Pattern:
    case Role::Medium: return QStringLiteral("kind-radio");
    case Role::Config: return QStringLiteral("kind-robotconfig");
    case Role::Instance: return QStringLiteral("kind-robot");
    case Role::Layout:
    case Role::Repeat: return QStringLiteral("kind-grid");
    case Role::Body: return QStringLiteral("kind-body");
    case Role::Geom: return QStringLiteral("kind-convex");
    case Role::Joint: return QStringLiteral("kind-hinge");
    case Role::Device: return QStringLiteral("kind-device");
    case Role::Controller: return QStringLiteral("kind-controller");
    case Role::Log: return QStringLiteral("kind-signallog");
    case Role::Region: return QStringLiteral("kind-region");
    }
    return QStringLiteral("kind-unknown");
}

QString kindIcon(const Kind* kind) {
    if (!kind) return QStringLiteral("kind-unknown");
    const bool drawn = std::binary_search(kDrawn.begin(), kDrawn.end(), std::string_view(kind->name));
    return drawn ? QStringLiteral("kind-") + QString::fromStdString(kind->name).toLower() : roleIcon(kind->role);
}

} // namespace trundle
