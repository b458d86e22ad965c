#include "editor/sensors/true_values.h"

#include <cmath>

namespace trundle {
namespace {

/// The pose and the velocity that a device has in the world, from the signals of its body.
class DeviceMotion {
public:
    DeviceMotion(const SignalLayout& layout, const RobotSpec& robot, const ComponentSpec& device) {
        const std::string body = robot.name + "/" + device.text("Body") + "/";
        const auto pose = layout.find(body + "pose"), velocity = layout.find(body + "velocity");
        if (!pose || !velocity || pose->count != 7 || velocity->count != 6) return;
        m_pose = pose->offset;
        m_velocity = velocity->offset;
        m_mounting = {vectorOf(device, "Pos"), rotationFromHpr(vectorOf(device, "HPR"))};
        m_exists = true;
    }
    [[nodiscard]] bool exists() const { return m_exists; }
    [[nodiscard]] Pose pose(const LiveSnapshot& snapshot) const { return bodyPose(snapshot) * m_mounting; }
    [[nodiscard]] Vec3 rate(const LiveSnapshot& snapshot) const {
        return Vec3(slots(snapshot) + m_velocity + 3);
    } ///< in the world
    [[nodiscard]] Vec3 velocity(const LiveSnapshot& snapshot) const {
        return Vec3(slots(snapshot) + m_velocity) + rate(snapshot).cross(bodyPose(snapshot).rotation * m_mounting.position);
    }

private:
    static const double* slots(const LiveSnapshot& snapshot) { return snapshot.block->slots().data(); }
    static Vec3 vectorOf(const ComponentSpec& device, std::string_view key) {
        const ResolvedValue* value = device.find(key);
        return value && value->value.numbers.size() == 3 ? Vec3(value->value.numbers.data()) : Vec3(Vec3::Zero());
    }
    [[nodiscard]] Pose bodyPose(const LiveSnapshot& snapshot) const {
        const double* s = slots(snapshot) + m_pose;
        return {Vec3(s), Quat(s[3], s[4], s[5], s[6]).normalized()};
    }

    std::uint32_t m_pose = 0, m_velocity = 0;
    Pose m_mounting;
    bool m_exists = false;
};

void writeVector(const Vec3& vector, double* numbers) { std::copy_n(vector.data(), 3, numbers); }

/// "range" with "trueRange": one reading for both.
void joinTrueSignals(std::vector<Reading>& readings) {
    for (Reading& reading : readings) {
        if (reading.name.empty()) continue;
        std::string name = "true" + reading.name;
        name[4] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[4])));
        const auto isTrue = [&](const Reading& other) { return other.name == name && other.count == reading.count; };
        if (const auto other = std::ranges::find_if(readings, isTrue); other != readings.end()) reading.readTrue = other->read;
    }
    std::erase_if(readings, [&](const Reading& reading) {
        const auto isMeasured = [&](const Reading& other) {
            return other.readTrue && reading.name.size() > 4 && reading.name.starts_with("true") &&
                   reading.name.substr(5) == other.name.substr(1);
        };
        return std::ranges::any_of(readings, isMeasured);
    });
}

} // namespace

void addTrueValues(const RunResults& run, const RobotSpec& robot, const ComponentSpec& device, std::vector<Reading>& readings) {
    joinTrueSignals(readings);
    const DeviceMotion motion(*run.layout, robot, device);
    if (!motion.exists()) return;
    for (Reading& reading : readings) {
        const bool gps = device.kind == "Gps", compass = device.kind == "Compass", imu = device.kind == "Imu";
        if (gps && reading.name == "position")
            reading.readTrue = [motion](const LiveSnapshot& s, double* numbers) {
                writeVector(motion.pose(s).position, numbers);
            };
        else if (gps && reading.name == "velocity")
            reading.readTrue = [motion](const LiveSnapshot& s, double* numbers) { writeVector(motion.velocity(s), numbers); };
        else if (imu && reading.name == "angularVelocity")
            reading.readTrue = [motion](const LiveSnapshot& s, double* numbers) {
                writeVector(motion.pose(s).rotation.conjugate() * motion.rate(s), numbers);
            };
        else if (compass && reading.name == "heading")
            reading.readTrue = [motion](const LiveSnapshot& s, double* numbers) {
                const Vec3 ahead = motion.pose(s).rotation * Vec3::UnitX();
                *numbers = std::atan2(ahead.y(), ahead.x());
            };
    }
}

} // namespace trundle
