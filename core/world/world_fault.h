#pragma once
// Faults: what ends a world, or single robots while all others continue.

#include <span>
#include <string>
#include <vector>

#include "world/world.h"
#include "world/world_objects.h"

namespace trundle {

/// Advice for the most likely cause of a fault: deep penetration, much lighter than its neighbours, or forces too strong for the tick.
[[nodiscard]] std::string faultAdvice(BodyHandle body, const WorldObjects& objects, const Engine& engine, double tick);

/// A fault of the engine at `time` (s), for users. `tick` in s.
[[nodiscard]] Fault faultFrom(const EngineFault& fault, const WorldObjects& objects, const Engine& engine, double tick,
                              double time);

class RobotFaults {
public:
    /// After a step of the engine: the robots that ended in it. Valid until the next call.
    [[nodiscard]] std::span<const RobotEnd> update(const WorldObjects& objects, const Engine& engine, double tick, double time);
    /// No robot is left, or in a world of passive objects no object.
    [[nodiscard]] bool isOver(const WorldObjects& objects) const;

    [[nodiscard]] const RobotFaultReport& report() const { return m_report; }

private:
    RobotFaultReport m_report;
};

} // namespace trundle
