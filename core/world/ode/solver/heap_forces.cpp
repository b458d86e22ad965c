#include "world/ode/solver/heap_forces.h"

#include <algorithm>
#include <cmath>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

// Measured: less lets heaps of 200 build up pressure, more makes them quiver until somebody climbs.
constexpr int kSweeps = 20; // at least, per tick
constexpr double kSweepsPerSecond = 2000;
constexpr double kRelaxed = 0.5;    // of Gauss-Seidel: the groups give less than as free bodies
constexpr double kRest = 1e-4;      // m: how deep what rests against each other is
constexpr double kClosing = 0.05;   // share of the rest of the depth, per tick
constexpr double kFloor = 0.7;      // cosine between its normal and the vertical
constexpr double kStanding = 0.8;   // share of the torque that would lift a group off the floor
constexpr double kSteadyLoad = 0.7; // share of the load before

} // namespace

Vec3 HeapForces::forceOf(const Push& p, double h) {
    return (p.normal.impulse * p.normal.way + p.across.impulse * p.across.way) / h;
}

void HeapForces::forget(Run bodies) {
    for (std::uint32_t i = bodies.begin; i < std::min<std::size_t>(bodies.end, m_expected.size()); ++i) m_expected[i] = {};
}

std::uint32_t HeapForces::groupIndex(std::uint32_t group) {
    if (m_indexOf[group] == kNone) {
        m_indexOf[group] = static_cast<std::uint32_t>(m_groups.size());
        m_groups.emplace_back();
        m_names.push_back(group);
    }
    return m_indexOf[group];
}

void HeapForces::apply(double h, std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
                       const BodyClusters& clusters, std::span<dJointFeedback> feedbacks) {
    gather(contacts, bodies, geoms, clusters);
    measure(bodies, clusters);
    for (Push& push : m_pushes) prepare(push, contacts[push.contact], geoms, h);
    expectOthers(contacts);
    const int sweeps = std::max(kSweeps, static_cast<int>(std::lround(h * kSweepsPerSecond / 2)) * 2);
    for (int sweep = 0; sweep < sweeps; sweep += 2) { // to and fro: in one order only, they would push a heap aside
        for (Push& push : m_pushes) solve(push);
        for (auto push = m_pushes.rbegin(); push != m_pushes.rend(); ++push) solve(*push);
    }
    for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
        const Group& g = m_groups[i];
        m_expected[m_names[i]] = {m_tick, g.velocity - g.pushed, g.turn - g.twisted};
    }
    push(h, contacts, bodies, geoms, feedbacks);
    ++m_tick;
}

/// At one height for all pushes on a group, as far as that lifts nothing, and without rolling its wheels on each other.
void HeapForces::push(double h, std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
                      std::span<dJointFeedback> feedbacks) {
    findHeights(h, contacts, bodies, geoms);
    const auto give = [&](const Group& g, std::uint32_t geom, const Vec3& at, const Vec3& force) {
        const OdeBody& body = bodies[geoms[geom].body];
        const double own = heightOn(g, vec(body.p));
        const Vec3 place = at - (heightOn(g, at) - own) * g.floor, torque = (g.height - own) * g.floor.cross(force);
        dBodyAddForceAtPos(body.id, force.x(), force.y(), force.z(), place.x(), place.y(), place.z());
        dBodyAddTorque(bodies[g.heaviest].id, torque.x(), torque.y(), torque.z());
    };
    for (const Push& p : m_pushes) {
        if (p.kind != Kind::Pair) continue;
        const OdeContact& c = contacts[p.contact];
        const Vec3 force = forceOf(p, h);
        give(m_groups[p.first], c.first, vec(c.position), force);
        give(m_groups[p.second], c.second, vec(c.position), -force);
        feedbacks[p.contact] = {};
        Vec3::Map(feedbacks[p.contact].f1) = force;
        Vec3::Map(feedbacks[p.contact].f2) = -force;
    }
    for (Group& g : m_groups) {
        findTip(g, h);
        const Vec3 against = (std::min(1.0, kStanding * standing(g)) - 1) * g.floor.cross(g.tip);
        dBodyAddTorque(bodies[g.heaviest].id, against.x(), against.y(), against.z());
    }
}

