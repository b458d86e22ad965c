#include "check/trial_world.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "check/drive_wheels.h"
#include "check/extent.h"
#include "devices/builtin.h"

namespace trundle {

namespace {

constexpr double kBaseShare = 0.2;  // of the mass
constexpr double kClearance = 1e-4; // m, above the floor
constexpr std::size_t kMostBodies = 150;
constexpr std::array<std::string_view, 10> kTried{"RotaryMotor", "Servo",     "LinearMotor",  "DifferentialDrive",
                                                  "SkidDrive",   "OmniDrive", "MecanumDrive", "AckermannDrive",
                                                  "Track",       "TrackDrive"};

Quat uprightOf(const Quat& rotation, const Vec3& up) {
    const Vec3 up_R = rotation.conjugate() * up;
    int most = 0;
    up_R.cwiseAbs().maxCoeff(&most);
    return Quat::FromTwoVectors(std::copysign(1.0, up_R[most]) * Vec3::Unit(most), Vec3::UnitZ());
}

/// The body above the first wheel of a drive that has a fair share of the mass; without a drive, the heaviest.
std::size_t baseOf(const RobotConfigSpec& config) {
    double whole = 0;
    for (const BodySpec& body : config.bodies) whole += body.mass.mass;
    const auto carrierOf = [&](int body) {
        const auto joint =
            std::ranges::find_if(config.joints, [&](const JointSpec& j) { return j.child == body && j.parent != kWorldBody; });
        return joint == config.joints.end() ? body : joint->parent;
    };
    for (const ComponentSpec& device : config.devices)
        for (const DriveMotor& motor : motorsOf(device)) {
            const auto turning = std::ranges::find(config.devices, motor.name, &ComponentSpec::name);
            if (turning == config.devices.end()) continue;
            const auto axle = std::ranges::find(config.joints, turning->text("Joint"), &JointSpec::name);
            if (axle == config.joints.end() || axle->parent == kWorldBody) continue;
            int base = axle->child == 0 ? 0 : axle->parent; // the chassis may be the child of its wheels
            for (std::size_t i = 0;
                 i < config.bodies.size() && config.bodies[static_cast<std::size_t>(base)].mass.mass < kBaseShare * whole; ++i)
                base = carrierOf(base);
            return static_cast<std::size_t>(base);
        }
    const auto heaviest = std::ranges::max_element(config.bodies, {}, [](const BodySpec& body) { return body.mass.mass; });
    return static_cast<std::size_t>(heaviest - config.bodies.begin());
}

} // namespace

const BodySpec& TrialWorld::base() const { return m_world->experiment().robots[0].config->bodies[m_base]; }

std::unique_ptr<TrialWorld> TrialWorld::build(const ExperimentSpec& experiment, const RobotSpec& robot, TrialTime end) {
    const auto isUnknown = [](const ComponentSpec& device) { return !findBuiltInDevice(device.kind); };
    if (robot.config->bodies.size() > kMostBodies || std::ranges::any_of(robot.config->devices, isUnknown)) return nullptr;
    const Vec3 gravity = experiment.settings.gravity;
    const Quat rotation = uprightOf(robot.pose.rotation, -gravity.normalized());
    const double low = extentAlong(*robot.config, {{0, 0, 0}, rotation}, Vec3::UnitZ()).low;
    if (!std::isfinite(low)) return nullptr;

    auto config = std::make_shared<RobotConfigSpec>(*robot.config);
    std::erase_if(config->devices,
                  [](const ComponentSpec& device) { return std::ranges::find(kTried, device.kind) == kTried.end(); });
    auto alone = std::make_shared<ExperimentSpec>();
    alone->settings = experiment.settings;
    alone->settings.gravity = {0, 0, -gravity.norm()};
    alone->settings.engine = EngineChoice::General;
    alone->settings.threads = 1;
    alone->materials = experiment.materials;
    alone->surfaces = experiment.surfaces;
    GeomSpec plane;
    plane.name = "plane";
    plane.shape = GeomShape::Plane;
    alone->statics = {{"floor", "Floor", {}, std::make_shared<std::vector<GeomSpec>>(1, plane), {}, {}}};
    alone->robots = {{"robot", {{0, 0, kClearance - low}, rotation}, std::move(config), {}, {}, {}, nullptr}};
    Diagnostics unused;
    const auto code = [](const std::string& kind) { return findBuiltInDevice(kind); };
    auto world = World::build(std::move(alone), code, unused);
    return world ? std::unique_ptr<TrialWorld>(new TrialWorld(std::move(world), baseOf(*robot.config), end)) : nullptr;
}

bool TrialWorld::run(double seconds, const std::stop_token& stop) {
    const auto ticks = static_cast<std::uint64_t>(std::ceil(seconds / m_world->experiment().settings.tick - 1e-9));
    for (std::uint64_t i = 0; i < ticks; ++i)
        if (stop.stop_requested() || std::chrono::steady_clock::now() > m_end || !m_world->tick() || fault()) return false;
    return true;
}

void TrialWorld::command(const std::string& device, const char* signal, double value) {
    const auto entry = m_world->layout().find("robot/" + device + "/" + signal);
    if (entry && entry->direction == SignalDirection::Command) m_world->block().slots()[entry->offset] = value;
}

double TrialWorld::value(const std::string& path, std::size_t index) const {
    const auto entry = m_world->layout().find("robot/" + path);
    return entry && index < entry->count ? m_world->block().slots()[entry->offset + index] : 0;
}

Pose TrialWorld::bodyPose(const BodySpec& body) const {
    const auto at = [&](std::size_t index) { return value(body.name + "/pose", index); };
    return {{at(0), at(1), at(2)}, {at(3), at(4), at(5), at(6)}};
}

Vec3 TrialWorld::velocity(const BodySpec& body) const {
    const std::string path = body.name + "/velocity";
    return {value(path, 0), value(path, 1), value(path, 2)};
}

double TrialWorld::loadOf(const BodySpec& body) const {
    const std::string own = "robot/" + body.name + "/";
    double load = 0;
    for (const WorldContact& contact : m_world->contacts())
        if (contact.first.starts_with(own) || contact.second.starts_with(own))
            load += contact.force * std::abs(contact.normal.z());
    return load;
}

const Fault* TrialWorld::fault() const {
    if (const Fault* fault = m_world->fault()) return fault;
    const auto& ends = m_world->robotFaults().ends;
    return ends.empty() ? nullptr : &ends.front().fault;
}

} // namespace trundle
