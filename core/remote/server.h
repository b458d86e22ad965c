#pragma once
// Serves one run to clients, over sockets, in the thread that calls serve(). The run never waits for a client: what a slow one does
// not read is left out or waits, within limits, in its own queue.

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/platform/socket.h"
#include "remote/client.h"
#include "remote/operations.h"
#include "remote/served_run.h"
#include "run/live/live_clock.h"

namespace trundle {

struct ServerOptions {
    std::string token;                         ///< clients must give it; not empty
    std::string experiment;                    ///< its name, for clients
    std::size_t mostClients = 16;
    std::chrono::milliseconds helloTime{5000}; ///< a client that has not given the token by then is closed
};

class RemoteServer {
public:
    RemoteServer(ServedRun& run, ServerOptions options) : m_run(run), m_options(std::move(options)) {}

    void listen(Socket socket) { m_listener = std::move(socket); }
    /// Adds a client that needs no token. The server ends with it.
    void adopt(Socket socket);

    /// One round: handles what clients sent, runs at most one tick, and sends. Waits at most `longest` if there is nothing to do.
    void serve(std::chrono::milliseconds longest);
    // Of a run that is paced elsewhere, around its ticks.
    void beforeTick();
    void afterTick(bool good);
    /// Ticks that clients ask of a paused run.
    [[nodiscard]] std::uint64_t wantedTicks() const;
    /// Ends all connections, after the news that the run is over.
    void close();
    /// Sends the problems of the build to the adopted client, as there is nothing to serve.
    void fail();
    /// The adopted client has gone.
    [[nodiscard]] bool isOver() const { return m_over; }

    /// Passes on what a controller or the run printed.
    void addLine(double time, const std::string& who, int severity, const std::string& text);
    [[nodiscard]] std::size_t clientCount() const { return m_connections.size(); }

private:
    using Clock = std::chrono::steady_clock;
    struct Connection {
        Socket socket;
        RemoteClient client;
        Clock::time_point since;
        bool adopted = false, gone = false;
    };

    [[nodiscard]] bool isStepping() const;
    [[nodiscard]] bool isTickDue(Clock::time_point now);
    [[nodiscard]] std::chrono::nanoseconds timeToWait(std::chrono::milliseconds longest);
    void exchange(std::chrono::nanoseconds atMost);
    void accept();
    void receive(Connection& connection);
    void send(Connection& connection);
    void answerAll();
    void answer(RemoteClient& client, const Frame& frame);
    [[nodiscard]] Reply hello(RemoteClient& client, Arguments& arguments);
    void tick();
    bool countStep();
    void publishTick();
    void publish(RemoteClient& client);
    void publish(RemoteClient& client, std::uint32_t number, Subscription& subscription);
    void publishLate(RemoteClient& client);
    void finishStep(RemoteClient& client);
    void finishSteps();
    void announce();
    void bindAgain();
    void removeGone();

    ServedRun& m_run;
    ServerOptions m_options;
    Socket m_listener;
    std::vector<std::unique_ptr<Connection>> m_connections;
    LivePace m_pace;
    bool m_paced = false; ///< running; m_pace is valid
    Clock::time_point m_exchanged;
    std::optional<Clock::time_point> m_full; ///< since when others wait for a seat
    ServedState m_announced = ServedState::Paused;
    std::size_t m_next = 0; ///< whose step comes first, so that all get their turn
    StepJob* m_counted = nullptr;     ///< of which the tick in progress is one
    std::uint64_t m_countedAfter = 0; ///< ticks before it
    bool m_over = false;
};

/// A random token of 32 hexadecimal digits, from the system.
[[nodiscard]] std::string randomToken();

} // namespace trundle
