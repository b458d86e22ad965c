#include "run/apart_updates.h"

#include <algorithm>
#include <utility>

#include "base/platform/work_team.h"

namespace trundle {

namespace {

constexpr std::size_t kControllersOfThread = 2; // the fewest

} // namespace

void ApartUpdates::run(std::span<RunningController> controllers, World& world, CallMonitor& calls, std::uint64_t tick,
                       double time) {
    WorkTeam* team = world.threads();
    if (!team || team->size() == 1) return;
    m_due.clear();
    for (RunningController& controller : controllers)
        if (controller.due && controller.backend->isIndependent()) m_due.push_back(&controller);
    std::ranges::sort(m_due, {}, [](const RunningController* controller) { return std::pair(controller->robot, controller); });
    const auto part = [&](unsigned thread, std::size_t begin, std::size_t end) {
        MonitoredCalls monitored(calls, "update", thread);
        for (std::size_t i = firstFrom(begin), last = firstFrom(end); i < last; ++i) {
            monitored.next(m_due[i]->target);
            m_due[i]->backend->tickApart(tick, time, m_due[i]->sinceLast(time));
            monitored.restoreFloatingPoint();
        }
    };
    team->split(m_due.size(), kControllersOfThread, part);
}

std::size_t ApartUpdates::firstFrom(std::size_t i) const {
    while (i > 0 && i < m_due.size() && m_due[i]->robot == m_due[i - 1]->robot) ++i;
    return i;
}

} // namespace trundle
