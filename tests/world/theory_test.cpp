// One table of closed forms of mechanics, each at 5, 10 and 30 ms with the exact solver: falling, sliding, rolling, towing, colliding,
// swinging, spinning up, turning. Masses, angles, speeds and frequencies are others than those of the tests that look closer.
#include <array>

#include "world/friction_vehicles.h"

using namespace fixture;

namespace {

// Of relative errors, at ticks up to 10 ms and at 30 ms.
constexpr double kExact = 1e-6, kClose = 1e-4, kFriction = 0.02, kFrictionAt30 = 0.04;

/// Gives a body that is alone a velocity in one tick without gravity.
bool kick(World& world, const std::string& path, double mass, const Vec3& velocity) {
    return world.push(path, mass / world.experiment().settings.tick * velocity, position(world, path)).ok();
}
/// The same about its centre, by two opposite forces.
bool twist(World& world, const std::string& path, const Vec3& angularImpulse) {
    const Vec3 arm = angularImpulse.unitOrthogonal(), at = position(world, path),
               force = angularImpulse.cross(arm) / (2 * world.experiment().settings.tick);
    return world.push(path, force, at + arm).ok() && world.push(path, -force, at - arm).ok();
}

Measure falls(double gravity, double seconds, bool height) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = {0, 0, -gravity};
        auto world = scene.ball("b", {0, 0, 50}, 3, 0.2).build();
        if (!run(*world, seconds)) return {};
        const double t = world->time();
        if (height) return {50 - position(*world, "b/body").z(), gravity * t * (t + c.tick) / 2};
        return {-velocity(*world, "b/body").z(), gravity * t};
    };
}

/// A crate on a slope that falls towards `heading`, pulled along its y axis with `pull` times its weight at `lift` degrees.
Measure crate(double mass, double mu, double angle, double heading, double pull = 0, double lift = 0) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = slopeGravity(angle, heading);
        const Vec3 size(0.5, 0.4, 0.04);
        scene.scenery({plane("floor", {}, scene.surface(mu))});
        scene.loose("crate", at(0, 0, 0.02), massOfBox(mass, size), {box("b", size, {}, scene.surface(mu))});
        auto world = scene.build();
        const Vec3 way = pull != 0 ? Vec3(Vec3::UnitY()) : Vec3(std::cos(rad(heading)), std::sin(rad(heading)), 0);
        double v0 = 0, t0 = 0;
        while (world->time() < 1.2 - 1e-9) {
            if (pull != 0 && !world->push("crate/body", pull * mass * g * Vec3(0, std::cos(rad(lift)), std::sin(rad(lift))),
                                          position(*world, "crate/body")))
                return {};
            if (!world->tick()) return {};
            if (t0 == 0 && world->time() > 0.35) t0 = world->time(), v0 = velocity(*world, "crate/body").dot(way);
        }
        const double weight = g * (std::cos(rad(angle)) - pull * std::sin(rad(lift)));
        const double drive = pull != 0 ? g * pull * std::cos(rad(lift)) : g * std::sin(rad(angle));
        return {(velocity(*world, "crate/body").dot(way) - v0) / (world->time() - t0), drive - mu * weight};
    };
}

/// Stays 1 degree below the angle of friction, slides 1 degree above it.
Measure parksCrate(double mass, double mu, double off) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = slopeGravity(std::atan(mu) * 180 / kPi + off, 130);
        const Vec3 size(0.3, 0.5, 0.05);
        scene.scenery({plane("floor", {}, scene.surface(mu))});
        scene.loose("crate", at(0, 0, 0.025, degrees(20, 0, 0)), massOfBox(mass, size), {box("b", size, {}, scene.surface(mu))});
        auto world = scene.build();
        if (!run(*world, 3)) return {};
        const double moved = position(*world, "crate/body").head<2>().norm();
        return {(off < 0 ? moved < 5e-4 : moved > 0.2) ? 1.0 : 0.0, 1};
    };
}

