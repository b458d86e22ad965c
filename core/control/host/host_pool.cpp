#include "control/host/host_pool.h"

#include <filesystem>

#include "control/python_kinds.h"

namespace trundle {
namespace {

class HostBackend final : public ControllerBackend {
public:
    HostBackend(HostGroup& group, std::size_t member, std::string kind)
        : m_group(group), m_member(member), m_kind(std::move(kind)) {}
    HostBackend(const HostBackend&) = delete;
    HostBackend& operator=(const HostBackend&) = delete;
    ~HostBackend() override { m_group.stop(m_member); }

    Status start(const SignalLayout& layout, SignalBlock& block, ControllerOutputs outputs) override {
        return m_group.start(m_member, layout, block, std::move(outputs));
    }
    void prepare(std::uint64_t tick, double time, double sinceLast) override {
        m_group.prepare(m_member, tick, time, sinceLast);
    }
    Status tick(std::uint64_t tick, double time, double sinceLast) override {
        return m_group.update(m_member, tick, time, sinceLast);
    }
    Status set(const std::string& property, const PropertyValue& value) override {
        return m_group.set(m_member, property, value);
    }
    Result<std::string> saveState() override { return m_group.saveState(m_member); }
    Status loadState(std::string_view state) override { return m_group.loadState(m_member, state); }
    void stop() override { m_group.stop(m_member); }
    Status renew(std::uint64_t request) override { return m_group.renew(request); }
    std::string module() const override { return m_group.library(); }
    const ControllerFault* fault() const override { return m_group.fault(m_member); }
    std::optional<double> updateS() const override { return m_group.updateS(m_member); }
    int processId() const override { return m_group.processId(); }
    std::string describe() const override {
        return m_kind + " from " + std::filesystem::path(m_group.library()).filename().string() + ", in a process of its own";
    }

private:
    HostGroup& m_group;
    std::size_t m_member;
    std::string m_kind;
};

} // namespace

HostPool::HostPool(HostPrograms programs, std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<CallMonitor> calls,
                   Isolation otherwise, const std::function<std::string(const std::string& kind)>& moduleOf) {
    m_otherwise = otherwise;
    m_hostsByDefault = isolationOf(ComponentSpec(), experiment->settings, otherwise) != Isolation::None;
    m_context.programs = std::move(programs);
    m_context.experiment = std::move(experiment);
    m_context.calls = std::move(calls);
    m_context.beginUpdates = [this] {
        for (const auto& [name, group] : m_groups) group->beginUpdates();
    };
    const std::vector<RobotSpec>& robots = m_context.experiment->robots;
    for (std::size_t i = 0; i < robots.size(); ++i)
        for (std::size_t k = 0; k < robots[i].controllers.size(); ++k) add(i, k, moduleOf(robots[i].controllers[k].kind));
}

Isolation HostPool::isolationFor(const ControllerSpec& controller, const std::string& library) const {
    const Isolation isolation = isolationOf(controller, m_context.experiment->settings, m_otherwise);
    return isolation == Isolation::None && isPythonModule(library) ? Isolation::Module : isolation;
}

void HostPool::add(std::size_t robot, std::size_t controller, const std::string& library) {
    const RobotSpec& spec = m_context.experiment->robots[robot];
    const Isolation isolation = isolationFor(spec.controllers[controller], library);
    m_inside[library] = m_inside[library] || isolation == Isolation::None;
    if (library.empty() || isolation == Isolation::None) return;
    std::unique_ptr<HostGroup>& group = m_groups[isolation == Isolation::Module ? library : library + "\n" + spec.name];
    if (!group) group = std::make_unique<HostGroup>(m_context, library);
    m_members[{spec.name, controller}] = {group.get(), group->add({m_context.experiment, &spec}, controller)};
}

bool HostPool::addLater(std::shared_ptr<const RobotSpec> robot, std::size_t controller, const std::string& library) {
    m_members.erase({robot->name, controller});
    if (isolationFor(robot->controllers[controller], library) == Isolation::None) return false;
    std::unique_ptr<HostGroup>& group = m_groups[library + "\n" + robot->name + "\n" + std::to_string(++m_later)];
    group = std::make_unique<HostGroup>(m_context, library);
    m_members[{robot->name, controller}] = {group.get(), group->add(robot, controller)};
    return true;
}

bool HostPool::hasOnly(const std::string& library) const {
    if (isPythonModule(library)) return true;
    const auto inside = m_inside.find(library);
    return inside == m_inside.end() ? m_hostsByDefault : !inside->second;
}

Result<std::vector<Kind>> HostPool::load(const std::string& library) {
    if (const auto shared = m_groups.find(library); shared != m_groups.end()) return shared->second->load();
    for (const auto& [name, group] : m_groups)
        if (group->library() == library) return group->load();
    return HostGroup(m_context, library).load();
}

std::unique_ptr<ControllerBackend> HostPool::makeBackend(const RobotSpec& robot, std::size_t controller) {
    const auto& [group, member] = m_members.at({robot.name, controller});
    return std::make_unique<HostBackend>(*group, member, robot.controllers[controller].kind);
}

} // namespace trundle
