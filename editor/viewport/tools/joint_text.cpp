#include "editor/viewport/tools/joint_text.h"

#include <cmath>
#include <optional>

#include "lang/number_text.h"
#include "model/dotted_path.h"

namespace trundle {
namespace {

constexpr double kNearMainAxis = 0.94; // cosine of 20 degrees
constexpr double kAtOrigin = 1e-6;     // m

std::string tripleText(const Vec3& v, double step) {
    return steppedNumber(v.x(), step) + "," + steppedNumber(v.y(), step) + "," + steppedNumber(v.z(), step);
}

/// A main axis where it is near one, in the direction in which it is positive.
Vec3 tidyAxis(const Vec3& axis) {
    int main = 0;
    const double most = axis.cwiseAbs().maxCoeff(&main);
    if (most > kNearMainAxis) return Vec3::Unit(main);
    return axis[main] < 0 ? Vec3(-axis) : axis;
}

/// The axis of a body that is a wheel: its shapes around its origin are cylinders, all about one axis. In the frame of the body.
std::optional<Vec3> wheelAxis(const BodySpec& body) {
    std::optional<Vec3> axis;
    for (const GeomSpec& geom : body.geoms) {
        if (geom.shape != GeomShape::Cylinder) continue;
        const Vec3 along = geom.pose.rotation * Vec3::UnitZ();
        const Vec3 beside = geom.pose.position - geom.pose.position.dot(along) * along;
        if (beside.norm() > kAtOrigin || (axis && std::abs(axis->dot(along)) < 0.999)) return std::nullopt;
        axis = along;
    }
    return axis;
}

bool isBall(const BodySpec& body) {
    return body.geoms.size() == 1 && body.geoms[0].shape == GeomShape::Sphere && body.geoms[0].pose.position.norm() < kAtOrigin;
}

/// "leftAxle" for "leftWheel", "armHinge" for "arm".
std::string jointName(const std::string& kind, const std::string& child, bool isWheel) {
    const std::string name(lastWord(child));
    constexpr std::string_view kWheel = "Wheel";
    if (isWheel && (kind == "Hinge" || kind == "Suspension")) {
        if (name == "wheel") return "axle";
        if (name.size() > kWheel.size() && name.ends_with(kWheel)) return name.substr(0, name.size() - kWheel.size()) + "Axle";
        return name + "Axle";
    }
    return name + (kind == "Fixed" ? "Mount" : kind == "Ball" || kind == "Universal" ? "Joint" : kind);
}

} // namespace

std::string jointText(const std::string& kind, const JointPick& pick, double step) {
    const auto wheel = wheelAxis(*pick.body);
    std::string text =
        kind + " " + jointName(kind, pick.child, wheel.has_value()) + " { Parent=" + pick.parent + " Child=" + pick.child;
    const bool hasAnchor = kind != "Fixed" && kind != "Slider";
    const bool isCentred = (wheel && (kind == "Hinge" || kind == "Suspension")) || isBall(*pick.body);
    if (hasAnchor && !isCentred) {
        Vec3 anchor = pick.point;
        for (int k = 0; k < 3; ++k) anchor[k] = step * std::round(anchor[k] / step) + 0.0;
        text += " Anchor=" + tripleText(anchor, 1e-4);
    }
    if (kind == "Hinge" || kind == "Slider") {
        const bool isAxle = wheel && kind == "Hinge";
        const Vec3 axis = tidyAxis(isAxle ? Vec3(pick.X_CB.rotation * *wheel) : pick.normal);
        if (!axis.isApprox(Vec3::UnitZ(), 1e-4)) text += " Axis=" + tripleText(axis, 1e-4);
    }
    if (kind == "Suspension" && wheel)
        if (const Vec3 axle = tidyAxis(pick.X_CB.rotation * *wheel); !axle.isApprox(Vec3::UnitY(), 1e-4))
            text += " Axis2=" + tripleText(axle, 1e-4);
    return text + " }";
}

} // namespace trundle
