#include "world/phase_calls.h"

#include <algorithm>

#include "base/platform/work_team.h"
#include "world/device_texts.h"

namespace trundle {

namespace {

constexpr std::size_t kAhead = 3;           // calls: by that the memory of a device is asked for before it is called
constexpr std::size_t kRobotsOfThread = 16; // fewer are called before another thread has begun

/// The devices of a large world do not fit the caches.
void prefetch(const void* instance) {
    constexpr std::size_t kLine = 64, kBytes = 640;
    for (std::size_t at = 0; at < kBytes; at += kLine) __builtin_prefetch(static_cast<const char*>(instance) + at);
}

const char* nameOf(DevicePhase::Calls calls) { return calls == DevicePhase::Calls::Act ? "act" : "sense"; }

} // namespace

void PhaseCalls::arrange() {
    std::ranges::stable_sort(m_apart, {}, [](const DeviceCall& call) { return call.context->robot; });
    m_robots.clear();
    for (std::uint32_t i = 0; i < m_apart.size(); ++i)
        if (i == 0 || m_apart[i].context->robot != m_apart[i - 1].context->robot) m_robots.push_back(i);
    m_robots.push_back(static_cast<std::uint32_t>(m_apart.size()));
}

void PhaseCalls::remove(std::uint32_t robot) {
    const auto isOfRobot = [robot](const DeviceCall& call) { return call.context->robot == robot; };
    std::erase_if(m_apart, isOfRobot);
    std::erase_if(m_others, isOfRobot);
    arrange();
}

const WorldDevice* PhaseCalls::run(const Round& round) const {
    DevicePhase& phase = round.phase;
    phase.isApart = true;
    phase.keepsTexts = round.team && round.team->size() > 1;
    const auto part = [&](unsigned thread, std::size_t begin, std::size_t end) {
        (void)call(round, thread, m_apart.data() + m_robots[begin], m_apart.data() + m_robots[end], false);
    };
    const std::size_t robots = m_robots.empty() ? 0 : m_robots.size() - 1;
    if (round.team) round.team->split(robots, kRobotsOfThread, part);
    else if (robots > 0) part(0, 0, robots);
    phase.isApart = phase.keepsTexts = false;
    if (phase.printed.exchange(false, std::memory_order_relaxed)) std::ranges::for_each(m_apart, passTexts);
    if (phase.noted.load(std::memory_order_relaxed))
        for (const DeviceCall& each : m_apart)
            if (!each.context->device->failure.empty()) return each.context->device;
    return call(round, 0, m_others.data(), m_others.data() + m_others.size(), true);
}

const WorldDevice* PhaseCalls::call(const Round& round, unsigned thread, const DeviceCall* begin, const DeviceCall* end,
                                    bool stop) {
    TrundleServices& services = round.services[thread].table;
    MonitoredCalls monitored(round.calls, nameOf(round.phase.calls), thread);
    for (const DeviceCall* each = begin; each != end; ++each) {
        if (end - each > static_cast<std::ptrdiff_t>(kAhead)) prefetch(each[kAhead].instance);
        services.context = each->context;
        monitored.next(each->target);
        const std::int32_t answer = each->run(each->instance, &services);
        monitored.restoreFloatingPoint();
        if (answer == 0 && !round.phase.noted.load(std::memory_order_relaxed)) continue;
        WorldDevice& device = *each->context->device;
        if (answer != 0 && device.failure.empty()) device.note(device.lastError());
        if (stop && !device.failure.empty()) return &device;
    }
    return nullptr;
}

/// In the order of the calls, whichever thread they were on.
void PhaseCalls::passTexts(const DeviceCall& call) {
    WorldDevice& device = *call.context->device;
    for (const auto& [severity, text] : device.texts) call.context->host->texts.print(device.path, severity, text.c_str());
    device.texts.clear();
}

} // namespace trundle
