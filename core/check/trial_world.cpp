#include "check/trial_world.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "check/extent.h"
#include "devices/builtin.h"

namespace trundle {

namespace {

constexpr double kClearance = 1e-4;          // m, above the floor
constexpr std::uint64_t kMostWork = 300'000; // bodies times ticks: about half a second
constexpr std::array<std::string_view, 10> kTried{"RotaryMotor", "Servo",     "LinearMotor",  "DifferentialDrive",
                                                  "SkidDrive",   "OmniDrive", "MecanumDrive", "AckermannDrive",
                                                  "Track",       "TrackDrive"};

Quat uprightOf(const Quat& rotation, const Vec3& up) {
    const Vec3 up_R = rotation.conjugate() * up;
    int most = 0;
    up_R.cwiseAbs().maxCoeff(&most);
    return Quat::FromTwoVectors(std::copysign(1.0, up_R[most]) * Vec3::Unit(most), Vec3::UnitZ());
}

double lowestOf(const RobotConfigSpec& config, const Quat& rotation) {
    double low = HUGE_VAL;
    for (const BodySpec& body : config.bodies)
        for (const GeomSpec& geom : body.geoms)
            if (geom.collide)
                low = std::min(low, extentAlong(geom, Pose{{0, 0, 0}, rotation} * body.pose * geom.pose, Vec3::UnitZ()).low);
    return low;
}

} // namespace

std::unique_ptr<TrialWorld> TrialWorld::build(const ExperimentSpec& experiment, const RobotSpec& robot) {
    const auto isUnknown = [](const ComponentSpec& device) { return !findBuiltInDevice(device.kind); };
    if (std::ranges::any_of(robot.config->devices, isUnknown)) return nullptr;
    const Vec3 gravity = experiment.settings.gravity;
    const Quat rotation = uprightOf(robot.pose.rotation, -gravity.normalized());
    const double low = lowestOf(*robot.config, rotation);
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
    return world ? std::unique_ptr<TrialWorld>(new TrialWorld(std::move(world))) : nullptr;
}

bool TrialWorld::run(double seconds, const std::stop_token& stop) {
    const auto ticks = static_cast<std::uint64_t>(std::ceil(seconds / m_world->experiment().settings.tick - 1e-9));
    m_work += ticks * m_world->experiment().robots[0].config->bodies.size();
    if (m_work > kMostWork) return false;
    for (std::uint64_t i = 0; i < ticks; ++i)
        if (stop.stop_requested() || !m_world->tick() || fault()) return false;
    return true;
}

void TrialWorld::command(const std::string& device, const char* signal, double value) {
    const SignalEntry* entry = m_world->layout().find("robot/" + device + "/" + signal);
    if (entry && entry->direction == SignalDirection::Command) m_world->block().slots()[entry->offset] = value;
}

double TrialWorld::value(const std::string& path, std::size_t index) const {
    const SignalEntry* entry = m_world->layout().find("robot/" + path);
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

const Fault* TrialWorld::fault() const {
    if (const Fault* fault = m_world->fault()) return fault;
    const auto& ends = m_world->robotFaults().ends;
    return ends.empty() ? nullptr : &ends.front().fault;
}

} // namespace trundle
