#include "world/wheeled/unit_contacts.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kLookAhead =
    0.005;                          // m: what is nearer than that has a row, which lets it come as near as it likes and no nearer
constexpr double kFar = 1e300;      // m
constexpr double kSamePoint = 0.02; // m
constexpr double kLeastOverlap = 1e-4; // m, of heights
constexpr double kTall = 0.005;        // m

/// m that a vehicle is displaced per metre above its centre of mass.
Vec2 leanOf(const WheeledUnit& unit) {
    if (!unit.isVehicle()) return Vec2::Zero();
    const Quat& q = unit.rotation;
    return {2 * (q.x() * q.z() + q.w() * q.y()), 2 * (q.y() * q.z() - q.w() * q.x())};
}

/// Farthest point over x and y from its centre of mass, m.
double reachOf(const WheeledUnit& unit) { return unit.shape->bound + unit.shape->tall * leanOf(unit).norm(); }

Box3 boxOf(const WheeledUnit& unit, double reach) {
    const double x = unit.position.x(), y = unit.position.y(), r = reach + kLookAhead;
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
    fileBoxes();
    for (Search& search : m_searches) search.found.clear();
    m_team.split(m_objects.units.size(), kUnitsOfThread, [this](unsigned worker, std::size_t begin, std::size_t end) {
        Search& search = m_searches[worker];
        for (std::size_t i = begin; i < end; ++i) findOf(static_cast<std::uint32_t>(i), search);
        takeOver(search.found);
    });
    for (const Search& search : m_searches) m_now.insert(m_now.end(), search.found.begin(), search.found.end());
    m_touches.assign(m_objects.units.size(), 0);
    for (const UnitContact& c : m_now) {
        m_touches[c.a] = 1;
        if (c.b != kNoActor) m_touches[c.b] = 1;
    }
}

void UnitContacts::fileBoxes() {
    if (m_filed != m_objects.scenery.size()) {
        std::vector<Box3> boxes;
        for (const WheeledScenery& s : m_objects.scenery) boxes.push_back(boxOf(s.footprint));
        m_sceneryGrid.build(std::move(boxes));
        m_filed = m_objects.scenery.size();
    }
    m_boxes.clear();
    m_reaches.clear();
    for (const WheeledUnit& unit : m_objects.units) {
        m_reaches.push_back(reachOf(unit));
        m_boxes.push_back(boxOf(unit, m_reaches.back()));
    }
    m_grid.file(m_boxes);
}

/// With units after it, then with the scenery: by ascending keys.
void UnitContacts::findOf(std::uint32_t unit, Search& search) const {
    const WheeledUnit& own = m_objects.units[unit];
    if (own.ended) return;
    search.sides.clear();
    m_grid.partnersOf(unit, m_boxes, search.near);
    for (const std::uint32_t other : search.near) meet(unit, other, search);
    if (m_filed == 0 || !own.isMovable()) return;
    m_sceneryGrid.query(m_boxes[unit], search.near);
    if (!search.near.empty()) meetScenery(unit, search);
}

void UnitContacts::forget(std::uint32_t unit) {
    std::erase_if(m_now, [unit](const UnitContact& c) { return c.a == unit || c.b == unit; });
}

UnitContacts::Side UnitContacts::sideOf(const WheeledUnit& unit, std::size_t footprint) {
    const PlanarShape& shape = unit.shape->footprints[footprint];
    const double height = unit.position.z();
    Side side{&shape, unit.plane, height, height, leanOf(unit), unit.plane.at + unit.plane.turn(shape.centre), shape.bound};
    side.bound += std::max(std::abs(shape.low), std::abs(shape.high)) * side.lean.norm();
    return side;
}

/// Takes its pose to where it is at that height, unless what is near is found all the same.
void UnitContacts::Side::moveTo(double to) {
    const Vec2 by = leanAt(to);
    if (by.squaredNorm() <= kLookAhead * kLookAhead) return;
    pose.at += by;
    level = to;
}

/// Those of the unit whose contacts are looked for, where they are not known yet.
void UnitContacts::seeSides(const WheeledUnit& unit, Search& search) {
    for (std::size_t i = search.sides.size(); i < unit.shape->footprints.size(); ++i) search.sides.push_back(sideOf(unit, i));
}

