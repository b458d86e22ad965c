#pragma once
// Experiments built in C++ as the resolver returns them, and a device that is only a motor constraint.

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "world/world.h"

namespace fixture {

using namespace trundle;

inline constexpr double kPi = std::numbers::pi;
inline constexpr double g = 9.81;

inline Vec3 degrees(double heading, double pitch, double roll) { return Vec3(heading, pitch, roll) * (kPi / 180); }
inline Pose at(double x, double y, double z, const Vec3& hpr = Vec3::Zero()) { return {{x, y, z}, rotationFromHpr(hpr)}; }

inline GeomSpec box(std::string name, const Vec3& size, const Pose& pose = {}, std::uint32_t surface = 0) {
    GeomSpec geom;
    geom.name = std::move(name);
    geom.shape = GeomShape::Box;
    geom.size = size;
    geom.pose = pose;
    geom.surface = surface;
    return geom;
}
inline GeomSpec sphere(std::string name, double radius, const Pose& pose = {}, std::uint32_t surface = 0) {
    GeomSpec geom;
    geom.name = std::move(name);
    geom.shape = GeomShape::Sphere;
    geom.radius = radius;
    geom.pose = pose;
    geom.surface = surface;
    return geom;
}
inline GeomSpec cylinder(std::string name, double radius, double length, const Pose& pose = {}, std::uint32_t surface = 0) {
    GeomSpec geom = sphere(std::move(name), radius, pose, surface);
    geom.shape = GeomShape::Cylinder;
    geom.length = length;
    return geom;
}
inline GeomSpec plane(std::string name = "floor", const Pose& pose = {}, std::uint32_t surface = 0) {
    GeomSpec geom;
    geom.name = std::move(name);
    geom.shape = GeomShape::Plane;
    geom.pose = pose;
    geom.surface = surface;
    return geom;
}

inline MassProperties massOfBox(double mass, const Vec3& s, const Vec3& centre = Vec3::Zero()) {
    const Vec3 i(s.y() * s.y() + s.z() * s.z(), s.x() * s.x() + s.z() * s.z(), s.x() * s.x() + s.y() * s.y());
    return {mass, centre, Mat3((mass / 12 * i).asDiagonal())};
}
inline MassProperties massOfSphere(double mass, double r, const Vec3& centre = Vec3::Zero()) {
    return {mass, centre, Mat3(Vec3::Constant(0.4 * mass * r * r).asDiagonal())};
}
/// Along z, then turned.
inline MassProperties massOfCylinder(double mass, double r, double length, const Quat& turn = Quat::Identity()) {
    const double side = mass * (3 * r * r + length * length) / 12;
    const Mat3 rotation = turn.toRotationMatrix(), inertia = Vec3(side, side, mass * r * r / 2).asDiagonal();
    return {mass, Vec3::Zero(), Mat3(rotation * inertia * rotation.transpose())};
}

inline BodySpec body(std::string name, const Pose& pose, const MassProperties& mass, std::vector<GeomSpec> geoms) {
    BodySpec b;
    b.name = std::move(name);
    b.pose = pose;
    b.mass = mass;
    b.geoms = std::move(geoms);
    return b;
}
inline JointSpec joint(std::string name, JointType type, int parent, int child, const Vec3& anchor, const Vec3& axis) {
    JointSpec j;
    j.name = std::move(name);
    j.type = type;
    j.parent = parent;
    j.child = child;
    j.anchor = anchor;
    j.axis = axis;
    return j;
}

inline ResolvedValue textValue(std::string text) { return {{PropertyType::Text, {}, {std::move(text)}}, {}, Origin::Config}; }
inline ResolvedValue numberValue(double number) { return {{PropertyType::Number, {number}, {}}, {}, Origin::Config}; }

/// `Row name { Joint=... }` of the Row device below.
inline ComponentSpec row(std::string name, std::string jointName) {
    ComponentSpec spec;
    spec.kind = "Row";
    spec.name = std::move(name);
    spec.values["Joint"] = textValue(std::move(jointName));
    return spec;
}

/// A motor constraint whose rate, softness and limit are command signals; its outputs are the joint values read through the services.
struct Row {
    std::string jointName;
    std::uint32_t joint = 0;
    double *command = nullptr, *position = nullptr, *effort = nullptr;

