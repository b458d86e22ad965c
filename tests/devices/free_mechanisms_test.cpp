// Mechanisms that nothing drives, as texts describe them: what they keep of their momentum and energy.
#include <cmath>

#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

std::string tickText(double tick) { return "Tick=" + std::to_string(tick) + "\n"; }

Quat turned(SensorWorld& w, const std::string& body) { return w.pose(body).rotation; }
Vec3 spin(SensorWorld& w, const std::string& body) {
    return {w.value(body + "/velocity", 3), w.value(body + "/velocity", 4), w.value(body + "/velocity", 5)};
}

} // namespace

class FreeMechanismsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSuspensionKeepsAngularMomentum_data() {
        QTest::addColumn<QString>("joint");
        QTest::addColumn<double>("tick");
        for (const double tick : {0.001, 0.01}) {
            QTest::addRow("suspension, %g ms", 1e3 * tick)
                << "Suspension s { Parent=ch Child=b Axis=0,0,1 Axis2=0,1,0 Stiffness=20 }" << tick;
            QTest::addRow("slider, %g ms", 1e3 * tick) << "Slider s { Parent=ch Child=b Axis=0,0,1 Stiffness=20 }" << tick;
        }
    }
    /// Two bodies in free flight, pushed apart across the joint. What ODE's joint adds is taken away a tick later.
    void aSuspensionKeepsAngularMomentum() {
        QFETCH(QString, joint);
        QFETCH(double, tick);
        SensorWorld w(
            tickText(tick) +
            "Gravity=0,0,0 RobotConfig V { Body ch { Mass=3 Inertia=0.05,0.06,0.07 Box h { Size=0.3,0.2,0.1 Collide=false } }\n"
            "  Body b { Pos=0.4,0,0 Mass=1 Inertia=0.002,0.002,0.002 Sphere t { Radius=0.1 Collide=false } } " +
            joint.toStdString() + " }\nRobot r { Config=V }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        const auto momentum = [&] {
            double sum = 0;
            for (const auto& [body, mass, inertia] : {std::tuple("r/ch", 3., 0.06), std::tuple("r/b", 1., 0.002)}) {
                const Vec3 at = w.pose(body).position, v = w.vector(std::string(body) + "/velocity");
                sum += mass * at.cross(v).y() + inertia * spin(w, body).y();
            }
            return sum;
        };
        (void)w.world().push("r/b", {0, 0, 0.4 / tick}, {0.4, 0, 0});
        (void)w.world().push("r/ch", {0, 0, -0.4 / tick}, {0, 0, 0});
        QVERIFY(w.run());
        const double start = momentum();
        double worst = 0;
        for (int i = 0; i < 30; ++i) {
            QVERIFY(w.run(static_cast<int>(std::lround(0.1 / tick))));
            worst = std::max(worst, std::abs(momentum() / start - 1));
        }
        qInfo("off by at most %.3f %%", 100 * worst);
        QVERIFY(std::abs(start) > 0.15 && worst < 2 * tick);
    }

    void aSpringBetweenFreeBodies_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {0.005, 0.01, 0.02}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    /// Fixed off their centres, so that they tumble: nothing adds energy.
    void aSpringBetweenFreeBodies() {
        QFETCH(double, tick);
        SensorWorld w(tickText(tick) +
                      "Gravity=0,0,0 RobotConfig A { Body a { Box s { Size=0.3,0.1,0.05 Mass=0.8 Collide=false } }\n"
                      "  Body b { Pos=0.5,0,0 Box s { Size=0.1,0.3,0.05 Mass=1.7 Collide=false } }\n"
                      "  Spring s { Parent=a Child=b Anchor=0.15,0.05,0.02 Anchor2=0.45,-0.1,0 Length=0.1 Stiffness=20 } }\n"
                      "Robot r { Config=A Pos=0,0,2 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        (void)w.world().push("r/a", {0.1 / tick, 0.5 / tick, 0.2 / tick}, {0.1, 0.05, 2.02});
        QVERIFY(w.run());
        const auto energy = [&] {
            double sum = 10 * std::pow(w.value("r/s/length") - 0.1, 2);
            for (const auto& [body, mass, size] :
                 {std::tuple("r/a", 0.8, Vec3(0.3, 0.1, 0.05)), std::tuple("r/b", 1.7, Vec3(0.1, 0.3, 0.05))}) {
                const Vec3 rate = turned(w, body).conjugate() * spin(w, body), s = size.cwiseAbs2();
                const Vec3 inertia = mass / 12 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y());
                sum +=
                    0.5 * (mass * w.vector(std::string(body) + "/velocity").squaredNorm() + rate.dot(inertia.cwiseProduct(rate)));
            }
            return sum;
        };
        const double start = energy();
        double most = 0;
        for (int i = 0; i < 120; ++i) {
            QVERIFY(w.run(static_cast<int>(std::lround(0.5 / tick))));
            most = std::max(most, energy());
        }
        qInfo("%.3f J, at most %.3f later", start, most);
        QVERIFY(start > 0.3 && most < 1.1 * start);
    }
};

QTEST_GUILESS_MAIN(FreeMechanismsTest)
#include "free_mechanisms_test.moc"
