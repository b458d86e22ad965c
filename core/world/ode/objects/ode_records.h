#pragma once
// What the ODE engine keeps of each thing, in flat arrays; all indices ascend with creation.

#include <cstdint>
#include <memory>
#include <vector>

#include <ode/ode.h>

#include "world/broad_phase.h"
#include "world/engine.h"
#include "world/ode/objects/ode_shapes.h"

namespace trundle {

inline constexpr std::uint32_t kNone = 0xffffffffu;

// Measured, together with the joints' ErrorReduction of 0.8: less lets axles gape in a fast turn.
inline constexpr double kWorldCfm = 1e-9;
inline constexpr double kContactStiffness = 2e5;             ///< N/m
inline constexpr double kContactDamping = 1100;              ///< N s/m
inline constexpr double kMaxSag = 1e-4, kFewestSupports = 3; ///< m, under an actor's own weight, which so many contacts share
inline constexpr double kSuspendedStiffness = 40;            ///< times that, so that the ground gives little beside the springs
inline constexpr double kCorrectingSpeed = 0.1;              ///< m/s
inline constexpr int kParamStep = dParamVel2 - dParamVel;    ///< from one axis of a motor to its next
inline constexpr double kBounceSpeed = 0.05;                 ///< m/s: slower impacts do not bounce

/// A run of indices in an array of something.
struct Run {
    std::uint32_t begin = 0, end = 0;
};

/// What moves; its origin for ODE is the centre of mass.
struct OdeBody {
    dBodyID id = nullptr;
    const dReal *p = nullptr, *r = nullptr, *q = nullptr, *v = nullptr, *w = nullptr; ///< ODE's own memory, fixed for its life
    Vec3 centre = Vec3::Zero();                                                       ///< of mass, in the body's frame
    std::uint32_t actor = 0;
    bool coupled = false; ///< by a spring, gear or latch
    bool latched = false; ///< by a latch
    Run geoms;
    double thin = 1e300, reach = 0; ///< of its geoms: least half extent; farthest point from the centre of mass
    SourceRange range;
};

/// A body as ODE holds it, bit for bit: its setters would re-normalise.
struct RawState {
    dReal p[3], r[12], q[4], v[3], w[3], force[3], torque[3];
};

/// What touches. A wheel is a geom that rolls about the axle of its body's joint.
struct OdeGeom {
    GeomShape shape = GeomShape::Box;
    bool wheel = false, turned = false, moves = false; ///< turned: not in its body's axes; moves: has a surface velocity
    std::uint32_t actor = kNoActor, body = kNone, surface = 0;
    double radius = 0, bound = 0; ///< radius of a height field: how high white is
    Vec3 offset = Vec3::Zero();   ///< from the body's centre of mass, in its axes
    Vec3 half = Vec3::Zero();
    Vec3 axle = Vec3::UnitZ();    ///< of a wheel, in the body's axes
    Mat3 axes = Mat3::Identity(); ///< in the body's axes; of a static in the world's
    Vec3 written = Vec3::Ones();  ///< signs of the axes that the text gives it, along these
    dGeomID id = nullptr;
    std::shared_ptr<ShapeData> data;
    Vec3 surfaceVelocity = Vec3::Zero();
};

/// normal . x = distance, solid below.
struct GroundPlane {
    std::uint32_t geom = 0;
    Vec3 normal = Vec3::UnitZ();
    double distance = 0;
};

/// What is always together, as runs of the arrays.
struct OdeActor {
    Run bodies, geoms, joints, couplings;
    double mass = 0, stiffness = kContactStiffness, damping = kContactDamping; ///< of its contacts
    bool jointed = false;
    bool sprung = false;              ///< has a spring, or is on one
    bool ended = false;               ///< stays where it is and touches nothing (ActorFaults)
    bool isApart = false;             ///< it, or a body of it, does not touch another actor, or a body of one
    std::vector<IndexPair> selfPairs; ///< geoms that may touch each other
};

/// A rotor on a joint's parent, which turns `ratio` times as far against it as the child does, about the joint's axis.
struct OdeRotor {
    double inertia = 0, ratio = 1; ///< kg m^2
    dJointID row = nullptr;
    int axisOf = 0; ///< 0: `axis` is in the child's axes, 1: in the parent's
    Vec3 axis = Vec3::UnitZ();
};

/// First what every tick looks at, then what only some joints have.
struct OdeJoint {
    JointType type = JointType::Hinge;
    bool motorChanged = false, driven = false;
    std::uint32_t order = 0;                 ///< in its actor
    std::uint32_t child = 0, parent = kNone; ///< bodies; kNone: the world
    std::uint32_t feedback = kNone;
    Vec3 childAnchor = Vec3::Zero(), parentAnchor = Vec3::Zero(); ///< in the axes of each, from its centre of mass
    Vec3 childAxis = Vec3::UnitZ(), parentAxis = Vec3::UnitZ();   ///< the axis that `position` is about or along
    Quat start = Quat::Identity();                                ///< child in parent at position 0
    double gapLimit = 0;
    double position = 0, rate = 0, effort = 0;
    MotorConstraint motor;
    dJointID id = nullptr, drive = nullptr;
    dJointID spring = nullptr, friction = nullptr, stop = nullptr, damper = nullptr;
    dJointID losses = nullptr;             ///< dry and viscous friction of the drive
    double frictionEffort = 0;             ///< of these
    double damperRate = 0, damperGive = 0; ///< of a servo's damper in this step; give 0: none
    // Of a motor whose effort is measured, at the start of the step, as its forces are: the axis, and the anchor from the child's centre.
    Vec3 startAxis = Vec3::UnitZ(), startArm = Vec3::Zero();
    double lowStop = 0, highStop = 0; ///< of a ball: how far `childAxis` tilts from `parentAxis`
    Vec3 slideAxis = Vec3::UnitZ(), slideForce = Vec3::Zero(), dampForce = Vec3::Zero(); ///< parent's axes; on parent, child
    Vec3 secondAxis = Vec3::UnitZ();                                     ///< of a universal joint, in the child's axes
    double stiffness = 0, damping = 0, travel = 0, rest = 0, beyond = 0; ///< beyond: m, past the travel; -: past its lower end
    // Of a universal joint about its second axis:
    double stiffness2 = 0, damping2 = 0, lowStop2 = 0, highStop2 = 0, position2 = 0, rate2 = 0;
    // Of JointInertias, along each free axis (a suspension's first is `slideAxis`): 0 until needed.
    Vec3 inertia = Vec3::Zero(), heldInertia = Vec3::Zero(); ///< held: while the child cannot move
    std::vector<std::uint32_t> childSide;                    ///< bodies that the child carries, with itself
    std::vector<std::shared_ptr<const OdeRotor>> rotors;     ///< not of a joint to the world, whose child has their inertia
    Vec3 rotorAxis = Vec3::UnitZ();                          ///< at the start of the last step, world
};

/// A spring, or a gear between two joints: one row along a line. The first body is never the world.
struct OdeCoupling {
    bool isGear = false, isTorque = false;   ///< isTorque: the row has no place, only a direction
    bool released = false;                   ///< one of its actors has ended
    std::uint32_t first = 0, second = kNone; ///< bodies; of a spring child and parent
    dJointID id = nullptr;
    std::unique_ptr<dJointFeedback> feedback;
    Vec3 direction = Vec3::UnitZ();        ///< of the row in this tick, world; on the first body
    static constexpr double kApart = 1000; ///< m
    double shift = 0, side = 1;            ///< m, by which a force's ends are to part beyond that; side of the first one: 1, -1
    CouplingState state;
    // Of a spring: its ends in the axes of each body, from its centre of mass.
    Vec3 firstAnchor = Vec3::Zero(), secondAnchor = Vec3::Zero();
    double stiffness = 0, damping = 0, restLength = 0;
    double inertia = 0;                ///< kg, along the line; 0 until needed
    std::vector<std::uint32_t> around; ///< bodies that it may move, ascending
    std::vector<bool> touched;         ///< by body around: touches what does not move, as in `inertia`
    // Of a gear:
    std::uint32_t joint = 0, other = 0, common = kNone; ///< common: the body of both joints
    Vec3 point = Vec3::Zero(), line = Vec3::UnitZ();    ///< of the row, in the axes of the common body, from its centre of mass
    double ratio = 1, lever = 1;                        ///< lever: the rate along the row per rate of the joint
};

/// Holds a body rigidly to another one, of any actor, from a command to the next.
struct OdeLatch {
    std::uint32_t number = 0;                                 ///< by which its owner calls it
    std::uint32_t body = kNone, held = kNone, wanted = kNone; ///< held: kNone is the world; wanted: from the next step on
    bool holds = false, wants = false;
    bool isApart = false; ///< the two bodies do not touch each other because of it
    dJointID id = nullptr;
    std::unique_ptr<dJointFeedback> feedback;
};

/// In the world, at the start.
struct JointFrame {
    Vec3 anchor, axis, axis2;
};

/// A touch of this tick. Its force is in the feedback of the same index.
struct OdeContact {
    std::uint32_t first = 0, second = 0; ///< geoms; `first` is of the moving actor of lower index
    std::uint32_t actor = 0, partner = kNoActor;
    double position[3] = {}, normal[3] = {}, depth = 0;
    double gap = 0;       ///< m, in the tick after an actor was placed: depth is 0 then
    double slide[3] = {}; ///< direction of friction's first axis, zero: along the slip
    // Of Impacts:
    double speed = 0;                             ///< m/s along the normal before the tick; negative: they approach
    double restitution = 0, restitutionShare = 1; ///< the share that leaves the energy as it was
    bool bounces = false;
    double borne = -1;     ///< m of its depth that presses in a solution for velocities alone (PushOut); negative: all of it
    bool outside = false;  ///< pushes by HeapForces, not by rows of the solver
    double raised = 0;     ///< m: how much higher its rows act than it is
    bool level = false;    ///< of a wall and what HeapForces pushes: friction acts in the plane of the floor alone
    bool iterated = false; ///< of a cluster that is iterated
    // Of the contact of the last tick that this one continues (ContactMemory):
    std::uint32_t ticks = 0;      ///< that it has lasted
    bool heir = false;            ///< has only what others left
    double load = 0, earlier = 0; ///< N along the normal in the last tick and in the previous one
    double grip[3] = {};          ///< N across the normal on the first body
    double stored = 0;            ///< J in the spring of a surface with Softness
    double less = 0;              ///< N s: so much less than that spring's own is its impulse in this tick
    // Of FrictionCones, from an earlier solution of this tick:
    bool solved = false;
    double solvedLoad = 0, solvedGrip[3] = {}, solvedSpeed[3] = {}; ///< N; N; m/s of the first body on the second, after the tick
};

/// The contacts of a tick, sorted by (actor, partner, geom), with what ODE has for each.
struct TickContacts {
    std::vector<OdeContact> all;
    std::vector<dJointFeedback> feedbacks; ///< by contact: its force
    std::vector<dJointID> rows;            ///< by contact; null: none of the whole tick
};

} // namespace trundle
