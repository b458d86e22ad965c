// Coulomb friction of vehicles compared with closed forms. Exact solver only, except for tracks: the quick one does not hold axles
// and locked wheels tightly enough.
#include "world/friction_vehicles.h"

using namespace fixture;

namespace {

Vehicle r0Like(double mu) {
    Vehicle v;
    v.mass = 4;
    v.friction = mu;
    v.wheels = {{0, 0.125, 0}, {0, -0.125, 0}};
    v.sliders = {{-0.13, 0, 0}};
    v.centre = {-0.03, 0, 0.09};
    return v;
}
Vehicle tailDriven(double mu) {
    Vehicle v;
    v.mass = 2.2;
    v.friction = mu;
    v.wheels = {{0, 0.1, 0}, {0, -0.1, 0}};
    v.sliders = {{0.18, 0, 0}};
    v.centre = {0.06, 0, 0.06};
    return v;
}
Vehicle heavyTail() {
    Vehicle v = tailDriven(0.3);
    v.mass = 12;
    return v;
}
Vehicle longTail() {
    Vehicle v = tailDriven(0.4);
    v.mass = 3;
    v.sliders = {{0.25, 0, 0}};
    v.centre = {0.12, 0, 0.05};
    return v;
}
Vehicle fourWheels(double mu, double mass = 3, double a = 0.12, double b = 0.15) {
    Vehicle v;
    v.mass = mass;
    v.friction = mu;
    v.wheels = {{a, b, 0}, {a, -b, 0}, {-a, b, 0}, {-a, -b, 0}};
    v.centre = {0, 0, 0.05};
    return v;
}

/// Lands nose first on spinning wheels, as it turns about itself while they spin up: the mean acceleration, of which `more` is beyond the
/// balance of moments at rest. That is from an integration of the rigid vehicle in steps of 5 us, each blow without restitution.
Measure lands(Vehicle v, double drop, double more) {
    return [=](const Conditions& c) -> Figures {
        const Figures f = startsOff(v, 0, 1, drop)(c);
        return {f.measured, f.expected * (1 + more)};
    };
}

/// Parked with its wheels locked: stays or slips `off` degrees from its limit, on a slope that rises towards `heading` of the vehicle.
Measure parks(Vehicle v, double off, double heading) {
    return [=](const Conditions& c) -> Figures {
        Vehicle copy = v;
        Scene scene = sceneOf(c);
        addVehicle(scene, copy, 0);
        scene.scenery({plane("floor", {}, copy.ground)});
        const double limit = copy.sliders.empty() ? std::atan(copy.friction) * 180 / kPi : copy.slipAngle(heading == 0 ? 1 : -1);
        scene.spec->settings.gravity = slopeGravity(limit + off, heading + 180);
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        driveAll(*world, copy, 0);
        if (!run(*world, 0.3)) return {};
        const Vec3 from = position(*world, "v/chassis");
        if (!run(*world, 2.4)) return {};
        const double moved = (position(*world, "v/chassis") - from).norm();
        return off < 0 ? Figures{moved < 2e-3 ? 1.0 : 2.0, 1} : Figures{moved > 0.02 ? 1.0 : 0.0, 1};
    };
}

/// Parked above its limit it slides: the distance in 2 s.
Measure slidesParked(Vehicle v, double angle, double heading) {
    return [=](const Conditions& c) -> Figures {
        Vehicle copy = v;
        Scene scene = sceneOf(c);
        addVehicle(scene, copy, 0);
        scene.scenery({plane("floor", {}, copy.ground)});
        scene.spec->settings.gravity = slopeGravity(angle, heading + 180);
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        driveAll(*world, copy, 0);
        const Vec3 down = -Vec3(std::cos(rad(heading)), std::sin(rad(heading)), 0);
        if (!run(*world, 0.3)) return {};
        const double v0 = velocity(*world, "v/chassis").dot(down);
        if (!run(*world, 1.5)) return {};
        const double friction =
            copy.sliders.empty() ? copy.friction * g * std::cos(rad(angle)) : copy.traction(angle, heading == 0 ? 1 : -1);
        return {(velocity(*world, "v/chassis").dot(down) - v0) / 1.5, g * std::sin(rad(angle)) - friction};
    };
}

/// Two tracks, each a box with a moving surface.
Measure tracksTurn(double mass, double length, double gauge, double width, double mu, double speed) {
    return [=](const Conditions& c) -> Figures {
        Scene scene = sceneOf(c);
        const auto s = scene.surface(mu);
        addTracked(scene, mass, length, gauge, width, s);
        scene.scenery({plane("floor", {}, s)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        setBelt(*world, "tracked/leftBelt", {speed, 0, 0});
        setBelt(*world, "tracked/rightBelt", {-speed, 0, 0});
        if (!run(*world, 1.5)) return {};
        const std::optional<double> rate = turnRate(*world, "tracked/chassis", 1.5);
        if (!rate) return {};
        std::vector<Eigen::Vector2d> points;
        for (const double y : {gauge / 2, -gauge / 2})
            for (const Eigen::Vector2d& p : corners(length / 2, width / 2)) points.push_back({p.x(), p.y() + y});
        return {*rate, skidRate(points, speed)};
    };
}

/// All wheels spin while a frictionless wall ahead blocks the vehicle; pulled sideways with a share of mu m g it creeps.
Measure spinsAside(Vehicle v, double speed, double share) {
    return [=](const Conditions& c) -> Figures {
        Vehicle copy = v;
        Scene scene = sceneOf(c);
        addVehicle(scene, copy, 0);
        scene.scenery({plane("floor", {}, copy.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        // Front wheels forwards, rear wheels backwards: the vehicle stays in place, and all wheels slip.
        for (std::size_t i = 0; i < copy.wheels.size(); ++i)
            drive(*world, copy, i, (copy.wheels[i].x() > copy.centre.x() ? 1 : -1) * speed / v.radius);
        const double pull = share * v.friction * copy.total * g;
        double y0 = 0, t0 = 0;
        for (double t = 0; t < 3 - 1e-9; t += c.tick) {
            if (t0 == 0 && t > 2.1) {
                y0 = position(*world, "v/chassis").y();
                t0 = world->time();
            }
            const Vec3 at = copy.centre - Vec3(0, 0, copy.centre.z());
            (void)world->push("v/chassis", {0, pull, 0}, world->robotPose(0) * at);
            if (!world->tick()) return {};
        }
        return {(position(*world, "v/chassis").y() - y0) / (world->time() - t0), speed * share / std::sqrt(1 - share * share)};
    };
}

/// Pulls a sled by a rod, or pushes a crate: traction minus the sled's friction.
Measure hauls(Vehicle v, double sled, double muSled, bool pushing) {
    return [=](const Conditions& c) -> Figures {
        Vehicle copy = v;
        Scene scene = sceneOf(c);
        const auto slow = scene.surface(muSled);
        const Vec3 size(0.4, 0.3, 0.06);
        if (pushing) {
            addVehicle(scene, copy, 0);
            const double front = v.reach();
            const auto slick = scene.surface(0);
            // a foot below with the sled's friction, a slick face towards the vehicle
            scene.loose(
                "sled", at(front + 0.22, 0, 0.03), massOfBox(sled, size),
                {box("foot", {0.4, 0.3, 0.02}, at(0, 0, -0.02), slow), box("face", {0.04, 0.3, 0.2}, at(-0.2, 0, 0.1), slick)});
        } else addVehicle(scene, copy, 0, Sled{sled, slow, size});
        scene.scenery({plane("floor", {}, copy.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        driveAll(*world, copy, 15 / v.radius);
        if (!run(*world, 0.3)) return {};
        const double v0 = velocity(*world, "v/chassis").x(), t0 = world->time();
        if (!run(*world, 0.6)) return {};
        const double a = (velocity(*world, "v/chassis").x() - v0) / (world->time() - t0);
        return {a, (v.friction * copy.total - muSled * sled) * g / (copy.total + sled)};
    };
}

/// Four driven wheels against a step: 1 if the vehicle climbs it.
Measure climbs(Vehicle v, double step, double speed) {
    return [=](const Conditions& c) -> Figures {
        Vehicle copy = v;
        Scene scene = sceneOf(c);
        addVehicle(scene, copy, 0);
        const double wall = copy.wheels[0].x() + v.radius + 0.2;
        scene.scenery({plane("floor", {}, copy.ground), box("step", {2, 2, step}, at(wall + 1, 0, step / 2), copy.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        driveAll(*world, copy, speed / v.radius);
        if (!run(*world, 6)) return {};
        return {position(*world, "v/chassis").z() > 0.8 * step ? 1.0 : 0.0, 1};
    };
}

/// Wheels without grip across their plane on two axes: the base goes where the wheels together say.
Measure omniDrives(double direction, double speed) {
    return [=](const Conditions& c) -> Figures {
        Vehicle v;
        v.friction = 0.8;
        v.friction2 = 0;
        v.omni = true;
        v.wheels = {{0.2, 0, 0}, {-0.1, 0.17320508, 0}, {-0.1, -0.17320508, 0}};
        v.centre = {0, 0, 0.08};
        Scene scene = sceneOf(c);
        addVehicle(scene, v, 0);
        scene.scenery({plane("floor", {}, v.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        const Vec3 way(std::cos(rad(direction)), std::sin(rad(direction)), 0);
        for (std::size_t i = 0; i < v.wheels.size(); ++i) {
            const Vec3 axle = v.wheels[i].normalized(), rolls = axle.cross(Vec3::UnitZ());
            drive(*world, v, i, speed * way.dot(rolls) / v.radius);
        }
        if (!run(*world, 0.6)) return {};
        const Vec3 from = position(*world, "v/chassis");
        if (!run(*world, 1.5)) return {};
        const Vec3 moved =
            world->robotPose(0).rotation.conjugate() * Vec3(position(*world, "v/chassis") - from); // it starts off with a jerk
        return {moved.dot(way) - std::abs(moved.cross(way).z()), 1.5 * speed};
    };
}

/// Four wheels that grip along one diagonal each: driven at v_x -+ v_y as the two diagonals say.
Measure mecanumDrives(double direction, double speed) {
    return [=](const Conditions& c) -> Figures {
        Vehicle v = fourWheels(0.8);
        v.friction2 = 0;
        Scene scene = sceneOf(c);
        v.headings = {rad(45), rad(-45), rad(-45), rad(45)};
        addVehicle(scene, v, 0);
        scene.scenery({plane("floor", {}, v.ground)});
        auto world = scene.build(beltOrRow);
        if (!world) return {};
        const Vec3 way(std::cos(rad(direction)), std::sin(rad(direction)), 0);
        for (std::size_t i = 0; i < v.wheels.size(); ++i) // the rim's speed along the grip is the ground's: w r cos = v . grip
            drive(*world, v, i, speed * (way.x() + std::tan(v.headings[i]) * way.y()) / v.radius);
        if (!run(*world, 0.9)) return {};
        const Vec3 from = position(*world, "v/chassis");
        if (!run(*world, 1.5)) return {};
        const Vec3 moved = position(*world, "v/chassis") - from;
        return {moved.dot(way) - std::abs(moved.cross(way).z()), 1.5 * speed};
    };
}

std::vector<Case> allCases() {
    return {
        {"front drive starts off, mu 1", startsOff(r0Like(1), 0, 1), 0.02, 0.04, 0},
        {"front drive backwards, mu .2", startsOff(r0Like(0.2), 0, -1), 0.02, 0.04, 0},
        {"rear drive starts off, mu .3", startsOff(tailDriven(0.3), 0, 1), 0.02, 0.04, 0},
        {"rear drive starts off, mu .8", startsOff(tailDriven(0.8), 0, 1), 0.02, 0.04, 0},
        {"four wheels up 15 deg, mu .7", startsOff(fourWheels(0.7), 15, 1), 0.02, 0.04, 0},
        {"front drive up 8 deg, mu .7", startsOff(r0Like(0.7), 8, 1), 0.02, 0.04, 0},
        {"lands on spinning wheels", startsOff(fourWheels(0.4), 0, 1, 0.09), 0.02, 0.04, 0},
        {"lands on spinning rear wheels", lands(tailDriven(0.3), 0.06, 0.0126), 0.02, 0.04, 0},
        {"lands on spinning rear wheels, mu .6", lands(tailDriven(0.6), 0.06, 0.0208), 0.02, 0.04, 0},
        {"lands on spinning rear wheels, 12 kg", lands(heavyTail(), 0.06, 0.0022), 0.02, 0.04, 0},
        {"lands on spinning rear wheels, long", lands(longTail(), 0.05, 0.0063), 0.02, 0.04, 0},
        {"front wheels lock", stops(r0Like(0.25), 2), 0.02, 0.04, 0},
        {"rear wheels lock", stops(tailDriven(0.5), 1.5), 0.02, 0.04, 0},
        {"four wheels lock", stops(fourWheels(0.9, 12), 3), 0.02, 0.04, 0},
        {"parks nose up, 1 deg below", parks(r0Like(1), -1, 0), 0.02, 0.04, 0},
        {"parks nose up, 1 deg above", parks(r0Like(1), 1, 0), 0.02, 0.04, 0},
        {"parks nose down, 1 deg below", parks(r0Like(0.2), -1, 180), 0.02, 0.04, 0},
        {"parks nose down, 1 deg above", parks(r0Like(0.2), 1, 180), 0.02, 0.04, 0},
        {"parks across, 1 deg below", parks(fourWheels(0.6), -1, 90), 0.02, 0.04, 0},
        {"parks across, 1 deg above", parks(fourWheels(0.6), 1, 90), 0.02, 0.04, 0},
        {"parks at 35 deg, 1 deg below", parks(fourWheels(0.6), -1, 35), 0.02, 0.04, 0},
        {"parks at 35 deg, 1 deg above", parks(fourWheels(0.6), 1, 35), 0.02, 0.04, 0},
        {"slides parked, nose up", slidesParked(r0Like(1), 31, 0), 0.02, 0.04, 0},
        {"slides parked, nose down", slidesParked(r0Like(0.3), 27, 180), 0.02, 0.04, 0},
        {"slides parked at 50 deg", slidesParked(fourWheels(0.4), 27, 50), 0.02, 0.04, 0},
        {"skid steer, wide", skidSteers(fourWheels(0.7), 0.4), 0.05, 0.05, 0},
        {"skid steer, long", skidSteers(fourWheels(0.5, 6, 0.2, 0.14), 0.3), 0.05, 0.05, 0},
        // the base of the first report: 0.642 rad/s, where a box of friction has it turn at 1.186
        {"skid steer at 0.642 rad/s", skidSteers(fourWheels(0.8, 4, 0.115, 0.125), 0.14825), 0.05, 0.05, 0},
        {"skid steer at 0.642 rad/s, mu .3", skidSteers(fourWheels(0.3, 1.2, 0.14, 0.15), 0.1803), 0.05, 0.05, 0},
        {"tracks turn in place, short and heavy", tracksTurn(40, 0.25, 0.35, 0.08, 0.9, 0.25), 0.05, 0.05, 0.01},
        {"tracks turn in place", tracksTurn(5, 0.4, 0.3, 0.06, 0.7, 0.4), 0.05, 0.05, 0.01},
        {"tracks turn in place, long", tracksTurn(15, 0.7, 0.4, 0.1, 0.5, 0.6), 0.05, 0.05, 0.01},
        {"four spinning wheels pulled aside, .5", spinsAside(fourWheels(0.5), 1, 0.5), 0.02, 0.04, 0},
        {"four spinning wheels pulled aside, .2", spinsAside(fourWheels(0.8, 8), 2, 0.2), 0.02, 0.04, 0},
        {"four spinning wheels pulled aside 1.2 m in a second", spinsAside(fourWheels(0.6, 5), 0.9, 0.8), 0.02, 0.04, 0},
        {"tows a sled", hauls(fourWheels(0.8, 4), 3, 0.3, false), 0.02, 0.04, 0},
        {"pushes a sled", hauls(fourWheels(0.8, 4), 2, 0.4, true), 0.02, 0.04, 0},
        {"omni base, ahead", omniDrives(0, 0.4), 0.02, 0.04, 0},
        {"omni base, at 77 deg", omniDrives(77, 0.4), 0.02, 0.04, 0},
        {"omni base, at 210 deg", omniDrives(210, 0.25), 0.02, 0.04, 0},
        {"mecanum base, ahead", mecanumDrives(0, 0.4), 0.02, 0.04, 0},
        {"mecanum base, aside", mecanumDrives(90, 0.3), 0.02, 0.04, 0},
        {"mecanum base, at 130 deg", mecanumDrives(130, 0.3), 0.02, 0.04, 0},
        {"climbs .46 of the wheel", climbs(fourWheels(1, 3, 0.12, 0.1), 0.046, 0.3), 0.02, 0.04, 0},
        {"climbs .3 of the wheel", climbs(fourWheels(0.9, 5, 0.15, 0.1), 0.03, 0.3), 0.02, 0.04, 0},
    };
}

/// Those that stay on level ground, with nothing but wheels and sliders, are for the wheeled engine too.
std::vector<Case> cases() {
    std::vector<Case> all = allCases();
    for (Case& c : all) {
        const auto is = [&](const char* start) { return c.name.starts_with(start); };
        if (!is("lands") && !is("tracks") && !is("tows") && !is("climbs")) c.wheeledUpTo = 0.03;
        if (is("four spinning wheels pulled aside, .2")) c.wheeledUpTo = 0.01; // 5.5 % off at 30 ms
    }
    return all;
}

} // namespace

class FrictionVehiclesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void coulomb_data() { addCases(cases()); }
    void coulomb() {
        QFETCH(int, index);
        QFETCH(double, tick);
        QFETCH(int, solver);
        QFETCH(bool, wheeled);
        check(cases()[static_cast<std::size_t>(index)],
              {tick, static_cast<SolverChoice>(solver), wheeled ? EngineChoice::Wheeled : EngineChoice::General});
    }

    void mecanumBaseTurnsWithoutEffort_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("turn");
        QTest::addColumn<double>("waves"); // rad/s: of the turn and of the way
        QTest::addColumn<double>("most");  // of the effort that slips
        for (const double tick : {0.002, 0.01}) {
            QTest::addRow("slowly, %g ms", 1e3 * tick) << tick << 0.05 << 0.0 << 0.03;
            QTest::addRow("fast, %g ms", 1e3 * tick) << tick << 1.0 << 0.0 << 0.15;
            QTest::addRow("to and fro, %g ms", 1e3 * tick) << tick << 1.0 << 3.0 << 0.2;
        }
    }
    /// Each of the four wheels is as fast as the way of the base has it, so that none works against another.
    void mecanumBaseTurnsWithoutEffort() {
        QFETCH(double, tick);
        QFETCH(double, turn);
        QFETCH(double, waves);
        QFETCH(double, most);
        Vehicle v = fourWheels(0.8);
        v.friction2 = 0;
        v.headings = {rad(-45), rad(45), rad(45), rad(-45)};
        Scene scene(tick);
        addVehicle(scene, v, 0);
        scene.scenery({plane("floor", {}, v.ground)});
        auto world = scene.build(beltOrRow);
        QVERIFY(world);
        double sum = 0;
        const int ticks = static_cast<int>(std::lround(3 / tick)), first = ticks / 3;
        for (int i = 0; i < ticks; ++i) {
            const double time = i * tick, rate = turn * (waves > 0 ? std::sin(waves * time) : std::min(1.0, time));
            const double speed = 0.2 * (waves > 0 ? std::cos(waves * time) : std::min(1.0, time));
            for (std::size_t k = 0; k < v.wheels.size(); ++k) { // the rim's speed along the grip is the ground's
                const Vec3 way(speed - rate * v.wheels[k].y(), rate * v.wheels[k].x(), 0);
                drive(*world, v, k, (way.x() + std::tan(v.headings[k]) * way.y()) / v.radius);
            }
            QVERIFY(world->tick());
            if (i < first) continue;
            const auto effort = [&](int k) { return value(*world, "v/m" + std::to_string(k) + "/effort"); };
            sum += std::pow((effort(0) + effort(1) - effort(2) - effort(3)) / 4, 2); // the front against the back
        }
        const double fight = std::sqrt(sum / (ticks - first)), slips = 0.8 * v.total * g / 4 / std::numbers::sqrt2 * v.radius;
        qInfo("%.4f of %.4f N m", fight, slips);
        QVERIFY(fight < most * slips);
    }
};

QTEST_APPLESS_MAIN(FrictionVehiclesTest)
#include "friction_vehicles_test.moc"
