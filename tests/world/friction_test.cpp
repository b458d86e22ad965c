// Coulomb friction of free bodies compared with closed forms or, where there is none, with a reference integrated here: cones,
// loads, impacts. Just below the angle of friction the quick solver creeps at longer ticks; those cases use only shorter ones.
#include "world/friction_cases.h"

using namespace fixture;

namespace {

// --- one block -------------------------------------------------------------------------------------------------------------------

struct Block {
    double mass = 1;
    Vec3 size{0.4, 0.3, 0.1};
    double friction = 0.3, friction2 = -1, heading = 0; ///< friction2: across the geom's own x axis
};

Scene blockScene(const Conditions& c, const Block& b, double drop = 0) {
    Scene scene = sceneOf(c);
    const auto s = surfaceOf(scene, b.friction, b.friction2);
    const auto floor = scene.surface(100);
    scene.scenery({plane("floor", {}, floor)});
    const double stiffness = std::max(2e5, b.mass * g / (3 * 1e-4));
    scene.loose("crate",
                at(0, 0, b.size.z() / 2 + drop - (drop > 0 ? 0 : b.mass * g / (4 * stiffness)), degrees(b.heading, 0, 0)),
                massOfBox(b.mass, b.size), {box("crate", b.size, {}, s)});
    return scene;
}

/// Gives a body a velocity in one tick, as impulses at its centre and about the vertical through it.
void setGoing(World& world, const std::string& path, double mass, double inertia, const Vec3& velocity, double spin) {
    const double h = world.experiment().settings.tick;
    const Vec3 at = position(world, path);
    (void)world.push(path, velocity * (mass / h), at);
    if (spin == 0) return;
    const double force = spin * inertia / h / 2; // two opposite forces with lever arms of 1 m
    (void)world.push(path, {0, force, 0}, at + Vec3(1, 0, 0));
    (void)world.push(path, {0, -force, 0}, at - Vec3(1, 0, 0));
}

/// Sliding down a slope that falls towards `heading`: the speed gained between two times.
Measure slides(Block b, double angle, double heading) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = blockScene(c, b);
        scene.spec->settings.gravity = slopeGravity(angle, heading);
        auto world = scene.build();
        const Vec3 down(std::cos(rad(heading)), std::sin(rad(heading)), 0);
        if (!world || !run(*world, 0.3)) return {};
        const double v0 = velocity(*world, "crate/body").dot(down), t0 = world->time();
        if (!run(*world, 0.9)) return {};
        return {(velocity(*world, "crate/body").dot(down) - v0) / (world->time() - t0),
                g * (std::sin(rad(angle)) - b.friction * std::cos(rad(angle)))};
    };
}

/// Holds `off` degrees below the angle of friction, slips above it: 1 if it behaves as expected.
Measure holds(Block b, double off, double heading) {
    return [=](const Conditions& c) -> Figures {
        const double limit = std::atan(b.friction) * 180 / kPi, angle = limit + off;
        Scene scene = blockScene(c, b);
        scene.spec->settings.gravity = slopeGravity(angle, heading);
        auto world = scene.build();
        if (!world || !run(*world, 0.3)) return {};
        const Vec3 from = position(*world, "crate/body");
        if (!run(*world, 1.5)) return {};
        const double moved = (position(*world, "crate/body") - from).head<2>().norm();
        const double a = g * (std::sin(rad(angle)) - b.friction * std::cos(rad(angle)));
        if (off < 0) return {moved < 1e-4 ? 1.0 : 2.0, 1};
        return {moved > 0.8 * a * 1.5 * 1.5 / 2 ? 1.0 : 0.0, 1};
    };
}

/// Slides to rest on level ground: the speed lost in the direction of sliding.
Measure brakes(Block b, double speed, double direction, double drop = 0) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = blockScene(c, b, drop);
        auto world = scene.build();
        if (!world || (drop == 0 && !run(*world, 0.3))) return {};
        const Vec3 way(std::cos(rad(direction)), std::sin(rad(direction)), 0);
        setGoing(*world, "crate/body", b.mass, 1, speed * way, 0);
        const double seconds = std::round(0.7 * speed / (b.friction * g) / 0.03) * 0.03;
        if (!run(*world, seconds)) return {};
        const Vec3 v = velocity(*world, "crate/body");
        return {(speed * way - v).head<2>().norm(), b.friction * g * seconds};
    };
}

