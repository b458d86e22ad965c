#include "world/ode/contacts/contact_memory.h"

#include <algorithm>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kSameSide = 0.7; // cosine of two normals of one side

} // namespace

void ContactMemory::keep(const OdeContact& c, const Vec3& force, const Vec3& moved, double work) {
    const Vec3 normal = vec(c.normal);
    const double load = std::max(0.0, normal.dot(force));
    m_kept.push_back({c.first, c.second, c.actor, c.ticks + 1, vec(c.position) + moved, normal,
                      force - normal.dot(force) * normal, load, c.load, c.stored - work, false});
}

void ContactMemory::forget(std::uint32_t actor) {
    std::erase_if(m_kept, [actor](const Kept& k) { return k.actor == actor; });
}

void ContactMemory::recall(std::vector<OdeContact>& contacts) {
    Kept* const end = m_kept.data() + m_kept.size();
    Kept* of = m_kept.data(); // where the actor's begin
    OdeContact* const last = contacts.data() + contacts.size();
    for (OdeContact* c = contacts.data(); c != last;) {
        while (of != end && of->actor < c->actor) ++of;
        OdeContact* next = c + 1;
        while (next != last && next->first == c->first && next->second == c->second) ++next;
        Kept* from = of;
        while (from != end && from->actor == c->actor && (from->first != c->first || from->second != c->second)) ++from;
        Kept* to = from;
        while (to != end && to->first == c->first && to->second == c->second) ++to;
        if (from != to) recallPair(c, next, from, to);
        c = next;
    }
}

void ContactMemory::recallPair(OdeContact* begin, OdeContact* end, Kept* from, Kept* to) const {
    const auto take = [](OdeContact& c, Kept& k) {
        c.ticks = k.ticks;
        c.load = k.load;
        c.earlier = k.earlier;
        c.stored = k.stored;
        Vec3::Map(c.grip) = k.grip;
        k.taken = true;
    };
    for (;;) { // the nearest two first, whatever their order
        OdeContact* next = nullptr;
        Kept* best = nullptr;
        double nearest = 0;
        for (OdeContact* c = begin; c != end; ++c) {
            if (c->ticks > 0) continue;
            for (Kept* k = from; k != to; ++k) {
                if (k->taken || k->normal.dot(vec(c->normal)) < kSameSide) continue;
                const double far = (k->position - vec(c->position)).squaredNorm();
                if (best && far >= nearest) continue;
                next = c;
                best = k;
                nearest = far;
            }
        }
        if (!best) break;
        take(*next, *best);
    }
    for (Kept* k = from; k != to; ++k) { // left over: to those that are new, else to all of its side
        if (k->taken || !(k->load > 0)) continue;
        const auto share = [&](bool fresh) {
            const auto heir = [&](const OdeContact& c) {
                return (!fresh || c.heir || c.ticks == 0) && k->normal.dot(vec(c.normal)) >= kSameSide;
            };
            const auto heirs = std::count_if(begin, end, heir);
            for (OdeContact* c = begin; c != end && heirs > 0; ++c) {
                if (!heir(*c)) continue;
                if (c->ticks == 0) c->heir = true;
                c->ticks = std::max(c->ticks, k->ticks);
                c->load += k->load / static_cast<double>(heirs);
                c->earlier += k->earlier / static_cast<double>(heirs);
                c->stored += k->stored / static_cast<double>(heirs);
                for (int i = 0; i < 3; ++i) c->grip[i] += k->grip[i] / static_cast<double>(heirs);
            }
            return heirs > 0;
        };
        if (!share(true)) (void)share(false);
    }
}

} // namespace trundle
