#pragma once
// Serves a run of the window to other programs, in the run's thread.

#include <atomic>
#include <memory>
#include <optional>

#include "remote/server.h"
#include "run/live/live_guest.h"

namespace trundle {

class RunGuest final : public LiveGuest {
public:
    /// `clients`: gets the number of programs that are connected.
    RunGuest(Socket listener, ServerOptions options, std::shared_ptr<std::atomic<std::size_t>> clients)
        : m_listener(std::move(listener)), m_options(std::move(options)), m_clients(std::move(clients)) {}

    void begin(Runner& runner) override;
    [[nodiscard]] std::optional<LiveRate> serve(const LiveRate& now) override;
    [[nodiscard]] std::uint64_t wantedTicks() const override { return m_server->wantedTicks(); }
    void beforeTick() override { m_server->beforeTick(); }
    void afterTick(bool good) override { m_server->afterTick(good); }
    void addLine(const LiveLine& line) override;
    void end() override;

private:
    Socket m_listener;
    ServerOptions m_options;
    std::shared_ptr<std::atomic<std::size_t>> m_clients;
    std::optional<ServedRun> m_run; // before the server, which refers to it
    std::optional<RemoteServer> m_server;
};

} // namespace trundle