    static inline const TrundleSignal signals[] = {
        {"command", "", "rate, softness, limit", TRUNDLE_REAL_SIGNAL, 3, TRUNDLE_COMMAND, 0},
        {"position", "rad", "", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT, 0},
        {"effort", "N m", "", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT, 0},
    };
    static inline const TrundleField fields[] = {
        {"Joint", "", "", "", 1, 0, 0, TRUNDLE_REFERENCE, 1, 1, TRUNDLE_REQUIRED, {nullptr, nullptr, 0}},
    };
    static Row& self(void* instance) { return *static_cast<Row*>(instance); }
    static const TrundleKind* kind() {
        static const TrundleKind k{sizeof(TrundleKind),
                                   TRUNDLE_DEVICE,
                                   "Row",
                                   "",
                                   fields,
                                   signals,
                                   1,
                                   3,
                                   [] { return static_cast<void*>(new Row); },
                                   [](void* i) { delete &self(i); },
                                   [](void* i, std::uint32_t, const TrundleValue* v) {
                                       self(i).jointName = v->texts[0];
                                       return std::int32_t{0};
                                   },
                                   [](void*) { return "row"; },
                                   nullptr,
                                   nullptr,
                                   [](void* i, const TrundleMount* m) {
                                       Row& r = self(i);
                                       r.command = m->signal(m->context, "command");
                                       r.position = m->signal(m->context, "position");
                                       r.effort = m->signal(m->context, "effort");
                                       return m->joint(m->context, r.jointName.c_str(), &r.joint);
                                   },
                                   [](void* i, const TrundleServices* s) {
                                       const Row& r = self(i);
                                       s->motorRow(s->context, r.joint, r.command[0], r.command[1], r.command[2]);
                                       return std::int32_t{0};
                                   },
                                   [](void* i, const TrundleServices* s) {
                                       Row& r = self(i);
                                       *r.position = s->jointPosition(s->context, r.joint);
                                       *r.effort = s->jointMotorEffort(s->context, r.joint);
                                       return std::int32_t{0};
                                   }};
        return &k;
    }
};

inline const TrundleKind* rowOnly(const std::string& kind) { return kind == "Row" ? Row::kind() : nullptr; }

/// An experiment under construction.
struct Scene {
    std::shared_ptr<ExperimentSpec> spec = std::make_shared<ExperimentSpec>();

    explicit Scene(double tick = 0.01) {
        spec->settings.tick = tick;
        spec->materials.emplace_back();
        spec->surfaces.push_back({"default", 0.5, 0, 0, 0, {}});
    }
    std::uint32_t surface(double friction, double restitution = 0, double rolling = 0, double softness = 0) {
        spec->surfaces.push_back({"s" + std::to_string(spec->surfaces.size()), friction, restitution, rolling, softness, {}});
        return static_cast<std::uint32_t>(spec->surfaces.size() - 1);
    }
    Scene& scenery(std::vector<GeomSpec> geoms, const Pose& pose = {}, std::string name = "arena") {
        StaticSpec s;
        s.name = std::move(name);
        s.pose = pose;
        s.geoms = std::make_shared<const std::vector<GeomSpec>>(std::move(geoms));
        spec->statics.push_back(s);
        return *this;
    }
    Scene& robot(std::string name, const Pose& pose, std::shared_ptr<const RobotConfigSpec> config) {
        RobotSpec r;
        r.name = std::move(name);
        r.pose = pose;
        r.config = std::move(config);
        spec->robots.push_back(r);
        return *this;
    }
    /// Adds one free body.
    Scene& loose(std::string name, const Pose& pose, const MassProperties& mass, std::vector<GeomSpec> geoms) {
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("body", {}, mass, std::move(geoms)));
        return robot(std::move(name), pose, config);
    }
    Scene& ball(std::string name, const Vec3& centre, double mass, double radius, std::uint32_t surfaceIndex = 0) {
        return loose(std::move(name), {centre, Quat::Identity()}, massOfSphere(mass, radius),
                     {sphere("ball", radius, {}, surfaceIndex)});
    }
    std::unique_ptr<World> build(const DeviceCode& code = rowOnly) {
        Diagnostics diagnostics;
        return build(code, diagnostics);
    }
    std::unique_ptr<World> build(const DeviceCode& code, Diagnostics& diagnostics) {
        return World::build(spec, code, diagnostics);
    }
};

