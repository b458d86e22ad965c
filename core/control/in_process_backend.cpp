#include "control/in_process_backend.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "control/controller_instance.h"
#include "control/kept_outputs.h"

namespace trundle {
namespace {

class InProcessBackend final : public ControllerBackend {
public:
    InProcessBackend(const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings, const TrundleKind& code,
                     std::string library)
        : m_controller(robot, controller, settings, code), m_library(std::move(library)) {}

    Status start(const SignalLayout& layout, SignalBlock& block, ControllerOutputs outputs) override {
        m_done.reset();
        m_seconds.reset();
        return m_controller.start(layout, {block.slots().data(), block.slots().data()}, m_outputs.inPlaceOf(std::move(outputs)));
    }
    Status tick(std::uint64_t tick, double time, double sinceLast) override {
        if (!m_done) return m_controller.tick(tick, time, sinceLast);
        m_outputs.pass();
        return *std::exchange(m_done, std::nullopt);
    }
    bool isIndependent() const override { return m_controller.isIndependent(); }
    void tickApart(std::uint64_t tick, double time, double sinceLast) override {
        const auto begin = std::chrono::steady_clock::now();
        m_outputs.keep();
        m_done = m_controller.tick(tick, time, sinceLast);
        m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    std::optional<double> updateS() const override { return m_seconds; }
    Status set(const std::string& property, const PropertyValue& value) override { return m_controller.set(property, value); }
    void stop() override { m_controller.stop(); }
    std::string describe() const override {
        const std::string file = std::filesystem::path(m_library).filename().string();
        return std::string(m_controller.kind()) + (file.empty() ? "" : " from " + file) + ", in process";
    }

private:
    KeptOutputs m_outputs; ///< outlives the controller
    ControllerInstance m_controller;
    std::string m_library;
    std::optional<Status> m_done;    ///< of a tickApart() whose tick() is to come
    std::optional<double> m_seconds; ///< that it took
};

} // namespace

std::unique_ptr<ControllerBackend> makeInProcessBackend(const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings,
                                                        const TrundleKind& code, std::string library) {
    return std::make_unique<InProcessBackend>(robot, controller, settings, code, std::move(library));
}

Result<std::unique_ptr<ControllerBackend>> makeInProcessBackend(const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings,
                                                                const ModuleStore& store) {
    if (controller >= robot.controllers.size()) return Error{Code::Internal, robot.name + " has no such controller"};
    const std::string& kind = robot.controllers[controller].kind;
    const LoadedModule* module = store.owner(kind, TRUNDLE_CONTROLLER);
    if (!module) return Error{Code::KindNotLoaded, "the controller " + kind + " of " + robot.name + " is in no loaded module"};
    return makeInProcessBackend(robot, controller, settings, *store.find(kind, TRUNDLE_CONTROLLER), module->library);
}

} // namespace trundle
