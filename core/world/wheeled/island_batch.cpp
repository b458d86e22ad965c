#include "world/wheeled/island_batch.h"

#include <algorithm>
#include <cmath>

#include "world/wheeled/wheeled_motion.h"

namespace trundle {

namespace {

enum { VX, VY, WX, WY, WZ };

constexpr int kMostTogether = 20;              // sweeps
constexpr std::size_t kMostBlocks = 3;         // with their contacts they fit the first level of the cache
constexpr double kSettledTogether = 1e-3;      // of the weight's impulse in a tick
constexpr double kSlop = 1e-4;                 // m
constexpr double kPushShare = 0.2;             // of the depth, per tick
constexpr double kFastestPush = 0.1;           // m/s
constexpr double kLeastBounce = 0.05;          // m/s
constexpr int kMostTakeOuts = 20;              // sweeps
constexpr int kSlideSteps = 3, kTurnSteps = 6; // of Newton's method for friction at its limit

using Pair = double __attribute__((vector_size(16)));

/// The velocities of one side of a contact, read once and written once for all that it does.
class ContactVelocity {
public:
    /// nullptr: it does not move.
    explicit ContactVelocity(double* from) : m_from(from) {
        if (!from) return;
        m_v[0] = {from[VX * kVehicleLanes], from[VY * kVehicleLanes]};
        m_v[1] = {from[WX * kVehicleLanes], from[WY * kVehicleLanes]};
        m_v[2] = {from[WZ * kVehicleLanes], 0};
    }
    [[nodiscard]] double speed(const VehiclePush& push) const {
        const Pair sum = at(push.row, 0) * m_v[0] + at(push.row, 1) * m_v[1] + at(push.row, 2) * m_v[2];
        return sum[0] + sum[1];
    }
    void push(const VehiclePush& push, double impulse) {
        for (int i = 0; i < 3; ++i) m_v[i] += impulse * at(push.change, i);
    }
    void write() const {
        if (!m_from) return;
        m_from[VX * kVehicleLanes] = m_v[0][0];
        m_from[VY * kVehicleLanes] = m_v[0][1];
        m_from[WX * kVehicleLanes] = m_v[1][0];
        m_from[WY * kVehicleLanes] = m_v[1][1];
        m_from[WZ * kVehicleLanes] = m_v[2][0];
    }

private:
    static Pair at(const double (&values)[6], int pair) { return Pair{values[2 * pair], values[2 * pair + 1]}; }

