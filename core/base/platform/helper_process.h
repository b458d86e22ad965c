#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// How a process ended.
struct ProcessExit {
    bool bySignal = false;
    int code = 0; ///< exit code, or the signal
};

/// A child process that works for this one until it is killed, with inherited descriptors. It has its own process group, so Ctrl+C
/// does not reach it, and should end itself when its parent does (endWithParent()). Used by one thread.
class HelperProcess {
public:
    /// `program`: a path. Its arguments are the id of this process and `more`; the child gets `descriptors` as its descriptors 3,
    /// 4 ...
    [[nodiscard]] static Result<HelperProcess> start(const std::string& program, const std::vector<int>& descriptors,
                                                     const std::vector<std::string>& more = {});
    HelperProcess() = default;
    HelperProcess(HelperProcess&& other) noexcept { *this = std::move(other); }
    HelperProcess& operator=(HelperProcess&& other) noexcept;
    ~HelperProcess() { kill(); }

    [[nodiscard]] int id() const { return m_process; } ///< 0: it has ended
    /// Whether it has ended, without waiting.
    [[nodiscard]] bool hasEnded();
    [[nodiscard]] ProcessExit exit() const { return m_exit; } ///< valid once it has ended
    /// Sends a signal to its main thread.
    void signalMainThread(int signal);
    /// Kills it with its process group, and waits.
    void kill();
    /// Sends it a signal.
    void send(int signal) const;
    /// Whether a debugger or another program traces it.
    [[nodiscard]] bool isTraced() const;
    /// Whether a signal reaches its main thread, which neither blocks nor ignores it.
    [[nodiscard]] bool receives(int signal) const;

private:
    void record(int status);
    int m_process = 0;
    ProcessExit m_exit;
};

/// In a child: it is killed when the thread that started it ends. False: that has ended already.
[[nodiscard]] bool endWithParent(int parent);

} // namespace trundle
