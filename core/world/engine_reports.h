#pragma once
// What an engine reports after its steps.

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include <trundle/geometry.h>

#include "world/engine_handles.h"
#include "world/engine_solves.h"

namespace trundle {

/// Of a spring or gear after the last step.
struct CouplingState {
    double length = 0, rate = 0; ///< of a spring, m and m/s
    double effort = 0;           ///< of a spring N, positive where it pulls; of a gear what it does to its first joint: N m or N
};

/// One contact of the last step, sorted by (actor, partner, geom).
struct EngineContact {
    std::uint32_t actor = 0;
    std::uint32_t partner = kNoActor;
    std::uint32_t first = 0, second = 0; ///< geom indices; `first` belongs to `actor`
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); ///< towards `first`
    double depth = 0;
    double force = 0;             ///< N along the normal
    Vec3 friction = Vec3::Zero(); ///< N across the normal, on `first`
};

/// Why a step failed, after which the engine cannot be used any more, or why an actor ended.
struct EngineFault {
    BodyHandle body; ///< invalid if the whole world is affected
    std::string reason;
};

/// Of the whole run.
struct EngineSweeps {
    std::uint64_t bodies = 0; ///< times ticks in which one moved farther than it is thick, so that its path was searched
    /// Geoms of two actors that passed through each other within a tick; once for two actors, the first 20.
    std::span<const std::pair<std::uint32_t, std::uint32_t>> passages;
};

/// Faults of single actors.
struct ActorFaultReport {
    std::span<const EngineFault> ended;        ///< one for each that has ended, in this order: it stays there and touches nothing
    std::span<const EngineFault> closedJoints; ///< the first joint of each actor that a tick tore open and that was closed again
};

} // namespace trundle
