#include "run/live/guest_seat.h"

#include <algorithm>
#include <utility>

namespace trundle {

void GuestSeat::serve(LiveRunShared& shared, Runner& runner) {
    std::optional<GuestMaker> other;
    LiveRate now;
    {
        const std::scoped_lock guard(shared.lock);
        other = std::exchange(shared.guest, std::nullopt);
        now = {shared.running, shared.speed};
    }
    if (other) {
        leave();
        m_guest = *other ? (*other)() : nullptr;
        if (m_guest) m_guest->begin(runner);
    }
    if (!m_guest) return;
    const std::optional<LiveRate> asked = m_guest->serve(now);
    const std::uint64_t ticks = m_guest->wantedTicks();
    const std::scoped_lock guard(shared.lock);
    if (asked) {
        shared.running = asked->running;
        shared.speed = asked->speed;
        shared.steps = 0;
    }
    if (!shared.running) shared.steps = std::max(shared.steps, ticks);
}

void GuestSeat::leave() {
    if (m_guest) m_guest->end();
    m_guest.reset();
}

} // namespace trundle