double HeapForces::heightOn(const Group& g, const Vec3& at) { return g.floor.dot(at - g.centre); }

/// All that pushes a group does so at one height, since how a push is spread over the height of a contact is not known: the mean of
/// theirs, or that of an axle whose wheel touches a wall. Its walls are taken to hold it there.
void HeapForces::findHeights(double h, std::span<OdeContact> contacts, std::span<const OdeBody> bodies,
                             std::span<const OdeGeom> geoms) {
    const auto add = [](Group& g, const Vec3& at, const Vec3& force) {
        g.pushing += force;
        g.load += force.norm();
        if (g.load > 0) g.height += force.norm() / g.load * (heightOn(g, at) - g.height);
    };
    const Vec3 up = -m_settings.gravity.normalized();
    m_feet.clear();
    for (const Push& p : m_pushes) {
        const Vec3 at = vec(contacts[p.contact].position), force = forceOf(p, h);
        Group& g = m_groups[p.first];
        if (p.kind == Kind::Wall) g.walled = true;
        if (p.kind == Kind::Floor) {
            m_feet.push_back({at - g.centre, force, p.friction / h, g.feet});
            g.feet = static_cast<std::uint32_t>(m_feet.size() - 1);
        }
        if (p.kind != Kind::Pair) continue;
        add(g, at, force);
        add(m_groups[p.second], at, -force);
    }
    for (const Push& p : m_pushes) {
        const std::uint32_t body = geoms[contacts[p.contact].first].body;
        if (p.kind == Kind::Wall && body != m_groups[p.first].heaviest)
            m_groups[p.first].height = heightOn(m_groups[p.first], vec(bodies[body].p));
    }
    for (const Push& p : m_pushes) {
        OdeContact& c = contacts[p.contact];
        if (p.kind != Kind::Wall) continue;
        const Group& g = m_groups[p.first];
        c.raised = (g.height - heightOn(g, vec(c.position))) / g.floor.dot(up);
    }
}

/// What all forces do to it: the floor's grip is what its rows found and what else moved the group. Walls take what the floor does not.
void HeapForces::findTip(Group& g, double h) const {
    double most = 0, feet = 0, low = 0;
    Vec3 grip = g.mass * (g.pushed / h - m_settings.gravity + m_settings.gravity.dot(g.floor) * g.floor);
    for (std::uint32_t i = g.feet; i != kNone; i = m_feet[i].next) {
        grip += m_feet[i].force;
        most += m_feet[i].most;
        low += (m_feet[i].arm.dot(g.floor) - low) / ++feet;
    }
    if (grip.norm() > most) grip *= most / grip.norm();
    g.tip = low * grip + g.height * (g.walled ? Vec3(-grip) : g.pushing);
}

/// How much of `tip` would lift it: where the floor's load would have to act is beyond the line between any two of its contacts.
double HeapForces::standing(const Group& g) const {
    const double weight = -g.mass * m_settings.gravity.dot(g.floor);
    const Vec3 way = g.tip / weight;
    const auto beside = [&](const Vec3& arm) { return g.floor.dot(way.cross(arm)); };
    double most = 0;
    for (std::uint32_t a = g.feet; a != kNone; a = m_feet[a].next)
        for (std::uint32_t b = m_feet[a].next; b != kNone; b = m_feet[b].next) {
            const double left = beside(m_feet[a].arm), right = beside(m_feet[b].arm);
            if (left * right > 0 || left == right) continue;
            const Vec3 between = (left * m_feet[b].arm - right * m_feet[a].arm) / (left - right);
            most = std::max(most, way.dot(between) / way.squaredNorm());
        }
    return most;
}

