#include "world/wheeled/actor_shape.h"

#include <algorithm>
#include <cmath>

#include "world/wheeled/loads_at_rest.h"

namespace trundle {

namespace {

constexpr double kStiffness = 2e5; // N/m, as the general engine's
constexpr double kDamping = 1100;  // N s/m
constexpr double kMostSag = 1e-4;  // m, under an actor's own weight
constexpr double kLeastShare = 3;  // supports that share it
constexpr double kSlick = 1e-9;
constexpr const char* kCanRoll = "can roll and is no ball of its own";
constexpr const char* kIsCaster = "is a Sphere on the ground, which is a caster only of a robot with wheels";

const char* nameOf(JointType type) {
    switch (type) {
    case JointType::Hinge: return "the Hinge";
    case JointType::Slider: return "the Slider";
    case JointType::Ball: return "the Ball";
    case JointType::Universal: return "the Universal";
    case JointType::Fixed: return "the Fixed";
    case JointType::Suspension: return "the Suspension";
    }
    return "the joint";
}

bool canRoll(const GeomSpec& geom, const PlanarShape& footprint) {
    return geom.shape == GeomShape::Sphere || geom.shape == GeomShape::Capsule ||
           (geom.shape == GeomShape::Cylinder && !footprint.isCircle());
}

/// A convex shape, counter-clockwise.
bool isAroundOrigin(const std::vector<Vec2>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], side = corners[(i + 1) % corners.size()] - a;
        if (side.x() * a.y() - side.y() * a.x() > kTouching * side.norm()) return false;
    }
    return corners.size() > 2;
}

/// Whether the centre of mass is beyond the line through two of them, with all others on its other side.
bool isBesideCentre(std::span<const Support> supports) {
    for (const Support& a : supports)
        for (const Support& b : supports) {
            const Vec2 from = a.centre.head<2>(), way = b.centre.head<2>() - from;
            if (way.norm() < kOnGround) continue;
            const auto side = [&](const Vec2& p) { return way.x() * (p.y() - from.y()) - way.y() * (p.x() - from.x()); };
            const bool outside = side(Vec2::Zero()) < 0 && std::ranges::all_of(supports, [&](const Support& s) {
                                     return side(s.centre.head<2>()) > -1e-9;
                                 });
            if (outside) return true;
        }
    return false;
}

} // namespace

bool hasTwoFrictions(const SurfaceSpec& surface) { return surface.friction2 && *surface.friction2 != surface.friction; }

double lowestOf(const ActorDef& actor) {
    double lowest = 1e300;
    for (const BodyDef& body : actor.bodies)
        for (const GeomSpec& geom : body.spec->geoms) {
            if (!geom.collide) continue;
            if (const auto shape = planarShapeOf(geom, body.pose * geom.pose)) lowest = std::min(lowest, shape.value().low);
        }
    return lowest;
}

bool ActorReader::refuse(std::string reason, SourceRange range) {
    if (m_why->reason.empty()) *m_why = {std::move(reason), range};
    return false;
}

Pose ActorReader::inActor(std::uint32_t index) const { return m_actor->frame.inverse() * m_actor->bodies[index].pose; }

std::shared_ptr<const ActorShape> ActorReader::read(const ActorDef& actor, NotWheeled& why) {
    m_actor = &actor;
    m_why = &why;
    m_anchored = false;
    why = {};
    m_shape = std::make_shared<ActorShape>();
    const bool upright = actor.frame.rotation.toRotationMatrix()(2, 2) > 1 - kLevelAxis;
    if (!upright && !refuse("it is not upright at the start", {})) return nullptr;
    if (!findRoles()) return nullptr;
    addMasses();
    if (!addFootprints()) return nullptr;
    setStiffness();
    if (m_anchored) m_shape->kind = ActorKind::Fixed;
    else if (m_shape->wheels.empty() && std::ranges::find(m_roles, Role::Caster) == m_roles.end()) {
        if (!readLoose()) return nullptr;
    } else {
        m_shape->kind = ActorKind::Vehicle;
        if (!addSupports() || !standsOnSupports()) return nullptr;
    }
    return m_shape;
}