/// Points of equal load under a flat body that slides and turns: its state after `seconds`, integrated in small steps.
struct Planar {
    double mass, inertia;
    std::vector<Eigen::Vector2d> points; ///< in the body's axes
    double mu1, mu2;                     ///< along the body's x, across it
    Eigen::Vector2d v = Eigen::Vector2d::Zero(), x = Eigen::Vector2d::Zero();
    double w = 0, turned = 0;

    void run(double seconds) {
        const double h = 2e-5;
        const double load = mass * g / static_cast<double>(points.size());
        for (int i = 0; i < static_cast<int>(std::lround(seconds / h)); ++i) {
            const Eigen::Rotation2Dd r(turned);
            Eigen::Vector2d force(0, 0);
            double torque = 0;
            for (std::size_t k = 0; k < points.size(); ++k) {
                const Eigen::Vector2d p = r * points[k];
                const Eigen::Vector2d slip = v + w * Eigen::Vector2d(-p.y(), p.x());
                const Eigen::Vector2d s = r.inverse() * slip;
                const double size = std::max(1e-4, std::hypot(mu1 * s.x(), mu2 * s.y()));
                const Eigen::Vector2d f = r * Eigen::Vector2d(-load * mu1 * mu1 * s.x() / size, -load * mu2 * mu2 * s.y() / size);
                force += f;
                torque += p.x() * f.y() - p.y() * f.x();
            }
            v += h * force / mass;
            w += h * torque / inertia;
            x += h * v;
            turned += h * w;
        }
    }
};

enum class What { Travel, Side, Turned };

/// A flat block that slides and spins: its pose at rest.
Measure whirls(Block b, const Vec3& v0, double spin, What what, double seconds = 1.2) {
    return [=](const Conditions& c) -> Figures {
        const double inertia = b.mass * (b.size.x() * b.size.x() + b.size.y() * b.size.y()) / 12;
        Scene scene = blockScene(c, b);
        auto world = scene.build();
        if (!world || !run(*world, 0.3)) return {};
        setGoing(*world, "crate/body", b.mass, inertia, v0, spin);
        if (!world->tick()) return {};
        const double mu2 = b.friction2 < 0 ? b.friction : b.friction2;
        Planar p{b.mass, inertia, corners(b.size.x() / 2, b.size.y() / 2), b.friction, mu2};
        p.v = velocity(*world, "crate/body").head<2>();
        p.x = position(*world, "crate/body").head<2>();
        p.w = fixture::spin(*world, "crate/body").z();
        p.turned = hprFromRotation(world->robotPose(0).rotation).x();
        const Eigen::Vector2d x0 = p.x, u0 = p.v;
        const double w0 = p.w, a0 = p.turned;
        p.run(seconds);
        double turned = 0;
        for (double t = 0; t < seconds - 1e-9; t += c.tick) {
            if (!world->tick()) return {};
            turned += c.tick * fixture::spin(*world, "crate/body").z();
        }
        // What symplectic Euler is known to lose: h/2 of the change of speed.
        turned += c.tick / 2 * (w0 - fixture::spin(*world, "crate/body").z());
        const Eigen::Vector2d way =
            (position(*world, "crate/body") + c.tick / 2 * (Vec3(u0.x(), u0.y(), 0) - velocity(*world, "crate/body"))).head<2>() -
            x0;
        if (what == What::Turned) return {turned, p.turned - a0};
        if (what == What::Side) return {way.y(), p.x.y() - x0.y()};
        return {way.x(), p.x.x() - x0.x()};
    };
}

/// A force at an upward angle reduces the load: F cos - mu (m g - F sin).
Measure pulledUp(Block b, double force, double up, double direction) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = blockScene(c, b);
        auto world = scene.build();
        if (!world || !run(*world, 0.3)) return {};
        const Vec3 way(std::cos(rad(direction)), std::sin(rad(direction)), 0);
        const Vec3 f = force * (std::cos(rad(up)) * way + std::sin(rad(up)) * Vec3::UnitZ());
        double v0 = 0, t0 = 0;
        for (double t = 0; t < 1.2 - 1e-9; t += c.tick) {
            if (t0 == 0 && t > 0.3) {
                v0 = velocity(*world, "crate/body").dot(way);
                t0 = world->time();
            }
            (void)world->push("crate/body", f, position(*world, "crate/body"));
            if (!world->tick()) return {};
        }
        return {(velocity(*world, "crate/body").dot(way) - v0) / (world->time() - t0),
                force * std::cos(rad(up)) / b.mass - b.friction * (g - force * std::sin(rad(up)) / b.mass)};
    };
}