    double* m_from;
    Pair m_v[3] = {};
};

double product(const VehiclePush& push) {
    double sum = 0;
    for (std::size_t i = 0; i < 5; ++i) sum += push.row[i] * push.change[i];
    return sum;
}

template <class L> auto& speedOf(L& loose, std::size_t component) { return loose.v[component * kVehicleLanes]; }

/// The square of the limit on whose surface friction is that slides and turns with these squares.
double limitSquareOf(double slides, double spins) {
    const double sum = slides + spins;
    return sum > 0 ? sum * (1 + std::sqrt(1 + 4 * slides * spins / (sum * sum))) / 2 : 0;
}

/// The impulse of the ground's friction from the one that would end all slip: translation f and turning m, scaled by their limit and a lever,
/// share one limit surface (S. Goyal et al., Planar sliding with dry friction, Wear 143, 1991): f^2 + m^2 + f^2 m^2 = 1, which is that of a
/// ring within 1 %. What slips does so along its normal. `k`, `kw`: what an impulse changes.
Vec3 withinLimit(const Vec3& wanted, double k, double kw, double limit) {
    double x = wanted.x(), y = wanted.y(), w = wanted.z(), square = limitSquareOf(x * x + y * y, w * w);
    if (!(square > limit * limit)) return wanted;
    const double bx = x * k, by = y * k, bw = w * kw;
    double add = 0;
    const int steps = w == 0 ? kSlideSteps : kTurnSteps;
    for (int i = 0; i < steps && limit > 0; ++i) {
        const double slides = x * x + y * y, spins = w * w, along = 1 + spins / square, about = 1 + slides / square;
        const double slope = slides * along / (k + add * along) + spins * about / (kw + add * about), length = std::sqrt(square);
        add = std::max(add + (length / limit - 1) * square / slope, 0.);
        x = bx / (k + add * along);
        y = by / (k + add * along);
        w = bw / (kw + add * about);
        square = limitSquareOf(x * x + y * y, w * w);
    }
    return limit / std::sqrt(square) * Vec3(x, y, w);
}

} // namespace

void IslandBatch::begin(const Vec3& gravity, double h) {
    m_tick = {{gravity.x(), gravity.y(), gravity.z()}, h};
    m_place.resize(m_objects.units.size());
}

bool IslandBatch::isFull() const { return m_blockCount >= kMostBlocks; }

void IslandBatch::add(std::span<const std::uint32_t> units, std::span<const std::uint32_t> contacts) {
    Island island;
    island.units = {m_units.size(), m_units.size() + units.size()};
    island.contacts = {m_contactList.size(), m_contactList.size() + contacts.size()};
    m_units.insert(m_units.end(), units.begin(), units.end());
    m_contactList.insert(m_contactList.end(), contacts.begin(), contacts.end());
    island.loose.first = m_loose.size();
    double lightest = 1e300;
    for (const std::uint32_t unit : units) {
        lightest = std::min(lightest, m_objects.units[unit].shape->mass);
        if (m_objects.units[unit].isVehicle()) place(unit);
        else addLoose(unit);
    }
    island.loose.last = m_loose.size();
    island.settled = kSettledTogether * m_objects.weight * m_tick.h * lightest;
    m_islands.push_back(island);
}

/// Into a block of its model with room.
void IslandBatch::place(std::uint32_t unit) {
    const std::uint32_t model = m_objects.units[unit].model;
    std::size_t b = 0;
    while (b < m_blockCount && (m_blocks[b].model != model || m_blocks[b].units.size() == kVehicleLanes)) ++b;
    if (b == m_blockCount) {
        if (m_blocks.size() == m_blockCount) m_blocks.emplace_back();
        m_blocks[b].model = model;
        m_blocks[b].units.clear();
        ++m_blockCount;
    }
    Block& block = m_blocks[b];
    m_place[unit] = {static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(block.units.size())};
    block.units.push_back(unit);
}

/// Speeds before the ground and others hold it. A ball rolls: its turning moves with it, and what turns it moves it; about the vertical it
/// turns freely.
IslandBatch::Loose IslandBatch::looseOf(std::uint32_t unit) const {
    const WheeledUnit& u = m_objects.units[unit];
    const ActorShape& s = *u.shape;
    const SurfaceSpec &own = m_objects.surfaces[s.surface], &floor = m_objects.surfaces[m_objects.ground->surface()];
    Loose out;
    out.unit = unit;
    const bool ball = s.kind == ActorKind::Ball;
    const double load = std::max(-m_tick.gravity[2] * s.mass - u.force.z(), 0.) * m_tick.h;
    out.mass = ball ? s.mass + s.inertia(2, 2) / (s.spinRadius * s.spinRadius) : s.mass;
    out.inertia = s.inertia(2, 2);
    out.reach = ball ? 0 : s.spinRadius;
    out.limit = load * (ball ? std::max(own.rollingFriction, floor.rollingFriction) / s.spinRadius
                             : std::min(own.friction, floor.friction));
    const Vec3 push = ball ? Vec3(u.force + Vec3(u.moment.y(), -u.moment.x(), 0) / s.spinRadius) : u.force;
    const Vec3 v = u.linear + m_tick.h * (push / out.mass + s.mass / out.mass * Vec3(m_tick.gravity));
    speedOf(out, VX) = v.x();
    speedOf(out, VY) = v.y();
    speedOf(out, WZ) = u.angular.z() + m_tick.h * u.moment.z() / out.inertia;
    return out;
}

void IslandBatch::addLoose(std::uint32_t unit) {
    m_place[unit].lane = static_cast<std::uint32_t>(m_loose.size());
    Loose loose = looseOf(unit);
    const Vec3& grip = m_objects.units[unit].grip;
    speedOf(loose, VX) += grip.x() / loose.mass;
    speedOf(loose, VY) += grip.y() / loose.mass;
    if (loose.reach > 0) speedOf(loose, WZ) += grip.z() * loose.reach / loose.inertia;
    m_loose.push_back(loose);
}

void IslandBatch::solveLoose(std::uint32_t unit) {
    WheeledUnit& u = m_objects.units[unit];
    const bool rests = u.linear.isZero(0) && u.angular.isZero(0) && u.force.isZero(0) && u.moment.isZero(0);
    u.grip.setZero();
    if (rests && m_tick.gravity[0] == 0 && m_tick.gravity[1] == 0) return;
    Loose loose = looseOf(unit);
    for (int i = 0; i < 2; ++i) (void)hold(loose, u.grip);
    writeBack(loose);
    moveOn(u, m_tick.h);
}

/// Friction of the ground, which may slip.
double IslandBatch::hold(Loose& loose, Vec3& grip) {
    const bool turns = loose.reach > 0;
    const double k = 1 / loose.mass, kw = turns ? loose.reach * loose.reach / loose.inertia : 1;
    const Vec3 wanted(grip.x() - speedOf(loose, VX) / k, grip.y() - speedOf(loose, VY) / k,
                      turns ? grip.z() - speedOf(loose, WZ) * loose.reach / kw : 0);
    const Vec3 held = withinLimit(wanted, k, kw, loose.limit);
    speedOf(loose, VX) += (held.x() - grip.x()) * k;
    speedOf(loose, VY) += (held.y() - grip.y()) * k;
    if (turns) speedOf(loose, WZ) += (held.z() - grip.z()) * kw / loose.reach;
    const double change = (held - grip).cwiseAbs().maxCoeff();
    grip = held;
    return change;
}

void IslandBatch::writeBack(const Loose& loose) {
    WheeledUnit& u = m_objects.units[loose.unit];
    u.linear = {speedOf(loose, VX), speedOf(loose, VY), 0};
    u.angular = {0, 0, speedOf(loose, WZ)};
    if (u.shape->kind == ActorKind::Ball)
        u.angular = {-speedOf(loose, VY) / u.shape->spinRadius, speedOf(loose, VX) / u.shape->spinRadius, speedOf(loose, WZ)};
}

double* IslandBatch::velocitiesOf(std::uint32_t unit) {
    if (unit == kNoActor || !m_objects.units[unit].isMovable()) return nullptr;
    const Place& at = m_place[unit];
    return m_objects.units[unit].isVehicle() ? &m_blocks[at.block].lanes->v[0][at.lane] : m_loose[at.lane].v.data();
}

VehiclePushes IslandBatch::pushesOf(std::uint32_t unit, const Vec3& point, const Vec2& normal) const {
    if (unit == kNoActor || !m_objects.units[unit].isMovable()) return {};
    const WheeledUnit& u = m_objects.units[unit];
    const Vec3 arm = point - u.position;
    const Place& at = m_place[unit];
    if (u.isVehicle()) return pushesAt(*m_blocks[at.block].lanes, at.lane, u.shape->mass, arm, normal);
    const Loose& loose = m_loose[at.lane];
    const auto fill = [&](VehiclePush& push, const Vec2& way) {
        const double turn = arm.x() * way.y() - arm.y() * way.x();
        push.row[VX] = way.x();
        push.row[VY] = way.y();
        push.row[WZ] = turn;
        push.change[VX] = way.x() / loose.mass;
        push.change[VY] = way.y() / loose.mass;
        push.change[WZ] = turn / loose.inertia;
    };
    VehiclePushes out;
    fill(out.normal, normal);
    fill(out.tangent, {-normal.y(), normal.x()});
    return out;
}

/// Over x and y, as the last tick left it: what drives or pulls a body in this tick is no blow.
Vec2 IslandBatch::velocityAt(std::uint32_t unit, const Vec3& point) const {
    if (unit == kNoActor || !m_objects.units[unit].isMovable()) return Vec2::Zero();
    const WheeledUnit& u = m_objects.units[unit];
    return (u.linear + u.angular.cross(point - u.position)).head<2>();
}

void IslandBatch::addRows(UnitContact& c) {
    const Vec2 normal = c.normal;
    for (const UnitContactPoint& point : c.points()) {
        ContactRow row;
        row.va = velocitiesOf(c.a);
        row.vb = velocitiesOf(c.b);
        row.a = pushesOf(c.a, point.at, normal);
        row.b = pushesOf(c.b, point.at, normal);
        row.normalMass = 1 / (product(row.a.normal) + product(row.b.normal));
        row.tangentMass = 1 / (product(row.a.tangent) + product(row.b.tangent));
        const double depth = -point.gap, closing = (velocityAt(c.a, point.at) - velocityAt(c.b, point.at)).dot(normal);
        row.bias = depth > 0 ? std::min(kPushShare * std::max(depth - kSlop, 0.) / m_tick.h, kFastestPush) : depth / m_tick.h;
        row.kept = std::min(row.bias, 0.);
        if (c.restitution > 0 && closing > kLeastBounce && closing * m_tick.h > -depth) {
            row.kept = c.restitution * closing;
            row.bias = std::max(row.bias, row.kept);
        }
        row.friction = c.friction;
        row.normal = point.normal;
        row.tangent = point.tangent;
        m_rows.push_back(row);
    }
}

double IslandBatch::solveContact(ContactRow& row) {
    ContactVelocity a(row.va), b(row.vb);
    const double speed = b.speed(row.b.normal) - a.speed(row.a.normal), before = row.normal, beforeTangent = row.tangent;
    row.normal = std::max(before + (row.bias - speed) * row.normalMass, 0.);
    const double change = row.normal - before, limit = row.friction * row.normal;
    if (change != 0) {
        a.push(row.a.normal, -change);
        b.push(row.b.normal, change);
    }
    double turn = 0;
    if (limit != 0 || beforeTangent != 0) {
        const double slip = b.speed(row.b.tangent) - a.speed(row.a.tangent);
        row.tangent = std::clamp(beforeTangent - slip * row.tangentMass, -limit, limit);
        turn = row.tangent - beforeTangent;
        a.push(row.a.tangent, -turn);
        b.push(row.b.tangent, turn);
    }
    if (change == 0 && turn == 0) return 0; // most do nothing, and need not be waited for
    a.write();
    b.write();
    return std::max(std::abs(change), std::abs(turn));
}

/// Vehicles with the impulses of the last tick, then the rows of contacts with theirs.
void IslandBatch::prepare() {
    for (std::size_t b = 0; b < m_blockCount; ++b) {
        Block& block = m_blocks[b];
        block.open = block.units.size();
        loadVehicles(*block.lanes, m_objects, block.units);
        m_kernel.prepare(*block.lanes, m_objects.models[block.model], m_tick);
    }
    for (Island& island : m_islands) {
        island.rows.first = m_rows.size();
        for (std::size_t k = island.contacts.first; k < island.contacts.last; ++k) addRows(m_contacts.all()[m_contactList[k]]);
        island.rows.last = m_rows.size();
    }
    for (const ContactRow& row : m_rows) {
        ContactVelocity a(row.va), b(row.vb);
        a.push(row.a.normal, -row.normal);
        a.push(row.a.tangent, -row.tangent);
        b.push(row.b.normal, row.normal);
        b.push(row.b.tangent, row.tangent);
        a.write();
        b.write();
    }
}

void IslandBatch::solve() {
    prepare();
    std::size_t open = m_islands.size();
    for (int i = 0; i < kMostTogether && open > 0; ++i) {
        for (std::size_t b = 0; b < m_blockCount; ++b)
            if (m_blocks[b].open > 0) m_kernel.sweep(*m_blocks[b].lanes, m_objects.models[m_blocks[b].model], i);
        for (Island& island : m_islands) {
            if (!island.isOpen || (sweep(island, i % 2 != 0) >= island.settled && i + 1 < kMostTogether) || i == 0) continue;
            settle(island);
            --open;
        }
    }
    finish();
}

/// Of all but its vehicles. The largest change of an impulse of the island, N s.
double IslandBatch::sweep(const Island& island, bool backwards) {
    double change = 0;
    for (std::size_t k = island.units.first; k < island.units.last; ++k) {
        if (!m_objects.units[m_units[k]].isVehicle()) continue;
        const Place& at = m_place[m_units[k]];
        change = std::max(change, m_blocks[at.block].lanes->change[at.lane]);
    }
    for (std::size_t k = island.loose.first; k < island.loose.last; ++k)
        change = std::max(change, hold(m_loose[k], m_objects.units[m_loose[k].unit].grip));
    const auto [first, last] = island.rows;
    for (std::size_t k = first; k < last; ++k)
        change = std::max(change, solveContact(m_rows[backwards ? first + last - 1 - k : k]));
    return change;
}

void IslandBatch::settle(Island& island) {
    island.isOpen = false;
    for (std::size_t k = island.units.first; k < island.units.last; ++k) {
        if (!m_objects.units[m_units[k]].isVehicle()) continue;
        const Place& at = m_place[m_units[k]];
        Block& block = m_blocks[at.block];
        bool chosen[kVehicleLanes] = {};
        chosen[at.lane] = true;
        m_kernel.keep(*block.lanes, m_objects.models[block.model], chosen);
        --block.open;
    }
}

/// What is deep in something is pushed out in this tick and does not keep the speed of that: as much of its impulse as gave that
/// speed is taken back once all have moved on. Wheels keep their spins; the next tick evens out the little that they hold.
void IslandBatch::takeOutPushes(const Island& island) {
    const std::span rows(m_rows.begin() + static_cast<std::ptrdiff_t>(island.rows.first), island.rows.last - island.rows.first);
    if (std::ranges::none_of(rows, [](const ContactRow& row) { return row.bias > row.kept && row.normal > 0; })) return;
    const std::span units(m_units.begin() + static_cast<std::ptrdiff_t>(island.units.first),
                          island.units.last - island.units.first);
    const auto eachVehicle = [&](auto use) {
        for (const std::uint32_t unit : units)
            if (m_objects.units[unit].isVehicle())
                use(*m_blocks[m_place[unit].block].lanes, m_place[unit].lane, m_objects.units[unit]);
    };
    eachVehicle([](VehicleBlock& block, std::size_t lane, WheeledUnit&) {
        for (std::size_t k = 0; k < 6; ++k) block.v[k][lane] = block.keptV[k][lane];
    });
    double change = island.settled;
    for (int i = 0; i < kMostTakeOuts && change >= island.settled; ++i) {
        change = 0;
        for (std::size_t k = 0; k < rows.size(); ++k)
            change = std::max(change, takeOut(rows[i % 2 != 0 ? rows.size() - 1 - k : k]));
    }
    for (ContactRow& row : rows) row.normal -= row.taken;
    eachVehicle(storeSpeeds);
    for (std::size_t k = island.loose.first; k < island.loose.last; ++k) writeBack(m_loose[k]);
}

/// The change of what is taken of its impulse.
double IslandBatch::takeOut(ContactRow& row) {
    ContactVelocity a(row.va), b(row.vb);
    const double speed = b.speed(row.b.normal) - a.speed(row.a.normal), before = row.taken;
    row.taken = std::clamp(before + (speed - row.kept) * row.normalMass, 0., row.normal);
    const double change = row.taken - before;
    a.push(row.a.normal, change);
    b.push(row.b.normal, -change);
    a.write();
    b.write();
    return std::abs(change);
}

void IslandBatch::finish() {
    for (std::size_t b = 0; b < m_blockCount; ++b) {
        Block& block = m_blocks[b];
        m_kernel.finish(*block.lanes, m_objects.models[block.model], m_tick);
        for (std::size_t lane = 0; lane < block.units.size(); ++lane)
            storeVehicle(*block.lanes, lane, m_objects, block.units[lane], m_tick.h);
    }
    for (const Loose& loose : m_loose) {
        writeBack(loose);
        moveOn(m_objects.units[loose.unit], m_tick.h);
    }
    for (const Island& island : m_islands) takeOutPushes(island);
    auto row = m_rows.begin();
    for (const std::uint32_t c : m_contactList)
        for (UnitContactPoint& point : m_contacts.all()[c].points()) {
            point.normal = row->normal;
            point.tangent = row++->tangent;
        }
    m_islands.clear();
    m_units.clear();
    m_contactList.clear();
    m_loose.clear();
    m_rows.clear();
    m_blockCount = 0;
}

} // namespace trundle
