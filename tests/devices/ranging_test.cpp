// Distance sensors: ranges against closed forms, the order of beams, limits, timing, errors.
#include "sensor_world.h"

#include <numbers>
#include <random>

#include "devices/range_sensor.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi, kMiss = 1e9;

/// A robot that floats in the origin, with a hull around the sensor, and scenery.
std::string floating(const std::string& sensor, const std::string& scenery, const std::string& robotPose = "",
                     const std::string& settings = "Tick=0.01 Seed=5") {
    return settings + " Gravity=0,0,0\nStaticConfig Things { " + scenery + " }\nStatic things { Config=Things }\n" +
           "RobotConfig Probe { Body base { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n" + sensor + " }\nRobot r { Config=Probe " +
           robotPose + " }\n";
}

std::string triple(const Vec3& v) {
    char text[120];
    std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g", v.x(), v.y(), v.z());
    return text;
}

/// A shape with its own code for the distance along a ray; the origin is outside.
struct Shape {
    enum Kind { Sphere, Box, Cylinder, Plane } kind = Sphere;
    Vec3 position, hpr;       ///< hpr in degrees
    Vec3 size{0.3, 0.3, 0.3}; ///< radius in x; length in z

    [[nodiscard]] std::string text(int number) const {
        char dimensions[160];
        if (kind == Sphere) std::snprintf(dimensions, sizeof dimensions, "Radius=%.17g", size.x());
        else if (kind == Box) std::snprintf(dimensions, sizeof dimensions, "Size=%s", triple(size).c_str());
        else if (kind == Cylinder) std::snprintf(dimensions, sizeof dimensions, "Radius=%.17g Length=%.17g", size.x(), size.z());
        else dimensions[0] = 0;
        static const char* const names[] = {"Sphere", "Box", "Cylinder", "Plane"};
        return std::string(names[kind]) + " s" + std::to_string(number) + " { " + dimensions + " Pos=" + triple(position) +
               " HPR=" + triple(hpr) + " }\n";
    }
    [[nodiscard]] double distance(const Vec3& from, const Vec3& along) const {
        const Pose inverse = Pose{position, rotationFromHpr(hpr * kPi / 180)}.inverse();
        const Vec3 o = inverse * from, d = inverse.rotation * along;
        switch (kind) {
        case Plane: return d.z() < 0 && o.z() > 0 ? -o.z() / d.z() : kMiss;
        case Sphere: return quadratic(1, o.dot(d), o.squaredNorm() - size.x() * size.x());
        case Box: {
            double enter = -kMiss, leave = kMiss;
            for (int k = 0; k < 3; ++k) {
                const double a = (-size[k] / 2 - o[k]) / d[k], b = (size[k] / 2 - o[k]) / d[k];
                enter = std::max(enter, std::min(a, b));
                leave = std::min(leave, std::max(a, b));
            }
            return enter > 0 && enter < leave ? enter : kMiss;
        }
        case Cylinder: break;
        }
        double nearest = kMiss;
        const double side =
            quadratic(d.head<2>().squaredNorm(), o.head<2>().dot(d.head<2>()), o.head<2>().squaredNorm() - size.x() * size.x());
        if (side < kMiss && std::abs(o.z() + side * d.z()) <= size.z() / 2) nearest = side;
        for (const double cap : {-size.z() / 2, size.z() / 2}) {
            const double t = (cap - o.z()) / d.z();
            if (t > 0 && (o + t * d).head<2>().norm() <= size.x()) nearest = std::min(nearest, t);
        }
        return nearest;
    }
    /// The smaller root of a t^2 + 2 b t + c.
    static double quadratic(double a, double b, double c) {
        const double square = b * b - a * c;
        if (square < 0) return kMiss;
        const double t = (-b - std::sqrt(square)) / a;
        return t > 0 ? t : kMiss;
    }
};

/// The walls of a hall far around, and shapes that do not touch the robot in the origin.
std::vector<Shape> randomShapes(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<Shape> shapes;
    for (int i = 0; i < 12; ++i) {
        Shape s;
        s.kind = static_cast<Shape::Kind>(i % 3);
        Vec3 way(unit(random), unit(random), unit(random));
        s.position = way.normalized() * (1.2 + 2 * std::abs(unit(random)));
        s.hpr = 180 * Vec3(unit(random), unit(random), unit(random));
        s.size = Vec3(0.3, 0.3, 0.3) + 0.2 * Vec3(unit(random), unit(random), unit(random));
        shapes.push_back(s);
    }
    Shape floor;
    floor.kind = Shape::Plane;
    floor.position = {0, 0, -1};
    floor.hpr = 20 * Vec3(unit(random), unit(random), unit(random));
    shapes.push_back(floor);
    return shapes;
}

} // namespace