/// On a belt of speed V with a steady pull of f mu m g across it: creep V f / sqrt(1 - f^2).
Measure creepsOnBelt(Block b, double speed, double share) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const auto s = surfaceOf(scene, b.friction, -1);
        const auto slick = scene.surface(0);
        addBeltBody(scene, "crate", b.mass, b.size, s);
        // Held by a frictionless wall along the belt, pulled across it.
        scene.scenery({plane("floor", {}, s), box("wall", {0.2, 60, 1}, at(-b.size.x() / 2 - 0.1, 0, 0.5), slick)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        setBelt(*world, "crate/belt", {speed, 0, 0});
        if (!run(*world, 0.3)) return {};
        double y0 = 0, t0 = 0;
        for (double t = 0; t < 1.8 - 1e-9; t += c.tick) {
            if (t0 == 0 && t > 0.9) {
                y0 = position(*world, "crate/body").y();
                t0 = world->time();
            }
            (void)world->push("crate/body", {0, share * b.friction * b.mass * g, 0}, position(*world, "crate/body"));
            if (!world->tick()) return {};
        }
        return {(position(*world, "crate/body").y() - y0) / (world->time() - t0), speed * share / std::sqrt(1 - share * share)};
    };
}

/// One block on another that is pulled hard: both accelerations.
Measure stacked(double lower, double upper, double muTop, double muFloor, double force, bool ofUpper) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const auto top = scene.surface(muTop), floor = scene.surface(muFloor), rough = scene.surface(100);
        (void)rough;
        const Vec3 big(1, 0.6, 0.1), small(0.3, 0.2, 0.1);
        scene.scenery({plane("floor", {}, floor)});
        scene.loose("lower", at(0, 0, 0.05), massOfBox(lower, big), {box("b", big, {}, rough)});
        scene.loose("upper", at(-0.1, 0, 0.15), massOfBox(upper, small), {box("b", small, {}, top)});
        auto world = scene.build();
        if (!world || !run(*world, 0.3)) return {};
        const std::string path = ofUpper ? "upper/body" : "lower/body";
        double v0 = 0, t0 = 0;
        for (double t = 0; t < 0.6 - 1e-9; t += c.tick) {
            if (t0 == 0 && t > 0.2) {
                v0 = velocity(*world, path).x();
                t0 = world->time();
            }
            (void)world->push("lower/body", {force, 0, 0}, position(*world, "lower/body") - Vec3(0, 0, 0.05));
            if (!world->tick()) return {};
        }
        const double a = (velocity(*world, path).x() - v0) / (world->time() - t0);
        return {a, ofUpper ? muTop * g : (force - muTop * upper * g - muFloor * (lower + upper) * g) / lower};
    };
}

// --- rolling things --------------------------------------------------------------------------------------------------------------

/// A ball or a cylinder down a slope too steep to roll: g (sin - mu cos).
Measure skidsDown(double mass, double radius, double mu, double angle, bool ball) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const auto s = scene.surface(mu);
        scene.spec->settings.gravity = slopeGravity(angle, 0);
        scene.scenery({plane("floor", {}, s)});
        const Quat lying = rotationFromHpr(degrees(0, 0, 90));
        if (ball) scene.ball("roller", {0, 0, radius}, mass, radius, s);
        else
            scene.loose("roller", at(0, 0, radius - mass * g * std::cos(rad(angle)) / 4e5),
                        massOfCylinder(mass, radius, 0.2, lying), {cylinder("c", radius, 0.2, {Vec3::Zero(), lying}, s)});
        auto world = scene.build();
        if (!world || !run(*world, 0.3)) return {};
        const double v0 = velocity(*world, "roller/body").x(), t0 = world->time();
        if (!run(*world, 0.6)) return {};
        return {(velocity(*world, "roller/body").x() - v0) / (world->time() - t0),
                g * (std::sin(rad(angle)) - mu * std::cos(rad(angle)))};
    };
}

/// A ball thrown at the floor without spin that slips during the whole impact: it loses mu (1 + e) v of its tangential speed.
Measure glances(double mass, double mu, double e, double along, double down) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        scene.spec->settings.gravity = Vec3::Zero();
        const auto s = scene.surface(mu, e);
        const double r = 0.1;
        scene.scenery({plane("floor", {}, s)}).ball("ball", {0, 0, r + 0.2}, mass, r, s);
        auto world = scene.build();
        if (!world) return {};
        const Vec3 way(std::cos(0.5), std::sin(0.5), 0);
        setGoing(*world, "ball/body", mass, 1, along * way - Vec3(0, 0, down), 0);
        if (!run(*world, 0.6 / down + 0.3)) return {};
        return {along - velocity(*world, "ball/body").dot(way),
                mu * (down + velocity(*world, "ball/body").z())}; // change of normal velocity, including push-out
    };
}

