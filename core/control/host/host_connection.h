#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/platform/helper_process.h"
#include "base/platform/shared_segment.h"
#include "base/result.h"
#include "control/host/message_link.h"
#include "control/host/wire.h"

namespace trundle {

/// A call of module code in a host process, as the host reports it.
struct HostCall {
    HostPhase phase = HostPhase::None;
    std::uint32_t controller = 0;
};

/// How a host process ended.
struct HostEnd {
    enum class Cause { Crash, Exit, Killed, NotResponding, Damaged };
    Cause cause = Cause::Crash;
    int code = 0; ///< the signal, or of an exit the code; -1: unknown
    HostCall during;
    bool ofThread = false, ofSensorImage = false;
    double limitS = 0;         ///< NotResponding: how long it was waited for
    bool afterRequest = false; ///< since then: the run was asked to end
    std::string exception;
    std::vector<std::pair<std::uint32_t, std::uint64_t>> frames; ///< index of the library, offset in it
    std::string report; ///< by the fault handler of Python
};

/// What runs controllers.
struct HostPrograms {
    std::string host;   ///< path of trundle-host
    std::string python; ///< folder of the Python package, for controllers in Python
};

/// A host process of one run and the memory shared with it. Used by the run's thread.
class HostConnection final : private MessageLink {
public:
    /// Handles a record of the host; the result is the reply to a record that needs one.
    using Records = std::function<std::string(HostRecord record, std::uint32_t controller, WireReader& bytes)>;
    /// The longest time for one call of a controller, s; 0: none.
    using Limits = std::function<double(const HostCall& call)>;
    /// Called now and then while a call takes long.
    using Waiting = std::function<void(const HostCall& call, double seconds)>;
    /// Whether the run has been asked to end: a call is then waited for a second only.
    using EndAsked = std::function<bool()>;
    struct Watch {
        Limits limits;
        Waiting waiting;
        EndAsked endAsked;
    };

    /// A host for a module. `generation` numbers the hosts of a run, each of which has segments of its own.
    [[nodiscard]] static Result<std::unique_ptr<HostConnection>> start(const HostPrograms& programs, const std::string& library,
                                                                       std::uint64_t generation, Watch watch);

    /// Gives the images their size. Call once.
    [[nodiscard]] Status map(std::size_t slots, const Records& records);
    [[nodiscard]] std::span<double> sensors() { return slotsOf(m_sensors); }   ///< read-only in the host
    [[nodiscard]] std::span<double> commands() { return slotsOf(m_commands); } ///< writable in both

    /// Hands a request to the host and returns at once. False: the host has ended.
    bool begin(HostRequest request, std::string_view bytes);
    /// Handles the records of the request that was begun, until it is done. False: the host has ended, see end().
    bool complete(const Records& records);
    bool call(HostRequest request, std::string_view bytes, const Records& records) {
        return begin(request, bytes) && complete(records);
    }
    [[nodiscard]] bool alive() const { return !m_end; }
    [[nodiscard]] const HostEnd& end() const { return *m_end; }
    [[nodiscard]] int processId() const { return m_process.id(); }

private:
    using Clock = std::chrono::steady_clock;

    HostConnection(SharedSegment control, ControlPage& page, Watch watch);
    [[nodiscard]] bool awaitTurn() override;
    [[nodiscard]] bool isOverdue();
    [[nodiscard]] bool handle(std::string& stream, const Records& records, bool& done);
    [[nodiscard]] HostCall current() const;
    void close(HostEnd::Cause cause, double limitS = 0);
    void requestReport();
    void takeStack();
    static std::span<double> slotsOf(SharedSegment& segment) {
        return {static_cast<double*>(segment.data()), segment.bytes() / sizeof(double)};
    }

    SharedSegment m_control, m_sensors, m_commands;
    HelperProcess m_process;
    Watch m_watch;
    bool m_isPython = false;
    HostCall m_watched;                       ///< what the host did when it was last looked at
    bool m_ends = false;                      ///< it was asked to end then
    Clock::time_point m_since = Clock::now(); ///< of that call, with all that it has asked for
    std::optional<HostEnd> m_end;
};

} // namespace trundle
