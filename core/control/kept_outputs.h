#pragma once
// What a controller puts out while it is called at the same time as those of other robots: kept, and passed on later in the order of the
// calls.

#include <functional>
#include <vector>

#include "control/backend.h"

namespace trundle {

class KeptOutputs {
public:
    KeptOutputs() = default;
    KeptOutputs(const KeptOutputs&) = delete;
    KeptOutputs& operator=(const KeptOutputs&) = delete;

    /// Those that the controller gets in place of `own`, which lead here; this outlives them.
    [[nodiscard]] ControllerOutputs inPlaceOf(ControllerOutputs own);
    /// From now on they are kept.
    void keep() { m_keeps = true; }
    /// Passes on what was kept; from now on all at once.
    void pass();

private:
    template <class... Arguments> [[nodiscard]] std::function<void(Arguments...)> kept(std::function<void(Arguments...)> own);

    std::vector<std::function<void()>> m_kept;
    bool m_keeps = false;
};

} // namespace trundle
