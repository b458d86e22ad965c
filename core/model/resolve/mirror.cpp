// With M = diag(1, -1, 1) for Mirror = y: a point p becomes M p, a rotation R becomes M R M, which is a rotation again, and an
// inertia I becomes M I M. All of these change signs only, so that a mirrored part has the bits of its copy by hand.
#include "model/resolve/mirror.h"

#include <cmath>
#include <numbers>

namespace trundle {

namespace {

/// An axis at 45 degrees to the mirror plane is as far from its image as from the reverse of that: it takes the image, whatever its last bits.
constexpr double kAcross = 1e-9;

double negated(double value) { return 0.0 - value; } // never -0

/// Values of a base change their places: LeftMotor and RightMotor, FrontLeftMotor and FrontRightMotor, LeftSteering and RightSteering.
void exchange(ComponentSpec& device, const std::string& one, const std::string& other) {
    for (auto& [key, value] : device.values) {
        const std::size_t at = key.find(one);
        if (at == std::string::npos) continue;
        const auto found = device.values.find(std::string(key).replace(at, one.size(), other));
        if (found != device.values.end()) std::swap(value, found->second);
    }
}

/// 180 degrees - `angle`, with the bits that it has written in degrees.
double supplement(double angle) {
    constexpr double kDegree = std::numbers::pi / 180;
    const double written = std::round(angle / kDegree * 1e9) / 1e9;
    return written * kDegree == angle ? (180 - written) * kDegree : std::numbers::pi - angle;
}

/// The direction of a belt in its geom, whose image is M R M.
double mirroredHeading(double heading, int axis) {
    return axis == 0 ? supplement(heading) : axis == 1 ? negated(heading) : heading;
}

/// Stops of an axis that turns the other way.
void reverse(std::optional<double>& low, std::optional<double>& high) {
    std::swap(low, high);
    for (std::optional<double>* stop : {&low, &high})
        if (*stop) *stop = negated(**stop);
}

void negateAt(Vec3& v, int axis) { v[axis] = negated(v[axis]); }

} // namespace

PartPlacement::PartPlacement(const PartFields& fields)
    : m_axis(fields.mirror == "x"   ? 0
             : fields.mirror == "y" ? 1
             : fields.mirror == "z" ? 2
                                    : -1),
      m_given(poseOf(fields.pos, fields.hpr)), m_pose(m_given) {}

Vec3 PartPlacement::mirrored(const Vec3& vector) const {
    Vec3 image = vector;
    if (isMirrored()) negateAt(image, m_axis);
    return image;
}

Quat PartPlacement::mirrored(const Quat& q) const {
    if (!isMirrored()) return q;
    Vec3 v = q.vec();
    for (int i = 0; i < 3; ++i)
        if (i != m_axis) negateAt(v, i);
    return {q.w(), v.x(), v.y(), v.z()};
}

Vec3 PartPlacement::mirroredAxis(const Vec3& axis, bool& isReversed) const {
    isReversed = false;
    if (!isMirrored()) return axis;
    Vec3 image = axis; // an angular velocity is an axial vector: its mirror image is -M w
    for (int i = 0; i < 3; ++i)
        if (i != m_axis) negateAt(image, i);
    isReversed = image.dot(axis) < -kAcross;
    return isReversed ? Vec3(negated(image.x()), negated(image.y()), negated(image.z())) : image;
}

void PartPlacement::countFrom(const Pose& frame) { m_pose = PartPlacement(frame).pose(m_given); }

Pose PartPlacement::pose(const Pose& described) const {
    const Pose image{mirrored(described.position), mirrored(described.rotation)};
    if (m_pose.rotation.coeffs() == Quat::Identity().coeffs()) return {m_pose.position + image.position, image.rotation};
    return m_pose * image;
}

bool PartPlacement::mirror(ResolveContext& context, GeomSpec& geom) const {
    if (!isMirrored()) return true;
    geom.pose = {mirrored(geom.pose.position), mirrored(geom.pose.rotation)};
    geom.surface = context.mirroredSurface(geom.surface);
    if (geom.shape == GeomShape::Heightfield) {
        context.diagnostics.error(Code::BadGeometry, geom.nameRange,
                                  "the Heightfield " + geom.name + " has no mirror image; mirror its picture instead");
        return false;
    }
    if (geom.shape == GeomShape::Plane && m_axis == 2) // its ground is on the other side
        geom.pose.rotation = geom.pose.rotation * Quat(0, 1, 0, 0);
    if (!geom.mesh) return true;
    std::array<double, 3> signs{1, 1, 1};
    signs[static_cast<std::size_t>(m_axis)] = -1;
    const bool isHull = geom.hull == geom.mesh;
    geom.mesh = context.assets.shapes->scaled(geom.mesh, signs);
    if (geom.hull) geom.hull = isHull ? geom.mesh : context.assets.shapes->scaled(geom.hull, signs);
    return true;
}

void PartPlacement::mirror(MassProperties& given) const {
    if (!isMirrored()) return;
    negateAt(given.centre, m_axis);
    for (int i = 0; i < 3; ++i) {
        if (i == m_axis) continue;
        given.inertia(i, m_axis) = negated(given.inertia(i, m_axis));
        given.inertia(m_axis, i) = negated(given.inertia(m_axis, i));
    }
}

bool PartPlacement::place(ResolveContext& context, GeomSpec& geom) const {
    const bool good = mirror(context, geom);
    PartPlacement moved;
    moved.m_pose = m_pose;
    geom.pose = moved.pose(geom.pose);
    return good;
}

void PartPlacement::place(JointSpec& joint) const {
    bool isReversed = false, isAlsoReversed = false;
    const bool slides = joint.type == JointType::Slider || joint.type == JointType::Suspension;
    joint.axis = slides ? mirrored(joint.axis) : mirroredAxis(joint.axis, isReversed);
    joint.axis2 = mirroredAxis(joint.axis2, isAlsoReversed);
    joint.anchor = pose({joint.anchor, Quat::Identity()}).position;
    if (m_pose.rotation.coeffs() != Quat::Identity().coeffs()) {
        joint.axis = (m_pose.rotation * joint.axis).normalized();
        joint.axis2 = (m_pose.rotation * joint.axis2).normalized();
    }
    if (isReversed) {
        reverse(joint.lowStop, joint.highStop);
        joint.rest = negated(joint.rest);
    }
    if (isAlsoReversed) reverse(joint.lowStop2, joint.highStop2);
}

void PartPlacement::place(SpringSpec& spring) const {
    spring.anchor = pose({spring.anchor, Quat::Identity()}).position;
    spring.anchor2 = pose({spring.anchor2, Quat::Identity()}).position;
}

bool PartPlacement::reverses(JointType type, Vec3& axis) const {
    bool isReversed = false;
    axis = m_pose.rotation.conjugate() * axis;
    axis = type == JointType::Slider ? mirrored(axis) : mirroredAxis(axis, isReversed);
    return isReversed;
}

/// What looks along its x axis looks along the mirrored x axis, with the mirrored z axis up: for Mirror = y that is M R M, and the
/// mirror images along x and z are that of y, turned by half a turn about z or x.
Vec3 PartPlacement::mirroredHpr(const Vec3& hpr) const {
    const double heading = hpr[0], pitch = hpr[1], roll = hpr[2];
    if (m_axis == 0) return {supplement(heading), pitch, negated(roll)};
    if (m_axis == 1) return {negated(heading), pitch, negated(roll)};
    return {heading, negated(pitch), supplement(roll)};
}

void PartPlacement::place(ComponentSpec& device, bool isOnOwnBody) const {
    const auto triple = [&](const char* key) -> std::vector<double>* {
        const auto it = device.values.find(key);
        return it != device.values.end() && it->second.value.numbers.size() == 3 ? &it->second.value.numbers : nullptr;
    };
    std::vector<double>*const pos = triple("Pos"), *const hpr = triple("HPR");
    if (isMirrored() && pos) {
        double& value = (*pos)[static_cast<std::size_t>(m_axis)];
        value = negated(value);
    }
    if (isMirrored() && hpr) {
        const Vec3 image = mirroredHpr({(*hpr)[0], (*hpr)[1], (*hpr)[2]});
        *hpr = {image[0], image[1], image[2]};
    }
    if (m_axis == 1) exchange(device, "Left", "Right");
    if (m_axis == 0) exchange(device, "Front", "Back");
    if (const auto heading = device.values.find("Heading"); device.kind == "Belt" && heading != device.values.end())
        for (double& value : heading->second.value.numbers) value = mirroredHeading(value, m_axis);
    if (isOnOwnBody) return;
    const bool isTurned = m_given.rotation.coeffs() != Quat::Identity().coeffs();
    if (pos) {
        const Vec3 described(pos->data());
        const Vec3 placed = m_given.position + (isTurned ? Vec3(m_given.rotation * described) : described);
        *pos = {placed[0], placed[1], placed[2]};
    }
    if (hpr && isTurned) {
        const Vec3 turned = hprFromRotation(m_given.rotation * rotationFromHpr(Vec3(hpr->data())));
        *hpr = {turned[0], turned[1], turned[2]};
    }
}

} // namespace trundle