/// Which bodies are one with the first one, which are its wheels and casters.
bool ActorReader::findRoles() {
    m_roles.assign(m_actor->bodies.size(), Role::Unknown);
    if (m_actor->springs && !m_actor->springs->empty()) {
        const SpringSpec& spring = m_actor->springs->front();
        return refuse(named("the Spring", spring.name, "joins bodies"), spring.nameRange);
    }
    if (m_actor->gears && !m_actor->gears->empty()) {
        const GearSpec& gear = m_actor->gears->front();
        return refuse(named("the Gear", gear.name, "joins joints"), gear.nameRange);
    }
    if (m_actor->joints)
        for (std::uint32_t j = 0; j < m_actor->joints->size(); ++j)
            if (!readJoint(j)) return false;
    return isWhole();
}

bool ActorReader::readJoint(std::uint32_t index) {
    const JointSpec& joint = (*m_actor->joints)[index];
    const auto child = static_cast<std::size_t>(joint.child);
    if (joint.type == JointType::Fixed) {
        if (joint.parent == kWorldBody) m_anchored = true;
        return true;
    }
    const bool free = m_roles[child] == Role::Unknown && joint.parent != kWorldBody;
    if (free && joint.type == JointType::Hinge && isWheel(joint)) {
        m_roles[child] = Role::Wheel;
        m_shape->wheels.push_back({index, static_cast<std::uint32_t>(joint.child), joint.axis, Vec3::Zero(), 0, joint.damping});
        return true;
    }
    if (free && joint.type == JointType::Ball && isCaster(joint)) {
        m_roles[child] = Role::Caster;
        return true;
    }
    return refuse(named(nameOf(joint.type), joint.name, "is not the axle of a wheel on the ground"), joint.nameRange);
}

/// Every other body is fixed to the first one.
bool ActorReader::isWhole() {
    m_roles[0] = m_roles[0] == Role::Unknown ? Role::Rigid : m_roles[0];
    const auto first = std::ranges::find(m_roles, Role::Unknown);
    if (m_roles[0] != Role::Rigid && first != m_roles.end()) *first = Role::Rigid;
    for (bool more = true; more && m_actor->joints;) {
        more = false;
        for (const JointSpec& joint : *m_actor->joints) {
            if (joint.type != JointType::Fixed || joint.parent == kWorldBody) continue;
            Role& a = m_roles[static_cast<std::size_t>(joint.parent)];
            Role& b = m_roles[static_cast<std::size_t>(joint.child)];
            if ((a == Role::Rigid) == (b == Role::Rigid)) continue;
            Role& other = a == Role::Rigid ? b : a;
            if (other != Role::Unknown) continue;
            other = Role::Rigid;
            more = true;
        }
    }
    for (std::uint32_t i = 0; i < m_roles.size(); ++i)
        if (m_roles[i] == Role::Unknown)
            return refuse(named("body", body(i).name, "is not fixed to the rest"), body(i).nameRange);
    return areJointsOfRigid();
}

/// No joint hangs on a wheel, none holds one beside its axle, and what is fixed to the world has none.
bool ActorReader::areJointsOfRigid() {
    const auto isRigid = [this](int index) {
        return index == kWorldBody || m_roles[static_cast<std::size_t>(index)] == Role::Rigid;
    };
    if (!m_actor->joints) return true;
    for (const JointSpec& joint : *m_actor->joints) {
        if (!isRigid(joint.parent))
            return refuse(named(nameOf(joint.type), joint.name, "has a wheel for its parent"), joint.nameRange);
        if (joint.type == JointType::Fixed && !isRigid(joint.child))
            return refuse(named(nameOf(joint.type), joint.name, "holds a wheel"), joint.nameRange);
        if (m_anchored && joint.type == JointType::Hinge)
            return refuse(named("wheel", body(static_cast<std::uint32_t>(joint.child)).name,
                                "is on a robot that is Fixed to the world: it would not turn"),
                          joint.nameRange);
    }
    return true;
}