/// A round body with the moment `k` m r^2 rolls down: g sin / (1 + k).
Measure rolls(bool ball, double mass, double radius, double k, double angle) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = slopeGravity(angle, 0);
        const auto s = scene.surface(0.9);
        scene.scenery({plane("floor", {}, s)});
        const Quat lying = rotationFromHpr(degrees(0, 0, 90));
        const MassProperties m{mass, Vec3::Zero(), Mat3(Vec3::Constant(k * mass * radius * radius).asDiagonal())};
        scene.loose("b", at(0, 0, radius), m,
                    {ball ? sphere("b", radius, {}, s) : cylinder("b", radius, 3 * radius, {Vec3::Zero(), lying}, s)});
        auto world = scene.build();
        if (!run(*world, 0.3)) return {};
        const double v0 = velocity(*world, "b/body").x(), t0 = world->time();
        if (!run(*world, 0.9)) return {};
        return {(velocity(*world, "b/body").x() - v0) / (world->time() - t0), g * std::sin(rad(angle)) / (1 + k)};
    };
}

/// A ball that slides first ends at 5/7 of its speed.
Measure startsRolling(double mass, double radius, double mu, double speed) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const auto s = scene.surface(mu);
        scene.scenery({plane("floor", {}, s)}).ball("b", {0, 0, radius}, mass, radius, s);
        auto world = scene.build();
        if (!run(*world, 0.3) || !kick(*world, "b/body", mass, {speed, 0, 0}) || !run(*world, 3)) return {};
        return {velocity(*world, "b/body").x(), 5 * speed / 7};
    };
}

/// What lies on the floor presses on it with its weight.
Measure presses(double mass) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const Vec3 size(0.3, 0.2, 0.1);
        scene.scenery({plane()}).loose("b", at(0, 0, 0.05), massOfBox(mass, size), {box("b", size)});
        auto world = scene.build();
        if (!run(*world, 3)) return {};
        double force = 0;
        for (const WorldContact& contact : world->contacts()) force += contact.force;
        return {force, mass * g};
    };
}

/// Speed after a bounce on the floor by that before it; `mu` and `across`: what is left of the speed along the floor.
Measure bounces(double e, double speed, double mu, double across) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        const auto s = scene.surface(mu, e);
        scene.scenery({plane("floor", {}, s)}).ball("b", {0, 0, 0.8}, 0.7, 0.15, s);
        auto world = scene.build();
        if (!kick(*world, "b/body", 0.7, {across, 0, -speed}) || !run(*world, 1.2 / speed)) return {};
        if (across == 0) return {velocity(*world, "b/body").z(), e * speed};
        return {velocity(*world, "b/body").x(), std::max(5 * across / 7, across - mu * (1 + e) * speed)};
    };
}

/// Two balls meet head-on: the speed of the second.
Measure meet(double m1, double m2, double v1, double v2, double e) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        const auto s = scene.surface(0.4, e);
        scene.ball("a", {0, 0, 1}, m1, 0.08, s).ball("b", {0.5, 0, 1}, m2, 0.12, s);
        auto world = scene.build();
        if (!kick(*world, "a/body", m1, {v1, 0, 0}) || !kick(*world, "b/body", m2, {v2, 0, 0}) || !run(*world, 0.9)) return {};
        return {velocity(*world, "b/body").x(), (m1 * v1 + m2 * v2 + e * m1 * (v1 - v2)) / (m1 + m2)};
    };
}

/// A ball hits a free rod at a distance from its centre: the rate of the rod.
Measure hitsRod(double ball, double rod, double length, double distance, double speed, double e) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        const auto s = scene.surface(0, e);
        const MassProperties m = massOfBox(rod, {0.1, length, 0.1});
        scene.ball("a", {-0.4, distance, 0}, ball, 0.06, s).loose("b", {}, m, {box("b", {0.1, length, 0.1}, {}, s)});
        auto world = scene.build();
        if (!kick(*world, "a/body", ball, {speed, 0, 0}) || !run(*world, 0.45 / speed)) return {};
        const double push = (1 + e) * speed / (1 / ball + 1 / rod + distance * distance / m.inertia(2, 2));
        return {-spin(*world, "b/body").z(), push * distance / m.inertia(2, 2)};
    };
}

