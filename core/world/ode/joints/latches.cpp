#include "world/ode/joints/latches.h"

#include <algorithm>

#include "world/ode/objects/ode_math.h"

namespace trundle {

void Latches::set(std::uint32_t number, std::uint32_t body, std::optional<std::uint32_t> held) {
    auto latch = std::ranges::find(m_objects.latches, number, &OdeLatch::number);
    if (latch == m_objects.latches.end()) {
        if (!held) return;
        latch = m_objects.latches.insert(latch, OdeLatch{});
        latch->number = number;
        latch->body = body;
    }
    latch->wants = held.has_value();
    latch->wanted = held.value_or(kNone);
}

bool Latches::update() {
    bool changed = false;
    for (OdeLatch& latch : m_objects.latches) {
        if (latch.holds && (!latch.wants || latch.wanted != latch.held)) {
            release(latch);
            changed = true;
        }
        if (latch.holds || !latch.wants || latch.wanted == latch.body) continue;
        hold(latch);
        changed = true;
    }
    if (changed) markBodies();
    return changed;
}

void Latches::hold(OdeLatch& latch) {
    latch.held = latch.wanted;
    latch.holds = true;
    if (!latch.id) {
        latch.id = dJointCreateFixed(m_world, nullptr);
        latch.feedback = std::make_unique<dJointFeedback>();
        dJointSetFeedback(latch.id, latch.feedback.get());
    }
    *latch.feedback = {};
    const bool world = latch.held == kNone;
    dJointAttach(latch.id, m_objects.bodies[latch.body].id, world ? nullptr : m_objects.bodies[latch.held].id);
    dJointSetFixed(latch.id);
    latch.isApart = !world && m_objects.separateBodies(latch.body, latch.held);
}

void Latches::release(OdeLatch& latch) {
    if (latch.isApart) m_objects.reuniteBodies(latch.body, latch.held);
    dJointAttach(latch.id, nullptr, nullptr);
    latch.holds = latch.isApart = false;
    latch.held = kNone;
}

/// A body stays marked as coupled, since springs and gears mark it too.
void Latches::markBodies() {
    for (OdeBody& body : m_objects.bodies) body.latched = false;
    for (const OdeLatch& latch : m_objects.latches)
        if (latch.holds)
            for (const std::uint32_t body : {latch.body, latch.held})
                if (body != kNone) m_objects.bodies[body].latched = m_objects.bodies[body].coupled = true;
}

bool Latches::isOf(const OdeLatch& latch, std::uint32_t actor) const {
    return m_objects.bodies[latch.body].actor == actor ||
           (latch.wanted != kNone && m_objects.bodies[latch.wanted].actor == actor);
}

void Latches::releaseActor(std::uint32_t actor) {
    for (OdeLatch& latch : m_objects.latches)
        if (latch.wants && isOf(latch, actor)) latch.wants = false;
}

const OdeLatch* Latches::find(std::uint32_t number) const {
    const auto latch = std::ranges::find(m_objects.latches, number, &OdeLatch::number);
    return latch == m_objects.latches.end() ? nullptr : &*latch;
}

bool Latches::holds(std::uint32_t number) const {
    const OdeLatch* latch = find(number);
    return latch && latch->holds;
}

/// ODE's first body is that of the latch; the held one, or the world, has the opposite. Torques are about its own centre of mass.
JointWrench Latches::wrench(std::uint32_t number) const {
    const OdeLatch* latch = find(number);
    if (!latch || !latch->holds) return {};
    const dJointFeedback& f = *latch->feedback;
    if (latch->held != kNone) return {vec(f.f2), vec(f.t2)};
    return {-vec(f.f1), -vec(f.t1)};
}

} // namespace trundle