/// A turntable of 2 m radius about z, its top at z = 0.
void addTurntable(Scene& scene, std::uint32_t surface) {
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(body("disc", {}, massOfCylinder(500, 2, 0.1), {cylinder("c", 2, 0.1, {}, surface)}));
    config->joints.push_back(joint("axle", JointType::Hinge, kWorldBody, 0, Vec3::Zero(), Vec3::UnitZ()));
    config->devices.push_back(row("motor", "axle"));
    scene.robot("table", at(0, 0, -0.05), config);
}

/// Faster and faster up to `rate`.
bool speedUp(World& world, double rate, double seconds) {
    const int n = static_cast<int>(std::lround(seconds / world.experiment().settings.tick));
    for (int i = 1; i <= n; ++i) {
        command(world, "table/motor", rate * i / n, 0, 1e7);
        if (!world.tick()) return false;
    }
    return true;
}

/// A block on a turntable, held by friction, of which it uses a share: how far it is from the axis after 3 s.
Measure ridesRound(double share) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const double mu = 0.8, r = 0.5;
        const auto s = scene.surface(mu);
        addTurntable(scene, s);
        const Vec3 size(0.06, 0.05, 0.04);
        scene.loose("crate", at(r, 0, 0.02, degrees(10, 0, 0)), massOfBox(0.4, size), {box("b", size, {}, s)});
        auto world = scene.build();
        if (!world || !speedUp(*world, std::sqrt(share * mu * g / r), 2.4) || !run(*world, 3)) return {};
        return {position(*world, "crate/body").head<2>().norm(), r};
    };
}

/// A ball that rolls on a turntable goes round at 2 / 7 of its rate, with a steady speed: the speed.
Measure rollsRound(double rate) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const auto s = scene.surface(2);
        addTurntable(scene, s);
        scene.ball("ball", {0.5, 0, 0.05}, 0.4, 0.05, s);
        auto world = scene.build();
        if (!world || !speedUp(*world, rate, 0.3)) return {};
        setGoing(*world, "ball/body", 0.4, 1, {0, 0.2, 0}, 0);
        if (!run(*world, 0.3)) return {};
        const double speed = velocity(*world, "ball/body").head<2>().norm();
        if (!run(*world, 4.5)) return {};
        return {velocity(*world, "ball/body").head<2>().norm(), speed};
    };
}

