// The rotor of a geared motor turns against the body that the motor is on: robots free in space, whose momentum stays zero, with other
// axes, gears and inertias; what the motor's time constant is there; a rotor as a gyroscope.
#include <QtTest>

#include "devices/builtin.h"
#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kTorqueConstant = 0.02, kSpeedConstant = 50, kResistance = 2, kVoltage = 6;

ComponentSpec motor(const std::string& name, const std::string& axle, double ratio, double rotor) {
    ComponentSpec spec;
    spec.kind = "RotaryMotor";
    spec.name = name;
    spec.values["Joint"] = textValue(axle);
    spec.values["TorqueConstant"] = numberValue(kTorqueConstant);
    spec.values["SpeedConstant"] = numberValue(kSpeedConstant);
    spec.values["Resistance"] = numberValue(kResistance);
    spec.values["MaxVoltage"] = numberValue(12);
    spec.values["GearRatio"] = numberValue(ratio);
    spec.values["RotorInertia"] = numberValue(rotor);
    return spec;
}

double dampingOf(double ratio) { return kTorqueConstant * ratio * ratio / (kResistance * kSpeedConstant); }

/// A base and what a motor on it turns about an axis through the centres of mass of both.
struct Pair {
    double ratio = 20, rotor = 1e-4;
    Vec3 axis = Vec3::UnitZ();
    Mat3 base = 0.02 * Mat3::Identity(), link = 0.01 * Mat3::Identity(); ///< kg m^2
    JointType type = JointType::Hinge;

    [[nodiscard]] Scene scene(double tick) const {
        Scene scene(tick);
        scene.spec->settings.gravity = Vec3::Zero();
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("base", {}, {2, Vec3::Zero(), base}, {}));
        config->bodies.push_back(body("link", {}, {0.5, Vec3::Zero(), link}, {}));
        config->joints.push_back(joint("axle", type, 0, 1, Vec3::Zero(), axis));
        config->joints[0].axis2 = type == JointType::Suspension ? axis : axis.unitOrthogonal();
        if (type == JointType::Suspension) {
            config->joints[0].axis = axis.unitOrthogonal();
            config->joints[0].stiffness = 1000;
        }
        config->devices.push_back(motor("motor", "axle", ratio, rotor));
        scene.robot("r", {}, config);
        return scene;
    }
    [[nodiscard]] double along(const Mat3& inertia) const { return axis.dot(inertia * axis); }
    /// Of what the motor turns, while base and link turn against each other.
    [[nodiscard]] double inertia() const {
        const double across = along(link) + rotor * ratio, all = along(base) + along(link) + rotor;
        return along(link) + rotor * ratio * ratio - across * across / all;
    }
    /// The axis, world.
    [[nodiscard]] Vec3 aboutNow(World& world) const {
        const double* pose = slot(world, "r/base/pose");
        return Quat(pose[3], pose[4], pose[5], pose[6]) * axis;
    }
    /// kg m^2/s, of base, link and rotor about the centre of mass; bodies there do not move.
    [[nodiscard]] Vec3 momentum(World& world) const {
        const auto of = [&world](const std::string& name, const Mat3& inertia) {
            const double* pose = slot(world, "r/" + name + "/pose");
            const Quat turned(pose[3], pose[4], pose[5], pose[6]);
            return Vec3(turned * (inertia * (turned.conjugate() * spin(world, "r/" + name))));
        };
        const Vec3 about = aboutNow(world);
        return of("base", base) + of("link", link) +
               rotor * about.dot(spin(world, "r/base") + ratio * (spin(world, "r/link") - spin(world, "r/base"))) * about;
    }
};

