#include "editor/outline/kind_icons.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace trundle {

// In alphabetical order.
static constexpr std::array<std::string_view, 26> kDrawn{
    "Ball",    "Body",      "Box",   "Capsule",     "ContactLog",  "Convex",  "Cylinder",  "DifferentialDrive",
    "Encoder", "EnergyLog", "Fixed", "Grid",        "Heightfield", "Hinge",   "Material",  "Mesh",
    "Plane",   "PoseLog",   "Robot", "RobotConfig", "RotaryMotor", "Scatter", "SignalLog", "Slider",
    "Sphere",  "Static"};
static constexpr std::array<std::string_view, 5> kDrawnToo{"StaticConfig", "Surface", "Suspension", "TouchSensor", "Universal"};

QString roleIcon(Role role) {
    switch (role) {
    case Role::Settings: return QStringLiteral("kind-settings");
    case Role::Material: return QStringLiteral("kind-material");
    case Role::Surface: return QStringLiteral("kind-surface");
    case Role::Config: return QStringLiteral("kind-robotconfig");
    case Role::Instance: return QStringLiteral("kind-robot");
    case Role::Layout: return QStringLiteral("kind-grid");
    case Role::Body: return QStringLiteral("kind-body");
    case Role::Geom: return QStringLiteral("kind-convex");
    case Role::Joint: return QStringLiteral("kind-hinge");
    case Role::Device: return QStringLiteral("kind-device");
    case Role::Controller: return QStringLiteral("kind-controller");
    case Role::Log: return QStringLiteral("kind-signallog");
    }
    return QStringLiteral("kind-unknown");
}

QString kindIcon(const Kind* kind) {
    if (!kind) return QStringLiteral("kind-unknown");
    const std::string_view name = kind->name;
    const bool drawn =
        std::binary_search(kDrawn.begin(), kDrawn.end(), name) || std::binary_search(kDrawnToo.begin(), kDrawnToo.end(), name);
    return drawn ? QStringLiteral("kind-") + QString::fromStdString(kind->name).toLower() : roleIcon(kind->role);
}

} // namespace trundle
