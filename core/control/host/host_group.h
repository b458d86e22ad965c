#pragma once
// The controllers that share one host process.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/call_monitor.h"
#include "control/backend.h"
#include "control/host/host_connection.h"
#include "control/host/member_slots.h"
#include "schema/kind.h"

namespace trundle {

/// What the groups of a run share.
struct HostContext {
    HostPrograms programs;
    std::shared_ptr<const ExperimentSpec> experiment;
    std::shared_ptr<CallMonitor> calls;
    std::uint64_t generations = 0;         ///< hosts started so far
    std::function<void()> beginUpdates;    ///< hands all announced updates to their hosts
    std::function<void(const std::string& text)> say;
};

class HostGroup {
public:
    /// `library`: path of the module that the controllers are from. The context must outlive the group.
    HostGroup(HostContext& context, std::string library) : m_context(context), m_library(std::move(library)) {}
    ~HostGroup();
    HostGroup(const HostGroup&) = delete;
    HostGroup& operator=(const HostGroup&) = delete;

    /// Adds a controller by its index in its robot. Returns its number here. Call for all before the first start().
    std::size_t add(std::shared_ptr<const RobotSpec> robot, std::size_t controller);
    /// Starts the host if it has ended or never ran, and loads the module into it. Returns the module's kinds.
    [[nodiscard]] Result<std::vector<Kind>> load();

    // As in ControllerBackend, for the controller with this number.
    [[nodiscard]] Status start(std::size_t member, const SignalLayout& layout, SignalBlock& block, ControllerOutputs outputs);
    void prepare(std::size_t member, std::uint64_t tick, double time, double sinceLast);
    [[nodiscard]] Status update(std::size_t member, std::uint64_t tick, double time, double sinceLast);
    [[nodiscard]] Status set(std::size_t member, const std::string& property, const PropertyValue& value);
    [[nodiscard]] Result<std::string> saveState(std::size_t member);
    [[nodiscard]] Status loadState(std::size_t member, std::string_view state);
    void stop(std::size_t member);
    [[nodiscard]] Status renew(std::uint64_t request);
    [[nodiscard]] const ControllerFault* fault(std::size_t member) const;
    [[nodiscard]] double updateS(std::size_t member) const { return m_members[member].seconds; }

    [[nodiscard]] int processId() const { return m_host && m_host->alive() ? m_host->processId() : 0; }
    /// Hands the announced updates to the host.
    void beginUpdates();
    [[nodiscard]] const std::string& library() const { return m_library; }

private:
    struct UpdateResult {
        Status status;
        bool gaveUp = false;
        std::string report;                 ///< of an exception in Python: the calls that led there, see framesOfPython()
        std::vector<std::uint64_t> thrown;  ///< of one in C++, see faultOfException()
        double seconds = 0;
    };
    struct Member {
        std::shared_ptr<const RobotSpec> robot;
        const ControllerSpec* controller = nullptr;
        std::size_t index = 0; ///< of the controller in its robot
        MemberSlots slots;
        const CallTarget* target = nullptr;
        ControllerOutputs outputs;
        std::vector<std::uint32_t> radios;
        std::optional<double> due; ///< announced: time since the last call, s
        std::optional<UpdateResult> result;
        std::optional<std::string> finish, gaveUp; ///< texts of finish() and fail() in the request in progress
        std::optional<ControllerFault> fault;
        double seconds = 0; ///< of the last update
        bool started = false;
    };

    [[nodiscard]] Result<std::unique_ptr<HostConnection>> startHost();
    [[nodiscard]] Status connect();
    [[nodiscard]] Result<std::string> loadInto(HostConnection& host);
    [[nodiscard]] Status replaceHost();
    void unload(Member& last);
    void passFinish(Member& member);
    [[nodiscard]] Status map(const SignalLayout& layout);
    void copyIn(const Member& member);
    void copyOut(const Member& member);
    [[nodiscard]] Status claim(Member& member, const std::string& command);
    void completeUpdates();
    [[nodiscard]] Status call(std::size_t member, HostRequest request, std::string_view bytes);
    [[nodiscard]] Status withPlace(const Status& status, const ControllerOutputs& outputs) const;
    [[nodiscard]] std::string handle(HostRecord record, std::uint32_t number, WireReader& in);
    [[nodiscard]] Member* memberAt(std::uint32_t number);
    [[nodiscard]] std::uint32_t robotIndex(const Member& member) const;
    [[nodiscard]] double limitOf(const HostCall& call) const;
    void showWaiting(const HostCall& call, double seconds);
    /// After the end of the host: a fault of every member that it ran.
    void setFaults();

    HostContext& m_context;
    std::string m_library;
    std::vector<Member> m_members;
    std::unique_ptr<HostConnection> m_host;
    std::optional<Result<std::vector<Kind>>> m_kinds; // of the module in the current host
    std::string m_json;                               // the same, of the last host that had loaded it
    std::uint64_t m_renewal = 0;
    Status m_renewed;
    const CallTarget* m_moduleTarget = nullptr;
    const SignalLayout* m_layout = nullptr;
    SignalBlock* m_block = nullptr;
    bool m_mapped = false, m_updating = false, m_announced = false, m_saidWaiting = false;
    std::uint64_t m_generation = 0; // of the current host
    std::uint64_t m_tick = 0;
    double m_time = 0;
    std::optional<Status> m_done;            // status of the request in progress
    std::string m_more;                      // what came with it
    std::vector<std::uint64_t> m_thrown;     // where its exception came from
    std::optional<MonitoredCall> m_waiting;  // names the controller that the clock waits for
};

} // namespace trundle
