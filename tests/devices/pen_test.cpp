// Pens: the line is where the tip was, within its tolerance, and has few points; strokes, limits.
#include "sensor_world.h"

using namespace trundle;
using namespace trundle::test;

namespace {

/// A plotter: a slider along x that carries one along y, with a pen at its end.
std::string plotter(const std::string& pen) {
    return "Tick=0.005\nGravity=0,0,0\nStaticConfig Floor { Plane paper { } }\nStatic floor { Config=Floor }\nRobotConfig "
           "Plotter {\n"
           "  Body beam { Pos=0,0,0.1 Box bar { Size=0.1,2,0.02 Mass=1 } }\n  Body head { Pos=0,0,0.06 Box block { "
           "Size=0.04,0.04,0.02 Mass=0.2 } }\n"
           "  Slider xRail { Parent=world Child=beam Axis=1,0,0 }\n  Slider yRail { Parent=beam Child=head Axis=0,1,0 }\n"
           "  LinearMotor xMotor { Joint=xRail Mode=speed MaxForce=500 MaxSpeed=2 }\n  LinearMotor yMotor { Joint=yRail "
           "Mode=speed MaxForce=500 MaxSpeed=2 }\n"
           "  Pen pen { Body=head Pos=0,0,-0.02 " +
           pen + " }\n}\nRobot r { Config=Plotter }\n";
}

void command(SensorWorld& w, const char* path, double value) {
    w.world().block().slots()[w.world().layout().find(path)->offset] = value;
}
void drive(SensorWorld& w, double x, double y, int ticks) {
    command(w, "r/xMotor/target", x);
    command(w, "r/yMotor/target", y);
    QVERIFY(w.run(ticks));
}

Vec3 pointOf(SensorWorld& w, int i) {
    const auto line = w.values("r/pen/line").subspan(std::size_t(i) * 4);
    return {line[0], line[1], line[2]};
}
bool begins(SensorWorld& w, int i) { return w.values("r/pen/line")[std::size_t(i) * 4 + 3] != 0; }

double distanceToLine(SensorWorld& w, const Vec3& p) {
    double nearest = 1e9;
    for (int i = 1; i < int(w.value("r/pen/points")); ++i) {
        if (begins(w, i)) continue;
        const Vec3 a = pointOf(w, i - 1), way = pointOf(w, i) - a;
        const double t = std::clamp((p - a).dot(way) / std::max(way.squaredNorm(), 1e-30), 0., 1.);
        nearest = std::min(nearest, (p - a - t * way).norm());
    }
    return nearest;
}

} // namespace

class PenTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void straightLinesAreFewPoints() {
        SensorWorld w(plotter("Width=0.01"));
        QVERIFY2(w.ok(), w.failure().c_str());
        drive(w, 0.5, 0, 200);
        drive(w, 0, 0.5, 200);
        QVERIFY2(w.value("r/pen/points") <= 8, qPrintable(QString::number(w.value("r/pen/points"))));
        QVERIFY(std::abs(w.value("r/pen/length") - 1) < 0.02);
        QVERIFY(begins(w, 0) && !begins(w, 1));
        const Vec3 end = pointOf(w, int(w.value("r/pen/points")) - 1);
        QVERIFY2((end - Vec3(0.5, 0.5, 0)).norm() < 0.02,
                 qPrintable(QString("%1, %2, %3").arg(end.x()).arg(end.y()).arg(end.z())));
        QVERIFY(std::abs(end.z()) < 1e-9); // on the floor
    }

    /// A circle is kept within a tenth of the width, by far fewer points than ticks.
    void curvesStayWithinTheTolerance() {
        SensorWorld w(plotter("Width=0.02"));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<Vec3> tips;
        for (int i = 0; i < 1200; ++i) {
            drive(w, -0.3 * std::sin(i * 0.005), 0.3 * std::cos(i * 0.005), 1);
            const Vec3 at = w.pose("r/head").position;
            tips.emplace_back(at.x(), at.y(), 0);
        }
        double worst = 0;
        for (const Vec3& tip : tips) worst = std::max(worst, distanceToLine(w, tip));
        qInfo("%g points, at most %.3f mm off", w.value("r/pen/points"), 1e3 * worst);
        QVERIFY(worst < 0.0021 && w.value("r/pen/points") < 60);
    }

    void aLiftedPenBeginsAnother() {
        SensorWorld w(plotter("Width=0.01 Down=false"));
        QVERIFY2(w.ok(), w.failure().c_str());
        drive(w, 0.5, 0, 100);
        QCOMPARE(w.value("r/pen/points"), 0.);
        command(w, "r/pen/down", 1);
        drive(w, 0.5, 0, 50);
        command(w, "r/pen/down", 0);
        drive(w, 0.5, 0, 50);
        command(w, "r/pen/down", 1);
        drive(w, 0.5, 0, 50);
        QCOMPARE(w.value("r/pen/points"), 4.);
        QVERIFY(begins(w, 0) && !begins(w, 1) && begins(w, 2) && !begins(w, 3));
        QVERIFY(std::abs(w.value("r/pen/length") - 0.25) < 0.01);
    }

    void outOfReachItDrawsNothing() {
        SensorWorld w(plotter("Reach=0.01"));
        QVERIFY2(w.ok(), w.failure().c_str());
        drive(w, 0.5, 0, 100);
        QCOMPARE(w.value("r/pen/points"), 0.);
    }

    void memoryIsBounded() {
        SensorWorld w(plotter("Width=0.01 MaxPoints=5"));
        QVERIFY2(w.ok(), w.failure().c_str());
        for (int i = 0; i < 12; ++i) drive(w, i % 2 ? 0.5 : 0, i % 2 ? 0 : 0.5, 100);
        QCOMPARE(w.value("r/pen/points"), 5.);
        QCOMPARE(w.values("r/pen/line").size(), std::size_t(20));
        QVERIFY(begins(w, 0));
        const Vec3 end = pointOf(w, 4), at = w.pose("r/head").position;
        QVERIFY((end.head<2>() - at.head<2>()).norm() < 2e-3); // the newest stay
    }
};

QTEST_GUILESS_MAIN(PenTest)
#include "pen_test.moc"