/// The period of a signal that swings about 0, from where it first to where it last rises through it.
double periodOf(World& world, const std::function<double()>& read, double seconds) {
    double last = read(), first = 0, latest = 0;
    int crossings = 0;
    const double end = world.time() + seconds, h = world.experiment().settings.tick;
    while (world.time() < end) {
        if (!world.tick()) return 0;
        const double now = read();
        if (last < 0 && now >= 0) {
            latest = world.time() - h * now / (now - last);
            if (crossings++ == 0) first = latest;
        }
        last = now;
    }
    return (latest - first) / (crossings - 1);
}

/// A bar on a hinge or a ball joint of the world, let go at an angle: 4 sqrt(I / m g l) K(sin(angle / 2)).
Measure swings(JointType type, double mass, double length, double angle) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const Vec3 size(0.06, 0.04, 0.5);
        const Quat turned = Quat(Eigen::AngleAxisd(rad(angle), Vec3::UnitY()));
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("bar", {turned * Vec3(0, 0, -length), turned}, massOfBox(mass, size), {}));
        config->joints.push_back(joint("pin", type, kWorldBody, 0, Vec3::Zero(), Vec3::UnitY()));
        auto world = scene.robot("p", {}, config).build();
        const double inertia = massOfBox(mass, size).inertia(1, 1) + mass * length * length;
        const double expected = 4 * std::sqrt(inertia / (mass * g * length)) * std::comp_ellint_1(std::sin(rad(angle) / 2));
        return {periodOf(
                    *world, [&] { return position(*world, "p/bar").x(); }, 12 * expected),
                expected};
    };
}

/// A block on a slider or a disc on a hinge with a spring.
Measure springs(JointType type, double inertia, double frequency) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("b", {}, {inertia, Vec3::Zero(), Mat3(Vec3::Constant(inertia).asDiagonal())}, {}));
        config->joints.push_back(joint("j", type, kWorldBody, 0, Vec3::Zero(), Vec3::UnitZ()));
        config->joints[0].stiffness = inertia * std::pow(2 * kPi * frequency, 2);
        auto world = scene.robot("r", {}, config).build();
        const bool slides = type == JointType::Slider;
        if (!(slides ? kick(*world, "r/b", inertia, {0, 0, 0.5}) : twist(*world, "r/b", {0, 0, 0.5 * inertia}))) return {};
        return {periodOf(
                    *world, [&] { return value(*world, "r/j/position"); }, 30 / frequency),
                1 / frequency};
    };
}

/// A ball on soft ground: period 2 pi sqrt(m Softness).
Measure bobs(double mass, double frequency) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const double softness = 1 / (mass * std::pow(2 * kPi * frequency, 2));
        scene.scenery({plane("floor", {}, scene.surface(0.3, 0, 0, softness))});
        const double rest = 0.3 - mass * g * softness;
        scene.ball("b", {0, 0, rest}, mass, 0.3);
        auto world = scene.build();
        if (!run(*world, 0.3) || !kick(*world, "b/body", mass, {0, 0, 0.3 * g / (2 * kPi * frequency)})) return {};
        const double stiffness = std::max(2e5, mass * g / 1e-4); // of the ground itself, in series
        const double ground = 1 / (softness * stiffness), mean = rest - mass * g / stiffness;
        return {periodOf(
                    *world, [&] { return position(*world, "b/body").z() - mean; }, 20 / frequency),
                std::sqrt(1 + ground) / frequency};
    };
}

