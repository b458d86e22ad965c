#pragma once
// The place of a guest in the thread of a LiveRun.

#include <memory>

#include "run/live/live_run_shared.h"

namespace trundle {

class GuestSeat {
public:
    [[nodiscard]] bool isTaken() const { return m_guest != nullptr; }
    [[nodiscard]] LiveGuest* operator->() const { return m_guest.get(); }
    /// Between ticks: seats another guest if one is asked for, and takes over the pace that it asks for, as if the window had.
    void serve(LiveRunShared& shared, Runner& runner);
    void leave();

private:
    std::unique_ptr<LiveGuest> m_guest; ///< null: none
};

} // namespace trundle
