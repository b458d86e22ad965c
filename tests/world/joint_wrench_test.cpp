// What acts across a joint, through the services of devices, against closed forms.
#include <QtTest>

#include <trundle/abi_joint.h>

#include "world/probe_device.h"

using namespace fixture;

namespace {

/// A base that hangs on the world, and an arm on it by a joint of this type, whose centre of mass is at `at`.
std::shared_ptr<RobotConfigSpec> armOn(JointType type, const Vec3& at, double mass) {
    auto config = std::make_shared<RobotConfigSpec>();
    const MassProperties small{mass, Vec3::Zero(), 1e-3 * mass * Mat3::Identity()};
    config->bodies = {body("base", {{0, 0, 1}, Quat::Identity()}, {2, Vec3::Zero(), Mat3::Identity()}, {}),
                      body("arm", {at, Quat::Identity()}, small, {})};
    config->joints = {joint("pivot", JointType::Hinge, kWorldBody, 0, {0, 0, 1}, Vec3::UnitZ()),
                      joint("wrist", type, 0, 1, {0.1, 0, 1}, Vec3::UnitY())};
    ComponentSpec probe;
    probe.kind = "Probe";
    probe.name = "probe";
    probe.values["Probe"] = textValue("probe");
    config->devices = {probe};
    return config;
}

struct JointReadings {
    double position = 1, rate = 1, effort = 1, friction = 1;
};
JointReadings readingsOf(const TrundleServices& s, std::uint32_t joint) {
    return {s.jointPosition(s.context, joint), s.jointRate(s.context, joint), s.jointMotorEffort(s.context, joint),
            s.joints->frictionEffort(s.context, joint)};
}

} // namespace

class JointWrenchTest : public QObject {
    Q_OBJECT

    Bench m_bench;
    Vec3 m_force, m_torque;

    /// Measures the wrist, and keeps the pivot at a rate.
    void measure(double rate = 0) {
        auto& probe = m_bench.probes["probe"];
        probe.setup = [](const TrundleMount& m) {
            std::uint32_t wrist = 0, none = 0;
            return m.measureJoint(m.context, "wrist", &wrist) == 0 && wrist == 1 && m.joint(m.context, "pivot", &none) == 0 ? 0
                                                                                                                            : 1;
        };
        probe.act = [rate](const TrundleServices& s) {
            const TrundleJointDrive drive{sizeof drive, 0, rate, 0, 1e4, 0, 0, 0};
            s.joints->drive(s.context, 0, &drive);
            return 0;
        };
        probe.sense = [this](const TrundleServices& s) {
            return s.joints->wrench(s.context, 1, m_force.data(), m_torque.data());
        };
    }

private Q_SLOTS:
    void init() {
        m_bench = {};
        bench = &m_bench;
    }

    void spinsWithoutTorque_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    /// An arm that turns at a steady rate needs a force towards the axle, m w^2 r, and no torque of the motor that turns it.
    void spinsWithoutTorque() {
        QFETCH(double, tick);
        Scene scene(tick);
        scene.spec->settings.gravity = Vec3::Zero();
        scene.robot("r", {}, armOn(JointType::Fixed, {0.3, 0, 1}, 0.5));
        JointReadings pivot;
        measure(12);
        const auto sense = m_bench.probes["probe"].sense;
        m_bench.probes["probe"].sense = [&](const TrundleServices& s) {
            pivot = readingsOf(s, 0);
            return sense(s);
        };
        auto world = scene.build(code);
        QVERIFY(world);
        QVERIFY(run(*world, 0.9));
        QVERIFY(m_force.norm() > 20);
        QVERIFY2(std::abs(pivot.effort) < 1e-4, qPrintable(QString::number(pivot.effort)));
    }

