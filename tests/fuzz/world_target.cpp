#include <cmath>

#include "base/rng.h"
#include "devices/builtin.h"
#include "fuzz/random_experiment.h"
#include "fuzz/targets.h"
#include "lang/diagnostic_text.h"
#include "world/world.h"

namespace trundle::fuzz {
namespace {

constexpr int kTicks = 20;

/// A command that a malicious controller might write.
double wildCommand(Choices& choices) {
    static const double values[] = {0, 1, -1, 0.3, 12, -100, 1e6, -1e9, 1e300, HUGE_VAL, NAN, 1e-300};
    return values[choices.pick(std::size(values))];
}

void writeCommands(World& world, Choices& choices) {
    for (const SignalEntry& entry : world.layout().entries()) {
        if (entry.direction != SignalDirection::Command) continue;
        for (std::uint32_t i = 0; i < entry.count; ++i)
            if (choices.chance(4)) world.block().slots()[entry.offset + i] = wildCommand(choices);
    }
}

/// Published values must be finite; commands are not checked, because controllers write them.
void checkSignals(const World& world) {
    for (const SignalEntry& entry : world.layout().entries()) {
        if (entry.direction == SignalDirection::Command) continue;
        for (std::uint32_t i = 0; i < entry.count; ++i) require(std::isfinite(world.block().slots()[entry.offset + i]));
    }
}

void pushBody(World& world, Choices& choices) {
    if (!choices.chance(1) || world.experiment().robots.empty()) return;
    const RobotSpec& robot =
        world.experiment().robots[choices.pick(static_cast<std::uint32_t>(world.experiment().robots.size()))];
    if (robot.config->bodies.empty()) return;
    const Vec3 force(wildCommand(choices), wildCommand(choices), wildCommand(choices));
    static_cast<void>(world.push(robot.name + "/" + robot.config->bodies.front().name, force, Vec3::Zero()).ok());
}

} // namespace

void tryWorld(std::span<const std::uint8_t> bytes) {
    Choices choices(bytes);
    const std::string text = randomExperiment(choices, *builtInKinds());
    const auto loaded = open({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    for (const Diagnostic& d : loaded->diagnostics.all()) require(!render(d, loaded->sources).empty());
    if (loaded->diagnostics.hasErrors()) return;
    Diagnostics problems;
    const auto world = World::build(
        loaded->experiment, [](const std::string& kind) { return findBuiltInDevice(kind); }, problems);
    require(world != nullptr || problems.hasErrors());
    for (const Diagnostic& d : problems.all()) require(!render(d, loaded->sources).empty());
    if (!world) return;
    checkSignals(*world);
    for (int i = 0; i < kTicks; ++i) {
        writeCommands(*world, choices);
        pushBody(*world, choices);
        const Status status = world->tick();
        require(status.ok() == (world->fault() == nullptr));
        if (!status.ok()) {
            require(!status.error().message.empty());
            return;
        }
        checkSignals(*world);
    }
}

} // namespace trundle::fuzz
