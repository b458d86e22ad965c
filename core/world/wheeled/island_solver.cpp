#include "world/wheeled/island_solver.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr int kMostAlone = 300, kMostTogether = 20;
constexpr double kSettledAlone = 1e-6,
                 kSettledTogether = 1e-3; // of the weight's impulse in a tick: less change of any impulse ends the sweeps
constexpr double kSlop = 1e-4;            // m
constexpr double kPushShare = 0.2;        // of the depth, per tick
constexpr double kFastestPush = 0.1;      // m/s
constexpr double kLeastBounce = 0.05;     // m/s

} // namespace

double IslandSolver::ContactRow::speed(const VehicleRows::Push& a, const VehicleRows::Push& b) const {
    double speed = 0;
    for (std::size_t i = 0; i < 5; ++i) speed += b.row[i] * vb[i] - a.row[i] * va[i];
    return speed;
}

void IslandSolver::ContactRow::push(const VehicleRows::Push& a, const VehicleRows::Push& b, double impulse) const {
    for (std::size_t i = 0; i < 5; ++i) {
        va[i] -= impulse * a.change[i];
        vb[i] += impulse * b.change[i];
    }
}

void IslandSolver::step(const Vec3& gravity, double h) {
    m_gravity = gravity;
    m_h = h;
    findIslands();
    for (std::uint32_t i = 0; i < m_objects.units.size(); ++i)
        if (m_objects.units[i].isMovable() && !m_touches[i]) solveAlone(i);
    std::size_t contact = 0;
    for (std::size_t i = 0; i < m_units.size();) {
        const std::uint32_t island = m_units[i].island;
        m_unitList.clear();
        m_contactList.clear();
        for (; i < m_units.size() && m_units[i].island == island; ++i) m_unitList.push_back(m_units[i].item);
        for (; contact < m_unitContacts.size() && m_unitContacts[contact].island == island; ++contact)
            m_contactList.push_back(m_unitContacts[contact].item);
        solve(m_unitList, m_contactList);
    }
}

std::uint32_t IslandSolver::root(std::uint32_t unit) {
    while (m_parent[unit] != unit) unit = m_parent[unit] = m_parent[m_parent[unit]];
    return unit;
}

void IslandSolver::findIslands() {
    const std::size_t count = m_objects.units.size();
    m_parent.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) m_parent[i] = i;
    m_touches.assign(count, false);
    m_slot.resize(count);
    const auto moves = [&](std::uint32_t unit) { return unit != kNoActor && m_objects.units[unit].isMovable(); };
    for (const UnitContact& c : m_contacts.all()) {
        for (const std::uint32_t unit : {c.a, c.b})
            if (moves(unit)) m_touches[unit] = true;
        if (!moves(c.a) || !moves(c.b)) continue;
        const std::uint32_t x = root(c.a), y = root(c.b);
        m_parent[std::max(x, y)] = std::min(x, y);
    }
    m_units.clear();
    for (std::uint32_t i = 0; i < count; ++i)
        if (m_touches[i]) m_units.push_back({root(i), i});
    std::ranges::sort(m_units);
    m_unitContacts.clear();
    for (std::uint32_t i = 0; i < m_contacts.all().size(); ++i) {
        const UnitContact& c = m_contacts.all()[i];
        m_unitContacts.push_back({root(moves(c.a) ? c.a : c.b), i});
    }
    std::ranges::sort(m_unitContacts);
}

void IslandSolver::solveAlone(std::uint32_t unit) {
    if (m_vehicles.empty()) m_vehicles.resize(1);
    if (m_objects.units[unit].isVehicle()) {
        VehicleRows& rows = m_vehicles[0];
        rows.prepare(m_objects, unit, m_gravity, m_h);
        const double settled = kSettledAlone * m_objects.weight * m_h * m_objects.units[unit].shape->mass;
        for (int i = 0; i < kMostAlone; ++i)
            if (rows.sweep(i % 2 != 0) < settled && i > 0) break;
        rows.finish(m_objects);
        return;
    }
    WheeledUnit& u = m_objects.units[unit];
    const bool rests = u.linear.isZero(0) && u.angular.isZero(0) && u.force.isZero(0) && u.moment.isZero(0);
    u.grip.setZero();
    if (rests && m_gravity.head<2>().isZero(0)) return;
    Loose loose = looseOf(unit);
    for (int i = 0; i < 2; ++i) (void)hold(loose, u.grip);
    writeBack(loose);
}