    void aWeightHangs_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.03}) {
            QTest::addRow("Fixed, %g ms", 1e3 * tick) << int(JointType::Fixed) << tick;
            QTest::addRow("Hinge, %g ms", 1e3 * tick) << int(JointType::Hinge) << tick;
        }
    }
    /// The joint carries the weight; a rigid one also its moment about the anchor.
    void aWeightHangs() {
        QFETCH(int, type);
        QFETCH(double, tick);
        measure();
        Scene scene(tick);
        const double mass = 1.5, reach = type == int(JointType::Fixed) ? 0.3 : 0;
        scene.robot("r", {}, armOn(JointType(type), {0.1 + reach, 0.05, 0.8}, mass));
        auto world = scene.build(code);
        QVERIFY(world);
        QVERIFY(run(*world, 1));
        const Vec3 weight(0, 0, mass * 9.81), lever(reach, 0.05, -0.2);
        const Vec3 moment = lever.cross(weight), axis = Vec3::UnitY();
        const Vec3 expected = type == int(JointType::Fixed) ? moment : Vec3(moment - moment.dot(axis) * axis);
        QVERIFY2((m_force - weight).norm() < 1e-4 * weight.norm(), qPrintable(QString::number(m_force.z())));
        QVERIFY2((m_torque - expected).norm() < 1e-3 * weight.norm() * lever.norm(),
                 qPrintable(QString("%1 %2 %3").arg(m_torque.x()).arg(m_torque.y()).arg(m_torque.z())));
    }

    /// On a turntable the joint also pulls the arm round its circle: m w^2 r towards the axis.
    void anArmTurnsOnATable() {
        measure(3);
        Scene scene(0.005);
        const double mass = 0.5;
        scene.robot("r", {}, armOn(JointType::Fixed, {0.4, 0, 1}, mass));
        auto world = scene.build(code);
        QVERIFY(world);
        QVERIFY(run(*world, 2));
        const double angle = value(*world, "r/pivot/position") - 0.005 * value(*world, "r/pivot/rate"); // before the tick
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        QVERIFY2(std::abs(m_force.dot(out) + mass * 9 * 0.4) < 0.01 * mass * 9 * 0.4,
                 qPrintable(QString::number(m_force.dot(out))));
        QVERIFY(std::abs(m_force.z() - mass * 9.81) < 1e-3 * mass * 9.81);
        QVERIFY((m_torque - (0.3 * out).cross(Vec3(0, 0, mass * 9.81))).norm() < 0.01 * 0.3 * mass * 9.81);
    }

    /// Devices read zeros of a joint that has no position, although the stop of its cone has an angle.
    void aBallHasNoPosition() {
        measure(3);
        JointReadings ball, hinge;
        m_bench.probes["probe"].sense = [&](const TrundleServices& s) {
            ball = readingsOf(s, 1);
            hinge = readingsOf(s, 0);
            return 0;
        };
        Scene scene(0.005);
        auto config = armOn(JointType::Ball, {0.3, 0, 1}, 0.5);
        config->joints[1].swingStop = 0.4;
        scene.robot("r", {}, config);
        auto world = scene.build(code);
        QVERIFY(world);
        QVERIFY(run(*world, 0.3));
        QVERIFY(hinge.position > 0.5 && std::abs(hinge.rate - 3) < 0.1 && hinge.effort != 0);
        QVERIFY(ball.position == 0 && ball.rate == 0 && ball.effort == 0 && ball.friction == 0);
    }

    void anUnknownJointIsNamed() {
        m_bench.probes["probe"].setup = [](const TrundleMount& m) {
            std::uint32_t none = 0;
            return m.measureJoint(m.context, "wirst", &none);
        };
        Scene scene;
        scene.robot("r", {}, armOn(JointType::Fixed, {0.4, 0, 1}, 1));
        Diagnostics diagnostics;
        QVERIFY(!scene.build(code, diagnostics));
        QVERIFY(QString::fromStdString(diagnostics.all().at(0).message).contains("wrist"));
    }
};

QTEST_APPLESS_MAIN(JointWrenchTest)
#include "joint_wrench_test.moc"
