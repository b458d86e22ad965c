#pragma once
// Vehicles, belts and sleds for the tests of friction.

#include "model/shortest_turn.h"
#include "world/fixtures.h"

namespace fixture {

/// A surface with a separate friction across its direction (`friction2`; below 0: none).
inline std::uint32_t surfaceOf(Scene& scene, double friction, double friction2) {
    const std::uint32_t index = scene.surface(friction);
    if (friction2 >= 0) scene.spec->surfaces[index].friction2 = friction2;
    return index;
}

/// A geom whose surface velocity is a command signal.
struct Belt {
    std::string geomName;
    std::uint32_t geom = 0;
    double* velocity = nullptr;

    static inline const TrundleSignal signals[] = {
        {"velocity", "m/s", "in the geom's frame", TRUNDLE_REAL_SIGNAL, 3, TRUNDLE_COMMAND, 0}};
    static inline const TrundleField fields[] = {
        {"Geom", "", "", "", 1, 0, 0, TRUNDLE_TEXT, 1, 1, TRUNDLE_REQUIRED, {nullptr, nullptr, 0}}};
    static Belt& self(void* instance) { return *static_cast<Belt*>(instance); }
    static const TrundleKind* kind() {
        static const TrundleKind k{sizeof(TrundleKind),
                                   TRUNDLE_DEVICE,
                                   "Belt",
                                   "",
                                   fields,
                                   signals,
                                   1,
                                   1,
                                   [] { return static_cast<void*>(new Belt); },
                                   [](void* i) { delete &self(i); },
                                   [](void* i, std::uint32_t, const TrundleValue* v) {
                                       self(i).geomName = v->texts[0];
                                       return std::int32_t{0};
                                   },
                                   [](void*) { return "belt"; },
                                   nullptr,
                                   nullptr,
                                   [](void* i, const TrundleMount* m) {
                                       self(i).velocity = m->signal(m->context, "velocity");
                                       return m->geom(m->context, self(i).geomName.c_str(), &self(i).geom);
                                   },
                                   [](void* i, const TrundleServices* s) {
                                       s->surfaceVelocity(s->context, self(i).geom, self(i).velocity);
                                       return std::int32_t{0};
                                   },
                                   nullptr};
        return &k;
    }
};

inline ComponentSpec belt(std::string name, std::string geom) {
    ComponentSpec spec;
    spec.kind = "Belt";
    spec.name = std::move(name);
    spec.values["Geom"] = textValue(std::move(geom));
    return spec;
}

inline const TrundleKind* beltOrRow(const std::string& kind) { return kind == "Belt" ? Belt::kind() : rowOnly(kind); }

inline void setBelt(World& world, const std::string& device, const Vec3& velocity) {
    for (int k = 0; k < 3; ++k) slot(world, device + "/velocity")[k] = velocity[k];
}

/// A robot with wheels about y (omni: about the direction to their position) and frictionless sliders. Its frame is on the floor.
struct Vehicle {
    double mass = 4; ///< of the chassis
    double radius = 0.05, wheelMass = 0.02;
    double friction = 0.8, friction2 = -1; ///< of the wheels
    bool omni = false;
    std::vector<Vec3> wheels, sliders; ///< positions
    std::vector<double> headings;      ///< FrictionHeading of each wheel, rad; empty: 0
    Vec3 centre = Vec3::Zero();        ///< centre of mass of the chassis; of the whole vehicle once it is in a scene
    double total = 0;
    std::uint32_t ground = 0;