/// Rate of what a line of torque drives, or what a damper slows, after `share` of its time constant `tau`.
Measure spinsUp(double inertia, double tau, double share) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("b", {}, {1, Vec3::Zero(), Mat3(Vec3::Constant(inertia).asDiagonal())}, {}));
        config->joints.push_back(joint("j", JointType::Hinge, kWorldBody, 0, Vec3::Zero(), Vec3::UnitX()));
        config->devices.push_back(row("motor", "j"));
        auto world = scene.robot("r", {}, config).build();
        command(*world, "r/motor", 40, tau / inertia, 1e6);
        if (!run(*world, std::ceil(share * tau / c.tick) * c.tick)) return {};
        return {value(*world, "r/j/rate"), -40 * std::expm1(-world->time() / tau)};
    };
}
Measure slowsDown(JointType type, double inertia, double tau, double share) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("b", {}, {inertia, Vec3::Zero(), Mat3(Vec3::Constant(inertia).asDiagonal())}, {}));
        config->joints.push_back(joint("j", type, kWorldBody, 0, Vec3::Zero(), Vec3::UnitZ()));
        config->joints[0].damping = inertia / tau;
        auto world = scene.robot("r", {}, config).build();
        const bool slides = type == JointType::Slider;
        if (!(slides ? kick(*world, "r/b", inertia, {0, 0, 2}) : twist(*world, "r/b", {0, 0, 2 * inertia})) || !world->tick())
            return {};
        const double v0 = value(*world, "r/j/rate"), t0 = world->time();
        if (!run(*world, std::ceil(share * tau / c.tick) * c.tick)) return {};
        return {value(*world, "r/j/rate"), v0 * std::exp(-(world->time() - t0) / tau)};
    };
}

/// A free symmetric body wobbles: its axis goes round the angular momentum at L / I across.
Measure wobbles(double mass, double radius, double length, double along, double across, double seconds) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        const MassProperties m = massOfCylinder(mass, radius, length);
        auto world = scene.loose("b", {}, m, {cylinder("b", radius, length)}).build();
        const Vec3 momentum(m.inertia(0, 0) * across, 0, m.inertia(2, 2) * along);
        if (!twist(*world, "b/body", momentum) || !world->tick()) return {};
        const auto axis = [&] {
            const double* p = slot(*world, "b/body/pose");
            const Vec3 a = Quat(p[3], p[4], p[5], p[6]) * Vec3::UnitZ();
            return Vec3(a - a.dot(momentum.normalized()) * momentum.normalized());
        };
        Vec3 last = axis();
        const double t0 = world->time();
        double turned = 0;
        while (world->time() < seconds) {
            if (!world->tick()) return {};
            const Vec3 now = axis();
            turned += std::atan2(last.cross(now).dot(momentum.normalized()), last.dot(now));
            last = now;
        }
        return {turned, momentum.norm() / m.inertia(0, 0) * (world->time() - t0)};
    };
}

/// Robot R0 on two driven wheels: its speed, or how fast it turns.
Measure drives(double left, double right, bool turns) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = r0Scene(c.tick);
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        command(*world, "r/leftMotor", left, 0, 3);
        command(*world, "r/rightMotor", right, 0, 3);
        if (!run(*world, 1.5)) return {};
        if (turns) return {spin(*world, "r/chassis").z(), (right - left) * kR0Radius / kR0Track};
        return {velocity(*world, "r/chassis").head<2>().norm(), (left + right) / 2 * kR0Radius};
    };
}

