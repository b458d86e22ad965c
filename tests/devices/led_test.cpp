// Leds against closed forms: what light sensors see of them by distance, angles, colour and what is in between.
#include "sensor_world.h"

#include <numbers>

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

const std::string kDark = "Tick=0.01 Seed=5 Gravity=0,0,0\nLight sun { Intensity=0 }\nSky sky { Ambient=0 }\n";

std::string numbers(const Vec3& v) {
    char text[120];
    std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g", v.x(), v.y(), v.z());
    return text;
}

/// A robot with a light sensor in its origin that faces along x.
const std::string kEye = "RobotConfig Eye { Body base { Sphere hull { Radius=0.05 Mass=1 Pos=-1,0,0 } } LightSensor eye { "
                         "Body=base } }\nRobot r { Config=Eye }\n";

/// A robot with an Led in its origin, which shines along its x.
std::string lamp(const std::string& name, const std::string& fields, const std::string& place, const std::string& more = "") {
    return "RobotConfig " + name + "Lamp { Body base { Sphere hull { Radius=0.01 Mass=1 Pos=0,0,-1 } } Led led { Body=base " +
           fields + " } " + more + " }\nRobot " + name + " { Config=" + name + "Lamp " + place + " }\n";
}

void command(SensorWorld& w, const char* path, double value, std::size_t element = 0) {
    w.world().block().slots()[w.world().layout().find(path)->offset + element] = value;
}

double read(const std::string& text) {
    SensorWorld w(text);
    if (!w.ok()) qWarning("%s", w.failure().c_str());
    return w.ok() && w.run() ? w.value("r/eye/illuminance") : -1;
}

} // namespace

class LedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// E = I cos(a)^m cos(b) / d^2: a at the Led, b at the sensor, m by the half angle.
    void itsLightFallsWithDistanceAndBothAngles() {
        for (const double distance : {0.2, 1.0, 4.0})
            for (const double seen : {0., 40., 89., 91.})
                for (const double sent : {0., 30., -70., 91., 180.})
                    for (const double half : {0., 15., 60.}) {
                        const Vec3 at = distance * Vec3(std::cos(seen * kDegree), std::sin(seen * kDegree), 0);
                        const std::string fields = half > 0 ? "Intensity=20 HalfAngle=" + std::to_string(half) : "Intensity=20";
                        const std::string heading = numbers({180 + seen + sent, 0, 0});
                        const double cosine = std::max(0., std::cos(sent * kDegree));
                        const double share = half > 0 ? std::pow(cosine, std::log(0.5) / std::log(std::cos(half * kDegree))) : 1;
                        const double expected = 20 * share * std::max(0., std::cos(seen * kDegree)) / (distance * distance);
                        const double now = read(kDark + kEye + lamp("a", fields, "Pos=" + numbers(at) + " HPR=" + heading));
                        QVERIFY2(std::abs(now - expected) < 1e-9 * 20 / (distance * distance),
                                 qPrintable(QString("%1 m, %2, %3, %4: %5, not %6")
                                                .arg(distance)
                                                .arg(seen)
                                                .arg(sent)
                                                .arg(half)
                                                .arg(now)
                                                .arg(expected)));
                    }
    }

    /// At its half angle it is half as bright.
    void theHalfAngleIsWhatItSays() {
        const auto at = [](const char* heading) {
            return read(kDark + kEye + lamp("a", "Intensity=8 HalfAngle=25", std::string("Pos=1,0,0 HPR=") + heading));
        };
        QVERIFY(std::abs(at("180,0,0") - 8) < 1e-9);
        QVERIFY(std::abs(at("205,0,0") - 4) < 1e-9);
        QVERIFY(std::abs(at("180,25,0") - 4) < 1e-9);
    }

    void itsColourIsCommanded() {
        SensorWorld w(kDark + kEye + lamp("a", "Intensity=10 ColorRGB=1,0,0", "Pos=1,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("a/led/on"), 1.);
        QCOMPARE(w.value("a/led/color"), 1.);
        QVERIFY(w.run());
        QVERIFY(std::abs(w.value("r/eye/illuminance") - 2.126) < 1e-9);
        QCOMPARE(w.value("a/led/lit"), 1.);
        for (const std::size_t i : {0, 1, 2}) command(w, "a/led/color", 0.5, i);
        QVERIFY(w.run());
        QVERIFY(std::abs(w.value("r/eye/illuminance") - 2.5) < 1e-9); // in the tick of the command
        command(w, "a/led/color", 7, 1);
        command(w, "a/led/color", std::nan(""), 0);
        QVERIFY(w.run());
        QVERIFY(std::abs(w.value("r/eye/illuminance") - 10 * (0.7152 + 0.25 * 0.0722)) < 1e-9);
    }

    void oneThatIsOffIsDark() {
        SensorWorld w(kDark + kEye + lamp("a", "Intensity=10 On=false", "Pos=1,0,0"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        QVERIFY(w.value("r/eye/illuminance") == 0 && w.value("a/led/lit") == 0);
        command(w, "a/led/on", 1);
        QVERIFY(w.run());
        QVERIFY(std::abs(w.value("r/eye/illuminance") - 10) < 1e-9 && w.value("a/led/lit") == 1);
        command(w, "a/led/on", 0);
        QVERIFY(w.run());
        QVERIFY(w.value("r/eye/illuminance") == 0 && w.value("a/led/lit") == 0);
    }

    /// The first reading is that of the start, with the light that On, ColorRGB and the battery give then.
    void itShinesFromTheStart() {
        const auto atStart = [](const std::string& fields, const std::string& more = "") {
            SensorWorld w(kDark + kEye + lamp("a", "Intensity=10 " + fields, "Pos=1,0,0", more));
            if (!w.ok()) qWarning("%s", w.failure().c_str());
            return w.ok() ? std::pair(w.value("r/eye/illuminance"), w.value("a/led/lit")) : std::pair(-1.0, -1.0);
        };
        const auto [white, lit] = atStart("");
        QVERIFY(std::abs(white - 10) < 1e-9 && lit == 1);
        QVERIFY(std::abs(atStart("ColorRGB=1,0,0").first - 2.126) < 1e-9);
        QVERIFY(std::abs(atStart("Power=0.5", "Battery cell { Capacity=1 Voltage=1 }").first - 10) < 1e-9);
        QCOMPARE(atStart("On=false"), std::pair(0.0, 0.0));
        QCOMPARE(atStart("", "Battery cell { Capacity=1 Voltage=1 StartLevel=0 }"), std::pair(0.0, 0.0));
    }

    void whatIsInBetweenHidesIt() {
        const std::string wall = "StaticConfig W { Box wall { Size=0.1,0.4,0.4 } }\n";
        const std::string led = lamp("a", "Intensity=4 Diameter=0.02", "Pos=2,0,0");
        QVERIFY(read(kDark + kEye + wall + led + "Static w { Config=W Pos=1,0,0 }") == 0);
        QVERIFY(std::abs(read(kDark + kEye + wall + led + "Static w { Config=W Pos=1,0.3,0 }") - 1) < 1e-9);
        QVERIFY(std::abs(read(kDark + kEye + wall + led + "Static w { Config=W Pos=2.06,0,0 }") - 1) < 1e-9); // behind it
        QVERIFY(std::abs(read(kDark + kEye + wall + led + "Static w { Config=W Pos=2.045,0,0 }") - 1) <
                1e-9); // it lies in the wall
    }

    /// Each sensor sees the light of this tick, and the sums have the same bits, whatever the order in the text.
    void theOrderOfRobotsDoesNotMatter() {
        std::vector<std::string> robots{kEye};
        for (int i = 0; i < 5; ++i)
            robots.push_back(lamp(std::string(1, char('a' + i)), "Intensity=" + std::to_string(0.1 + 0.37 * i),
                                  "Pos=" + numbers({1 + 0.13 * i, 0.2 * i - 0.3, 0.05 * i})));
        std::vector<double> seen;
        for (int round = 0; round < 6; ++round) {
            std::rotate(robots.begin(), robots.begin() + 1, robots.end());
            std::string text = kDark;
            for (const std::string& robot : robots) text += robot;
            seen.push_back(read(text));
        }
        QVERIFY(seen.front() > 0.1);
        for (const double each : seen) QCOMPARE(std::bit_cast<std::uint64_t>(each), std::bit_cast<std::uint64_t>(seen.front()));
    }

    void itDrawsItsPowerAndIsDarkWithout() {
        SensorWorld w(kDark + kEye +
                      lamp("a", "Intensity=10 Power=0.5", "Pos=1,0,0", "Battery cell { Capacity=0.0001 Voltage=1 }")); // 0.36 J
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run(2));
        QVERIFY(std::abs(w.value("a/cell/current") - 0.5) < 1e-9);
        command(w, "a/led/on", 0);
        QVERIFY(w.run(2));
        QVERIFY(w.value("a/cell/current") == 0);
        command(w, "a/led/on", 1);
        QVERIFY(w.run(80));
        QVERIFY(w.value("a/cell/level") == 0 && w.value("a/led/lit") == 0 && w.value("r/eye/illuminance") == 0);
    }

    void badValuesAreRefused() {
        for (const char* fields : {"HalfAngle=0.5", "HalfAngle=90", "Diameter=-1", "Intensity=-1", "ColorRGB=2,0,0"}) {
            const SensorWorld w(kDark + kEye + lamp("a", fields, "Pos=1,0,0"));
            QVERIFY2(!w.ok(), fields);
        }
    }
};

QTEST_GUILESS_MAIN(LedTest)
#include "led_test.moc"