/// Speeds before the ground and others hold it. A ball rolls: its turning moves with it.
IslandSolver::Loose IslandSolver::looseOf(std::uint32_t unit) const {
    const WheeledUnit& u = m_objects.units[unit];
    const ActorShape& s = *u.shape;
    const SurfaceSpec &own = m_objects.surfaces[s.surface], &floor = m_objects.surfaces[m_objects.ground->surface()];
    Loose out;
    out.unit = unit;
    const bool ball = s.kind == ActorKind::Ball;
    const double load = -m_gravity.z() * s.mass * m_h;
    out.mass = ball ? s.mass + s.inertia(2, 2) / (s.spinRadius * s.spinRadius) : s.mass;
    out.inertia = ball ? 0 : s.inertia(2, 2);
    out.reach = ball ? 0 : s.spinRadius;
    out.limit = load * (ball ? std::max(own.rollingFriction, floor.rollingFriction) / s.spinRadius
                             : std::min(own.friction, floor.friction));
    const Vec3 v = u.linear + m_h * (u.force / out.mass + s.mass / out.mass * m_gravity);
    out.v = {v.x(), v.y(), 0, 0, ball ? 0 : u.angular.z() + m_h * u.moment.z() / out.inertia};
    return out;
}

/// Friction of the ground: translation and turning share one ellipsoid (S. Goyal et al., Planar sliding with dry friction, Wear 143, 1991);
/// the turning is scaled by `reach`.
double IslandSolver::hold(Loose& loose, Vec3& grip) {
    const bool turns = loose.reach > 0;
    const double k = 1 / loose.mass, kw = turns ? loose.reach * loose.reach / loose.inertia : 1;
    double x = grip.x() - loose.v[0] / k, y = grip.y() - loose.v[1] / k, w = turns ? grip.z() - loose.v[4] * loose.reach / kw : 0;
    double square = x * x + y * y + w * w;
    if (square > loose.limit * loose.limit) {
        const double bx = x * k, by = y * k, bw = w * kw;
        double add = 0;
        for (int i = 0; i < 3 && loose.limit > 0; ++i) {
            const double slope = (x * x + y * y) / (k + add) + w * w / (kw + add), length = std::sqrt(square);
            add = std::max(add + (length / loose.limit - 1) * square / slope, 0.);
            x = bx / (k + add);
            y = by / (k + add);
            w = bw / (kw + add);
            square = x * x + y * y + w * w;
        }
        const double scale = loose.limit / std::sqrt(square);
        x *= scale;
        y *= scale;
        w *= scale;
    }
    loose.v[0] += (x - grip.x()) * k;
    loose.v[1] += (y - grip.y()) * k;
    if (turns) loose.v[4] += (w - grip.z()) * kw / loose.reach;
    const double change = (Vec3(x, y, w) - grip).cwiseAbs().maxCoeff();
    grip = {x, y, w};
    return change;
}

void IslandSolver::writeBack(const Loose& loose) {
    WheeledUnit& u = m_objects.units[loose.unit];
    u.linear = {loose.v[0], loose.v[1], 0};
    u.angular = {0, 0, loose.v[4]};
    if (u.shape->kind == ActorKind::Ball) u.angular = {-loose.v[1] / u.shape->spinRadius, loose.v[0] / u.shape->spinRadius, 0};
}

void IslandSolver::prepare(std::span<const std::uint32_t> units) {
    m_vehicleCount = 0;
    m_loose.clear();
    for (const std::uint32_t unit : units) {
        if (m_objects.units[unit].isVehicle()) {
            if (m_vehicles.size() <= m_vehicleCount) m_vehicles.resize(2 * m_vehicleCount + 1);
            m_slot[unit] = static_cast<std::uint32_t>(m_vehicleCount);
            m_vehicles[m_vehicleCount++].prepare(m_objects, unit, m_gravity, m_h);
        } else {
            m_slot[unit] = static_cast<std::uint32_t>(m_loose.size());
            Loose loose = looseOf(unit);
            const Vec3& grip = m_objects.units[unit].grip;
            loose.v[0] += grip.x() / loose.mass;
            loose.v[1] += grip.y() / loose.mass;
            if (loose.reach > 0) loose.v[4] += grip.z() * loose.reach / loose.inertia;
            m_loose.push_back(loose);
        }
    }
}

double* IslandSolver::velocitiesOf(std::uint32_t unit) {
    if (unit == kNoActor || !m_objects.units[unit].isMovable()) return m_still.data();
    return m_objects.units[unit].isVehicle() ? m_vehicles[m_slot[unit]].velocities() : m_loose[m_slot[unit]].v.data();
}