Vehicle vehicle(double mass, double mu, std::vector<Vec3> wheels, std::vector<Vec3> sliders, const Vec3& centre) {
    Vehicle v;
    v.mass = mass;
    v.friction = mu;
    v.wheels = std::move(wheels);
    v.sliders = std::move(sliders);
    v.centre = centre;
    return v;
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> list;
        const auto add = [&list](std::string name, Measure measure, double most, double mostAt30 = 0) {
            list.push_back({std::move(name), std::move(measure), most, mostAt30 > 0 ? mostAt30 : most, 0});
        };
        const auto number = [](double x) { return QString::number(x).toStdString(); };
        for (const double gravity : {1.62, 3.7, 24.8}) {
            add("falls at " + number(gravity) + " m/s2: speed", falls(gravity, 1.5, false), 1e-9);
            add("falls at " + number(gravity) + " m/s2: way", falls(gravity, 1.5, true), 1e-9);
        }
        for (const auto& [mass, mu, angle, heading] :
             {std::array{0.2, 0.15, 17.0, 10.0}, {6.0, 0.45, 38.0, 75.0}, {25.0, 0.7, 52.0, 201.0}, {90.0, 0.3, 33.0, 300.0}})
            add("slides down " + number(angle) + " deg, " + number(mass) + " kg", crate(mass, mu, angle, heading), 1e-3, 0.01);
        for (const auto& [mass, mu] : {std::array{0.3, 0.2}, {15.0, 0.55}, {70.0, 0.9}})
            for (const double off : {-1.0, 1.0})
                add((off < 0 ? "holds " : "slips ") + number(mass) + " kg, mu " + number(mu), parksCrate(mass, mu, off), 0.5);
        for (const auto& [mass, mu, pull, lift] :
             {std::array{2.0, 0.35, 0.7, 0.0}, {9.0, 0.5, 0.8, 25.0}, {30.0, 0.25, 0.6, -30.0}, {0.4, 0.8, 1.1, 40.0}})
            add("is pulled at " + number(lift) + " deg, " + number(mass) + " kg", crate(mass, mu, 0, 0, pull, lift), kFriction,
                kFrictionAt30);
        for (const auto& [mass, radius, k, angle] :
             {std::array{0.4, 0.03, 0.4, 9.0}, {12.0, 0.25, 0.4, 31.0}, {1.5, 0.1, 2.0 / 3, 24.0}})
            add("ball rolls, " + number(angle) + " deg", rolls(true, mass, radius, k, angle), kClose, 0.01);
        for (const auto& [mass, radius, k, angle] :
             {std::array{0.8, 0.04, 0.5, 14.0}, {40.0, 0.3, 0.5, 27.0}, {3.0, 0.12, 0.95, 35.0}})
            add("cylinder rolls, " + number(angle) + " deg", rolls(false, mass, radius, k, angle), kClose, 0.01);
        for (const auto& [mass, radius, mu, speed] : {std::array{0.2, 0.03, 0.25, 0.7}, {8.0, 0.2, 0.5, 2.6}})
            add("starts rolling at " + number(speed) + " m/s", startsRolling(mass, radius, mu, speed), kClose);
        for (const double mass : {0.04, 2.7, 85.0}) add("presses, " + number(mass) + " kg", presses(mass), kClose);
        for (const auto& [e, speed] : {std::array{0.15, 0.9}, {0.65, 2.3}, {0.92, 7.0}, {1.0, 3.1}})
            add("bounces, e " + number(e), bounces(e, speed, 0.3, 0), 1e-5);
        for (const auto& [e, speed, mu, across] : {std::array{0.4, 1.2, 0.15, 1.5}, {0.7, 2.0, 1.0, 1.1}})
            add("bounces aside, mu " + number(mu), bounces(e, speed, mu, across), kClose);
        for (const auto& [m1, m2, v1, v2, e] :
             {std::array{0.3, 2.0, 2.0, 0.5, 0.7}, {5.0, 0.8, 1.3, -0.6, 0.35}, {1.0, 40.0, 3.0, 0.2, 1.0}})
            add("meets " + number(m2) + " kg, e " + number(e), meet(m1, m2, v1, v2, e), kExact);
        for (const auto& [ball, rod, length, distance, speed, e] :
             {std::array{0.2, 1.0, 0.8, 0.3, 1.5, 0.6}, {2.0, 0.7, 0.5, 0.15, 2.5, 1.0}, {0.5, 6.0, 1.2, 0.5, 0.9, 0.25}})
            add("hits a rod of " + number(rod) + " kg", hitsRod(ball, rod, length, distance, speed, e), kClose);
        for (const auto& [mass, length, angle] : {std::array{0.15, 0.4, 25.0}, {7.0, 1.6, 65.0}, {2.2, 0.9, 140.0}}) {
            add("swings on a hinge from " + number(angle) + " deg", swings(JointType::Hinge, mass, length, angle), 5e-5, 1e-3);
            add("swings on a ball joint from " + number(angle) + " deg", swings(JointType::Ball, mass, length, angle), 5e-5,
                1e-3);
        }
        for (const auto& [inertia, frequency] : {std::array{0.02, 1.4}, {3.5, 3.3}, {45.0, 7.1}}) {
            add("spring of a slider, " + number(frequency) + " Hz", springs(JointType::Slider, inertia, frequency), 5e-3);
            add("spring of a hinge, " + number(frequency) + " Hz", springs(JointType::Hinge, inertia, frequency), 5e-3);
        }
        for (const auto& [mass, frequency] : {std::array{0.5, 2.2}, {20.0, 4.5}})
            add("bobs on soft ground, " + number(frequency) + " Hz", bobs(mass, frequency), 5e-3);
        for (const auto& [inertia, tau, share] : {std::array{3e-4, 0.02, 1.5}, {0.05, 0.13, 1.0}, {2.0, 0.9, 0.7}}) {
            add("spins up, tau " + number(tau) + " s", spinsUp(inertia, tau, share), 2e-3);
            add("hinge slows down, tau " + number(tau) + " s", slowsDown(JointType::Hinge, inertia, tau, share), 2e-3);
        }
        add("slider slows down", slowsDown(JointType::Slider, 12, 0.31, 1.2), 2e-3);
        for (const auto& [mass, radius, length, along, across] :
             {std::array{0.3, 0.15, 0.03, 9.0, 2.0}, {4.0, 0.05, 0.6, 14.0, 3.0}, {1.1, 0.2, 0.25, -5.0, 4.0}})
            add("wobbles, " + number(along) + " rad/s", wobbles(mass, radius, length, along, across, 9), kExact);
        add("drives straight", drives(11, 11, false), kClose);
        add("drives an arc", drives(7, 13, false), 5e-3);
        add("drives an arc: rate", drives(7, 13, true), 5e-3);
        add("turns on the spot: rate", drives(-6, 6, true), 5e-3);
        const Vehicle front = vehicle(7, 0.55, {{0.1, 0.15, 0}, {0.1, -0.15, 0}}, {{-0.16, 0, 0}}, {0.02, 0, 0.08}),
                      rear = vehicle(1.3, 0.85, {{0, 0.09, 0}, {0, -0.09, 0}}, {{0.2, 0, 0}}, {0.08, 0, 0.05}),
                      four = vehicle(11, 0.4, {{0.2, 0.18, 0}, {0.2, -0.18, 0}, {-0.2, 0.18, 0}, {-0.2, -0.18, 0}}, {},
                                     {0, 0, 0.07});
        add("front drive starts off", startsOff(front, 0, 1), kFriction, kFrictionAt30);
        add("front drive starts off uphill", startsOff(front, 6, 1), kFriction, kFrictionAt30);
        add("rear drive starts off", startsOff(rear, 0, 1), kFriction, kFrictionAt30);
        add("four wheels start off uphill", startsOff(four, 8, 1), kFriction, kFrictionAt30);
        add("four wheels brake", stops(four, 2.1), kFriction, kFrictionAt30);
        add("front drive brakes", stops(front, 1.7), kFriction, kFrictionAt30);
        add("skid steer", skidSteers(four, 0.6), 0.05);
        add("skid steer, wide",
            skidSteers(vehicle(2.6, 0.7, {{0.09, 0.2, 0}, {0.09, -0.2, 0}, {-0.09, 0.2, 0}, {-0.09, -0.2, 0}}, {}, {0, 0, 0.06}),
                       0.9),
            0.05);
        return list;
    }();
    return all;
}

} // namespace

class TheoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sixtyCases() { QVERIFY(cases().size() >= 60); }
    void closedForms_data() { addCases(cases()); }
    void closedForms() {
        QFETCH(int, index);
        QFETCH(double, tick);
        check(cases()[static_cast<std::size_t>(index)], {tick, SolverChoice::Exact});
    }
};

QTEST_APPLESS_MAIN(TheoryTest)
#include "theory_test.moc"