void ActorReader::addMasses() {
    ActorShape& s = *m_shape;
    for (std::uint32_t i = 0; i < m_roles.size(); ++i) {
        s.bodies.push_back(inActor(i));
        s.isTurned.push_back(s.bodies.back().rotation.coeffs() != Quat::Identity().coeffs());
        s.bodyCentres.push_back(body(i).mass.centre);
        s.mass += body(i).mass.mass;
        s.centre += body(i).mass.mass * (s.bodies[i] * body(i).mass.centre);
    }
    s.centre /= s.mass;
    s.inertia = Mat3::Zero();
    for (std::uint32_t i = 0; i < m_roles.size(); ++i) {
        const Mat3 axes = s.bodies[i].rotation.toRotationMatrix();
        const Vec3 arm = s.bodies[i] * body(i).mass.centre - s.centre;
        Mat3 own = axes * body(i).mass.inertia * axes.transpose();
        if (m_roles[i] == Role::Caster) own.setZero(); // it does not turn with the rest
        s.inertia += own + body(i).mass.mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
        s.bodies[i].position -= s.centre;
    }
    for (WheelShape& wheel : s.wheels) {
        const Vec3 axis = s.bodies[wheel.body].rotation.conjugate() * wheel.axis;
        const Vec3 from = s.bodies[wheel.body].position + s.centre - (*m_actor->joints)[wheel.joint].anchor;
        wheel.offset = from - from.dot(wheel.axis) * wheel.axis;
        wheel.inertia = axis.dot(body(wheel.body).mass.inertia * axis);
    }
}

bool ActorReader::addFootprints() {
    ActorShape& s = *m_shape;
    for (std::uint32_t i = 0; i < m_roles.size(); ++i) {
        std::uint32_t count = 0;
        for (const GeomSpec& geom : body(i).geoms) {
            if (!geom.collide) continue;
            if (m_roles[i] != Role::Wheel && hasTwoFrictions(m_surfaces[geom.surface]))
                return refuse(named("geom", geom.name, kTwoFrictions), geom.nameRange);
            auto made = planarShapeOf(geom, s.bodies[i] * geom.pose);
            if (!made) return refuse(named("geom", geom.name, "has no footprint"), geom.nameRange);
            const PlanarShape& f = made.value();
            s.bound = std::max(s.bound, f.centre.norm() + f.bound);
            s.tall = std::max({s.tall, std::abs(f.low), std::abs(f.high)});
            s.footprints.push_back(std::move(made).value());
            s.footprintBody.push_back(i);
            ++count;
        }
        s.geomCounts.push_back(count);
    }
    return true;
}

/// Height over the ground at the start.
double ActorReader::bottom(const PlanarShape& footprint) const {
    return m_actor->frame.position.z() + m_shape->centre.z() + footprint.low - m_ground.height;
}

bool ActorReader::addSupports() {
    for (std::uint32_t w = 0; w < m_shape->wheels.size(); ++w)
        if (!addWheel((*m_actor->joints)[m_shape->wheels[w].joint], w)) return false;
    std::uint32_t geom = 0;
    for (std::uint32_t i = 0; i < m_roles.size(); ++i)
        for (const GeomSpec& spec : body(i).geoms) {
            if (!spec.collide) continue;
            const std::uint32_t index = geom++;
            if (m_roles[i] == Role::Wheel || bottom(m_shape->footprints[index]) > kOnGround) continue;
            if (spec.shape != GeomShape::Sphere)
                return refuse(named("geom", spec.name, "slides on the ground; only a Sphere can"), spec.nameRange);
            addSlider(i, index, spec, m_shape->bodies[i] * spec.pose.position);
        }
    return true;
}

bool ActorReader::addWheel(const JointSpec& joint, std::uint32_t index) {
    const WheelShape& wheel = m_shape->wheels[index];
    const GeomSpec& geom = *onlyGeom(body(wheel.body));
    const SurfaceSpec& own = m_surfaces[geom.surface];
    Support s;
    s.body = wheel.body;
    for (std::uint32_t i = 0; i < wheel.body; ++i) s.geom += m_shape->geomCounts[i];
    s.centre = m_shape->bodies[wheel.body] * geom.pose.position;
    s.radius = geom.radius;
    s.surface = geom.surface;
    s.wheel = index;
    const Vec2 rolls(wheel.axis.y(), -wheel.axis.x()); // axis x up
    s.way = rolls;
    if (hasRollingFriction(geom)) return refuse(named("wheel", body(wheel.body).name, "has rolling friction"), joint.nameRange);
    if (own.friction2) {
        if (*own.friction2 > kSlick)
            return refuse(named("wheel", body(wheel.body).name, "has a Friction2 other than 0"), joint.nameRange);
        s.round = false;
        const double c = std::cos(own.frictionHeading), t = std::sin(own.frictionHeading);
        s.way = {c * rolls.x() - t * rolls.y(), t * rolls.x() + c * rolls.y()};
    }
    s.lever = s.radius * s.way.dot(rolls);
    m_shape->supports.push_back(s);
    return true;
}