    [[nodiscard]] double reach() const {
        double most = 0;
        for (const Vec3& w : wheels) most = std::max(most, std::abs(w.x()));
        return most + radius + 0.03;
    }
    /// Traction in N per kg along the floor towards `sign` x while the wheels (all at one x, or all of them) slip, on a slope
    /// that rises by `angle` degrees towards x.
    [[nodiscard]] double traction(double angle, double sign) const {
        const double weight = g * std::cos(angle * kPi / 180);
        if (sliders.empty()) return sign * sign * friction * weight;
        const double driven = wheels[0].x(), other = sliders[0].x();
        return friction * weight * (centre.x() - other) / (driven - other + sign * friction * centre.z());
    }
    /// Largest slope, degrees, at which the wheels hold; the slope rises towards `sign` x.
    [[nodiscard]] double slipAngle(double sign) const { return std::atan(traction(0, sign) / g) * 180 / kPi; }
};

struct Sled {
    double mass;
    std::uint32_t surface;
    Vec3 size;
};

inline void addSled(RobotConfigSpec& config, const Vehicle& v, const Sled& sled) {
    const double hook = -v.reach(), z = sled.size.z() / 2, length = 0.3;
    const auto bodies = static_cast<int>(config.bodies.size());
    config.bodies.push_back(body("rod", at(hook - length / 2, 0, z), massOfBox(0.01, {length, 0.03, 0.03}), {}));
    config.bodies.push_back(body("sled", at(hook - length - sled.size.x() / 2, 0, z), massOfBox(sled.mass, sled.size),
                                 {box("b", sled.size, {}, sled.surface)}));
    config.joints.push_back(joint("hook", JointType::Ball, 0, bodies, {hook, 0, z}, Vec3::UnitZ()));
    config.joints.push_back(joint("eye", JointType::Ball, bodies, bodies + 1, {hook - length, 0, z}, Vec3::UnitZ()));
}

inline void addVehicle(Scene& scene, Vehicle& v, double drop, const std::optional<Sled>& sled = {}) {
    const auto tyre = surfaceOf(scene, v.friction, v.friction2), slick = scene.surface(0);
    v.ground = scene.surface(100);
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 hull(2 * v.reach(), 0.1, 0.04), top(0, 0, 0.1);
    const MassProperties mass = massOfBox(v.mass, hull, v.centre);
    std::vector<GeomSpec> geoms{box("hull", hull, {top, Quat::Identity()}, slick)};
    int count = 0;
    for (const Vec3& s : v.sliders)
        geoms.push_back(sphere("slider" + std::to_string(count++), 0.01, at(s.x(), s.y(), 0.01), slick));
    config->bodies.push_back(body("chassis", {}, mass, geoms));
    v.total = v.mass;
    Vec3 moment = v.mass * v.centre;
    for (std::size_t i = 0; i < v.wheels.size(); ++i) {
        const std::string n = std::to_string(i);
        std::uint32_t surface = tyre;
        if (!v.headings.empty()) {
            surface = surfaceOf(scene, v.friction, v.friction2);
            scene.spec->surfaces[surface].frictionHeading = v.headings[i];
        }
        const Vec3 hub = v.wheels[i] + Vec3(0, 0, v.radius), axle = v.omni ? Vec3(v.wheels[i].normalized()) : Vec3::UnitY();
        const Quat lying = shortestTurn(Vec3::UnitZ(), axle);
        config->bodies.push_back(body("wheel" + n, {hub, Quat::Identity()}, massOfCylinder(v.wheelMass, v.radius, 0.02, lying),
                                      {cylinder("tyre", v.radius, 0.02, {Vec3::Zero(), lying}, surface)}));
        config->joints.push_back(joint("axle" + n, JointType::Hinge, 0, static_cast<int>(i) + 1, hub, axle));
        config->devices.push_back(row("m" + n, "axle" + n));
        v.total += v.wheelMass;
        moment += v.wheelMass * hub;
    }
    v.centre = moment / v.total;
    if (sled) addSled(*config, v, *sled);
    scene.robot("v", at(0, 0, drop), config);
}

inline void drive(World& world, const Vehicle&, std::size_t wheel, double rate) {
    command(world, "v/m" + std::to_string(wheel), rate, 0, 1e3);
}
inline void driveAll(World& world, const Vehicle& v, double rate) {
    for (std::size_t i = 0; i < v.wheels.size(); ++i) drive(world, v, i, rate);
}

/// A block whose surface velocity is given in its own frame.
inline void addBeltBody(Scene& scene, const std::string& name, double mass, const Vec3& size, std::uint32_t surface) {
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(body("body", {}, massOfBox(mass, size), {box("crate", size, {}, surface)}));
    config->devices.push_back(belt("belt", "body.crate"));
    scene.robot(name, at(0, 0, size.z() / 2), config);
}

/// A body on two boxes with moving surfaces.
inline void addTracked(Scene& scene, double mass, double length, double gauge, double width, std::uint32_t surface) {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 track(length, width, 0.06);
    config->bodies.push_back(
        body("chassis", {}, massOfBox(mass, {length, gauge, 0.06}, {0, 0, 0.04}),
             {box("left", track, at(0, gauge / 2, 0.03), surface), box("right", track, at(0, -gauge / 2, 0.03), surface)}));
    config->devices.push_back(belt("leftBelt", "chassis.left"));
    config->devices.push_back(belt("rightBelt", "chassis.right"));
    scene.robot("tracked", {}, config);
}

} // namespace fixture
