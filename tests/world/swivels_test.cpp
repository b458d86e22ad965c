// Springs and stops of Ball and Universal joints, and where springs of Hinges and Sliders rest.
#include <QtTest>

#include "world/probe_device.h"

using namespace fixture;

namespace {

/// A body on a joint to the world, its centre of mass at the anchor.
Scene onJoint(JointSpec spec, double inertia, bool isHeavy = false) {
    Scene scene(0.01);
    if (!isHeavy) scene.spec->settings.gravity = Vec3::Zero();
    auto config = std::make_shared<RobotConfigSpec>();
    config->bodies.push_back(
        body("arm", at(0, 0, 1), {2, Vec3::Zero(), Mat3(Vec3(inertia, 2 * inertia, 1.5 * inertia).asDiagonal())}, {}));
    config->joints.push_back(std::move(spec));
    scene.robot("r", {}, config);
    return scene;
}

/// A pair of forces with this torque for one tick.
void turn(World& world, const Vec3& torque) {
    const Vec3 arm = torque.unitOrthogonal(), force = torque.cross(arm) / 2;
    QVERIFY(world.push("r/arm", force, Vec3(0, 0, 1) + arm).ok());
    QVERIFY(world.push("r/arm", -force, Vec3(0, 0, 1) - arm).ok());
}

Quat rotation(World& world) {
    const double* p = slot(world, "r/arm/pose");
    return {p[3], p[4], p[5], p[6]};
}

/// Time of the first return to 0 after a push: half a period, by linear interpolation.
template <class Angle> double halfPeriod(World& world, const Angle& angle) {
    double last = 0;
    for (int i = 0; i < 500; ++i) {
        if (!world.tick().ok()) return 0;
        const double now = angle();
        if (last > 0 && now <= 0) return world.time() - 0.01 * now / (now - last);
        last = now;
    }
    return 0;
}

} // namespace

class SwivelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// T = 2 pi sqrt(J / k) about each axis of its own.
    void universalSwings() {
        JointSpec spec = joint("j", JointType::Universal, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
        spec.axis2 = Vec3::UnitY();
        spec.stiffness = 40;
        spec.stiffness2 = 10;
        for (const bool second : {false, true}) {
            const double inertia = 0.1, expected = kPi * std::sqrt(second ? 2 * inertia / 10 : inertia / 40);
            auto world = onJoint(spec, inertia).build();
            QVERIFY(world);
            turn(*world, second ? Vec3(0, 1, 0) : Vec3(1, 0, 0));
            const double measured = halfPeriod(*world, [&] { return second ? rotation(*world).y() : rotation(*world).x(); });
            // The push acts in the first tick, which is where the swing begins.
            QVERIFY2(std::abs((measured - 0.005) / expected - 1) < 0.01 + 0.005 / expected,
                     qPrintable(QString::number(measured / expected)));
        }
    }

    /// The second angle is that about the axis of the child, as the signals have it.
    void universalHasTwoAngles() {
        JointSpec spec = joint("j", JointType::Universal, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
        spec.axis2 = Vec3::UnitY();
        auto world = onJoint(spec, 0.1).build();
        QVERIFY(world);
        turn(*world, Vec3(0, 1, 0));
        for (int i = 0; i < 20; ++i) QVERIFY(world->tick().ok());
        QVERIFY(std::abs(*slot(*world, "r/j/position")) < 1e-9);
        const double angle = 2 * std::asin(rotation(*world).y());
        QVERIFY(angle > 0.005 && std::abs(*slot(*world, "r/j/position2") - angle) < 1e-9);
        QVERIFY(*slot(*world, "r/j/rate2") > 0);
    }

    /// A torque about the first axis, and a motor there, act about the parent's axis, however the child is tilted about its own.
    void universalTurnsAboutTheAxisOfItsParent() {
        JointSpec spec = joint("j", JointType::Universal, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
        spec.axis2 = Vec3::UnitY();
        Bench probes;
        bench = &probes;
        std::uint32_t id = 0;
        double torque = 0;
        probes.probes["p"].setup = [&](const TrundleMount& m) { return m.joint(m.context, "j", &id); };
        probes.probes["p"].act = [&](const TrundleServices& s) {
            s.jointTorque(s.context, id, torque);
            return 0;
        };
        for (const bool motor : {false, true}) {
            Scene scene = onJoint(spec, 0.1);
            auto config = std::make_shared<RobotConfigSpec>(*scene.spec->robots[0].config);
            config->devices.push_back(motor ? row("m", "j") : probe("p"));
            scene.spec->robots[0].config = config;
            torque = 0;
            auto world = scene.build(code);
            QVERIFY(world);
            turn(*world, {0, 40, 0}); // 2 rad/s
            for (int i = 0; i < 100 && value(*world, "r/j/position2") < 40 * kPi / 180; ++i) QVERIFY(world->tick().ok());
            const double angle = value(*world, "r/j/position2");
            QVERIFY(angle > 0.6 && angle < 0.8);
            const double inertia = 0.1 * std::pow(std::cos(angle), 2) + 0.15 * std::pow(std::sin(angle), 2);
            torque = 2;
            if (motor) command(*world, "r/m", 1, 0, 1000);
            QVERIFY(world->tick().ok());
            const double expected = motor ? 1 : torque * 0.01 / inertia, rate = value(*world, "r/j/rate");
            QVERIFY2(std::abs(rate / expected - 1) < 0.01, qPrintable(QString::number(rate / expected)));
            if (!motor) continue;
            const double effort = value(*world, "r/m/effort") * 0.01 / inertia;
            QVERIFY2(std::abs(effort - 1) < 0.01, qPrintable(QString::number(effort)));
        }
    }

    void ballSwings() {
        JointSpec spec = joint("j", JointType::Ball, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ());
        spec.stiffness = 10;
        for (int axis = 0; axis < 3; ++axis) {
            const double inertia = 0.1,
                         own = axis == 0   ? inertia
                               : axis == 1 ? 2 * inertia
                                           : 1.5 * inertia,
                         expected = kPi * std::sqrt(own / 10);
            auto world = onJoint(spec, inertia).build();
            QVERIFY(world);
            turn(*world, Vec3::Unit(axis));
            const double measured = halfPeriod(*world, [&] { return rotation(*world).vec()[axis]; });
            QVERIFY2(std::abs((measured - 0.005) / expected - 1) < 0.01 + 0.005 / expected,
                     qPrintable(QString::number(measured / expected)));
        }
    }

    void damped() {
        for (const JointType type : {JointType::Ball, JointType::Universal}) {
            JointSpec spec = joint("j", type, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
            spec.axis2 = Vec3::UnitY();
            spec.damping = 0.2;
            auto world = onJoint(spec, 0.1).build();
            QVERIFY(world);
            turn(*world, {10, 0, 0}); // 1 rad/s, then w = exp(-t c / J)
            QVERIFY(run(*world, 1.01));
            QVERIFY2(std::abs(spin(*world, "r/arm").x() / std::exp(-2.0) - 1) < 0.02,
                     qPrintable(QString::number(spin(*world, "r/arm").x())));
        }
    }

    void universalStops_data() {
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("second");
        QTest::addColumn<Vec3>("torque");
        QTest::newRow("first, high") << 0.3 << 0.0 << Vec3(5, 0, 0);
        QTest::newRow("first, low") << -0.2 << 0.0 << Vec3(-5, 0, 0);
        QTest::newRow("second, high") << 0.0 << 0.5 << Vec3(0, 5, 0);
        QTest::newRow("second, low") << 0.0 << -0.4 << Vec3(0, -5, 0);
        QTest::newRow("both") << 0.3 << 0.5 << Vec3(5, 8, 0);
    }
    /// A push for as long as it takes leaves it at its stop, both angles as about axes of their own.
    void universalStops() {
        QFETCH(double, first);
        QFETCH(double, second);
        QFETCH(Vec3, torque);
        JointSpec spec = joint("j", JointType::Universal, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
        spec.axis2 = Vec3::UnitY();
        spec.lowStop = -0.2;
        spec.highStop = 0.3;
        spec.lowStop2 = -0.4;
        spec.highStop2 = 0.5;
        auto world = onJoint(spec, 0.1).build();
        QVERIFY(world);
        for (int i = 0; i < 200; ++i) {
            turn(*world, torque);
            QVERIFY(world->tick().ok());
        }
        const Quat q = rotation(*world);
        const double about1 = 2 * std::atan2(q.x(), q.w()), about2 = 2 * std::atan2(q.y(), q.w());
        QVERIFY2(std::abs(about1 - first) < 1e-3, qPrintable(QString::number(about1)));
        QVERIFY2(std::abs(about2 - second) < 1e-3, qPrintable(QString::number(about2)));
        QVERIFY(spin(*world, "r/arm").norm() < 0.02);
    }

    /// A stop on one side of one axis alone; the other side and the other axis are free.
    void universalStopsOfOneSide_data() {
        QTest::addColumn<int>("side");
        for (int side = 0; side < 4; ++side) QTest::addRow("axis %d, %s", 1 + side / 2, side % 2 ? "high" : "low") << side;
    }
    void universalStopsOfOneSide() {
        QFETCH(int, side);
        const double sign = side % 2 ? 1 : -1;
        for (const double towards : {sign, -sign}) {
            JointSpec spec = joint("j", JointType::Universal, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
            spec.axis2 = Vec3::UnitY();
            std::optional<double>* stops[] = {&spec.lowStop, &spec.highStop, &spec.lowStop2, &spec.highStop2};
            *stops[side] = 0.3 * sign;
            auto world = onJoint(spec, 0.1).build();
            QVERIFY(world);
            const Vec3 axis = side < 2 ? Vec3::UnitX() : Vec3::UnitY();
            double most = 0;
            for (int i = 0; i < 60; ++i) {
                turn(*world, towards * axis);
                QVERIFY(world->tick().ok());
                const Quat q = rotation(*world);
                most = std::max(most, towards * 2 * std::atan2(q.vec().dot(axis), q.w()));
            }
            QVERIFY2(towards == sign ? std::abs(most - 0.3) < 0.01 : most > 0.5, qPrintable(QString::number(most)));
        }
    }

    void ballStops_data() {
        QTest::addColumn<Vec3>("torque");
        QTest::addColumn<double>("stop");
        for (const double stop : {0.6, 1.2, 1.9, 2.8}) { // from pointed to beyond a plane
            QTest::addRow("about x, %g", stop) << Vec3(5, 0, 0) << stop;
            QTest::addRow("about y, %g", stop) << Vec3(0, -5, 0) << stop;
            if (stop < 1.5) QTest::addRow("aslant, %g", stop) << Vec3(3, 3, 0) << stop;
        }
    }
    /// The cone holds however it is tilted, and the twist about its axis stays free.
    void ballStops() {
        QFETCH(Vec3, torque);
        QFETCH(double, stop);
        JointSpec spec = joint("j", JointType::Ball, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ());
        spec.swingStop = stop;
        auto world = onJoint(spec, 0.1).build();
        QVERIFY(world);
        double most = 0;
        for (int i = 0; i < 200; ++i) {
            turn(*world, torque);
            QVERIFY(world->tick().ok());
            most = std::max(most, std::acos(std::min(1.0, (rotation(*world) * Vec3::UnitZ()).z())));
        }
        QVERIFY2(most < stop + 5e-3, qPrintable(QString::number(most)));
        const Vec3 up = rotation(*world) * Vec3::UnitZ();
        QVERIFY2(std::abs(std::acos(up.z()) - stop) < 5e-3, qPrintable(QString::number(std::acos(up.z()))));
        const Vec3 before = spin(*world, "r/arm");
        turn(*world, 2 * up);
        QVERIFY(world->tick().ok());
        QVERIFY((spin(*world, "r/arm") - before).dot(up) > 0.05);
    }

    /// What hangs on a cone does not go round with energy from nowhere.
    void conePendulumKeepsItsEnergy() {
        JointSpec spec = joint("j", JointType::Ball, kWorldBody, 0, {0, 0, 1.5}, -Vec3::UnitZ());
        spec.swingStop = 0.5;
        auto world = onJoint(spec, 0.01, true).build();
        QVERIFY(world);
        QVERIFY(world->push("r/arm", {400, 100, 0}, {0, 0, 1}).ok());
        QVERIFY(world->tick().ok());
        const auto energy = [&] { return 2 * g * position(*world, "r/arm").z() + velocity(*world, "r/arm").squaredNorm(); };
        const double before = energy(); // goes to and fro by m g h v / 2 within a swing
        double early = 0, late = 0;     // means
        for (int i = 0; i < 500; ++i) {
            QVERIFY(world->tick().ok());
            QVERIFY2(energy() < before + 2 * g * 0.01, qPrintable(QString::number(energy() - before)));
            if (i >= 100) (i < 300 ? early : late) += energy() / 200;
            const Vec3 hang = (position(*world, "r/arm") - Vec3(0, 0, 1.5)).normalized();
            QVERIFY2(std::acos(-hang.z()) < 0.52, qPrintable(QString::number(std::acos(-hang.z()))));
        }
        QVERIFY2(late < early + 5e-3, qPrintable(QString::number(late - early)));
    }

    void restsAtItsRest() {
        for (const JointType type : {JointType::Hinge, JointType::Slider}) {
            JointSpec spec = joint("j", type, kWorldBody, 0, {0, 0, 1}, Vec3::UnitX());
            spec.stiffness = 20;
            spec.damping = 4;
            spec.rest = -0.4;
            auto world = onJoint(spec, 0.1).build();
            QVERIFY(world);
            QVERIFY(run(*world, 15));
            QVERIFY2(std::abs(value(*world, "r/j/position") + 0.4) < 1e-5,
                     qPrintable(QString::number(value(*world, "r/j/position"))));
        }
    }
};

QTEST_APPLESS_MAIN(SwivelsTest)
#include "swivels_test.moc"
