// Light sensors against closed forms: sun, lamps, sky, shadows, limits, errors.
#include "sensor_world.h"

#include <numbers>

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi;

const std::string kDark = "Light sun { Intensity=0 }\nSky sky { Ambient=0 }\n";

/// A sensor in the origin that faces by `hpr` (degrees), with the lights and scenery of `more`.
std::string seeing(const std::string& more, const std::string& hpr = "0,0,0", const std::string& fields = "") {
    return "Tick=0.01 Seed=5 Gravity=0,0,0\n" + more +
           "\nRobotConfig Probe { Body base { Sphere hull { Radius=0.05 Mass=1 } } LightSensor eye { Body=base HPR=" + hpr + " " +
           fields + " } }\nRobot r { Config=Probe }\n";
}

double read(const std::string& text, const char* signal = "r/eye/illuminance") {
    SensorWorld w(text);
    if (!w.ok()) qWarning("%s", w.failure().c_str());
    return w.ok() && w.run() ? w.value(signal) : -1;
}

double luminance(double red, double green, double blue) { return 0.2126 * red + 0.7152 * green + 0.0722 * blue; }

} // namespace

class LightTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLampFallsWithTheSquareOfItsDistanceAndTheCosine() {
        for (const double distance : {0.5, 1.0, 7.0})
            for (const double angle : {0., 60., 89., 91., 180.}) {
                char place[80];
                std::snprintf(place, sizeof place, "%.17g,%.17g,0", distance * std::cos(angle * kPi / 180),
                              distance * std::sin(angle * kPi / 180));
                const std::string lamp =
                    "Light lamp { Mode=lamp Intensity=3 ColorRGB=1,0.5,0.2 Pos=" + std::string(place) + " }\n";
                const double expected =
                    3000 * luminance(1, 0.25, 0.04) * std::max(0., std::cos(angle * kPi / 180)) / (distance * distance);
                const double now = read(seeing(kDark + lamp));
                QVERIFY2(std::abs(now - expected) < 1e-9 * 3000,
                         qPrintable(QString("%1 m, %2: %3, not %4").arg(distance).arg(angle).arg(now).arg(expected)));
            }
    }

    void lampsAddUp() {
        const std::string a = "Light a { Mode=lamp Pos=1,0,0 }\n", b = "Light b { Mode=lamp Pos=2,0,0 Intensity=2 }\n";
        QVERIFY(std::abs(read(seeing(kDark + a + b)) - 1500) < 1e-6);
        QVERIFY(std::abs(read(seeing(kDark)) - 0) < 1e-12);
    }

    void theSunComesFromItsDirection() {
        const std::string sun = "Light sun { Direction=-1,0,-1 Intensity=0.5 }\nSky sky { Ambient=0 }\n";
        QVERIFY(std::abs(read(seeing(sun)) - 500 * std::sqrt(0.5)) < 1e-6);
        QVERIFY(std::abs(read(seeing(sun, "180,0,0"))) < 1e-9);
        QVERIFY(std::abs(read(seeing(sun, "90,0,0"))) < 1e-9);
    }

    /// The light that everything has, in the brightness of pictures.
    void withoutLightsInTheTextThereAreSunAndSky() {
        const Vec3 toSun = Vec3(-0.52, -0.30, 0.80).normalized();
        const double sky = luminance(0.36, 0.395, 0.45), ground = luminance(0.19, 0.185, 0.18), sun = luminance(0.98, 0.94, 0.86);
        QVERIFY(std::abs(read(seeing("")) - 1000 * (sky + ground) / 2) < 1e-6); // away from the sun
        QVERIFY(std::abs(read(seeing("", "180,0,0")) - 1000 * ((sky + ground) / 2 - sun * toSun.x())) < 1e-6);
        QVERIFY(std::abs(read(seeing("Light s { Intensity=0 }\nSky k { Ambient=2 }")) - 1000 * (sky + ground)) < 1e-6);
    }

    void whatIsInBetweenCastsAShadow() {
        const std::string lamp = "Light lamp { Mode=lamp Pos=2,0,0 }\n";
        const std::string wall = "StaticConfig W { Box wall { Size=0.1,0.4,0.4 Pos=1,0,0 } }\n";
        QVERIFY(std::abs(read(seeing(kDark + lamp + wall + "Static w { Config=W }"))) < 1e-12);
        QVERIFY(std::abs(read(seeing(kDark + lamp + wall + "Static w { Config=W Pos=0,0.3,0 }")) - 250) < 1e-6);
        QVERIFY(std::abs(read(seeing(kDark + lamp + wall + "Static w { Config=W Pos=1.5,0,0 }")) - 250) <
                1e-6); // behind the lamp
        const std::string soft = "Light lamp { Mode=lamp Pos=2,0,0 Shadows=false }\n";
        QVERIFY(std::abs(read(seeing(kDark + soft + wall + "Static w { Config=W }")) - 250) < 1e-6);
        const std::string sun = "Light sun { Direction=-1,0,0 }\nSky sky { Ambient=0 }\n";
        QVERIFY(std::abs(read(seeing(sun + wall + "Static w { Config=W }"))) < 1e-12);
        QVERIFY(std::abs(read(seeing(sun + wall + "Static w { Config=W Pos=0,0,0.3 }")) - 1000) < 1e-6);
        const std::string other =
            "RobotConfig O { Body b { Box b { Size=0.1,0.4,0.4 Mass=1 } } }\nRobot o { Config=O Pos=1,0,0 }";
        QVERIFY(std::abs(read(seeing(kDark + lamp + other))) < 1e-12); // another robot
    }

    void aNarrowSensorSeesWhatIsAhead() {
        const std::string aside = "Light lamp { Mode=lamp Pos=0.5,0.8660254037844386,0 }\n";
        QVERIFY(std::abs(read(seeing(kDark + aside, "0,0,0", "Exponent=1")) - 500) < 1e-6);
        QVERIFY(std::abs(read(seeing(kDark + aside, "0,0,0", "Exponent=4")) - 1000 / 16.) < 1e-6);
        QVERIFY(std::abs(read(seeing(kDark + aside, "0,0,0", "Exponent=0")) - 1000) < 1e-6);
        QVERIFY(std::abs(read(seeing(kDark + aside, "180,0,0", "Exponent=0"))) < 1e-6);
        const double sky = luminance(0.36, 0.395, 0.45);
        QVERIFY(std::abs(read(seeing("Light s { Intensity=0 }", "0,90,0", "Exponent=3")) - 0) <
                1000 * sky); // from everywhere, less
    }

    /// Of sky and ground a narrow sensor sees what is ahead. Expected: integrals over the half sphere, by points on it.
    void aNarrowSensorDividesSkyAndGround() {
        const double sky = luminance(0.36, 0.395, 0.45), ground = luminance(0.19, 0.185, 0.18);
        for (const auto& [exponent, up] : {std::pair(4., 30.), {20., 30.}, {100., 10.}, {100., -3.}, {0.5, -50.}, {3., 90.}}) {
            double all = 0, above = 0;
            const double tilt = up * kPi / 180;
            for (int i = 0; i < 4000; ++i)
                for (int k = 0; k < 200; ++k) {
                    const double cosine = (i + 0.5) / 4000, round = 2 * kPi * (k + 0.5) / 200;
                    const double height =
                        cosine * std::sin(tilt) + std::sqrt(1 - cosine * cosine) * std::cos(tilt) * std::cos(round);
                    const double weight = std::pow(cosine, exponent);
                    all += weight;
                    if (height > 0) above += weight;
                }
            const double share = above / all, expected = 1000 * 2 / (exponent + 1) * (share * sky + (1 - share) * ground);
            const QString hpr = QStringLiteral("20,%1,0").arg(-up), fields = QStringLiteral("Exponent=%1").arg(exponent);
            const double shown = read(seeing("Light s { Intensity=0 }", hpr.toStdString(), fields.toStdString()));
            QVERIFY2(std::abs(shown / expected - 1) < 0.006, qPrintable(QStringLiteral("%1 of %2").arg(shown).arg(expected)));
        }
    }

    void limitsAndResolution() {
        const std::string lamp = "Light lamp { Mode=lamp Pos=1,0,0 }\n";
        QCOMPARE(read(seeing(kDark + lamp, "0,0,0", "MaxIlluminance=400")), 400.);
        QVERIFY(std::abs(read(seeing(kDark + lamp, "0,0,0", "MaxIlluminance=400"), "r/eye/trueIlluminance") - 1000) < 1e-6);
        QCOMPARE(read(seeing(kDark + lamp, "0,0,0", "MaxIlluminance=400 Resolution=30")), 390.);
        QCOMPARE(read(seeing(kDark + lamp, "0,0,0", "Resolution=300")), 900.);
    }

    void noiseIsWhatTheFieldsSay() {
        SensorWorld w(seeing(kDark + "Light lamp { Mode=lamp Pos=2,0,0 }\n", "0,0,0", "Noise=2 NoiseShare=0.02"));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> all;
        for (int t = 0; t < 20000; ++t) {
            QVERIFY(w.run());
            all.push_back((w.value("r/eye/illuminance") - 250) / 7);
        }
        const double n = static_cast<double>(all.size());
        const Moments m = momentsOf(all);
        qInfo("%.0f samples: mean %.4f, deviation %.4f, correlation %.4f", n, m.mean, m.deviation, correlationOf(all, 1));
        QVERIFY(std::abs(m.mean) < 4 / std::sqrt(n));
        QVERIFY(std::abs(m.deviation - 1) < 4 / std::sqrt(2 * n));
        QVERIFY(std::abs(correlationOf(all, 1)) < 4 / std::sqrt(n));
    }
};

QTEST_GUILESS_MAIN(LightTest)
#include "light_test.moc"
