#include "cli/progress.h"

#include <algorithm>
#include <cmath>

#include <unistd.h>

#include "cli/numbers.h"
#include "cli/standard_streams.h"

namespace trundle {
namespace {

using namespace std::chrono_literals;

constexpr auto kBarEvery = 100ms;
constexpr auto kLineEvery = 1s;
constexpr int kBarWidth = 24;

/// "8 s", "2 min 5 s", "3 h 20 min"
std::string lengthText(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::min(seconds, 1e9)));
    if (whole < 120) return std::to_string(whole) + " s";
    if (whole < 7200) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

} // namespace

Progress::Progress(std::uint64_t ticks, double tick, bool hidden)
    : m_total(ticks), m_tick(tick), m_hidden(hidden), m_terminal(isatty(messagesFile()) == 1), m_start(Clock::now()),
      m_next(m_start + (m_terminal ? std::chrono::nanoseconds(kBarEvery) : std::chrono::nanoseconds(kLineEvery))) {}

Progress::~Progress() { clearBar(); }

std::string Progress::stateText(std::uint64_t ticks, double wallS) const {
    const double simulated = static_cast<double>(ticks) * m_tick;
    const double factor = wallS > 0 ? simulated / wallS : 0;
    std::string text;
    if (m_total > 0) {
        const double part = std::min(1.0, static_cast<double>(ticks) / static_cast<double>(m_total));
        if (m_terminal) {
            const int full = static_cast<int>(part * kBarWidth);
            text = "[" + std::string(full, '#') + std::string(kBarWidth - full, '.') + "] ";
        }
        text += fixedText(std::floor(part * 100), 0) + " %  " + fixedText(simulated, 2) + " of " +
                fixedText(static_cast<double>(m_total) * m_tick, 2) + " s simulated";
    } else {
        text = fixedText(simulated, 2) + " s simulated";
    }
    if (factor > 0) text += ", " + shortText(factor) + " x real time";
    if (m_total > ticks && ticks > 0) text += ", " + lengthText(static_cast<double>(m_total - ticks) * m_tick / factor) + " left";
    return text;
}

void Progress::clearBar() {
    if (m_barShown) writeMessage("\r\033[K");
    m_barShown = false;
}

void Progress::show(std::uint64_t ticks) {
    const double wallS = std::chrono::duration<double>(Clock::now() - m_start).count();
    const std::string text = stateText(ticks, wallS);
    if (m_terminal) {
        writeMessage("\r" + text + "\033[K");
        m_barShown = true;
    } else {
        writeMessage(text + "\n");
    }
}

void Progress::update(std::uint64_t ticks) {
    if (m_hidden) return;
    const auto now = Clock::now();
    if (now < m_next) return;
    m_next = now + (m_terminal ? std::chrono::nanoseconds(kBarEvery) : std::chrono::nanoseconds(kLineEvery));
    show(ticks);
}

void Progress::finish(std::uint64_t ticks) {
    if (m_hidden || m_finished) return;
    m_finished = true;
    show(ticks);
    if (m_barShown) writeMessage("\n");
    m_barShown = false;
}

void Progress::line(const std::string& text) {
    clearBar();
    writeMessage(text);
}

} // namespace trundle
