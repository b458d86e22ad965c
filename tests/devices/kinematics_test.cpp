// Kinematics of the differential drive.
#include "devices/kinematics.h"

#include <QtTest>

using namespace trundle;

class KinematicsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wheelSpeeds_data() {
        QTest::addColumn<double>("v");
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("left");
        QTest::addColumn<double>("right");
        constexpr double quarter = M_PI / 2;
        QTest::newRow("arc") << .3 << 1. << 3.5 << 8.5;
        QTest::newRow("wide arc") << .5 << .5 << 8.75 << 11.25;
        QTest::newRow("on the spot") << 0. << 1. << -2.5 << 2.5;
        QTest::newRow("straight") << 1. << 0. << 20. << 20.;
        QTest::newRow("amounts: quarter turn on the spot") << 0. << quarter << -3.926991 << 3.926991;
        QTest::newRow("amounts: quarter circle") << .471239 << quarter << 5.497787 << 13.351769;
    }
    void wheelSpeeds() {
        QFETCH(double, v);
        QFETCH(double, w);
        QFETCH(double, left);
        QFETCH(double, right);
        const WheelMotion wheels = wheelsFromChassis({v, w}, .05, .25);
        QVERIFY2(std::abs(wheels.left - left) < 1e-5, qPrintable(QString::number(wheels.left, 'g', 12)));
        QVERIFY2(std::abs(wheels.right - right) < 1e-5, qPrintable(QString::number(wheels.right, 'g', 12)));
        const ChassisMotion back = chassisFromWheels(wheels, .05, .25);
        QVERIFY(std::abs(back.linear - v) < 1e-15 && std::abs(back.angular - w) < 1e-14);
    }

    void posesAlongArcs_data() {
        QTest::addColumn<double>("linear");
        QTest::addColumn<double>("angular");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("v .3, W 1, 1 s") << .3 << 1. << .252441 << .137909;
        QTest::newRow("v .5, W .5, 2 s") << 1. << 1. << .841471 << .459698;
        QTest::newRow("straight") << 2. << 0. << 2. << 0.;
        QTest::newRow("on the spot") << 0. << 3. << 0. << 0.;
        QTest::newRow("full circle") << 1. << 2 * M_PI << 0. << 0.;
    }
    void posesAlongArcs() {
        QFETCH(double, linear);
        QFETCH(double, angular);
        QFETCH(double, x);
        QFETCH(double, y);
        const PlanePose pose = alongArc({}, {linear, angular});
        QVERIFY(std::abs(pose.x - x) < 1e-6 && std::abs(pose.y - y) < 1e-6 && pose.heading == angular);
    }

    void theWayBetweenTwoPosesIsTheArc() {
        for (const double heading : {0.0, 2.5, -3.0})
            for (const ChassisMotion& way : {ChassisMotion{0.3, 0, -0.2}, {0.3, 0.7, 0.4}, {-0.2, 3.0, 0.1}, {0.1, -2.9, 0}}) {
                const PlanePose from{1, -2, heading};
                const ChassisMotion found = motionBetween(from, alongArc(from, way));
                QVERIFY(std::abs(found.linear - way.linear) < 1e-12 && std::abs(found.lateral - way.lateral) < 1e-12);
                QVERIFY(std::abs(found.angular - way.angular) < 1e-12);
            }
    }
};

QTEST_APPLESS_MAIN(KinematicsTest)
#include "kinematics_test.moc"
