// What lidars measure beside distances: sweeps, intensities, objects.
#include "sensor_world.h"

#include <numbers>

#include "model/object_numbers.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// A robot that floats in the origin, with a hull around the sensor, and scenery.
std::string floating(const std::string& sensor, const std::string& scenery, const std::string& robotPose = "",
                     const std::string& settings = "Tick=0.01 Seed=5") {
    return settings + " Gravity=0,0,0\nStaticConfig Things { " + scenery + " }\nStatic things { Config=Things }\n" +
           "RobotConfig Probe { Body base { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n" + sensor + " }\nRobot r { Config=Probe " +
           robotPose + " }\n";
}

} // namespace

class LidarTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSweepCastsEachBeamFromWhereTheSensorIsThen_data() {
        QTest::addColumn<double>("sweep");
        QTest::addColumn<double>("period");
        QTest::addColumn<int>("view"); // deg
        for (const int view : {180, 360}) {
            QTest::addRow("all of the period, %d deg", view) << 0.1 << 0.1 << view;
            QTest::addRow("a part of it, %d deg", view) << 0.06 << 0.1 << view;
            QTest::addRow("a period that is no multiple of the tick, %d deg", view) << 0.05 << 0.073 << view;
            QTest::addRow("all of such a period, %d deg", view) << 0.073 << 0.073 << view;
            QTest::addRow("none, %d deg", view) << 0.0 << 0.1 << view;
        }
    }
    /// The sensor turns and moves before a wall. The first beam is due at the start of the sweep and the last one at its end, in a
    /// full turn a step before its end; each is cast in the tick that ends then or first after it.
    void aSweepCastsEachBeamFromWhereTheSensorIsThen() {
        QFETCH(double, sweep);
        QFETCH(double, period);
        QFETCH(int, view);
        const double tick = 0.01;
        const int beams = 36, steps = view == 360 ? beams : beams - 1;
        char fields[200];
        std::snprintf(fields, sizeof fields, "Beams=%d FieldOfView=%d MaxRange=20 MinRange=0 UpdatePeriod=%g SweepTime=%g", beams,
                      view, period, sweep);
        SensorWorld w(floating("Lidar scan { Body=base " + std::string(fields) + " }", "Plane wall { HPR=0,-90,0 Pos=3,0,0 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.world().push("r/base", {0, 20, 0}, {0.01, 0, 0}).ok());
        std::vector<Pose> eyes{w.pose("r/base")};
        double read = w.value("r/scan/time");
        int readings = 0;
        for (int t = 1; t <= 100; ++t) {
            QVERIFY(w.run());
            eyes.push_back(w.pose("r/base"));
            if (w.value("r/scan/time") == read) continue;
            read = w.value("r/scan/time");
            const double due =
                std::round(std::floor((read + 1e-9) / period)) * period; // of this reading, at most a tick before it
            if (due < sweep) continue;
            ++readings;
            const auto ranges = w.values("r/scan/ranges");
            for (int i = 0; i < beams; ++i) {
                const double at = sweep > tick ? due - sweep * (1 - double(i) / steps) : read;
                const auto when = std::min<std::size_t>(eyes.size() - 1, std::size_t(std::ceil(at / tick - 1e-4)));
                const double bearing = view * (-0.5 + double(i) / steps) * kPi / 180;
                const Vec3 along = eyes[when].rotation * Vec3(std::cos(bearing), std::sin(bearing), 0);
                const double expected = along.x() > 0 ? std::min(20., (3 - eyes[when].position.x()) / along.x()) : 20;
                QVERIFY2(
                    std::abs(ranges[std::size_t(i)] - expected) < 1e-9 * std::max(1.0, expected),
                    qPrintable(QString("at %1, beam %2: %3, not %4").arg(read).arg(i).arg(ranges[std::size_t(i)]).arg(expected)));
            }
        }
        QVERIFY(readings > 5);
        QVERIFY((eyes.back().rotation.angularDistance(Quat::Identity()) > 0.5)); // bent walls are something else here
    }

    /// It drives at 1 m/s towards a wall and sweeps for 1 s: the first beam measures 1 m more than the last one, which is cast at
    /// the time of the reading.
    void aSweepIsAsLongAsItSays() {
        std::string lidars;
        for (const int beams : {1, 2, 5, 101})
            lidars += "Lidar l" + std::to_string(beams) + " { Body=base Beams=" + std::to_string(beams) +
                      " FieldOfView=0.001 SweepTime=1 UpdatePeriod=1 MaxRange=50 MinRange=0 }\n";
        SensorWorld w(floating(lidars, "Plane wall { HPR=0,-90,0 Pos=20,0,0 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.world().push("r/base", {100, 0, 0}, {0, 0, 0}).ok());
        QVERIFY(w.run(300));
        const double x = w.pose("r/base").position.x();
        QVERIFY(std::abs(w.value("r/base/velocity") - 1) < 1e-9);
        for (const int beams : {1, 2, 5, 101}) {
            const auto ranges = w.values("r/l" + std::to_string(beams) + "/ranges");
            QVERIFY(std::abs(ranges.back() - (20 - x)) < 1e-6);
            const double nearer = ranges.front() - ranges.back();
            QVERIFY2(std::abs(nearer - (beams > 1 ? 1 : 0)) < 1e-6, qPrintable(QString::number(nearer)));
        }
    }

    void aSweepIsNoLongerThanThePeriod() {
        SensorWorld w(floating("Lidar scan { Body=base UpdatePeriod=0.1 SweepTime=0.11 }", "Sphere s { Radius=1 Pos=3,0,0 }"));
        QVERIFY(!w.ok());
        QVERIFY2(QString::fromStdString(w.failure()).contains("SweepTime"), w.failure().c_str());
    }

    /// A matt surface returns its reflectance times the cosine of incidence; what reads nothing returns nothing.
    void intensitiesAreThoseOfAMattSurface() {
        const std::string materials = "Material half { ColorRGB=0.5,0.5,0.5 }\nMaterial white { ColorRGB=1,1,1 }\n";
        SensorWorld w(
            materials +
            floating("Lidar scan { Body=base Beams=91 FieldOfView=90 MaxRange=10 MinRange=0 Intensity=true Objects=true }\n"
                     "Lidar blind { Body=base Beams=91 FieldOfView=90 MaxRange=10 Dropouts=0.5 Intensity=true }\n"
                     "Lidar plain { Body=base Beams=91 FieldOfView=90 MaxRange=10 }\n"
                     "Lidar rough { Body=base Beams=91 FieldOfView=90 MaxRange=10 Intensity=true IntensityNoise=0.02 }",
                     "Plane wall { HPR=0,-90,0 Pos=3,0,0 Material=half } Box post { Size=0.1,0.1,1 Pos=2,0,0 Material=white }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> errors;
        for (int t = 0; t < 200; ++t) {
            QVERIFY(w.run());
            const auto intensities = w.values("r/scan/intensities"), ranges = w.values("r/scan/ranges"),
                       lost = w.values("r/blind/intensities"), left = w.values("r/blind/ranges"),
                       rough = w.values("r/rough/intensities"), objects = w.values("r/scan/objects");
            for (std::size_t i = 0; i < 91; ++i) {
                const double bearing = (-45 + double(i)) * kPi / 180;
                const bool post = std::abs(1.95 * std::tan(bearing)) < 0.05;
                QVERIFY(std::abs(ranges[i] - (post ? 1.95 : 3) / std::cos(bearing)) < 1e-9);
                QVERIFY2(std::abs(intensities[i] - (post ? 1 : 0.25) * std::cos(bearing)) < 1e-9,
                         qPrintable(QString::number(intensities[i])));
                QCOMPARE(lost[i] == 0, left[i] == 10);
                QCOMPARE(w.values("r/plain/intensities")[i], 0.);
                QCOMPARE(w.values("r/plain/objects")[i], 0.);
                QCOMPARE(objects[i], objects[post ? 45 : 0]);
                errors.push_back(rough[i] - intensities[i]);
            }
            QVERIFY(objects[0] > 0 && objects[45] > 0 && objects[0] != objects[45]);
        }
        const Moments m = momentsOf(errors);
        QVERIFY(std::abs(m.mean) < 4 * 0.02 / std::sqrt(double(errors.size())) && std::abs(m.deviation / 0.02 - 1) < 0.05);
    }

    /// The numbers are those of objectNames().
    void whatIsHitHasAName() {
        SensorWorld w("Tick=0.01 Gravity=0,0,0\nStaticConfig Things { Box near { Size=0.1,1,1 Pos=1,0,0 } Box ghost { Size=0.1,1,1 Pos=0.5,0,0 "
                      "Collide=false } Sphere far { Radius=0.5 Pos=-3,0,0 } }\nStatic z { Config=Things }\n"
                      "RobotConfig Probe { Body base { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n"
                      "RangeSensor front { Body=base MaxRange=5 } RangeSensor back { Body=base HPR=180,0,0 MaxRange=5 Type=ultrasonic } "
                      "RangeSensor left { Body=base HPR=90,0,0 MaxRange=5 } RangeSensor right { Body=base HPR=-90,0,0 MaxRange=1 } }\n"
                      "Robot r { Config=Probe }\nRobot a { Config=Probe Pos=0,2,0 }\n");
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        const std::vector<std::string> names = objectNames(w.world().experiment());
        const auto seen = [&](const char* path) { return names.at(std::size_t(w.value(path))); };
        QCOMPARE(seen("r/front/object"), std::string("z/near"));
        QCOMPARE(seen("r/back/object"), std::string("z/far"));
        QCOMPARE(seen("r/left/object"), std::string("a/base/hull"));
        QCOMPARE(seen("a/right/object"), std::string()); // farther than its MaxRange
        QCOMPARE(w.value("a/right/object"), 0.);
    }
};

QTEST_GUILESS_MAIN(LidarTest)
#include "lidar_test.moc"