void UnitContacts::meet(std::uint32_t a, std::uint32_t b, Search& search) const {
    const WheeledUnit &ua = m_objects.units[a], &ub = m_objects.units[b];
    if (ub.ended || (!ua.isMovable() && !ub.isMovable())) return;
    const double reach = m_reaches[a] + m_reaches[b] + kLookAhead;
    if ((ua.plane.at - ub.plane.at).squaredNorm() > reach * reach) return;
    seeSides(ua, search);
    search.facing.clear();
    for (std::uint32_t i = 0; i < search.sides.size(); ++i)
        if (isNear(search.sides[i], b)) search.facing.push_back(i);
    if (search.facing.empty()) return;
    search.others.clear();
    for (std::uint32_t k = 0; k < ub.shape->footprints.size(); ++k)
        if (const Side side = sideOf(ub, k); isNear(side, a)) search.others.push_back({side, ub.geoms + k});
    for (const std::uint32_t i : search.facing)
        for (const Other& other : search.others)
            if (areNear(search.sides[i], other.side)) add({a, b, ua.geoms + i, other.geom}, search.sides[i], other.side, search);
}

/// That of `near`.
void UnitContacts::meetScenery(std::uint32_t a, Search& search) const {
    const WheeledUnit& unit = m_objects.units[a];
    seeSides(unit, search);
    for (std::uint32_t i = 0; i < search.sides.size(); ++i)
        for (const std::uint32_t s : search.near) {
            const WheeledScenery& scenery = m_objects.scenery[s];
            const PlanarShape& f = scenery.footprint;
            const Side other{&f, {}, 0, 0, Vec2::Zero(), f.centre, f.bound};
            if (areNear(search.sides[i], other)) add({a, kNoActor, unit.geoms + i, scenery.geom}, search.sides[i], other, search);
        }
}

/// Whether the circles of a footprint and of all of another unit touch.
bool UnitContacts::isNear(const Side& side, std::uint32_t unit) const {
    const double reach = side.bound + m_reaches[unit] + kLookAhead;
    return (side.centre - m_objects.units[unit].plane.at).squaredNorm() <= reach * reach;
}

/// Their circles and heights: most pairs need no more.
bool UnitContacts::areNear(const Side& a, const Side& b) {
    const double reach = a.bound + b.bound + kLookAhead;
    return (a.centre - b.centre).squaredNorm() <= reach * reach &&
           std::min(a.high(), b.high()) - std::max(a.low(), b.low()) >= kLeastOverlap;
}

/// Their poses are those at the middle of what they share; what they lean from there on is added point by point.
void UnitContacts::add(const UnitContact& pair, Side a, Side b, Search& search) const {
    const double low = std::max(a.low(), b.low()), high = std::min(a.high(), b.high());
    a.moveTo((low + high) / 2);
    b.moveTo((low + high) / 2);
    const double apart = std::max((b.leanAt(low) - a.leanAt(low)).norm(), (b.leanAt(high) - a.leanAt(high)).norm());
    const bool leans = apart > kLookAhead;
    const PlanarTouch touch = touchOf(*a.footprint, a.pose, *b.footprint, b.pose, leans ? kLookAhead + apart : kLookAhead);
    if (touch.count == 0) return;
    UnitContact& contact = search.found.emplace_back(pair);
    contact.normal = touch.normal;
    const SurfaceSpec &sa = m_objects.surfaces[a.footprint->surface], &sb = m_objects.surfaces[b.footprint->surface];
    contact.friction = std::min(sa.friction, sb.friction);
    contact.restitution = std::max(sa.restitution, sb.restitution);
    addPoints(contact, a, b, touch, leans ? kLookAhead : kFar);
    if (contact.count == 0) search.found.pop_back();
}

/// Those with a gap of at most `most`.
void UnitContacts::addPoints(UnitContact& contact, const Side& a, const Side& b, const PlanarTouch& touch, double most) const {
    const double low = std::max(a.low(), b.low()), high = std::min(a.high(), b.high());
    const auto addAt = [&](double height) {
        const double lean = contact.normal.dot(b.leanAt(height) - a.leanAt(height));
        for (int i = 0; i < touch.count; ++i) {
            const Vec2& p = touch.points[i];
            if (touch.gaps[i] + lean > most) continue;
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
void UnitContacts::takeOver(std::span<UnitContact> contacts) const {
    if (contacts.empty()) return;
    auto old = std::ranges::lower_bound(m_last, contacts[0].key(), {}, &UnitContact::key);
    for (UnitContact& c : contacts) {
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
