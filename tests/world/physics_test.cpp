// Textbook cases against the engine's settings. Limits are twice the error measured for these settings; what is exact there
// is held to 1e-6 (momentum to 1e-9).
#include <QtTest>

#include "world/fixtures.h"

using namespace fixture;

namespace {

/// Plane tilted by `slope` about y: downhill is +x turned; heading turns the friction axes against downhill.
Pose slope(double degreesDown, double heading = 0) { return {Vec3::Zero(), rotationFromHpr(degrees(heading, degreesDown, 0))}; }

double along(World& world, const std::string& path, const Vec3& axis) { return position(world, path).dot(axis); }

} // namespace

class PhysicsTest : public QObject {
    Q_OBJECT

    static void bothTicks() {
        QTest::addColumn<double>("h");
        QTest::newRow("10 ms") << 0.01;
        QTest::newRow("30 ms") << 0.03;
    }

private Q_SLOTS:
    void freeFall_data() { bothTicks(); }
    /// v = -g t to the last digits; symplectic Euler's z lags by g t h / 2 exactly.
    void freeFall() {
        QFETCH(double, h);
        Scene scene(h);
        scene.ball("ball", {0, 0, 100}, 1, 0.1);
        auto world = scene.build();
        QVERIFY(world && run(*world, 1.2));
        const double t = world->time();
        QVERIFY(std::abs(velocity(*world, "ball/body").z() + g * t) < 1e-9);
        QVERIFY(std::abs(position(*world, "ball/body").z() - (100 - g * t * t / 2 - g * t * h / 2)) < 1e-6 * g * t * t);
    }

