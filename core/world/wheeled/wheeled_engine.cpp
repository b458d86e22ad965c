#include "world/wheeled/wheeled_engine.h"

#include <algorithm>
#include <cmath>

#include "world/wheeled/vehicle_blocks.h"
#include "world/wheeled/wheeled.h"
#include "world/wheeled/wheeled_motion.h"

namespace trundle {

namespace {

constexpr std::string_view kLeavesGround = "it leaves the ground", kLeans = "it leans by more than 20 degrees";
constexpr double kFarthest = 1e5;        // m
constexpr double kFastest = 200;  // m/s
constexpr double kFastestTurn = 1e4;
constexpr double kLeastUpright = 0.94; // cosine of 20 degrees: a robot that is bumped may lift a wheel for a moment

} // namespace

Result<std::unique_ptr<Engine>> makeWheeledEngine(const EngineSettings& settings, bool planar, std::optional<double> ground) {
    return std::unique_ptr<Engine>(std::make_unique<WheeledEngine>(settings, planar, ground));
}

WheeledEngine::WheeledEngine(EngineSettings settings, bool planar, std::optional<double> ground)
    : m_settings(std::move(settings)), m_groundHeight(ground), m_team(m_settings.threads) {
    m_objects.planar = planar;
    m_objects.surfaces = m_settings.surfaces;
    m_objects.weight = -m_settings.gravity.z();
    m_objects.tilt = m_settings.gravity.head<2>() / m_objects.weight;
}

Result<GeomHandle> WheeledEngine::addStatic(const GeomSpec& geom, const Pose& pose) {
    const auto index = static_cast<std::uint32_t>(m_objects.geoms.size());
    m_grounds.add(index, geom, pose);
    m_objects.geoms.push_back({kNoGeom, rayGeomOf(geom, pose, kNoGeom)});
    m_objects.aloft.push_back(kNoActor);
    if (geom.shape != GeomShape::Plane)
        if (auto footprint = planarShapeOf(geom, pose)) m_objects.scenery.push_back({std::move(footprint).value(), index});
    m_rays.markMoved();
    return GeomHandle{index};
}

std::shared_ptr<const ActorShape> WheeledEngine::shapeOf(const ActorDef& actor, NotWheeled& why) {
    const double height = actor.frame.position.z();
    const void* bodies = actor.bodies[0].spec;
    for (const KnownShape& known : m_shapes)
        if (known.bodies == bodies && known.joints == actor.joints && known.height == height) return known.shape;
    auto shape = ActorReader(m_objects.surfaces, *m_objects.ground).read(actor, why);
    if (!shape) return shape;
    m_shapes.push_back({bodies, actor.joints, height, shape});
    m_objects.models.push_back(vehicleModel(*shape, m_objects));
    return shape;
}

Result<ActorHandles> WheeledEngine::addActor(const ActorDef& actor) {
    if (!m_objects.ground)
        m_objects.ground =
            m_groundHeight ? m_grounds.at(*m_groundHeight) : m_grounds.under(lowestOf(actor), actor.frame.position.head<2>());
    if (!m_objects.ground) return Error{Code::NotInEngine, "there is no level ground below it"};
    if (m_objects.units.empty()) { // what is the ground, or in it, is nothing to run into
        const double height = m_objects.ground->height + 1e-4;
        std::erase_if(m_objects.scenery, [&](const WheeledScenery& s) { return s.footprint.high <= height; });
    }
    NotWheeled why;
    auto shape = shapeOf(actor, why);
    if (!shape) return Error{Code::NotInEngine, why.reason};
    m_rays.markMoved();
    return addUnit(actor, std::move(shape));
}

ActorHandles WheeledEngine::addUnit(const ActorDef& actor, std::shared_ptr<const ActorShape> shape) {
    ActorHandles handles;
    const auto index = static_cast<std::uint32_t>(m_objects.units.size());
    handles.actor = {index};
    WheeledUnit unit;
    unit.position = actor.frame * shape->centre;
    unit.rotation = actor.frame.rotation;
    unit.bodies = static_cast<std::uint32_t>(m_objects.states.size());
    unit.geoms = static_cast<std::uint32_t>(m_objects.geoms.size());
    unit.joints = static_cast<std::uint32_t>(m_objects.wheelOf.size());
    unit.supports = static_cast<std::uint32_t>(m_objects.supports.size());
    unit.wheels = static_cast<std::uint32_t>(m_objects.wheels.size());
    m_objects.supports.resize(unit.supports + shape->supports.size());
    unit.model = static_cast<std::uint32_t>(std::ranges::find(m_shapes, shape, &KnownShape::shape) - m_shapes.begin());
    unit.shape = std::move(shape);
    unit.setPlane();
    setDown(unit);
    m_objects.units.push_back(std::move(unit));
    addGeoms(actor, handles);
    markAloft(m_objects.units.back());
    addWheels(actor, handles);
    publishStates(m_objects, index);
    return handles;
}

void WheeledEngine::addGeoms(const ActorDef& actor, ActorHandles& handles) {
    for (const BodyDef& body : actor.bodies) {
        const auto index = static_cast<std::uint32_t>(m_objects.states.size());
        handles.bodies.push_back({index});
        m_objects.states.emplace_back();
        m_objects.unitOf.push_back(handles.actor.index);
        auto& geoms = handles.geoms.emplace_back();
        for (const GeomSpec& geom : body.spec->geoms) {
            geoms.push_back(geom.collide ? GeomHandle{static_cast<std::uint32_t>(m_objects.geoms.size())} : GeomHandle{});
            if (geom.collide) m_objects.geoms.push_back({index, rayGeomOf(geom, geom.pose, handles.actor.index)});
        }
    }
}

void WheeledEngine::markAloft(const WheeledUnit& unit) {
    const auto index = static_cast<std::uint32_t>(m_objects.units.size() - 1);
    m_objects.aloft.resize(m_objects.geoms.size(), unit.isVehicle() ? index : kNoActor);
    for (const Support& s : unit.shape->supports) m_objects.aloft[unit.geoms + s.geom] = kNoActor;
}

void WheeledEngine::addWheels(const ActorDef& actor, ActorHandles& handles) {
    const std::uint32_t first = m_objects.units.back().wheels;
    const auto& wheels = m_objects.units.back().shape->wheels;
    for (const WheelShape& wheel : wheels) {
        WheelState state;
        state.inertia = state.carried = wheel.inertia;
        m_objects.wheels.push_back(state);
    }
    if (!actor.joints) return;
    for (std::uint32_t j = 0; j < actor.joints->size(); ++j) {
        const auto wheel = std::ranges::find(wheels, j, &WheelShape::joint);
        handles.joints.push_back({static_cast<std::uint32_t>(m_objects.wheelOf.size())});
        m_objects.wheelOf.push_back(wheel == wheels.end() ? kNoGeom : first + static_cast<std::uint32_t>(wheel - wheels.begin()));
    }
}

void WheeledEngine::setMotor(JointHandle joint, const MotorConstraint& row) {
    if (const std::uint32_t wheel = m_objects.wheelOf[joint.index]; wheel != kNoGeom) m_objects.wheels[wheel].motor = row;
}

void WheeledEngine::addJointTorque(JointHandle joint, double torque) {
    if (const std::uint32_t wheel = m_objects.wheelOf[joint.index]; wheel != kNoGeom) m_objects.wheels[wheel].torque += torque;
}

void WheeledEngine::addForce(BodyHandle body, const Vec3& force, const Vec3& point) {
    WheeledUnit& unit = m_objects.units[m_objects.unitOf[body.index]];
    unit.force += force;
    unit.moment += (point - unit.position).cross(force);
}

void WheeledEngine::setSurfaceVelocity(GeomHandle, const Vec3& velocity) {
    if (!velocity.isZero(0))
        m_fault = EngineFault{{}, "a surface moves by itself, which " + m_objects.engineName() + " does not have; use general"};
}

void WheeledEngine::setSurface(std::size_t surface, const SurfaceSpec& values) {
    if (surface >= m_objects.surfaces.size()) return;
    m_objects.surfaces[surface] = values;
    for (std::size_t i = 0; i < m_shapes.size(); ++i) m_objects.models[i] = vehicleModel(*m_shapes[i].shape, m_objects);
}

Status WheeledEngine::addRotor(JointHandle joint, double inertia, double ratio) {
    const std::uint32_t wheel = m_objects.wheelOf[joint.index];
    if (wheel == kNoGeom) return Error{Code::NotInEngine, "its joint turns no wheel"};
    m_objects.wheels[wheel].inertia += ratio * ratio * inertia;
    m_objects.wheels[wheel].carried += ratio * inertia;
    return {};
}

Status WheeledEngine::measureWrench(JointHandle) { return Error{Code::NotInEngine, "it has no forces in joints"}; }

void WheeledEngine::findContacts() {
    m_contacts.find();
    m_list.clear(1);
}

std::optional<EngineFault> WheeledEngine::step(double h) {
    if (m_fault) return m_fault;
    applyMotions();
    m_contacts.find();
    m_solver.step(m_settings.gravity, h);
    m_joints.resize(m_objects.wheelOf.size());
    m_faulty.resize(m_team.size());
    m_team.split(m_objects.units.size(), kUnitsOfThread, [this, h](unsigned worker, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (!finish(static_cast<std::uint32_t>(i), h)) m_faulty[worker].push_back(static_cast<std::uint32_t>(i));
    });
    endFaulty(h);
    m_list.clear(h);
    m_rays.markMoved();
    return m_fault;
}

/// A unit's tick is over. False, and nothing is published, where it has a fault.
bool WheeledEngine::finish(std::uint32_t index, double h) {
    WheeledUnit& unit = m_objects.units[index];
    unit.force = unit.moment = Vec3::Zero();
    for (std::size_t i = 0; i < unit.shape->wheels.size(); ++i) m_objects.wheels[unit.wheels + i].torque = 0;
    if (unit.isMovable()) {
        if (!faultOf(unit).empty()) return false;
        publishStates(m_objects, index);
    }
    publishJoints(unit, h);
    return true;
}

/// What was moved is at rest and touches nothing yet.
void WheeledEngine::applyMotions() {
    for (const Motion& m : m_motions) {
        WheeledUnit& unit = m_objects.units[m.unit];
        if (unit.ended) continue;
        unit.position = m.motion * unit.position;
        unit.rotation = (m.motion.rotation * unit.rotation).normalized();
        unit.linear = unit.angular = unit.grip = unit.reaction = Vec3::Zero();
        unit.setPlane();
        setDown(unit);
        for (std::size_t i = 0; i < unit.shape->supports.size(); ++i) m_objects.supports[unit.supports + i] = {};
        for (std::size_t i = 0; i < unit.shape->wheels.size(); ++i) m_objects.wheels[unit.wheels + i].stop();
        m_contacts.forget(m.unit);
        if (unit.shape->kind == ActorKind::Fixed) publishStates(m_objects, m.unit);
    }
    m_motions.clear();
}

/// Empty: it has none.
std::string_view WheeledEngine::faultOf(const WheeledUnit& unit) const {
    const auto within = [](const Vec3& v, double most) { return v.squaredNorm() <= most * most; }; // false for NaN
    const Quat& q = unit.rotation;
    const double up = 1 - 2 * (q.x() * q.x() + q.y() * q.y());
    if (!within(unit.position, kFarthest) || !std::isfinite(up))
        return "it is farther than 100000 m from the origin, or its state is no number";
    if (!within(unit.linear, kFastest)) return "it moves faster than 200 m/s";
    if (!within(unit.angular, kFastestTurn)) return "it turns faster than 10000 rad/s";
    if (!isOverGround(unit)) return kLeavesGround;
    if (unit.shape->kind != ActorKind::Ball && up < kLeastUpright) return kLeans;
    return {};
}

/// With all that carries it; something loose with its centre of mass.
bool WheeledEngine::isOverGround(const WheeledUnit& unit) const {
    const LevelGround& ground = *m_objects.ground;
    const ActorShape& shape = *unit.shape;
    if (ground.isEndless()) return true;
    if (!unit.isVehicle()) return ground.isBelow(unit.position.head<2>());
    if (ground.isBelow(unit.position.head<2>(), shape.bound + shape.tall)) return true; // however it leans
    for (std::size_t i = 0; i < shape.supports.size(); ++i) {
        const Vec3 at = unit.position + unit.rotation * shape.supports[i].centre;
        if (m_objects.supports[unit.supports + i].normal > 0 && !ground.isBelow(at.head<2>(), -kBridged)) return false;
    }
    return true;
}

/// A planar vehicle keeps its height: wherever it is put, it touches the ground.
void WheeledEngine::setDown(WheeledUnit& unit) const {
    if (!m_objects.planar || !unit.isVehicle()) return;
    double low = 1e300;
    for (const Support& s : unit.shape->supports) low = std::min(low, (unit.rotation * s.centre).z() - s.radius);
    const double gap = unit.position.z() + low - m_objects.ground->height;
    if (std::abs(gap) > kTouching) unit.position.z() -= gap;
}

/// They stay as they were published last.
void WheeledEngine::endFaulty(double h) {
    for (std::vector<std::uint32_t>& units : m_faulty) {
        for (const std::uint32_t index : units) {
            WheeledUnit& unit = m_objects.units[index];
            std::string fault(faultOf(unit));
            if (fault == kLeavesGround || fault == kLeans)
                fault += ", which " + m_objects.engineName() + " cannot follow; use Engine = general";
            unit.ended = true;
            m_ended.push_back({{unit.bodies}, std::move(fault)});
            for (std::size_t i = 0; i < unit.shape->bodies.size(); ++i)
                m_objects.states[unit.bodies + i].linear = m_objects.states[unit.bodies + i].angular = Vec3::Zero();
            for (std::size_t i = 0; i < unit.shape->wheels.size(); ++i) m_objects.wheels[unit.wheels + i].stop();
            publishJoints(unit, h);
        }
        units.clear();
    }
}

/// Rigid joints stay at zero.
void WheeledEngine::publishJoints(const WheeledUnit& unit, double h) {
    const auto& shapes = unit.shape->wheels;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const WheelState& wheel = m_objects.wheels[unit.wheels + i];
        m_joints[unit.joints + shapes[i].joint] = {wheel.angle, wheel.spin, 0, 0, wheel.impulse / h, wheel.friction / h};
    }
}

} // namespace trundle