void HeapForces::gather(std::span<OdeContact> contacts, std::span<const OdeBody> bodies, std::span<const OdeGeom> geoms,
                        const BodyClusters& clusters) {
    m_pushes.clear();
    m_groups.clear();
    m_names.clear();
    m_indexOf.assign(bodies.size(), kNone);
    m_expected.resize(bodies.size());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!contacts[i].outside) continue;
        Push& push = m_pushes.emplace_back();
        push.contact = i;
        push.first = groupIndex(clusters.groupOf(geoms[contacts[i].first].body));
        push.second = groupIndex(clusters.groupOf(geoms[contacts[i].second].body));
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) { // what holds them
        OdeContact& c = contacts[i];
        const std::uint32_t index = m_indexOf[clusters.groupOf(geoms[c.first].body)];
        if (geoms[c.second].body != kNone || index == kNone) continue;
        const double up = -vec(c.normal).dot(m_settings.gravity.normalized());
        if (up > kFloor) m_groups[index].floor += vec(c.normal);
        c.level = up <= kFloor;
        Push& push = m_pushes.emplace_back();
        push.contact = i;
        push.kind = up > kFloor ? Kind::Floor : Kind::Wall;
        push.first = index;
    }
}

void HeapForces::measure(std::span<const OdeBody> bodies, const BodyClusters& clusters) {
    for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
        Group& g = m_groups[i];
        g.floor = g.floor.squaredNorm() > 0 ? g.floor.normalized() : Vec3(-m_settings.gravity.normalized());
        Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();
        double heaviest = 0;
        const auto each = [&](const auto& use) { // a group is part of an actor, whose bodies follow each other
            const std::uint32_t actor = bodies[m_names[i]].actor;
            for (std::uint32_t b = m_names[i]; b < bodies.size() && bodies[b].actor == actor; ++b)
                if (clusters.groupOf(b) == m_names[i]) use(bodies[b], b);
        };
        each([&](const OdeBody& b, std::uint32_t index) {
            dMass mass;
            dBodyGetMass(b.id, &mass);
            g.mass += mass.mass;
            if (mass.mass > heaviest) {
                heaviest = mass.mass;
                g.heaviest = index;
            }
            g.centre += mass.mass * vec(b.p);
            momentum += mass.mass * vec(b.v);
        });
        g.centre /= g.mass;
        g.velocity = momentum / g.mass;
        each([&](const OdeBody& b, std::uint32_t) {
            dMass mass;
            dBodyGetMass(b.id, &mass);
            const Vec3 axis = turnBack(b.r, g.floor), arm = vec(b.p) - g.centre, spun = turn(mass.I, axis);
            g.inertia += axis.dot(spun) + mass.mass * g.floor.cross(arm).squaredNorm();
            spin += turn(b.r, turn(mass.I, turnBack(b.r, vec(b.w)))) + mass.mass * arm.cross(vec(b.v));
        });
        g.turn = spin.dot(g.floor) / g.inertia;
    }
}

HeapForces::Row HeapForces::rowOf(const Push& push, const Vec3& at, const Vec3& way) const {
    const auto armOf = [&](const Group& g) { return g.floor.dot((at - g.centre).cross(way)); };
    const Group& a = m_groups[push.first];
    Row row{way, armOf(a), 0, 0, 0};
    double give = 1 / a.mass + row.firstArm * row.firstArm / a.inertia;
    if (push.kind == Kind::Pair) {
        const Group& b = m_groups[push.second];
        row.secondArm = armOf(b);
        give += 1 / b.mass + row.secondArm * row.secondArm / b.inertia;
    }
    row.mass = 1 / give;
    return row;
}

void HeapForces::prepare(Push& push, const OdeContact& c, std::span<const OdeGeom> geoms, double h) {
    const SurfaceSpec &s1 = m_settings.surfaces[geoms[c.first].surface], &s2 = m_settings.surfaces[geoms[c.second].surface];
    push.friction = std::min(s1.friction, s2.friction);
    if (push.kind == Kind::Floor) return prepareFloor(push, c, h);
    Vec3 up = m_groups[push.first].floor;
    if (push.kind == Kind::Pair) up = (up + m_groups[push.second].floor).normalized();
    const Vec3 at = vec(c.position), normal = vec(c.normal), way = (normal - normal.dot(up) * up).normalized();
    push.normal = rowOf(push, at, way);
    push.across = rowOf(push, at, up.cross(way));
    push.target = std::min(kClosing * (c.depth - kRest) / h, kCorrectingSpeed);
    const double closing = -speed(push, push.normal), restitution = std::max(s1.restitution, s2.restitution);
    if (restitution > 0 && closing > kBounceSpeed) push.target = std::max(push.target, restitution * closing);
    push.normal.impulse = h * c.load;
    push.across.impulse = h * push.across.way.dot(Vec3::Map(c.grip));
}

