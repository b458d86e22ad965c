#include "remote/run_guest.h"

#include "base/clean_text.h"

namespace trundle {

void RunGuest::begin(Runner& runner) {
    m_run.emplace(runner);
    m_server.emplace(*m_run, std::move(m_options));
    m_server->listen(std::move(m_listener));
}

std::optional<LiveRate> RunGuest::serve(const LiveRate& now) {
    m_run->follow(now.running, now.speed);
    m_server->serve(std::chrono::milliseconds(0));
    m_clients->store(m_server->clientCount());
    const bool running = m_run->state() == ServedState::Running;
    if (running == now.running && (!running || m_run->speed() == now.speed)) return std::nullopt;
    return LiveRate{running, m_run->speed()};
}

void RunGuest::addLine(const LiveLine& line) {
    if (m_server) m_server->addLine(line.time, line.who, line.severity, cleanText(line.text));
}

void RunGuest::end() {
    if (m_server) m_server->close();
    if (m_run)
        for (const RobotSpec& robot : m_run->world().experiment().robots)
            if (m_run->isHeld(robot.name)) m_run->runner().command(HoldCommand{robot.name, false, Holder::Guest});
    m_clients->store(0);
}

} // namespace trundle