VehicleRows::Push IslandSolver::pushOf(std::uint32_t unit, const Vec3& point, const Vec2& way) const {
    if (unit == kNoActor || !m_objects.units[unit].isMovable()) return {};
    const WheeledUnit& u = m_objects.units[unit];
    const Vec3 arm = point - u.position;
    if (u.isVehicle()) return m_vehicles[m_slot[unit]].pushAt(arm, way);
    const Loose& loose = m_loose[m_slot[unit]];
    const double turn = loose.reach > 0 ? arm.x() * way.y() - arm.y() * way.x() : 0;
    VehicleRows::Push push;
    push.row = {way.x(), way.y(), 0, 0, turn};
    push.change = {way.x() / loose.mass, way.y() / loose.mass, 0, 0, turn == 0 ? 0 : turn / loose.inertia};
    return push;
}

void IslandSolver::addRows(UnitContact& c) {
    const Vec2 normal = c.normal, tangent(-normal.y(), normal.x());
    for (const UnitContactPoint& point : c.points()) {
        ContactRow row;
        row.va = velocitiesOf(c.a);
        row.vb = velocitiesOf(c.b);
        row.normalA = pushOf(c.a, point.at, normal);
        row.normalB = pushOf(c.b, point.at, normal);
        row.tangentA = pushOf(c.a, point.at, tangent);
        row.tangentB = pushOf(c.b, point.at, tangent);
        for (std::size_t i = 0; i < 5; ++i) {
            row.normalMass += row.normalA.row[i] * row.normalA.change[i] + row.normalB.row[i] * row.normalB.change[i];
            row.tangentMass += row.tangentA.row[i] * row.tangentA.change[i] + row.tangentB.row[i] * row.tangentB.change[i];
        }
        const double depth = -point.gap, closing = -row.speed(row.normalA, row.normalB);
        row.bias = depth > 0 ? std::min(kPushShare * std::max(depth - kSlop, 0.) / m_h, kFastestPush) : depth / m_h;
        if (c.restitution > 0 && closing > kLeastBounce && closing * m_h > -depth)
            row.bias = std::max(row.bias, c.restitution * closing);
        row.friction = c.friction;
        row.normal = point.normal;
        row.tangent = point.tangent;
        m_rows.push_back(row);
    }
}

double IslandSolver::solveContact(ContactRow& row) {
    const double before = row.normal,
                 normal = std::max(before + (row.bias - row.speed(row.normalA, row.normalB)) / row.normalMass, 0.);
    if (normal != row.normal) row.push(row.normalA, row.normalB, normal - row.normal);
    row.normal = normal;
    double change = std::abs(normal - before);
    const double limit = row.friction * normal;
    const double tangent = std::clamp(row.tangent - row.speed(row.tangentA, row.tangentB) / row.tangentMass, -limit, limit);
    if (tangent != row.tangent) row.push(row.tangentA, row.tangentB, tangent - row.tangent);
    change = std::max(change, std::abs(tangent - row.tangent));
    row.tangent = tangent;
    return change;
}

void IslandSolver::solve(std::span<const std::uint32_t> units, std::span<const std::uint32_t> contacts) {
    prepare(units);
    m_rows.clear();
    for (const std::uint32_t c : contacts) addRows(m_contacts.all()[c]);
    for (const ContactRow& row : m_rows) { // after all closing speeds are known
        row.push(row.normalA, row.normalB, row.normal);
        row.push(row.tangentA, row.tangentB, row.tangent);
    }
    double lightest = 1e300;
    for (const std::uint32_t unit : units) lightest = std::min(lightest, m_objects.units[unit].shape->mass);
    const double settled = kSettledTogether * m_objects.weight * m_h * lightest;
    for (int i = 0; i < kMostTogether; ++i)
        if (sweep(i % 2 != 0) < settled && i > 0) break;
    finish(contacts);
}

/// The largest change of an impulse, N s.
double IslandSolver::sweep(bool backwards) {
    double change = 0;
    for (std::size_t k = 0; k < m_vehicleCount; ++k) change = std::max(change, m_vehicles[k].sweep(backwards));
    for (Loose& loose : m_loose) change = std::max(change, hold(loose, m_objects.units[loose.unit].grip));
    for (std::size_t k = 0; k < m_rows.size(); ++k)
        change = std::max(change, solveContact(m_rows[backwards ? m_rows.size() - 1 - k : k]));
    return change;
}

void IslandSolver::finish(std::span<const std::uint32_t> contacts) {
    for (std::size_t k = 0; k < m_vehicleCount; ++k) m_vehicles[k].finish(m_objects);
    for (const Loose& loose : m_loose) writeBack(loose);
    auto row = m_rows.begin();
    for (const std::uint32_t c : contacts)
        for (UnitContactPoint& point : m_contacts.all()[c].points()) {
            point.normal = row->normal;
            point.tangent = row++->tangent;
        }
}

} // namespace trundle
