#include "world/wheeled/unit_contacts.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kLookAhead = 0.005;  // m: what is nearer than that has a row, which lets it come as near as it likes and no nearer
constexpr double kSamePoint = 0.02;   // m
constexpr double kLeastOverlap = 1e-4; // m, of heights

Box3 boxOf(const WheeledUnit& unit) {
    const double x = unit.position.x(), y = unit.position.y(), r = unit.shape->bound + kLookAhead;
    return {{x - r, y - r, 0}, {x + r, y + r, 0}};
}

Box3 boxOf(const Footprint& f) {
    const double x = f.centre.x(), y = f.centre.y();
    return {{x - f.bound, y - f.bound, 0}, {x + f.bound, y + f.bound, 0}};
}

} // namespace

void UnitContacts::find() {
    std::swap(m_now, m_last);
    m_now.clear();
    if (m_filed != m_objects.scenery.size()) {
        std::vector<Box3> boxes;
        for (const WheeledScenery& s : m_objects.scenery) boxes.push_back(boxOf(s.footprint));
        m_sceneryGrid.build(std::move(boxes));
        m_filed = m_objects.scenery.size();
    }
    m_boxes.clear();
    for (const WheeledUnit& unit : m_objects.units) m_boxes.push_back(boxOf(unit));
    m_grid.pairs(m_boxes, m_pairs);
    for (const auto& [a, b] : m_pairs) meet(a, b);
    if (m_filed > 0)
        for (std::uint32_t i = 0; i < m_objects.units.size(); ++i) {
            if (!m_objects.units[i].isMovable()) continue;
            m_near.clear();
            m_sceneryGrid.query(m_boxes[i], m_near);
            for (const std::uint32_t s : m_near) meetScenery(i, m_objects.scenery[s]);
        }
    std::ranges::sort(m_now, {}, [](const UnitContact& c) { return c.key(); });
    takeOver();
}

void UnitContacts::forget(std::uint32_t unit) {
    std::erase_if(m_now, [unit](const UnitContact& c) { return c.a == unit || c.b == unit; });
}

bool UnitContacts::overlap(const Footprint& a, double atA, const Footprint& b, double atB, double& height) const {
    const double low = std::max(atA + a.low, atB + b.low), high = std::min(atA + a.high, atB + b.high);
    height = (low + high) / 2;
    return high - low > kLeastOverlap;
}

void UnitContacts::meet(std::uint32_t a, std::uint32_t b) {
    const WheeledUnit &ua = m_objects.units[a], &ub = m_objects.units[b];
    if (ua.ended || ub.ended || (!ua.isMovable() && !ub.isMovable())) return;
    for (std::uint32_t i = 0; i < ua.shape->footprints.size(); ++i)
        for (std::uint32_t k = 0; k < ub.shape->footprints.size(); ++k) {
            const Footprint &fa = ua.shape->footprints[i], &fb = ub.shape->footprints[k];
            UnitContact contact{a, b, ua.geoms + i, ub.geoms + k, {}, 0, 0, 0};
            if (overlap(fa, ua.position.z(), fb, ub.position.z(), contact.height)) add(contact, fa, ua.plane, fb, ub.plane);
        }
}

void UnitContacts::meetScenery(std::uint32_t a, const WheeledScenery& scenery) {
    const WheeledUnit& unit = m_objects.units[a];
    for (std::uint32_t i = 0; i < unit.shape->footprints.size(); ++i) {
        const Footprint& f = unit.shape->footprints[i];
        UnitContact contact{a, kNoActor, unit.geoms + i, scenery.geom, {}, 0, 0, 0};
        if (overlap(f, unit.position.z(), scenery.footprint, 0, contact.height)) add(contact, f, unit.plane, scenery.footprint, {});
    }
}

void UnitContacts::add(UnitContact contact, const Footprint& fa, const PlanarPose& pa, const Footprint& fb, const PlanarPose& pb) {
    contact.touch = touchOf(fa, pa, fb, pb, kLookAhead);
    if (contact.touch.count == 0) return;
    const SurfaceSpec &a = m_objects.surfaces[fa.surface], &b = m_objects.surfaces[fb.surface];
    contact.friction = std::min(a.friction, b.friction);
    contact.restitution = std::max(a.restitution, b.restitution);
    for (int i = 0; i < contact.touch.count; ++i)
        contact.local[static_cast<std::size_t>(i)] = pa.turnBack(contact.touch.points[i] - pa.at);
    m_now.push_back(contact);
}

/// From the nearest point of the last tick, each used once.
void UnitContacts::takeOver() {
    auto old = m_last.begin();
    for (UnitContact& c : m_now) {
        while (old != m_last.end() && old->key() < c.key()) ++old;
        if (old == m_last.end() || old->key() != c.key()) continue;
        bool used[2] = {false, false};
        for (std::size_t p = 0; p < static_cast<std::size_t>(c.touch.count); ++p) {
            std::size_t best = 2;
            double least = kSamePoint * kSamePoint;
            for (std::size_t k = 0; k < static_cast<std::size_t>(old->touch.count); ++k)
                if (const double square = (old->local[k] - c.local[p]).squaredNorm(); !used[k] && square < least) {
                    best = k;
                    least = square;
                }
            if (best == 2) continue;
            used[best] = true;
            c.normal[p] = old->normal[best];
            c.tangent[p] = old->tangent[best];
        }
    }
}

} // namespace trundle