void HeapForces::prepareFloor(Push& push, const OdeContact& c, double h) {
    const Vec3 normal = vec(c.normal), slide = vec(c.slide);
    push.rolls = slide.squaredNorm() > 0;
    push.friction *= h * c.load;
    const Vec3 along = push.rolls ? Vec3((slide - slide.dot(normal) * normal).normalized()) : normal.unitOrthogonal();
    push.normal = rowOf(push, vec(c.position), normal.cross(along));
    push.across = rowOf(push, vec(c.position), along);
    push.normal.impulse = h * push.normal.way.dot(Vec3::Map(c.grip));
    push.across.impulse = push.rolls ? 0 : h * push.across.way.dot(Vec3::Map(c.grip));
}

/// What else accelerates a group will do so again: what it has done beyond its contacts. Where that is not known, all that presses
/// steadily is at rest, and nothing else presses.
void HeapForces::expectOthers(std::span<const OdeContact> contacts) {
    m_before = m_groups;
    const auto isKnown = [&](std::uint32_t group) { return m_expected[m_names[group]].tick + 1 == m_tick; };
    for (Push& push : m_pushes) {
        const OdeContact& c = contacts[push.contact];
        const bool known = isKnown(push.first) && (push.kind != Kind::Pair || isKnown(push.second)),
                   steady = c.load > kSteadyLoad * c.earlier && kSteadyLoad * c.load < c.earlier;
        if (push.kind == Kind::Pair && !known && !steady) push.normal.impulse = push.across.impulse = 0;
        give(push, push.normal, push.normal.impulse);
        give(push, push.across, push.across.impulse);
    }
    for (std::uint32_t i = 0; i < m_groups.size(); ++i) {
        Group& g = m_groups[i];
        const Group& old = m_before[i];
        const Expected& expected = m_expected[m_names[i]];
        if (isKnown(i)) {
            g.pushed = old.velocity - expected.velocity;
            g.twisted = old.turn - expected.turn;
        } else {
            g.pushed = old.velocity - g.velocity;
            g.twisted = old.turn - g.turn;
        }
        g.velocity += g.pushed;
        g.turn += g.twisted;
    }
}

void HeapForces::give(const Push& push, const Row& row, double impulse) {
    Group& a = m_groups[push.first];
    a.velocity += impulse / a.mass * row.way;
    a.turn += row.firstArm * impulse / a.inertia;
    if (push.kind != Kind::Pair) return;
    Group& b = m_groups[push.second];
    b.velocity -= impulse / b.mass * row.way;
    b.turn -= row.secondArm * impulse / b.inertia;
}

double HeapForces::speed(const Push& push, const Row& row) const {
    const Group& a = m_groups[push.first];
    const double own = row.way.dot(a.velocity) + row.firstArm * a.turn;
    if (push.kind != Kind::Pair) return own;
    const Group& b = m_groups[push.second];
    return own - row.way.dot(b.velocity) - row.secondArm * b.turn;
}

void HeapForces::bring(const Push& push, Row& row, double impulse) {
    give(push, row, impulse - row.impulse);
    row.impulse = impulse;
}

void HeapForces::solve(Push& push) {
    Row &normal = push.normal, &across = push.across;
    const double stop = normal.impulse + kRelaxed * normal.mass * (push.target - speed(push, normal));
    const bool floor = push.kind == Kind::Floor;
    bring(push, normal, floor ? std::clamp(stop, -push.friction, push.friction) : std::max(0.0, stop));
    if (push.rolls) return;
    const double most = floor ? push.friction : push.friction * normal.impulse;
    bring(push, across, std::clamp(across.impulse - across.mass * speed(push, across), -most, most));
}

} // namespace trundle
