#include "world/wheeled/unit_contacts.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kLookAhead =
    0.005;                          // m: what is nearer than that has a row, which lets it come as near as it likes and no nearer
constexpr double kSamePoint = 0.02; // m
constexpr double kLeastOverlap = 1e-4; // m, of heights
constexpr double kTall = 0.005;        // m

Box3 boxOf(const WheeledUnit& unit) {
    const double x = unit.position.x(), y = unit.position.y(), r = unit.shape->bound + kLookAhead;
    return {{x - r, y - r, 0}, {x + r, y + r, 0}};
}

Box3 boxOf(const PlanarShape& f) {
    Vec2 low = f.centre - Vec2::Constant(f.radius), high = f.centre + Vec2::Constant(f.radius);
    for (const Vec2& p : f.corners) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return {{low.x(), low.y(), 0}, {high.x(), high.y(), 0}};
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
    m_touches.assign(m_objects.units.size(), 0);
    for (const UnitContact& c : m_now) {
        m_touches[c.a] = 1;
        if (c.b != kNoActor) m_touches[c.b] = 1;
    }
}

void UnitContacts::forget(std::uint32_t unit) {
    std::erase_if(m_now, [unit](const UnitContact& c) { return c.a == unit || c.b == unit; });
}

UnitContacts::Side UnitContacts::sideOf(const WheeledUnit& unit, std::size_t footprint) const {
    const PlanarShape& shape = unit.shape->footprints[footprint];
    Side side{&shape, unit.plane, unit.position.z(), Vec2::Zero(), unit.plane.at + unit.plane.turn(shape.centre)};
    if (!unit.isVehicle()) return side;
    const Quat& q = unit.rotation;
    side.lean = {2 * (q.x() * q.z() + q.w() * q.y()), 2 * (q.y() * q.z() - q.w() * q.x())};
    return side;
}

void UnitContacts::meet(std::uint32_t a, std::uint32_t b) {
    const WheeledUnit &ua = m_objects.units[a], &ub = m_objects.units[b];
    if (ua.ended || ub.ended || (!ua.isMovable() && !ub.isMovable())) return;
    const double reach = ua.shape->bound + ub.shape->bound + kLookAhead;
    if ((ua.plane.at - ub.plane.at).squaredNorm() > reach * reach) return;
    m_sides.clear();
    for (std::uint32_t k = 0; k < ub.shape->footprints.size(); ++k) m_sides.push_back(sideOf(ub, k));
    for (std::uint32_t i = 0; i < ua.shape->footprints.size(); ++i) {
        const Side side = sideOf(ua, i);
        for (std::uint32_t k = 0; k < m_sides.size(); ++k)
            if (areNear(side, m_sides[k])) add({a, b, ua.geoms + i, ub.geoms + k}, side, m_sides[k]);
    }
}

void UnitContacts::meetScenery(std::uint32_t a, const WheeledScenery& scenery) {
    const WheeledUnit& unit = m_objects.units[a];
    const Side other{&scenery.footprint, {}, 0, Vec2::Zero(), scenery.footprint.centre};
    for (std::uint32_t i = 0; i < unit.shape->footprints.size(); ++i)
        if (const Side side = sideOf(unit, i); areNear(side, other))
            add({a, kNoActor, unit.geoms + i, scenery.geom}, side, other);
}

/// Their circles and heights: most pairs need no more.
bool UnitContacts::areNear(const Side& a, const Side& b) {
    const double reach = a.footprint->bound + b.footprint->bound + kLookAhead;
    return std::min(a.high(), b.high()) - std::max(a.low(), b.low()) >= kLeastOverlap &&
           (a.centre - b.centre).squaredNorm() <= reach * reach;
}

void UnitContacts::add(const UnitContact& pair, const Side& a, const Side& b) {
    const PlanarTouch touch = touchOf(*a.footprint, a.pose, *b.footprint, b.pose, kLookAhead);
    if (touch.count == 0) return;
    UnitContact& contact = m_now.emplace_back(pair);
    contact.normal = touch.normal;
    const SurfaceSpec &sa = m_objects.surfaces[a.footprint->surface], &sb = m_objects.surfaces[b.footprint->surface];
    contact.friction = std::min(sa.friction, sb.friction);
    contact.restitution = std::max(sa.restitution, sb.restitution);
    addPoints(contact, a, b, touch);
}

void UnitContacts::addPoints(UnitContact& contact, const Side& a, const Side& b, const PlanarTouch& touch) {
    const double low = std::max(a.low(), b.low()), high = std::min(a.high(), b.high());
    const auto addAt = [&](double height) {
        const double lean = contact.normal.dot((height - b.height) * b.lean - (height - a.height) * a.lean);
        for (int i = 0; i < touch.count; ++i) {
            const Vec2& p = touch.points[i];
            contact.list[contact.count++] = {{p.x(), p.y(), height}, a.pose.turnBack(p - a.pose.at), touch.gaps[i] + lean};
        }
    };
    if (a.footprint->upright && b.footprint->upright && high - low > kTall && !m_objects.planar) {
        addAt(low);
        addAt(high);
    } else if (a.footprint->upright == b.footprint->upright) addAt((low + high) / 2);
    else { // a ball or what leans touches with its middle
        const Side& round = a.footprint->upright ? b : a;
        addAt(std::clamp((round.low() + round.high()) / 2, low, high));
    }
}

/// From the nearest point of the last tick, each used once.
void UnitContacts::takeOver() {
    auto old = m_last.begin();
    for (UnitContact& c : m_now) {
        while (old != m_last.end() && old->key() < c.key()) ++old;
        if (old == m_last.end() || old->key() != c.key()) continue;
        std::array<bool, 4> used{};
        for (UnitContactPoint& p : c.points()) {
            std::size_t best = used.size();
            double least = kSamePoint * kSamePoint;
            for (std::size_t k = 0; k < old->count; ++k) {
                const UnitContactPoint& before = old->list[k];
                const double rise = before.at.z() - p.at.z(), square = (before.local - p.local).squaredNorm() + rise * rise;
                if (used[k] || square >= least) continue;
                best = k;
                least = square;
            }
            if (best == used.size()) continue;
            used[best] = true;
            p.normal = old->list[best].normal;
            p.tangent = old->list[best].tangent;
        }
    }
}

} // namespace trundle
