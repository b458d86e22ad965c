#include "world/built_world.h"

#include <algorithm>
#include <thread>

#include "world/validate.h"
#include "world/wheeled/wheeled.h"

namespace trundle {

namespace {

constexpr unsigned kMostByItself = 8;     // threads
constexpr std::ptrdiff_t kWorthThreads = 32; // robots with moving joints

/// What has none, like a mote that is fixed to the floor, takes less time than to hand it to another thread.
bool hasMovingJoints(const RobotSpec& robot) {
    return std::ranges::any_of(robot.config->joints, [](const JointSpec& joint) { return joint.type != JointType::Fixed; });
}

/// With the engine that fits it.
std::shared_ptr<const ExperimentSpec> withEngine(std::shared_ptr<const ExperimentSpec> experiment) {
    if (experiment->settings.engine != EngineChoice::Auto) return experiment;
    auto chosen = std::make_shared<ExperimentSpec>(*experiment);
    chosen->settings.whyGeneral = whyNotWheeled(*experiment);
    chosen->settings.engine = chosen->settings.whyGeneral.empty() ? EngineChoice::Wheeled : EngineChoice::General;
    return chosen;
}

} // namespace

unsigned threadsFor(const ExperimentSpec& experiment) {
    if (experiment.settings.threads > 0) return static_cast<unsigned>(experiment.settings.threads);
    if (std::ranges::count_if(experiment.robots, hasMovingJoints) < kWorthThreads) return 1; // few are done before other threads have begun
    return std::clamp(std::thread::hardware_concurrency(), 1u, kMostByItself);
}

std::unique_ptr<World> World::build(std::shared_ptr<const ExperimentSpec> experiment, const DeviceCode& devices,
                                    Diagnostics& diagnostics, std::shared_ptr<CallMonitor> calls) {
    if (!calls) calls = std::make_shared<CallMonitor>();
    if (!isBuildable(*experiment, diagnostics)) return nullptr;
    experiment = withEngine(std::move(experiment));
    const SettingsSpec& s = experiment->settings;
    const EngineSettings settings{
        s.gravity, s.seed, s.solver, s.iterations, s.errorReduction, experiment->surfaces, calls.get(), threadsFor(*experiment)};
    auto engine = s.engine == EngineChoice::General
                      ? makeOdeEngine(settings)
                      : makeWheeledEngine(settings, s.engine == EngineChoice::Planar, wheeledGround(*experiment));
    if (!engine) {
        diagnostics.error(engine.error().code, {}, engine.error().message);
        return nullptr;
    }
    auto world = std::make_unique<BuiltWorld>(std::move(experiment), std::move(calls), std::move(engine).value());
    if (!world->build(devices, diagnostics)) return nullptr;
    return world;
}

BuiltWorld::BuiltWorld(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<CallMonitor> calls,
                       std::unique_ptr<Engine> engine)
    : m_experiment(std::move(experiment)), m_calls(std::move(calls)), m_solver(m_calls->add({"the solver", {}, {}, {}})),
      m_engine(std::move(engine)) {}

BuiltWorld::~BuiltWorld() = default;

bool BuiltWorld::build(const DeviceCode& code, Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.errorCount();
    const auto failed = [&] { return diagnostics.errorCount() > before; };
    m_objects.build(*m_experiment, *m_engine, diagnostics);
    if (failed()) return false;
    m_calls->setBodies(m_objects.bodyPaths());
    m_devices.create(m_objects.robots(), code, diagnostics);
    if (failed()) return false;
    m_layout = m_signals.layOut(*m_experiment, m_objects, m_devices);
    m_block = std::make_unique<SignalBlock>(m_layout);
    m_host.emplace(DeviceHost{*m_experiment, *m_engine, m_objects, m_radio, m_supply, m_lamps, m_chargers, *m_block, m_texts,
                              m_devices.list()});
    m_devices.setup(*m_host, diagnostics);
    if (!failed()) m_devices.order(diagnostics);
    if (failed()) return false;
    publish();
    m_radio.place();
    const WorldDevice* device = m_devices.shine();
    if (!device) device = m_devices.sense(0); // so that sensor signals are valid at tick 0
    if (device) {
        diagnostics.error(Code::DeviceSetup, device->spec->nameRange, device->path + ": " + device->failure);
        return false;
    }
    return true;
}

} // namespace trundle