struct R0Options {
    double wheelFriction = 1;
    bool wheels = true;
    bool roundWheels = false;                    ///< spheres for tyres
    std::uint32_t tyre = 1, slick = 2, hull = 3; ///< surfaces
};

inline constexpr double kR0Radius = 0.05, kR0Track = 0.25;

/// Robot R0: 4 kg box, two wheels of 0.2 kg, one frictionless slider. Its frame is on the floor below the middle of the axle.
inline std::shared_ptr<RobotConfigSpec> r0(const R0Options& o = {}) {
    auto config = std::make_shared<RobotConfigSpec>();
    config->name = "R0";
    const Vec3 hull(0.30, 0.20, 0.10), centre(-0.03, 0, 0.09);
    config->bodies.push_back(
        body("chassis", {}, massOfBox(4, hull, centre),
             {box("hull", hull, {centre, Quat::Identity()}, o.hull), sphere("slider", 0.015, at(-0.13, 0, 0.015), o.slick)}));
    if (!o.wheels) return config;
    const Quat sideways = rotationFromHpr(degrees(0, 0, 90));
    for (const int side : {1, -1}) {
        const std::string name = side > 0 ? "left" : "right";
        const Vec3 hub(0, side * kR0Track / 2, kR0Radius);
        GeomSpec tyre = cylinder("tyre", kR0Radius, 0.02, {Vec3::Zero(), sideways}, o.tyre);
        if (o.roundWheels) tyre = sphere("tyre", kR0Radius, {}, o.tyre);
        config->bodies.push_back(
            body(name + "Wheel", {hub, Quat::Identity()}, massOfCylinder(0.2, kR0Radius, 0.02, sideways), {tyre}));
        config->joints.push_back(joint(name + "Axle", JointType::Hinge, 0, side > 0 ? 1 : 2, hub, Vec3::UnitY()));
        config->devices.push_back(row(name + "Motor", name + "Axle"));
    }
    return config;
}

/// A scene with R0's three surfaces.
inline Scene r0Scene(double tick = 0.01, double friction = 1) {
    Scene scene(tick);
    scene.surface(friction);
    scene.surface(0);
    scene.surface(0.3);
    return scene;
}

inline double* slot(World& world, const std::string& path) {
    const auto entry = world.layout().find(path);
    return entry ? world.block().slots().data() + entry->offset : nullptr;
}
inline double value(World& world, const std::string& path, int index = 0) { return slot(world, path)[index]; }
inline Vec3 position(World& world, const std::string& bodyPath) { return Vec3(slot(world, bodyPath + "/pose")); }
inline Vec3 velocity(World& world, const std::string& bodyPath) { return Vec3(slot(world, bodyPath + "/velocity")); }
inline Vec3 spin(World& world, const std::string& bodyPath) { return Vec3(slot(world, bodyPath + "/velocity") + 3); }

inline void command(World& world, const std::string& device, double rate, double softness, double limit) {
    double* c = slot(world, device + "/command");
    c[0] = rate;
    c[1] = softness;
    c[2] = limit;
}
/// Runs for `seconds` of simulated time; false after a fault.
inline bool run(World& world, double seconds) {
    const auto ticks = static_cast<std::uint64_t>(std::llround(seconds / world.experiment().settings.tick));
    for (std::uint64_t i = 0; i < ticks; ++i)
        if (!world.tick()) return false;
    return true;
}

} // namespace fixture