void addTicks() {
    QTest::addColumn<double>("tick");
    for (const double tick : {0.001, 0.005, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
}

} // namespace

class RotorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void turnsAgainstItsRotor_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("rotor");
        QTest::addColumn<double>("ratio");
        QTest::addColumn<int>("type");
        QTest::addColumn<bool>("oblique");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const auto& [rotor, ratio] : {std::pair{1e-4, 20.0}, {1e-6, 100.0}, {1e-5, 30.0}, {5e-3, 1.0}, {0.05, 0.5}})
                for (const JointType type : {JointType::Hinge, JointType::Universal, JointType::Suspension})
                    for (const bool oblique : {false, true})
                        QTest::addRow("J %g, G %g, joint %d, %s, %g ms", rotor, ratio, int(type), oblique ? "oblique" : "along z",
                                      1e3 * tick)
                            << tick << rotor << ratio << int(type) << oblique;
    }
    /// The momentum of all stays 0, the base turns at -(I + J G) / (B + I + J) of the joint's rate, in the motor's time constant.
    void turnsAgainstItsRotor() {
        QFETCH(double, tick);
        Pair pair;
        QFETCH(double, rotor);
        QFETCH(double, ratio);
        QFETCH(int, type);
        QFETCH(bool, oblique);
        pair.rotor = rotor;
        pair.ratio = ratio;
        pair.type = JointType(type);
        if (oblique) pair.axis = Vec3(1, -2, 3).normalized();
        auto world = pair.scene(tick).build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/voltage") = kVoltage;
        const double tau = pair.inertia() / dampingOf(ratio), end = kVoltage * kSpeedConstant / ratio;
        const double share = (pair.along(pair.link) + rotor * ratio) / (pair.along(pair.base) + pair.along(pair.link) + rotor);
        double worst = 0;
        for (int i = 0; i < 10 || world->time() < std::min(3 * tau, 10.0); ++i) {
            QVERIFY(world->tick().ok());
            const double rate = value(*world, "r/axle/rate");
            worst = std::max(worst, pair.momentum(*world).norm() / (pair.along(pair.base) * std::abs(rate)));
            QVERIFY(std::abs(pair.axis.dot(spin(*world, "r/base")) / (-share * rate) - 1) < 1e-6);
            if (pair.type == JointType::Hinge) QVERIFY(std::abs(rate / (-end * std::expm1(-world->time() / tau)) - 1) < 1e-4);
        }
        qInfo("tau %.4g s, momentum %.2g", tau, worst);
        QVERIFY(worst < 1e-6);
    }

    void turnsAsideWithItsRotor_data() { addTicks(); }
    /// About no principal axis of the base the whole tumbles, and its momentum is what it is without a rotor: 0, less an error of
    /// first order in the tick.
    void turnsAsideWithItsRotor() {
        QFETCH(double, tick);
        double off[] = {0, 0, 0}, *to = off;
        for (const auto& [rotor, ratio] : {std::pair{0.0, 20.0}, {1e-4, 20.0}, {1e-6, 100.0}}) {
            Pair pair;
            pair.rotor = rotor;
            pair.ratio = ratio;
            pair.base = Vec3(0.03, 0.05, 0.02).asDiagonal();
            pair.axis = Vec3(1, -2, 3).normalized();
            auto world = pair.scene(tick).build(findBuiltInDevice);
            QVERIFY(world);
            *slot(*world, "r/motor/voltage") = kVoltage;
            while (world->time() < 2) {
                QVERIFY(world->tick().ok());
                *to = std::max(*to, pair.momentum(*world).norm() / (0.02 * std::abs(value(*world, "r/axle/rate"))));
            }
            qInfo("J %g, G %g: momentum %.2g", rotor, ratio, *to);
            ++to;
        }
        QVERIFY(off[0] < 0.8 * tick);
        QVERIFY(off[1] < 1.1 * off[0] && off[2] < 1.1 * off[0]);
    }

    void turnsAsAGyroscope_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<bool>("opposed");
        for (const double tick : {0.005, 0.01, 0.03})
            for (const bool opposed : {false, true})
                QTest::addRow("%s, %g ms", opposed ? "base opposed" : "base at rest", 1e3 * tick) << tick << opposed;
    }
    /// A rotor of 300 rad/s whose base gets a kick across it: the momentum stays where it is, and what turns across does not grow. The base
    /// turns against the rotor, or not about its axis.
    void turnsAsAGyroscope() {
        QFETCH(double, tick);
        QFETCH(bool, opposed);
        Pair pair;
        pair.link = 1e-3 * Mat3::Identity();
        auto world = pair.scene(tick).build(findBuiltInDevice);
        QVERIFY(world);
        *slot(*world, "r/motor/voltage") = kVoltage;
        QVERIFY(run(*world, 5));
        const double kick = 0.02, spun = pair.rotor * pair.ratio * value(*world, "r/axle/rate");
        const auto turn = [&](const Vec3& momentum, const Vec3& arm) { // on arms of 1 m
            const Vec3 force = momentum.cross(arm) / (2 * tick);
            return world->push("r/base", force, arm).ok() && world->push("r/base", -force, -arm).ok();
        };
        QVERIFY(turn({kick, 0, 0}, Vec3::UnitZ()));
        if (!opposed) QVERIFY(turn({0, 0, spun}, Vec3::UnitX()));
        QVERIFY(world->tick().ok());
        const Vec3 start = pair.momentum(*world);
        QVERIFY(std::abs(start.x() / kick - 1) < 0.01);
        const auto across = [&] {
            const Vec3 w = spin(*world, "r/base"), axis = pair.aboutNow(*world);
            return (w - axis * axis.dot(w)).norm();
        };
        const double first = across();
        double most = 0, off = 0;
        while (world->time() < 15) {
            QVERIFY(world->tick().ok());
            most = std::max(most, across());
            off = std::max(off, (pair.momentum(*world) - start).norm() / start.norm());
        }
        qInfo("across %.4g to %.4g rad/s, at most %.4g; momentum off by %.2g", first, across(), most, off);
        QVERIFY(most < first * (1 + 1e-3));
        QVERIFY(off < 12 * tick);
    }
};

QTEST_APPLESS_MAIN(RotorTest)
#include "rotor_test.moc"