/// Or a ball that turns freely.
void ActorReader::addSlider(std::uint32_t index, std::uint32_t geom, const GeomSpec& spec, const Vec3& centre) {
    Support s;
    s.body = index;
    s.geom = geom;
    s.centre = centre;
    s.radius = spec.radius;
    s.surface = spec.surface;
    if (m_roles[index] == Role::Caster) s.rolling = body(index).mass.inertia.trace() / 3 / (spec.radius * spec.radius);
    m_shape->supports.push_back(s);
}

/// The centre of mass is inside what the supports span.
bool ActorReader::standsOnSupports() {
    const std::vector<Support>& supports = m_shape->supports;
    if (supports.size() > kMostSupports) return refuse("it has more than 24 wheels and casters", {});
    const SourceRange range = body(0).nameRange;
    if (supports.size() < 3) return refuse("it needs at least three wheels and casters on the ground", range);
    return !isBesideCentre(supports) || refuse("its centre of mass is not between its wheels and casters: it tips over", range);
}

/// A box, a cylinder on its end or a ball, or several that are one body.
bool ActorReader::readLoose() {
    ActorShape& s = *m_shape;
    s.kind = ActorKind::Loose;
    if (s.footprints.empty()) return refuse(named("body", body(0).name, "has nothing that collides"), body(0).nameRange);
    const auto lowest = std::ranges::min_element(s.footprints, {}, &PlanarShape::low);
    const PlanarShape& base = *lowest;
    if (std::abs(bottom(base)) > kOnGround)
        return refuse(named("body", body(0).name, "is not on the ground at the start"), body(0).nameRange);
    s.surface = base.surface;
    const GeomSpec* only = s.bodies.size() == 1 ? onlyGeom(body(0)) : nullptr;
    if (only && only->shape == GeomShape::Sphere) {
        if ((body(0).mass.centre - only->pose.position).norm() > kTouching)
            return refuse(named("body", body(0).name, "is a ball whose centre of mass is not its middle"), body(0).nameRange);
        s.kind = ActorKind::Ball;
        s.spinRadius = only->radius;
        return true;
    }
    for (std::size_t i = 0; i < s.footprints.size(); ++i) {
        const bool flat = s.footprints[i].low < base.low + kTouching;
        const std::uint32_t owner = s.footprintBody[i];
        std::uint32_t k = static_cast<std::uint32_t>(i);
        for (std::uint32_t b = 0; b < owner; ++b) k -= s.geomCounts[b];
        for (const GeomSpec& geom : body(owner).geoms) {
            if (!geom.collide || k-- != 0) continue;
            if (flat && canRoll(geom, s.footprints[i]))
                return refuse(named("geom", geom.name, geom.shape == GeomShape::Sphere ? kIsCaster : kCanRoll), geom.nameRange);
        }
    }
    return restsOnBase(base.low);
}

/// The centre of mass is above what is lowest of it: more than an edge or a corner. Friction's lever is that of the same points.
bool ActorReader::restsOnBase(double low) {
    std::vector<Vec2> points;
    for (std::uint32_t i = 0; i < m_roles.size(); ++i)
        for (const GeomSpec& geom : body(i).geoms)
            if (geom.collide) addPointsBelow(geom, m_shape->bodies[i] * geom.pose, low + kTouching, points);
    m_shape->spinRadius = turningLever(points);
    if (isAroundOrigin(convexHullOf(std::move(points)))) return true;
    return refuse(named("body", body(0).name, "does not rest on a side below its centre of mass: it tips over"),
                  body(0).nameRange);
}

/// As the general engine's: nothing sags by more than kMostSag under its weight.
void ActorReader::setStiffness() {
    m_shape->stiffness = std::max(kStiffness, m_shape->mass * 9.81 / (kLeastShare * kMostSag));
    m_shape->damping = kDamping * m_shape->stiffness / kStiffness;
}

} // namespace trundle
