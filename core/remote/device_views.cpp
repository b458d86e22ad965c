#include "remote/device_views.h"

#include <algorithm>
#include <array>

namespace trundle {
namespace {

constexpr ViewData kDriveData[] = {{"pos", "odometry"}, {"done", "done"}, {"busy", "busy"}};
constexpr ViewWrite kDriveVelocity[] = {
    {"linearVelocity", 0}, {"angularVelocity", 1}, {"linearAmount", -1, 0}, {"angularAmount", -1, 0}};
constexpr ViewCommand kDriveCommands[] = {{"vel", 2, kDriveVelocity}};
constexpr ViewWrite kOmniVelocity[] = {
    {"linearVelocity", 0}, {"lateralVelocity", 1}, {"angularVelocity", 2}, {"linearAmount", -1, 0}, {"angularAmount", -1, 0}};
constexpr ViewCommand kOmniCommands[] = {{"vel", 3, kOmniVelocity}};
constexpr ViewWrite kCarVelocity[] = {{"linearVelocity", 0}, {"steeringAngle", 1}, {"linearAmount", -1, 0}};
constexpr ViewCommand kCarCommands[] = {{"car", 2, kCarVelocity}};

constexpr ViewData kServoData[] = {{"pos", "position"}, {"vel", "rate"}, {"saturated", "saturated"}};
constexpr ViewWrite kTarget[] = {{"target", 0}};
constexpr ViewCommand kServoCommands[] = {{"pos", 1, kTarget}};

constexpr ViewData kMotorData[] = {{"vel", "rate"}, {"current", "current"}, {"torque", "torque"}, {"saturated", "saturated"}};
constexpr ViewWrite kVoltage[] = {{"servo", -1, 0}, {"voltage", 0}};
constexpr ViewWrite kRate[] = {{"servo", -1, 1}, {"targetRate", 0}};
constexpr ViewCommand kMotorCommands[] = {{"voltage", 1, kVoltage}, {"vel", 1, kRate}};

constexpr ViewData kEncoderData[] = {{"pos", "angle"}, {"vel", "rate"}, {"count", "count"}};
constexpr ViewData kRangeData[] = {{"ranges", "range"}, {"time", "time"}};
constexpr ViewData kLidarData[] = {{"ranges", "ranges"}, {"time", "time"}};
constexpr ViewData kTouchData[] = {{"bumped", "pressed"}, {"force", "force"}, {"count", "count"}};
constexpr ViewData kCameraData[] = {{"frame", "frame"}, {"time", "time"}};
constexpr ViewData kRadioData[] = {{"address", "address"}, {"rssi", "rssi"},         {"lqi", "lqi"},      {"pending", "pending"},
                                   {"sent", "sent"},       {"received", "received"}, {"energy", "energy"}};
constexpr ViewData kImuData[] = {
    {"angularVelocity", "angularVelocity"}, {"acceleration", "acceleration"}, {"orientation", "orientation"}, {"time", "time"}};
constexpr ViewData kGpsData[] = {{"pos", "position"}, {"vel", "velocity"}, {"time", "time"}};

constexpr DeviceView kViews[] = {
    {"DifferentialDrive", "position2d", kDriveData, kDriveCommands},
    {"SkidDrive", "position2d", kDriveData, kDriveCommands},
    {"OmniDrive", "position2d", kDriveData, kOmniCommands},
    {"MecanumDrive", "position2d", kDriveData, kOmniCommands},
    {"AckermannDrive", "position2d", kDriveData, kCarCommands},
    {"Servo", "position1d", kServoData, kServoCommands},
    {"LinearMotor", "position1d", kServoData, kServoCommands},
    {"RotaryMotor", "position1d", kMotorData, kMotorCommands},
    {"Encoder", "position1d", kEncoderData, {}},
    {"RangeSensor", "ranger", kRangeData, {}},
    {"Lidar", "ranger", kLidarData, {}},
    {"TouchSensor", "bumper", kTouchData, {}},
    {"Camera", "camera", kCameraData, {}},
    {"Transceiver", "wsn", kRadioData, {}},
    {"Imu", "imu", kImuData, {}},
    {"Gps", "gps", kGpsData, {}},
};

} // namespace

const DeviceView* viewOf(std::string_view kind) {
    const auto* found = std::ranges::find(kViews, kind, &DeviceView::kind);
    return found == std::end(kViews) ? nullptr : found;
}

std::string interfaceOf(std::string_view kind) {
    const DeviceView* view = viewOf(kind);
    return view ? std::string(view->interface) : "opaque";
}

const ComponentSpec* deviceAt(const ExperimentSpec& experiment, std::string_view path) {
    const std::size_t slash = path.find('/');
    if (slash == std::string_view::npos) return nullptr;
    const auto robot = std::ranges::find(experiment.robots, path.substr(0, slash), &RobotSpec::name);
    if (robot == experiment.robots.end()) return nullptr;
    const std::vector<ComponentSpec>& devices = robot->config->devices;
    const auto device = std::ranges::find(devices, path.substr(slash + 1), &ComponentSpec::name);
    return device == devices.end() ? nullptr : &*device;
}

} // namespace trundle
