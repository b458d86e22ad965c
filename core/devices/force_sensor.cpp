#include "devices/force_sensor.h"

namespace trundle {

namespace {

constexpr std::size_t kForce = 0, kTorque = 1;

} // namespace

void ForceSensor::describe(Describe<ForceSensor>& d) {
    d.help("Measures the force and the torque that act across a joint.").independent();
    d.field("Joint", &ForceSensor::m_jointName, reference("Fixed|Hinge|Slider|Ball|Universal|Suspension").required(),
            "The joint: its parent's force on its child is measured.");
    describeSensor(d);
    const Quantity size = number().within(0, 1e9);
    d.field("Noise", &ForceSensor::m_noise, size, "Standard deviations of a reading: force [N], torque [N m].");
    d.field("ForceBias", &ForceSensor::m_forceBias, newtons().within(-1e9, 1e9), "Added to x, y, z.");
    d.field("TorqueBias", &ForceSensor::m_torqueBias, newtonMetres().within(-1e9, 1e9), "Added to x, y, z.");
    d.field("Range", &ForceSensor::m_range, size, "Largest reading: force [N], torque [N m]; 0: any.");
    d.field("Resolution", &ForceSensor::m_resolution, size, "Readings are multiples of it: force [N], torque [N m]; 0: exact.");
    ForceSensorSignals::describe(d);
}

void ForceSensor::begin(Mount& mount) {
    m_joint = mount.measuredJoint(m_jointName);
    time.set(-1);
}

void ForceSensor::measure(Sensing& world, std::vector<double>& reading) {
    Wrench wrench;
    Vec3 anchor = Vec3::Zero(), axis;
    if (world.time() <= 0 || !world.jointWrench(m_joint, wrench) || !world.jointAnchor(m_joint, anchor, axis)) return;
    const Pose place = pose(world);
    const Quat toSensor = place.rotation.conjugate() * turnedInTick(world);
    const Vec3 force = toSensor * wrench.force,
               torque = toSensor * wrench.torque + (place.rotation.conjugate() * (anchor - place.position)).cross(force);
    for (const std::size_t part : {kForce, kTorque})
        for (int axisIndex = 0; axisIndex < 3; ++axisIndex)
            reading.push_back(measured(part, axisIndex, (part == kForce ? force : torque)[axisIndex], world));
    reading.insert(reading.end(), {force.x(), force.y(), force.z(), torque.x(), torque.y(), torque.z()});
}

/// A wrench is that of where the bodies were before the tick turned them.
Quat ForceSensor::turnedInTick(const Sensing& world) const {
    const Vec3 turned = world.tick() * Vec3(world.bodyState(body()).angular);
    const double angle = turned.norm();
    return angle > 0 ? Quat(Eigen::AngleAxisd(angle, turned / angle)) : Quat(Quat::Identity());
}

double ForceSensor::measured(std::size_t part, int axis, double truth, const Services& world) const {
    const auto i = static_cast<std::size_t>(axis);
    double value = truth + (part == kForce ? m_forceBias : m_torqueBias)[i];
    if (m_noise[part] > 0) value += m_noise[part] * normalDeviate(world.randomBits(3 * part + i));
    const double most = m_range[part] > 0 ? m_range[part] : HUGE_VAL;
    return roundedWithin(value, -most, most, m_resolution[part]);
}

void ForceSensor::publish(std::span<const double> reading, double measuredAt) {
    for (std::uint32_t i = 0; i < 3; ++i) {
        force.set(i, reading[i]);
        torque.set(i, reading[3 + i]);
        trueForce.set(i, reading[6 + i]);
        trueTorque.set(i, reading[9 + i]);
    }
    time.set(measuredAt);
}

} // namespace trundle
