#pragma once
// Which controller has which commands of its robot: those that its ports have asked for.

#include <algorithm>
#include <cstddef>
#include <map>

#include "signals/block.h"
#include "signals/layout.h"

namespace trundle {

class CommandClaims {
public:
    /// The controller that has the command, which is this one if none had it.
    [[nodiscard]] std::size_t claim(std::size_t robot, const SignalEntry& command, std::size_t controller) {
        return m_claims[robot].try_emplace(command.offset, Claim{controller, command.count}).first->second.controller;
    }
    /// Its commands are free for others.
    void forget(std::size_t robot, std::size_t controller) {
        std::erase_if(m_claims[robot], [controller](const auto& claim) { return claim.second.controller == controller; });
    }
    void setToZero(std::size_t robot, std::size_t controller, SignalBlock& block) const {
        const auto claims = m_claims.find(robot);
        if (claims == m_claims.end()) return;
        for (const auto& [offset, claim] : claims->second)
            if (claim.controller == controller) std::fill_n(block.slots().begin() + offset, claim.count, 0.0);
    }

private:
    struct Claim {
        std::size_t controller;
        std::uint32_t count; ///< of the command's slots
    };
    std::map<std::size_t, std::map<std::uint32_t, Claim>> m_claims; ///< by robot and first slot
};

} // namespace trundle