class RangingTest : public QObject {
    Q_OBJECT

    /// A lidar in front of a flat wall at x = 2: the true distance of each beam is 2 / (cos of its angles).
    static std::string atWall(const std::string& fields, const std::string& settings = "Tick=0.01 Seed=5") {
        return floating("Lidar scan { Body=base FieldOfView=40 " + fields + " }", "Box wall { Pos=2.5,0,0 Size=1,50,50 }", "",
                        settings);
    }

private Q_SLOTS:
    void rangesAgreeWithClosedForms() {
        std::mt19937 random(19);
        std::uniform_real_distribution<double> unit(-1, 1);
        int hits = 0, beams = 0;
        double worst = 0;
        for (int scene = 0; scene < 10; ++scene) {
            const std::vector<Shape> shapes = randomShapes(random);
            std::string scenery;
            for (std::size_t i = 0; i < shapes.size(); ++i) scenery += shapes[i].text(static_cast<int>(i));
            const Pose robot{0.1 * Vec3(unit(random), unit(random), unit(random)),
                             rotationFromHpr(kPi * Vec3(unit(random), unit(random), unit(random)))};
            const Vec3 place = 0.1 * Vec3(unit(random), unit(random), unit(random)),
                       turn = 180 * Vec3(unit(random), unit(random), unit(random));
            const Vec3 hpr = hprFromRotation(robot.rotation) * 180 / kPi;
            SensorWorld w(floating("Lidar scan { Body=base Pos=" + triple(place) + " HPR=" + triple(turn) +
                                       " Beams=360 Layers=5 VerticalFieldOfView=100 MinRange=0 MaxRange=6 }",
                                   scenery, "Pos=" + triple(robot.position) + " HPR=" + triple(hpr)));
            QVERIFY2(w.ok(), w.failure().c_str());
            QVERIFY(w.run());
            const Pose eye = w.pose("r/base") * Pose{place, rotationFromHpr(turn * kPi / 180)};
            const auto ranges = w.values("r/scan/ranges");
            QCOMPARE(ranges.size(), std::size_t(1800));
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                const double up = (-50.0 + 25.0 * static_cast<double>(i / 360)) * kPi / 180,
                             bearing = (-180.0 + static_cast<double>(i % 360)) * kPi / 180;
                const Vec3 along =
                    eye.rotation * Vec3(std::cos(up) * std::cos(bearing), std::cos(up) * std::sin(bearing), std::sin(up));
                double expected = 6;
                for (const Shape& s : shapes) expected = std::min(expected, s.distance(eye.position, along));
                ++beams;
                hits += expected < 6;
                const double error = std::abs(ranges[i] - expected);
                if (error > 1e-9) { // an edge within rounding of the beam: one of both sides is right
                    bool grazes = false;
                    for (const Vec3& aside : {Vec3(1e-9, 0, 0), Vec3(-1e-9, 0, 0), Vec3(0, 1e-9, 0), Vec3(0, -1e-9, 0),
                                              Vec3(0, 0, 1e-9), Vec3(0, 0, -1e-9)}) {
                        double beside = 6;
                        for (const Shape& s : shapes)
                            beside = std::min(beside, s.distance(eye.position, (along + aside).normalized()));
                        grazes = grazes || std::abs(ranges[i] - beside) < 1e-6;
                    }
                    QVERIFY2(grazes, qPrintable(QString("scene %1 beam %2: %3, expected %4")
                                                    .arg(scene)
                                                    .arg(i)
                                                    .arg(ranges[i], 0, 'g', 17)
                                                    .arg(expected, 0, 'g', 17)));
                    continue;
                }
                worst = std::max(worst, error);
            }
        }
        qInfo("%d beams, %d hit something, largest error %.2g m", beams, hits, worst);
        QVERIFY(hits > beams / 4);
    }

    /// A post in a known direction, seen by the beam that the rule names.
    void beamsAreCountedCounterClockwise_data() {
        QTest::addColumn<double>("field");
        QTest::addColumn<int>("beams");
        QTest::addColumn<double>("bearing"); // of the post, degrees
        QTest::addColumn<int>("beam");       // -1: none sees it
        QTest::newRow("first beam") << 180. << 181 << -90. << 0;
        QTest::newRow("last beam") << 180. << 181 << 90. << 180;
        QTest::newRow("middle beam") << 180. << 181 << 0. << 90;
        QTest::newRow("two beams, right") << 90. << 2 << -45. << 0;
        QTest::newRow("two beams, left") << 90. << 2 << 45. << 1;
        QTest::newRow("full circle, behind") << 360. << 360 << 180. << 0;
        QTest::newRow("full circle, ahead") << 360. << 360 << 0. << 180;
        QTest::newRow("full circle, last") << 360. << 360 << 179. << 359;
        QTest::newRow("full circle of four") << 360. << 4 << 90. << 3;
        QTest::newRow("one beam") << 360. << 1 << 0. << 0;
        QTest::newRow("one beam looks ahead, not behind") << 360. << 1 << 180. << -1;
        QTest::newRow("one narrow beam") << 30. << 1 << 0. << 0;
    }
    void beamsAreCountedCounterClockwise() {
        QFETCH(double, field);
        QFETCH(int, beams);
        QFETCH(double, bearing);
        QFETCH(int, beam);
        const Vec3 post = 2 * Vec3(std::cos(bearing * kPi / 180), std::sin(bearing * kPi / 180), 0);
        SensorWorld w(floating("Lidar scan { Body=base Beams=" + std::to_string(beams) + " FieldOfView=" + std::to_string(field) +
                                   " MaxRange=5 }",
                               "Sphere post { Radius=0.012 Pos=" + triple(post) + " }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        const auto ranges = w.values("r/scan/ranges");
        QCOMPARE(ranges.size(), std::size_t(beams));
        for (int i = 0; i < beams; ++i) {
            const double expected = i == beam ? 2 - 0.012 : 5;
            QVERIFY2(std::abs(ranges[static_cast<std::size_t>(i)] - expected) < 1e-9, qPrintable(QString("beam %1").arg(i)));
        }
    }

    void layersAreCountedFromBelow() {
        SensorWorld w(floating("Lidar scan { Body=base Beams=1 Layers=3 VerticalFieldOfView=60 MaxRange=5 }",
                               "Sphere low { Radius=0.1 Pos=" + triple(2 * Vec3(std::cos(kPi / 6), 0, -0.5)) + " }\n" +
                                   "Sphere high { Radius=0.1 Pos=" + triple(3 * Vec3(std::cos(kPi / 6), 0, 0.5)) + " }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        const auto ranges = w.values("r/scan/ranges");
        QCOMPARE(ranges.size(), std::size_t(3));
        QVERIFY(std::abs(ranges[0] - 1.9) < 1e-9 && ranges[1] == 5 && std::abs(ranges[2] - 2.9) < 1e-9);
    }

    void limitsAreKept() {
        SensorWorld w(atWall("Beams=5 MinRange=2.05 MaxRange=2.1"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("r/scan/ranges", 2), 2.05); // the first reading is that of the start
        QCOMPARE(w.value("r/scan/time"), 0.);
        QVERIFY(w.run());
        QCOMPARE(w.value("r/scan/ranges", 2), 2.05); // nearer than MinRange
        QVERIFY(std::abs(w.value("r/scan/ranges", 3) - std::max(2.05, 2 / std::cos(kPi / 18))) < 1e-9);
        QCOMPARE(w.value("r/scan/ranges", 4), 2.1); // farther than MaxRange
        QVERIFY(!SensorWorld(atWall("MinRange=3 MaxRange=2")).ok());
        QVERIFY(SensorWorld(atWall("MinRange=3 MaxRange=2")).failure().find("MinRange must be smaller") != std::string::npos);
        QVERIFY(SensorWorld(atWall("Beams=100000 Layers=2")).failure().find("ranges has 200000 numbers") != std::string::npos);
    }

    void aRangeSensorSeesItsNearestEcho_data() {
        QTest::addColumn<QString>("fields");
        QTest::addColumn<QString>("scenery");
        QTest::addColumn<double>("range");
        const auto row = [](const char* name, const char* fields, const char* scenery, double range) {
            QTest::newRow(name) << QString(fields) << QString(scenery) << range;
        };
        const char* wall = "Box wall { Pos=1.5,0,0 Size=1,9,9 }";
        row("infrared, a wall", "", wall, 1);
        row("infrared, nothing", "MaxRange=0.8", wall, 0.8);
        row("infrared, oblique", "HPR=60,0,0 MaxRange=9", wall, 2);
        row("infrared, beside it", "", "Sphere s { Radius=0.1 Pos=1,0.2,0 }", 2);
        row("infrared with a cone", "ConeAngle=40", "Sphere s { Radius=0.1 Pos=1,0.2,0 }", std::hypot(1, 0.2) - 0.1);
        row("infrared, too near", "MinRange=1.2", wall, 1.2);
        row("ultrasonic, a wall", "Type=ultrasonic", wall, 1);
        row("ultrasonic, oblique within its cone", "Type=ultrasonic HPR=10,0,0", wall, 1 / std::cos(1e-9));
        row("ultrasonic, grazing", "Type=ultrasonic HPR=70,0,0 MaxRange=9", wall, 9);
        row("ultrasonic, grazing allowed", "Type=ultrasonic HPR=70,0,0 MaxRange=9 MaxIncidence=90 ConeAngle=0", wall,
            1 / std::cos(70 * kPi / 180));
        row("ultrasonic, a wall in its dead zone", "Type=ultrasonic MinRange=1.2 ConeAngle=0", wall, 2);
        row("ultrasonic, a ball in its dead zone before a wall", "Type=ultrasonic MinRange=0.5",
            "Sphere s { Radius=0.1 Pos=0.4,0,0 } Box wall { Pos=1.5,0,0 Size=1,9,9 }", -1);
    }
    void aRangeSensorSeesItsNearestEcho() {
        QFETCH(QString, fields);
        QFETCH(QString, scenery);
        QFETCH(double, range);
        SensorWorld w(floating("RangeSensor eye { Body=base " + fields.toStdString() + " }", scenery.toStdString()));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        const double read = w.value("r/eye/range");
        if (range < 0) { // past the ball, to the wall
            QVERIFY2(read > 1 && read < 1.1, qPrintable(QString::number(read)));
            QVERIFY(std::abs(w.value("r/eye/trueRange") - 0.3) < 1e-9);
            return;
        }
        const bool sampled = fields.contains("HPR=10") || fields.contains("Cone");
        QVERIFY2(std::abs(read - range) < (sampled ? 0.005 : 1e-9), qPrintable(QString::number(read, 'g', 17)));
    }

    void voltagesAreThoseOfTheDataSheet() {
        const auto voltageAt = [](double distance, const std::string& fields = "") {
            SensorWorld w(floating("RangeSensor eye { Body=base MinRange=0.001 " + fields + " }",
                                   "Box wall { Pos=" + std::to_string(distance + 0.5) + ",0,0 Size=1,9,9 }"));
            w.run();
            return w.value("r/eye/voltage");
        };
        QVERIFY(std::abs(voltageAt(0.8) - 0.4) < 1e-6 && std::abs(voltageAt(0.1) - 2.3) < 1e-6); // E4-A00201EN: typical values
        QVERIFY(std::abs(voltageAt(0.2) - 1.3) < 0.1 && std::abs(voltageAt(0.4) - 0.74) < 0.1);  // its figure, as read from it
        QCOMPARE(voltageAt(1.5), 0.4);
        QCOMPARE(voltageAt(0.3, "Type=ultrasonic"), 0.);
        QVERIFY(std::abs(voltageAt(0.3, "VoltageCurve=0.1,3,0.3,1,0.5,0.2") - 1) < 1e-6);
        QVERIFY(!SensorWorld(floating("RangeSensor eye { Body=base VoltageCurve=0.3,1,0.2,2 }", "Box b { Pos=2,0,0 Size=1,1,1 }"))
                     .ok());
    }

    void readingsFollowThePeriodWithoutDrift_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("period");
        QTest::addColumn<double>("latency");
        QTest::newRow("every tick") << 0.01 << 0. << 0.;
        QTest::newRow("a multiple") << 0.01 << 0.05 << 0.;
        QTest::newRow("no multiple") << 0.01 << 0.025 << 0.;
        QTest::newRow("thirds") << 0.003 << 0.01 << 0.;
        QTest::newRow("shorter than a tick") << 0.01 << 0.004 << 0.;
        QTest::newRow("late") << 0.01 << 0.025 << 0.013;
        QTest::newRow("later than the next reading") << 0.01 << 0.02 << 0.055;
    }
    void readingsFollowThePeriodWithoutDrift() {
        QFETCH(double, tick);
        QFETCH(double, period);
        QFETCH(double, latency);
        SensorWorld w(atWall("Beams=1 Noise=0.01 UpdatePeriod=" + std::to_string(period) + " Latency=" + std::to_string(latency),
                             "Tick=" + std::to_string(tick) + " Seed=3"));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> due; // the ticks at which it must measure, by the rule alone
        double next = 0;
        for (int i = 0; i <= 400; ++i) {
            if (period > 0 && i * tick < next * period - 1e-9) continue;
            due.push_back(i * tick);
            while (period > 0 && next * period <= i * tick + 1e-9) ++next;
        }
        std::vector<double> measured, seen;
        double last = -1; // before the first reading
        for (int i = 0; i <= 400; ++i) {
            if (i > 0) QVERIFY(w.run());
            const double time = w.value("r/scan/time");
            if (time == last) continue;
            last = time;
            measured.push_back(time);
            seen.push_back(w.time());
        }
        QVERIFY(measured.size() > 50 && measured.size() <= due.size());
        if (period > 0 && period > tick && latency == 0) QVERIFY(std::abs(double(measured.size()) - 400 * tick / period) <= 1.5);
        for (std::size_t i = 0; i < measured.size(); ++i) {
            QVERIFY2(std::abs(measured[i] - due[i]) < 1e-9,
                     qPrintable(QString("%1: %2, not %3").arg(i).arg(measured[i]).arg(due[i])));
            QVERIFY(seen[i] >= measured[i] + latency - 1e-9 && seen[i] < measured[i] + latency + tick - 1e-7);
        }
    }

    void noiseIsWhatTheFieldsSay() {
        SensorWorld w(atWall("Beams=1001 MaxRange=10 Noise=0.02 NoisePerMetre=0.01"));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> all, tracks; // normalised errors; of one beam from tick to tick
        for (int t = 0; t < 100; ++t) {
            QVERIFY(w.run());
            const auto ranges = w.values("r/scan/ranges");
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                const double bearing = (-20 + 0.04 * static_cast<double>(i)) * kPi / 180, truth = 2 / std::cos(bearing);
                all.push_back((ranges[i] - truth) / (0.02 + 0.01 * truth));
            }
        }
        const double n = static_cast<double>(all.size());
        const Moments m = momentsOf(all);
        qInfo("%.0f samples: mean %.4f, deviation %.4f, correlation of neighbours %.4f, of ticks %.4f", n, m.mean, m.deviation,
              correlationOf(all, 1), correlationOf(all, 1001));
        QVERIFY(std::abs(m.mean) < 4 / std::sqrt(n));
        QVERIFY(std::abs(m.deviation - 1) < 4 / std::sqrt(2 * n));
        QVERIFY(std::abs(correlationOf(all, 1)) < 4 / std::sqrt(n));
        QVERIFY(std::abs(correlationOf(all, 1001)) < 4 / std::sqrt(n));
        const auto beyond = [&](double sigma) {
            return std::count_if(all.begin(), all.end(), [&](double e) { return std::abs(e) > sigma; }) / n;
        };
        QVERIFY(std::abs(beyond(1) - 0.3173) < 4 * std::sqrt(0.3173 * 0.6827 / n)); // it is a normal distribution
        QVERIFY(std::abs(beyond(3) - 0.0027) < 4 * std::sqrt(0.0027 / n));
    }

    void dropoutsAndOutliersAreAsOftenAsTheFieldsSay() {
        SensorWorld w(atWall("Beams=1001 MinRange=0.5 MaxRange=10 Dropouts=0.1 Outliers=0.05"));
        QVERIFY2(w.ok(), w.failure().c_str());
        double n = 0, missed = 0;
        std::vector<double> strays;
        for (int t = 0; t < 100; ++t) {
            QVERIFY(w.run());
            const auto ranges = w.values("r/scan/ranges");
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                const double truth = 2 / std::cos((-20 + 0.04 * static_cast<double>(i)) * kPi / 180);
                ++n;
                missed += ranges[i] == 10;
                if (ranges[i] != 10 && std::abs(ranges[i] - truth) > 1e-9) strays.push_back(ranges[i]);
            }
        }
        const Moments m = momentsOf(strays);
        qInfo("%.0f samples: missed %.4f, outliers %.4f around %.3f", n, missed / n, double(strays.size()) / n, m.mean);
        QVERIFY(std::abs(missed / n - 0.1) < 4 * std::sqrt(0.1 * 0.9 / n));
        QVERIFY(std::abs(double(strays.size()) / n - 0.05) < 4 * std::sqrt(0.05 * 0.95 / n));
        QVERIFY(std::abs(m.mean - 5.25) <
                4 * 9.5 / std::sqrt(12 * double(strays.size()))); // any distance from MinRange to MaxRange
    }

    void readingsAreMultiplesOfTheResolution() {
        SensorWorld w(atWall("Beams=100 Noise=0.1 Resolution=0.03 MinRange=0.01 MaxRange=5"));
        QVERIFY(w.run());
        for (const double r : w.values("r/scan/ranges")) QVERIFY(r == 5 || std::abs(r / 0.03 - std::round(r / 0.03)) < 1e-9);
    }

    void errorsDependOnSeedPathAndTickAlone() {
        const auto readings = [](const std::string& more, int seed, const std::string& name) {
            SensorWorld w(
                atWall("Beams=3 Noise=0.1 } " + more + " Lidar " + name + " { Body=base Beams=3 FieldOfView=40 Noise=0.1",
                       "Tick=0.01 Seed=" + std::to_string(seed)));
            w.run(7);
            const auto values = w.values("r/" + name + "/ranges");
            return std::vector<double>(values.begin(), values.end());
        };
        const auto plain = readings("", 1, "a");
        QCOMPARE(plain.size(), std::size_t(3));
        QCOMPARE(readings("", 1, "a"), plain);
        QCOMPARE(readings("RangeSensor other { Body=base Noise=0.1 }", 1, "a"), plain); // another sensor changes nothing
        QVERIFY(readings("", 2, "a") != plain);
        QVERIFY(readings("", 1, "b") != plain);
    }

    void normalDeviatesAreExact() {
        QCOMPARE(normalQuantile(0.5), 0.);
        QVERIFY(std::abs(normalQuantile(0.975) - 1.959963984540054) < 1e-15);
        QVERIFY(std::abs(normalQuantile(1e-10) + 6.361340902404056) < 1e-14);
        QVERIFY(std::isfinite(normalDeviate(0)) && std::isfinite(normalDeviate(~0ull)));
        QCOMPARE(normalDeviate(0), -normalDeviate(~0ull));
        for (const double x : {1e-300, 1e-9, 0.1, 0.7, 1.0, 1.5, 1e9})
            QVERIFY(std::abs(trundle::sdk1::detail::portableLog(x) - std::log(x)) <=
                    1e-15 * std::max(1.0, std::abs(std::log(x))));
    }

    void movingAndTiltedBodiesCarryTheirSensors() {
        // A free body turns about its axis and flies along a wall: each reading is that of the pose at its tick.
        SensorWorld w(floating("Lidar scan { Body=base Pos=0.02,0,0.01 Beams=90 FieldOfView=360 MaxRange=20 MinRange=0 }",
                               "Plane wall { HPR=0,90,0 Pos=-3,0,0 }", "HPR=10,20,30"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.world().push("r/base", {0, 30, 5}, {0.01, 0.02, 0}).ok());
        for (int t = 0; t < 50; ++t) {
            QVERIFY(w.run());
            const Pose eye = w.pose("r/base") * Pose{Vec3(0.02, 0, 0.01), Quat::Identity()};
            const auto ranges = w.values("r/scan/ranges");
            for (std::size_t i = 0; i < ranges.size(); ++i) {
                const double bearing = (-180 + 4 * static_cast<double>(i)) * kPi / 180;
                const Vec3 along = eye.rotation * Vec3(std::cos(bearing), std::sin(bearing), 0);
                const double expected = along.x() < 0 ? std::min(20., (eye.position.x() + 3) / -along.x()) : 20;
                QVERIFY2(std::abs(ranges[i] - expected) < 1e-9 * std::max(1.0, expected),
                         qPrintable(QString("%1 %2 %3").arg(i).arg(ranges[i]).arg(expected)));
            }
        }
    }
};

QTEST_GUILESS_MAIN(RangingTest)
#include "ranging_test.moc"
