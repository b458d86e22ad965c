#pragma once
// The host processes of one run: which controllers run in which, and the backends to them.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "control/host/host_group.h"
#include "control/isolation.h"
#include "control/module_store.h"

namespace trundle {

class HostPool {
public:
    /// `moduleOf` gives the path of the library with a kind of controller; empty: none.
    HostPool(HostPrograms programs, std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<CallMonitor> calls,
             Isolation otherwise, const std::function<std::string(const std::string& kind)>& moduleOf);
    ~HostPool() { m_context.say = nullptr; } // what it writes to may be destroyed now
    HostPool(const HostPool&) = delete;
    HostPool& operator=(const HostPool&) = delete;

    /// Where it is said what a run waits for.
    void setConsole(std::function<void(const std::string& text)> say) { m_context.say = std::move(say); }
    /// Whether a controller runs in a host process.
    [[nodiscard]] bool has(const RobotSpec& robot, std::size_t controller) const { return m_members.contains({robot.name, controller}); }
    /// Whether code of a module is needed in host processes alone: each controller that is from it runs in one, and if there is
    /// none, one without a setting of its own would.
    [[nodiscard]] bool hasOnly(const std::string& library) const;
    /// Loads a module in a host process and returns its kinds.
    [[nodiscard]] Result<std::vector<Kind>> load(const std::string& library);
    /// For a controller that comes during the run: gives it a process of its own, in place of another one of the robot with this index.
    /// False: by its isolation it runs inside the program.
    bool addLater(std::shared_ptr<const RobotSpec> robot, std::size_t controller, const std::string& library);
    /// The backend of a controller, by its index, for which has() holds. The pool must outlive it.
    [[nodiscard]] std::unique_ptr<ControllerBackend> makeBackend(const RobotSpec& robot, std::size_t controller);

private:
    [[nodiscard]] Isolation isolationFor(const ControllerSpec& controller, const std::string& library) const;
    void add(std::size_t robot, std::size_t controller, const std::string& library);

    Isolation m_otherwise;
    bool m_hostsByDefault;
    std::map<std::string, bool> m_inside; ///< by library: a controller of it runs inside the program
    HostContext m_context;
    std::size_t m_later = 0; ///< controllers that came during the run
    std::map<std::string, std::unique_ptr<HostGroup>> m_groups; ///< by library, or library and robot
    std::map<std::pair<std::string, std::size_t>, std::pair<HostGroup*, std::size_t>> m_members; ///< by robot and controller
};

} // namespace trundle