    void sliding_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("heading");
        QTest::addColumn<double>("most");
        for (const double h : {0.01, 0.03}) {
            QTest::addRow("%g s along", h) << h << 0.0 << 2e-5;
            QTest::addRow("%g s 22.5 deg across", h) << h << 22.5 << 2e-5;
            QTest::addRow("%g s 45 deg across", h) << h << 45.0 << 2e-5;
        }
    }
    /// a = g (sin - mu cos) in every direction of the slope.
    void sliding() {
        QFETCH(double, h);
        QFETCH(double, heading);
        QFETCH(double, most);
        Scene scene(h);
        const auto s = scene.surface(0.3);
        const Pose incline = slope(30, 0);
        scene.scenery({plane("slope", incline, s)});
        const Quat turned = incline.rotation * rotationFromHpr(degrees(heading, 0, 0));
        const Vec3 size(0.4, 0.4, 0.1), down = incline.rotation * Vec3::UnitX();
        scene.loose("crate", {incline.rotation * Vec3(0, 0, 0.05 - 2e-5), turned}, massOfBox(1, size),
                    {box("crate", size, {}, s)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.6));
        const double v0 = velocity(*world, "crate/body").dot(down), t0 = world->time();
        QVERIFY(run(*world, 1.2));
        const double a = (velocity(*world, "crate/body").dot(down) - v0) / (world->time() - t0);
        const double expected = g * (std::sin(kPi / 6) - 0.3 * std::cos(kPi / 6));
        qInfo("relative error %.2g", a / expected - 1);
        QVERIFY(std::abs(a / expected - 1) < most);
    }

    void slidingFromRest_data() { bothTicks(); }
    void slidingFromRest() {
        QFETCH(double, h);
        Scene scene(h);
        const auto s = scene.surface(0.3);
        const Pose incline = slope(30, 0);
        scene.scenery({plane("slope", incline, s)});
        const Vec3 size(0.4, 0.4, 0.1), down = incline.rotation * Vec3::UnitX();
        scene.loose("crate", {incline.rotation * Vec3(0, 0, 0.05 - 1e-5), incline.rotation * rotationFromHpr(degrees(45, 0, 0))},
                    massOfBox(1, size), {box("crate", size, {}, s)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 1.2));
        const double a = velocity(*world, "crate/body").dot(down) / world->time(),
                     expected = g * (std::sin(kPi / 6) - 0.3 * std::cos(kPi / 6));
        qInfo("relative error %.2g", a / expected - 1);
        QVERIFY(std::abs(a / expected - 1) < 0.014);
    }

    void holding_data() { bothTicks(); }
    /// 15 degrees at mu = 0.3 holds; the limit of the creep was measured over 2 s.
    void holding() {
        QFETCH(double, h);
        Scene scene(h);
        const auto s = scene.surface(0.3);
        const Pose incline = slope(15);
        scene.scenery({plane("slope", incline, s)});
        const Vec3 size(0.4, 0.4, 0.1), down = incline.rotation * Vec3::UnitX();
        scene.loose("crate", {incline.rotation * Vec3(0, 0, 0.05), incline.rotation}, massOfBox(1, size),
                    {box("crate", size, {}, s)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.6));
        const double x0 = along(*world, "crate/body", down);
        QVERIFY(run(*world, 2.1));
        const double creep = along(*world, "crate/body", down) - x0;
        qInfo("creep %.3g m", creep);
        QVERIFY(std::abs(creep) < 1.6e-6);
    }

    void sag_data() { bothTicks(); }
    /// A ball of 1 kg rests m g / kp deep.
    void sag() {
        QFETCH(double, h);
        Scene scene(h);
        scene.scenery({plane()}).ball("ball", {0, 0, 0.1}, 1, 0.1);
        auto world = scene.build();
        QVERIFY(world && run(*world, 3));
        const double sag = 0.1 - position(*world, "ball/body").z();
        QVERIFY(std::abs(sag / 4.905e-5 - 1) < 2e-4);
    }

    void restitution_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("e");
        for (const double h : {0.01, 0.03})
            for (const double e : {0.3, 0.5, 0.8, 0.95}) QTest::addRow("%g s, e = %g", h, e) << h << e;
    }
    /// A ball dropped from 1 m: speed after over speed before is e.
    void restitution() {
        QFETCH(double, h);
        QFETCH(double, e);
        Scene scene(h);
        const auto s = scene.surface(0.5, e);
        scene.scenery({plane("floor", {}, s)}).ball("ball", {0, 0, 1.1}, 1, 0.1, s);
        auto world = scene.build();
        QVERIFY(world);
        double before = 0, after = 0;
        for (int i = 0; i < 200 && after <= 0; ++i) {
            before = after;
            QVERIFY(world->tick().ok());
            after = velocity(*world, "ball/body").z();
        }
        QVERIFY(after > 0);
        QVERIFY(std::abs(after / -before - e) < 2e-4);
    }

    void headOn_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("e");
        for (const double h : {0.01, 0.03})
            for (const double e : {1.0, 0.5}) QTest::addRow("%g s, e = %g", h, e) << h << e;
    }
    /// Equal spheres, one at rest: (1-e)/2 and (1+e)/2; momentum stays.
    void headOn() {
        QFETCH(double, h);
        QFETCH(double, e);
        Scene scene(h);
        scene.spec->settings.gravity = Vec3::Zero();
        const auto s = scene.surface(0.5, e);
        scene.ball("a", {0, 0, 1}, 1, 0.1, s).ball("b", {0.5, 0, 1}, 1, 0.1, s);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->push("a/body", {1 / h, 0, 0}, {0, 0, 1}).ok()); // 1 N s: 1 m/s
        QVERIFY(run(*world, 0.9));
        const double va = velocity(*world, "a/body").x(), vb = velocity(*world, "b/body").x();
        QVERIFY(std::abs(va - (1 - e) / 2) < 1e-6);
        QVERIFY(std::abs(vb - (1 + e) / 2) < 1e-6);
        QVERIFY(std::abs(va + vb - 1) < 1e-9);
    }

    void pendulum_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("errorReduction");
        QTest::addColumn<double>("period");
        QTest::addColumn<double>("kept");
        QTest::addColumn<double>("lengthMm");
        QTest::newRow("10 ms, soft joints") << 0.01 << 0.25 << 6e-6 << 0.9995 << 0.01;
        QTest::newRow("30 ms, soft joints") << 0.03 << 0.25 << 6e-6 << 0.9995 << 0.01;
        QTest::newRow("10 ms") << 0.01 << 0.8 << 6e-6 << 0.9995 << 0.01;
        QTest::newRow("30 ms") << 0.03 << 0.8 << 6e-6 << 0.9995 << 0.01;
    }
    /// 1 m, 10 deg, 60 s: T = 2 pi sqrt(I/mgl) (1 + a^2/16), whatever share of its error a joint corrects in a tick.
    void pendulum() {
        QFETCH(double, h);
        QFETCH(double, errorReduction);
        QFETCH(double, period);
        QFETCH(double, kept);
        QFETCH(double, lengthMm);
        const double a0 = 10 * kPi / 180, r = 0.05;
        Scene scene(h);
        scene.spec->settings.errorReduction = errorReduction;
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("bob", at(std::sin(a0), 0, 2 - std::cos(a0)), massOfSphere(1, r), {sphere("bob", r)}));
        config->joints.push_back(joint("pivot", JointType::Hinge, kWorldBody, 0, {0, 0, 2}, {0, -1, 0}));
        scene.robot("p", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        double last = position(*world, "p/bob").x(), first = 0, latest = 0, amplitude = 0, longest = 0;
        int crossings = 0;
        while (world->time() < 60) {
            QVERIFY(world->tick().ok());
            const Vec3 p = position(*world, "p/bob");
            const double x = p.x(), t = world->time();
            if (last < 0 && x >= 0) {
                latest = t - h * x / (x - last);
                if (crossings++ == 0) first = latest;
            }
            if (t > 58) amplitude = std::max(amplitude, std::abs(std::atan2(x, 2 - p.z())));
            longest = std::max(longest, std::abs((p - Vec3(0, 0, 2)).norm() - 1));
            last = x;
        }
        const double inertia = 1 + 0.4 * r * r, mean = a0 * (1 + amplitude / a0) / 2;
        const double expected = 2 * kPi * std::sqrt(inertia / g) * (1 + mean * mean / 16);
        const double measured = (latest - first) / (crossings - 1);
        qInfo("period %+.5f %%, amplitude kept %.4f, length off by %.3f mm", 100 * (measured / expected - 1), amplitude / a0,
              1e3 * longest);
        QVERIFY(std::abs(measured / expected - 1) < period);
        QVERIFY(amplitude / a0 > kept);
        QVERIFY(1e3 * longest < lengthMm);
    }

    void rolling_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("most");
        QTest::newRow("cylinder, 10 ms") << "cylinder" << 0.01 << 6e-5;
        QTest::newRow("cylinder, 30 ms") << "cylinder" << 0.03 << 1.6e-3;
        QTest::newRow("sphere on plane, 10 ms") << "sphere" << 0.01 << 1e-6;
        QTest::newRow("sphere on plane, 30 ms") << "sphere" << 0.03 << 1e-6;
        QTest::newRow("sphere on box, 10 ms") << "box" << 0.01 << 6e-4;
        QTest::newRow("sphere on box, 30 ms") << "box" << 0.03 << 2e-2;
    }
    /// Down 20 degrees without slip: 2/3 and 5/7 of g sin.
    void rolling() {
        QFETCH(QString, shape);
        QFETCH(double, h);
        QFETCH(double, most);
        Scene scene(h);
        const auto s = scene.surface(1);
        const Pose incline = slope(20);
        const Vec3 down = incline.rotation * Vec3::UnitX();
        if (shape == "box") scene.scenery({box("slope", {40, 4, 1}, {incline.rotation * Vec3(0, 0, -0.5), incline.rotation}, s)});
        else scene.scenery({plane("slope", incline, s)});
        const double r = 0.1, mass = 1, sagged = mass * g * std::cos(kPi / 9) / 2e5;
        const Quat lying = rotationFromHpr(degrees(0, 0, 90));
        if (shape == "cylinder")
            scene.loose("roller", {incline.rotation * Vec3(0, 0, r - sagged / 2), incline.rotation},
                        massOfCylinder(mass, r, 0.2, lying), {cylinder("c", r, 0.2, {Vec3::Zero(), lying}, s)});
        else scene.ball("roller", incline.rotation * Vec3(0, 0, r - sagged), mass, r, s);
        auto world = scene.build();
        QVERIFY(world && run(*world, 0.3));
        const double v0 = velocity(*world, "roller/body").dot(down), t0 = world->time();
        QVERIFY(run(*world, 1.5));
        const double a = (velocity(*world, "roller/body").dot(down) - v0) / (world->time() - t0);
        const double expected = (shape == "cylinder" ? 2.0 / 3 : 5.0 / 7) * g * std::sin(kPi / 9);
        qInfo("relative error %.3g", a / expected - 1);
        QVERIFY(std::abs(a / expected - 1) < most);
    }

    void slidingToRolling_data() { bothTicks(); }
    /// A ball set sliding at 1 m/s ends rolling at 5/7, after 2 v0 / (7 mu g).
    void slidingToRolling() {
        QFETCH(double, h);
        Scene scene(h);
        const auto s = scene.surface(0.3);
        scene.scenery({plane("floor", {}, s)}).ball("ball", {0, 0, 0.1 - 4.905e-5}, 1, 0.1, s);
        auto world = scene.build();
        QVERIFY(world);
        QVERIFY(world->push("ball/body", {1 / h, 0, 0}, position(*world, "ball/body")).ok());
        double rolls = 0;
        while (world->time() < 1) {
            QVERIFY(world->tick().ok());
            const double slip = velocity(*world, "ball/body").x() - 0.1 * spin(*world, "ball/body").y();
            if (rolls == 0 && std::abs(slip) < 1e-4) rolls = world->time();
        }
        QVERIFY(std::abs(velocity(*world, "ball/body").x() / (5.0 / 7) - 1) < 2e-6);
        QVERIFY(std::abs(rolls - 2 / (7 * 0.3 * g)) < 2 * h);
    }

    void motorSpinUp_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("ratio");
        for (const double h : {0.01, 0.03})
            for (const double ratio : {0.04, 0.2, 0.4, 1.2}) QTest::addRow("%g s, h/tau %g", h, ratio) << h << ratio;
    }
    /// w0 (1 - exp(-t/tau)), tau = I/b.
    void motorSpinUp() {
        QFETCH(double, h);
        QFETCH(double, ratio);
        const double tau = h / ratio, inertia = 0.4 * 1 * 0.01, b = inertia / tau, w0 = 13.33;
        Scene scene(h);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("rotor", at(0, 0, 1), massOfSphere(1, 0.1), {sphere("rotor", 0.1)}));
        config->joints.push_back(joint("axle", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, {0, 1, 0}));
        config->devices.push_back(row("motor", "axle"));
        scene.robot("m", {}, config);
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "m/motor", w0, 1 / b, 1e6);
        double worst = 0;
        while (world->time() < 6 * tau) {
            QVERIFY(world->tick().ok());
            worst = std::max(worst, std::abs(value(*world, "m/axle/rate") / w0 - (1 - std::exp(-world->time() / tau))));
        }
        qInfo("worst %.3g", worst);
        QVERIFY(worst < 1e-6);
    }

    void stall_data() {
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("mu");
        QTest::addColumn<double>("torque");
        for (const double h : {0.01, 0.03}) {
            QTest::addRow("%g s, mu .3", h) << h << 0.3 << 0.2332;
            QTest::addRow("%g s, mu 1", h) << h << 1.0 << 0.6444;
        }
    }
    /// Against a wall the wheels slip: each motor gives mu N r. A soft motor constraint gives it by its law, a stiff one by the hinge's reaction.
    /// The wall is as high as the hull's lower edge, so that the lever arm that lifts the front is known.
    void stall() {
        QFETCH(double, h);
        QFETCH(double, mu);
        QFETCH(double, torque);
        double measured[2] = {0, 0};
        for (int stiff = 0; stiff < 2; ++stiff) {
            Scene scene = r0Scene(h, mu);
            R0Options options;
            options.hull = 2; // a frictionless hull, so that the wall carries no weight
            scene.scenery({plane("floor", {}, 1), box("wall", {0.2, 2, 0.05}, at(0.3, 0, 0.025), 2)}).robot("r", {}, r0(options));
            auto world = scene.build();
            QVERIFY(world);
            command(*world, "r/leftMotor", 2, stiff ? 0 : 1 / 0.405, 5.4);
            command(*world, "r/rightMotor", 2, stiff ? 0 : 1 / 0.405, 5.4);
            QVERIFY(run(*world, 3));
            measured[stiff] = value(*world, "r/leftMotor/effort");
        }
        qInfo("torque by law %.4f N m, by reaction %.4f N m", measured[0], measured[1]);
        QVERIFY(std::abs(measured[0] / torque - 1) < 0.05);
        QVERIFY(std::abs(measured[1] / measured[0] - 1) < 0.03); // one wheel slips a little faster than the other
    }

    void restingBox_data() { bothTicks(); }
    /// The floor's contact forces equal the weight.
    void restingBox() {
        QFETCH(double, h);
        Scene scene(h);
        const Vec3 size(0.3, 0.2, 0.1);
        scene.scenery({plane()}).loose("crate", at(0, 0, 0.05), massOfBox(1, size), {box("crate", size)});
        auto world = scene.build();
        QVERIFY(world && run(*world, 2));
        double sum = 0;
        for (const WorldContact& c : world->contacts()) sum += c.force * c.normal.z();
        QVERIFY(world->contacts().size() == 4);
        QVERIFY(std::abs(sum / 9.81 - 1) < 2e-4);
    }

    /// 60 s at rest: nothing drifts.
    void restingRobot() {
        Scene scene = r0Scene(0.01);
        scene.scenery({plane("floor", {}, 1)}).robot("r", {}, r0());
        auto world = scene.build();
        QVERIFY(world);
        command(*world, "r/leftMotor", 0, 0, 5.4);
        command(*world, "r/rightMotor", 0, 0, 5.4);
        QVERIFY(run(*world, 1));
        const Vec3 before = world->robotPose(0).position;
        QVERIFY(run(*world, 60));
        QVERIFY((world->robotPose(0).position - before).norm() < 1e-12);
    }

    /// Energy of a free fall is constant except for the known loss of symplectic Euler.
    void energyOfAFall() {
        Scene scene(0.001);
        scene.ball("ball", {0, 0, 10}, 2, 0.1);
        auto world = scene.build();
        const RobotEnergy start = world->robotEnergy(0);
        QVERIFY(std::abs(start.potential - 2 * g * 10) < 1e-9);
        QVERIFY(run(*world, 1));
        const RobotEnergy end = world->robotEnergy(0);
        QVERIFY(std::abs(end.kinetic - g * g) < 1e-6);
        QVERIFY(std::abs(end.kinetic + end.potential - start.potential) < 0.01 * end.kinetic);
    }

    void rollingFriction_data() {
        QTest::addColumn<double>("heading");
        for (const double heading : {0., 15., 45., 100.}) QTest::addRow("heading %g", heading) << heading;
    }
    /// Rolling friction slows a ball by (5/7) g rho / r wherever it rolls to, and does not turn it.
    void rollingFriction() {
        QFETCH(double, heading);
        const Vec3 way(std::cos(heading * kPi / 180), std::sin(heading * kPi / 180), 0);
        Scene scene(0.01);
        const auto s = scene.surface(1, 0, 0.005);
        scene.scenery({plane("floor", {}, s)}).ball("ball", {0, 0, 0.1 - 4.905e-5}, 1, 0.1, s);
        auto world = scene.build();
        QVERIFY(
            world->push("ball/body", 100 * way, {0, 0, 0.14}).ok()); // through the centre of percussion: rolls without sliding
        QVERIFY(run(*world, 0.2));
        const double v0 = velocity(*world, "ball/body").dot(way);
        QVERIFY(run(*world, 1));
        const double a = velocity(*world, "ball/body").dot(way) - v0, expected = -5.0 / 7 * g * 0.005 / 0.1;
        qInfo("%.4f, expected %.4f", a, expected);
        QVERIFY(std::abs(a / expected - 1) < 0.01);
        QVERIFY(std::abs(velocity(*world, "ball/body").cross(way).z()) < 0.005);
    }

    /// A ball stays on a slope up to the angle whose tangent is rho / r, whatever the way down.
    void rollingFrictionHolds() {
        for (const double heading : {0., 20., 45., 80.})
            for (const double share : {0.9, 1.1}) {
                Scene scene(0.01);
                const auto s = scene.surface(1, 0, 0.005);
                const double angle = std::atan(share * 0.05), turned = heading * kPi / 180;
                scene.spec->settings.gravity =
                    g * Vec3(std::sin(angle) * std::cos(turned), std::sin(angle) * std::sin(turned), -std::cos(angle));
                scene.scenery({plane("floor", {}, s)}).ball("ball", {0, 0, 0.1 - 4.905e-5}, 1, 0.1, s);
                auto world = scene.build();
                QVERIFY(run(*world, 2));
                const double moved = position(*world, "ball/body").head<2>().norm();
                QVERIFY2(share < 1 ? moved < 1e-3 : moved > 0.03,
                         qPrintable(QString("%1 deg, %2: %3 m").arg(heading).arg(share).arg(moved)));
            }
    }
};

QTEST_APPLESS_MAIN(PhysicsTest)
#include "physics_test.moc"
