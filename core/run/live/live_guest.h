#pragma once
// Something that takes part in a LiveRun, such as a server of other programs. Its calls come from the run's thread, never during a tick.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "run/live/live_state.h"

namespace trundle {

/// What a run does now, or is to do.
struct LiveRate {
    bool running = false;
    double speed = 1; ///< simulated s per s; 0: as fast as possible
};

class LiveGuest {
public:
    virtual ~LiveGuest() = default;
    /// The run is built, and outlives the guest.
    virtual void begin(Runner& runner) = 0;
    /// Called before each tick, and every few milliseconds where none is due. Returns another pace that it asks for.
    [[nodiscard]] virtual std::optional<LiveRate> serve(const LiveRate& now) = 0;
    /// Ticks that it asks of a paused run.
    [[nodiscard]] virtual std::uint64_t wantedTicks() const = 0;
    virtual void beforeTick() = 0;
    virtual void afterTick(bool good) = 0;
    virtual void addLine(const LiveLine& line) = 0;
    /// No tick follows.
    virtual void end() = 0;
};

/// Called on the run's thread.
using GuestMaker = std::function<std::unique_ptr<LiveGuest>()>;

} // namespace trundle