std::vector<Case> cases() {
    const Block light{0.4, {0.3, 0.3, 0.06}, 0.25}, heavy{25, {0.5, 0.4, 0.12}, 0.6, -1, 20};
    return {
        {"slides, slope along the axes", slides(light, 25, 0)},
        {"slides, 22.5 deg to the axes", slides(light, 25, 22.5)},
        {"slides, 45 deg, heavy", slides(heavy, 40, 45)},
        {"slides, 70 deg, heavy", slides(heavy, 36, 70)},
        {"holds 1 deg below, along", holds(light, -1, 0), 0.02, 0.04, 0.005},
        {"slips 1 deg above, along", holds(light, 1, 0)},
        {"holds 1 deg below, 45 deg", holds(light, -1, 45), 0.02, 0.04, 0.005},
        {"slips 1 deg above, 45 deg", holds(light, 1, 45)},
        {"slips 1 deg above, 30 deg, heavy", holds(heavy, 1, 30)},
        {"holds 1 deg below, 30 deg, heavy", holds(heavy, -1, 30), 0.02, 0.04, 0.005},
        {"brakes along", brakes(light, 2, 0)},
        {"brakes at 37 deg, heavy", brakes(heavy, 3, 37)},
        {"brakes after a fall of 5 cm", brakes(light, 2, 20, 0.05)},
        {"brakes after a fall of 20 cm, heavy", brakes(heavy, 5, 0, 0.2)},
        {"spins to rest", whirls({1, {0.3, 0.3, 0.02}, 0.4}, {0, 0, 0}, 8, What::Turned)},
        {"spins and slides: way", whirls({2, {0.3, 0.2, 0.02}, 0.3}, {1.2, 0, 0}, 6, What::Travel)},
        {"spins and slides: turn", whirls({2, {0.3, 0.2, 0.02}, 0.3}, {1.2, 0, 0}, 6, What::Turned), 0.02, 0.04, 0.005},
        {"skates: slides along its grip", whirls({1, {0.3, 0.2, 0.02}, 0.2, 0.6, 0}, {1.5, 0, 0}, 0, What::Travel)},
        {"skates: turned 40 deg, way", whirls({1, {0.3, 0.2, 0.02}, 0.1, 0.6, 40}, {1.5, 0, 0}, 0, What::Travel), 0.02, 0.04, 0},
        {"skates: turned 40 deg, aside", whirls({1, {0.3, 0.2, 0.02}, 0.1, 0.6, 40}, {1.5, 0, 0}, 0, What::Side), 0.02, 0.04, 0},
        {"skates: turned 65 deg and spinning", whirls({3, {0.4, 0.2, 0.02}, 0.15, 0.5, 65}, {1, 0.5, 0}, 3, What::Side), 0.02,
         0.04, 0.01},
        {"pulled up at 30 deg", pulledUp({3, {0.4, 0.3, 0.04}, 0.5}, 17, 30, 25)},
        {"pushed down at 20 deg", pulledUp({3, {0.4, 0.3, 0.04}, 0.5}, 30, -20, 115)},
        {"creeps across its belt, .5", creepsOnBelt({1.5, {0.4, 0.3, 0.04}, 0.5}, 0.6, 0.5), 0.02, 0.04, 0.01},
        {"creeps across its belt, .8", creepsOnBelt({1.5, {0.4, 0.3, 0.04}, 0.5}, 0.3, 0.8)},
        {"block on a block: lower", stacked(4, 1, 0.2, 0.3, 30, false)},
        {"block on a block: upper", stacked(4, 1, 0.2, 0.3, 30, true)},
        {"ball skids down", skidsDown(1, 0.1, 0.1, 35, true)},
        {"cylinder skids down", skidsDown(3, 0.06, 0.15, 40, false)},
        {"rides on a turntable, .15 of its grip", ridesRound(0.15), 0.001, 0.003, 0.01},
        {"rides on a turntable, .8 of its grip", ridesRound(0.8), 0.002, 0.02, 0},
        {"ball rolls on a turntable", rollsRound(2), 0.0001, 0.0001},
        {"ball glances off, e .6", glances(1, 0.2, 0.6, 4, 2)},
        {"ball glances off, e 0", glances(0.3, 0.3, 0, 4, 2)},
    };
}

} // namespace

class FrictionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void coulomb_data() { addCases(cases()); }
    void coulomb() {
        QFETCH(int, index);
        QFETCH(double, tick);
        QFETCH(int, solver);
        check(cases()[static_cast<std::size_t>(index)], {tick, static_cast<SolverChoice>(solver)});
    }

    /// Two blocks on a slope, on a surface and its mirror image, which has the same name. Its heading changes in the run: each
    /// slides aside as far as the other, to the other side.
    void aChangedHeadingIsMirrored() {
        Scene scene(0.005);
        const auto own = surfaceOf(scene, 0.05, 1), mirrored = surfaceOf(scene, 0.05, 1), floor = scene.surface(100);
        scene.spec->surfaces[own].frictionHeading = rad(10);
        scene.spec->surfaces[mirrored] = scene.spec->surfaces[own];
        scene.spec->surfaces[mirrored].frictionHeading = rad(-10);
        scene.spec->settings.gravity = slopeGravity(20, 90);
        scene.scenery({plane("floor", {}, floor)});
        const Vec3 size(0.4, 0.4, 0.06);
        scene.loose("right", at(1, 0, 0.03), massOfBox(1, size), {box("b", size, {}, own)});
        scene.loose("left", at(-1, 0, 0.03), massOfBox(1, size), {box("b", size, {}, mirrored)});
        auto world = scene.build();
        QVERIFY(world);
        SurfaceSpec changed = scene.spec->surfaces[own];
        changed.frictionHeading = rad(60);
        QVERIFY(world->setSurface(changed).ok());
        QVERIFY(run(*world, 0.5));
        const Vec3 right = position(*world, "right/body") - Vec3(1, 0, 0), left = position(*world, "left/body") + Vec3(1, 0, 0);
        QVERIFY2(std::abs(right.x()) > 0.05 && right.y() > 0.1, qPrintable(QString("%1 %2").arg(right.x()).arg(right.y())));
        QVERIFY2(std::abs(right.x() + left.x()) < 0.2 * std::abs(right.x()), qPrintable(QString("%1").arg(left.x())));
        QVERIFY2(std::abs(right.y() - left.y()) < 0.2 * right.y(), qPrintable(QString("%1").arg(left.y())));
    }
};

QTEST_APPLESS_MAIN(FrictionTest)
#include "friction_test.moc"
