#pragma once
// What an actor is for the wheeled engine: a vehicle, something loose or something fixed; or why it is none of these.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "world/engine.h"
#include "world/wheeled/level_ground.h"

namespace trundle {

inline constexpr std::size_t kMostSupports = 24; ///< of a vehicle
inline constexpr const char* kTwoFrictions = "has a surface with a Friction2 other than its Friction";

/// Whether friction depends on the direction, which only wheels may have.
[[nodiscard]] bool hasTwoFrictions(const SurfaceSpec& surface);

/// Where a vehicle touches the ground: a wheel, or a ball or slider under it. Vectors from the centre of mass, in the vehicle's axes.
struct Support {
    Vec3 centre = Vec3::Zero(); ///< of the wheel or ball
    double radius = 0;
    Vec2 way{1, 0};     ///< unit: in which friction acts; of a wheel that grips alike everywhere, the way that it rolls
    bool round = true;  ///< friction acts across the way too
    double lever = 0;   ///< speed of the tread along `way` at 1 rad/s, m; 0: it is no wheel
    double rolling = 0; ///< of a ball that turns freely in its socket: mass that its turning adds to its motion, kg
    std::uint32_t body = 0, geom = 0, wheel = 0; ///< within the actor; `wheel`: of those with a lever
    std::uint32_t surface = 0;
};

struct WheelShape {
    std::uint32_t joint = 0, body = 0; ///< within the actor
    Vec3 axis = Vec3::UnitY();         ///< in the vehicle's axes
    Vec3 offset = Vec3::Zero();        ///< of the body's origin from the axle, in the vehicle's axes at the start
    double inertia = 0;                ///< about the axis, kg m^2
    double damping = 0;                ///< N m s/rad
};

enum class ActorKind { Vehicle, Loose, Ball, Fixed };

/// Shared by equal actors. The frame has its origin in the centre of mass of the whole and the axes of the actor's frame at the start.
struct ActorShape {
    ActorKind kind = ActorKind::Fixed;
    Vec3 centre = Vec3::Zero();            ///< of mass, in the actor's frame
    double mass = 0;                       ///< kg
    Mat3 inertia = Mat3::Identity();       ///< of all, wheels included, kg m^2
    std::vector<Pose> bodies;              ///< at the start
    std::vector<std::uint8_t> isTurned;    ///< whether a body's rotation is not the identity
    std::vector<Vec3> bodyCentres;         ///< of mass, in the bodies' frames
    std::vector<std::uint32_t> geomCounts; ///< of bodies: geoms that collide
    std::vector<PlanarShape> footprints;   ///< in the order of the geoms that collide
    std::vector<std::uint32_t> footprintBody;
    std::vector<Support> supports;
    std::vector<WheelShape> wheels;
    double stiffness = 0, damping = 0; ///< of the ground under each support, N/m, N s/m
    double bound = 0;                  ///< farthest point over x and y from the centre of mass, m
    double tall = 0;                   ///< farthest point above or below it, m
    double spinRadius = 0;     ///< of something loose: moment of friction over its force when it only turns; of a ball its radius
    std::uint32_t surface = 0; ///< of the lowest geom of something loose
};

/// The lowest point of what collides of an actor, m.
[[nodiscard]] double lowestOf(const ActorDef& actor);

/// The colliding one, if there is only one.
[[nodiscard]] const GeomSpec* onlyGeom(const BodySpec& body);

/// Reads an actor that is on the ground at its start.
class ActorReader {
public:
    ActorReader(std::span<const SurfaceSpec> surfaces, const LevelGround& ground) : m_surfaces(surfaces), m_ground(ground) {}

    /// Null where it cannot be in this engine, for the reason in `why`.
    [[nodiscard]] std::shared_ptr<const ActorShape> read(const ActorDef& actor, NotWheeled& why);

private:
    [[nodiscard]] bool findRoles();
    [[nodiscard]] bool readJoint(std::uint32_t index);
    [[nodiscard]] bool isWheel(const JointSpec& joint);
    [[nodiscard]] bool isCaster(const JointSpec& joint);
    [[nodiscard]] bool hasRollingFriction(const GeomSpec& geom) const;
    [[nodiscard]] bool isOnGround(const char* kind, const JointSpec& joint, double gap);
    [[nodiscard]] double gapBelow(std::uint32_t body, const GeomSpec& round) const;
    [[nodiscard]] bool isWhole();
    [[nodiscard]] bool areJointsOfRigid();
    void addMasses();
    [[nodiscard]] bool addFootprints();
    [[nodiscard]] bool addSupports();
    [[nodiscard]] bool addWheel(const JointSpec& joint, std::uint32_t index);
    void addSlider(std::uint32_t body, std::uint32_t geom, const GeomSpec& spec, const Vec3& centre);
    [[nodiscard]] bool standsOnSupports();
    [[nodiscard]] bool readLoose();
    [[nodiscard]] bool restsOnBase(double low);
    void setStiffness();
    [[nodiscard]] bool refuse(std::string reason, SourceRange range);
    [[nodiscard]] const BodySpec& body(std::uint32_t index) const { return *m_actor->bodies[index].spec; }
    [[nodiscard]] double bottom(const PlanarShape& footprint) const;
    [[nodiscard]] Pose inActor(std::uint32_t index) const;

    enum class Role { Unknown, Rigid, Wheel, Caster };

    std::span<const SurfaceSpec> m_surfaces;
    LevelGround m_ground;
    const ActorDef* m_actor = nullptr;
    std::shared_ptr<ActorShape> m_shape;
    std::vector<Role> m_roles; ///< of bodies
    bool m_anchored = false;
    NotWheeled* m_why = nullptr;
};

} // namespace trundle
