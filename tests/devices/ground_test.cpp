// Ground sensors: what floors of any material return, spots, limits, errors.
#include "sensor_world.h"

#include <numbers>

#include <QImage>

#include "devices/ground_sensor.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// A robot that floats `height` above the origin, and what is below it.
std::string above(const std::string& scenery, const std::string& sensor = "GroundSensor eye { Body=base Pos=0,0,-0.06 }",
                  const std::string& robotPose = "Pos=0,0,0.1", const std::string& settings = "Tick=0.01 Seed=5") {
    return settings + " Gravity=0,0,0\n" + scenery + "\nStatic things { Config=Things }\n" +
           "RobotConfig Probe { Body base { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n" + sensor + " }\nRobot r { Config=Probe " +
           robotPose + " }\n";
}

/// Sensors named e0, e1 ... on a robot in the origin, each at a place.
std::string eyes(const std::vector<Vec3>& places, const std::string& fields = "") {
    std::string all;
    for (std::size_t i = 0; i < places.size(); ++i) {
        char text[120];
        std::snprintf(text, sizeof text, "GroundSensor e%zu { Body=base Pos=%.15g,%.15g,%.15g ", i, places[i].x(), places[i].y(),
                      places[i].z());
        all += text + fields + " }\n";
    }
    return all;
}

double luminance(double red, double green, double blue) {
    return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue;
}

/// 4 x 2 pixels, each of its own colour.
QImage colours() {
    QImage image(4, 2, QImage::Format_RGB32);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) image.setPixel(x, y, qRgb(20 + 70 * x, 250 - 90 * y, 10 + 31 * (x + 3 * y)));
    return image;
}

/// Writes them beside the text.
void writeColours(const QTemporaryDir& folder) {
    if (!colours().save(folder.filePath(QStringLiteral("colours.png")))) qFatal("the picture cannot be written");
}

/// Luminance of a pixel of `colours`, repeated in both directions.
double pixel(int x, int y) {
    const QRgb c = colours().pixel(((x % 4) + 4) % 4, ((y % 2) + 2) % 2);
    return luminance(qRed(c) / 255., qGreen(c) / 255., qBlue(c) / 255.);
}

/// The line of textures/line_course, by the formula that its arena names.
double distanceToLine(double x, double y) {
    double best = 9;
    for (int k = 0; k < 20000; ++k) {
        const double t = 2 * kPi * k / 20000;
        best = std::min(best, std::hypot(x - (0.88 * std::cos(t) + 0.10 * std::cos(2 * t) - 0.06 * std::sin(3 * t)),
                                         y - (0.50 * std::sin(t) + 0.10 * std::sin(3 * t) + 0.06 * std::cos(2 * t))));
    }
    return best;
}

} // namespace

class GroundTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aMaterialWithoutAPictureReturnsTheSquareOfItsColour() {
        for (const auto& [red, green, blue] : {std::array{1., 1., 1.}, {0., 0., 0.}, {0.5, 0.25, 0.75}, {0.8, 0.15, 0.12}}) {
            const std::string colour = std::to_string(red) + "," + std::to_string(green) + "," + std::to_string(blue);
            SensorWorld w(above("Material m { ColorRGB=" + colour + " }\nStaticConfig Things { Plane floor { Material=m } }"));
            QVERIFY2(w.ok(), w.failure().c_str());
            QVERIFY(w.run());
            QVERIFY(std::abs(w.value("r/eye/reflectance") - luminance(red, green, blue)) < 1e-12);
            QCOMPARE(w.value("r/eye/trueReflectance"), w.value("r/eye/reflectance"));
        }
    }

    void aPictureReturnsWhatIsInIt_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<double>("width"); // m, of the picture
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("left"); // its upper left corner
        QTest::addColumn<double>("top");
        QTest::newRow("plane") << "Plane floor { Material=m }" << 1. << 1. << 0. << 0.;
        QTest::newRow("plane, four times in a metre") << "Plane floor { Material=fine }" << 0.25 << 0.25 << 0. << 0.;
        QTest::newRow("box") << "Box floor { Size=0.8,0.4,0.1 Pos=0,0,-0.05 Material=m }" << 0.8 << 0.4 << -0.4 << 0.2;
        QTest::newRow("box, planar") << "Box floor { Size=0.8,0.4,0.1 Pos=0.1,0,-0.05 Material=flat }" << 0.8 << 0.4 << -0.3
                                     << 0.2;
        QTest::newRow("cap of a cylinder") << "Cylinder floor { Radius=0.3 Length=0.2 Pos=0,0,-0.1 Material=m }" << 0.6 << 0.6
                                           << -0.3 << 0.3;
    }
    /// In the middle of each pixel it is that of the pixel; between four it is that of their mean colour.
    void aPictureReturnsWhatIsInIt() {
        QFETCH(QString, floor);
        QFETCH(double, width);
        QFETCH(double, height);
        QFETCH(double, left);
        QFETCH(double, top);
        const std::string picture = "colours.png";
        const std::string materials = "Material m { Texture=" + picture +
                                      " }\nMaterial fine { TextureScale=4 Texture=" + picture +
                                      " }\nMaterial flat { TextureMap=planar Texture=" + picture + " ColorRGB=0,0,1 }\n";
        std::vector<Vec3> places{Vec3(left + width / 2, top - height / 2, -0.06)};
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x) places.emplace_back(left + width * (x + 0.5) / 4, top - height * (y + 0.5) / 2, -0.06);
        SensorWorld w(above(materials + "StaticConfig Things { " + floor.toStdString() + " }", eyes(places)), {}, writeColours);
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        for (int i = 0; i < 8; ++i) {
            const Vec3& place = places[std::size_t(i) + 1];
            if (floor.startsWith("Cylinder") && std::hypot(place.x(), place.y()) > 0.29) continue; // beyond the cap
            const double seen = w.value("r/e" + std::to_string(i + 1) + "/reflectance"), expected = pixel(i % 4, i / 4);
            QVERIFY2(std::abs(seen - expected) < 1e-9, qPrintable(QString("%1: %2, not %3").arg(i).arg(seen).arg(expected)));
        }
        double mean[3] = {};
        for (const QPoint p : {QPoint(1, 0), QPoint(2, 0), QPoint(1, 1), QPoint(2, 1)}) {
            const QRgb c = colours().pixel(p);
            mean[0] += qRed(c) / 1020.;
            mean[1] += qGreen(c) / 1020.;
            mean[2] += qBlue(c) / 1020.;
        }
        QVERIFY(std::abs(w.value("r/e0/reflectance") - luminance(mean[0], mean[1], mean[2])) < 1e-9);
    }

    void theLineOfTheShippedFloorIsWhereItsFormulaSays() {
        std::vector<Vec3> places;
        for (int i = 0; i < 120; ++i) places.emplace_back(-1.1 + 2.2 * ((i * 37) % 120) / 120, -0.7 + 1.4 * i / 120, -0.06);
        for (int k = 0; k < 12; ++k) { // on it
            const double t = 2 * kPi * k / 12;
            places.emplace_back(0.88 * std::cos(t) + 0.10 * std::cos(2 * t) - 0.06 * std::sin(3 * t),
                                0.50 * std::sin(t) + 0.10 * std::sin(3 * t) + 0.06 * std::cos(2 * t), -0.06);
        }
        SensorWorld w("#import arenas/line_course.sim\nStatic course { Config=LineCourse }\n" +
                      above("StaticConfig Things { Sphere far { Radius=0.1 Pos=9,9,9 } }", eyes(places)));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        int dark = 0, light = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double far = distanceToLine(places[i].x(), places[i].y());
            if (std::abs(far - 0.009) < 0.004) continue; // its edge
            const double read = w.value("r/e" + std::to_string(i) + "/reflectance");
            QVERIFY2(far < 0.009 ? read < 0.02 : read > 0.6, qPrintable(QString("%1: %2 at %3 m").arg(i).arg(read).arg(far)));
            (far < 0.009 ? dark : light) += 1;
        }
        QVERIFY2(light > 80 && dark >= 12, qPrintable(QString("%1 %2").arg(light).arg(dark)));
    }

    /// Another robot's picture turns and moves with it; the sensor looks along its own -z.
    void picturesMoveWithTheirBodies() {
        const std::string picture = "colours.png";
        SensorWorld w("Tick=0.01 Gravity=0,0,0\nMaterial m { Texture=" + picture +
                          " }\nRobotConfig Slab { Body base { Box top { Size=0.8,0.4,0.1 Mass=1 Material=m } } }\n"
                          "Robot slab { Config=Slab Pos=2,1,0 HPR=90,0,0 }\n"
                          "RobotConfig Probe { Body base { Sphere hull { Radius=0.02 Mass=1 } }\n"
                          "GroundSensor eye { Body=base MaxHeight=1 } }\n"
                          // Pixel 3,0 of its top is at 0.3,0.1 in the slab's frame: after a quarter turn to the left at -0.1,0.3.
                          "Robot r { Config=Probe Pos=1.9,1.3,0.5 }\n",
                      {}, writeColours);
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        QVERIFY2(std::abs(w.value("r/eye/reflectance") - pixel(3, 0)) < 1e-9,
                 qPrintable(QString::number(w.value("r/eye/reflectance"))));
        QVERIFY(w.world().push("slab/base", {0, 0.4 / 0.01 * 0.5, 0}, {2, 1, 0}).ok());
        QVERIFY(w.run()); // 20 N on 1 kg: 0.2 m/s
        QVERIFY(w.run(99));
        const double moved = w.pose("slab/base").position.y() - 1;
        QVERIFY(moved > 0.1 && moved < 0.3);
        QVERIFY(std::abs(w.value("r/eye/reflectance") - pixel(3, 0)) > 1e-3); // between this one and the next one now
    }

    /// A side has the whole picture, upright along the box's z and not mirrored, however the box lies.
    void aBoxThatLiesShowsTheSideThatIsUp_data() {
        QTest::addColumn<Vec3>("hpr"); // degrees
        QTest::addColumn<Vec3>("side");
        QTest::newRow("+x") << Vec3(0, -90, 0) << Vec3(1, 0, 0);
        QTest::newRow("-x") << Vec3(0, 90, 0) << Vec3(-1, 0, 0);
        QTest::newRow("+y") << Vec3(0, 0, 90) << Vec3(0, 1, 0);
        QTest::newRow("-y") << Vec3(0, 0, -90) << Vec3(0, -1, 0);
        QTest::newRow("+x, turned") << Vec3(30, -90, 0) << Vec3(1, 0, 0);
    }
    void aBoxThatLiesShowsTheSideThatIsUp() {
        QFETCH(Vec3, hpr);
        QFETCH(Vec3, side);
        const Quat turn = rotationFromHpr(hpr * (kPi / 180));
        QVERIFY((turn * side - Vec3::UnitZ()).norm() < 1e-9);
        const Vec3 right = turn * Vec3::UnitZ().cross(side), down = turn * Vec3(0, 0, -1);
        std::vector<Vec3> places;
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x)
                places.push_back(Vec3(0, 0, -0.06) + 0.2 * ((x + 0.5) / 4 - 0.5) * right + 0.2 * ((y + 0.5) / 2 - 0.5) * down);
        char box[160];
        std::snprintf(box, sizeof box, "Box cube { Size=0.2,0.2,0.2 Pos=0,0,-0.1 HPR=%g,%g,%g Material=m }", hpr.x(), hpr.y(),
                      hpr.z());
        const std::string picture = "colours.png";
        SensorWorld w(above("Material m { Texture=" + picture + " }\nStaticConfig Things { " + box + " }", eyes(places)), {},
                      writeColours);
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        for (int i = 0; i < 8; ++i) {
            const double seen = w.value("r/e" + std::to_string(i) + "/reflectance"), expected = pixel(i % 4, i / 4);
            QVERIFY2(std::abs(seen - expected) < 1e-9, qPrintable(QString("%1: %2, not %3").arg(i).arg(seen).arg(expected)));
        }
    }

    void aSpotIsAMeanOverItsArea() {
        const std::string halves =
            "Material dark { ColorRGB=0,0,0 }\nMaterial light { ColorRGB=1,1,1 }\nStaticConfig Things {\n"
            "Box a { Size=1,1,0.1 Pos=-0.5,0,-0.05 Material=dark }\nBox b { Size=1,1,0.1 Pos=0.5,0,-0.05 Material=light } }";
        std::vector<Vec3> places;
        for (const double x : {-0.03, -0.012, -0.004, 0.001, 0.008, 0.0153, 0.03}) places.emplace_back(x, 0.2, -0.06);
        SensorWorld w(above(halves, eyes(places, "Spot=0.04")));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double h = std::clamp(places[i].x() / 0.02, -1., 1.); // area of a disc on one side of a chord
            const double share = 0.5 + (std::asin(h) + h * std::sqrt(1 - h * h)) / kPi;
            const double read = w.value("r/e" + std::to_string(i) + "/reflectance");
            QVERIFY2(std::abs(read - share) < 0.03, qPrintable(QString("%1: %2, not %3").arg(i).arg(read).arg(share)));
        }
        Vec3 sum = Vec3::Zero();
        double square = 0;
        const std::vector<Vec3> all = placesOnDisc(2);
        for (const Vec3& p : all) {
            sum += p;
            square += p.squaredNorm() / static_cast<double>(all.size());
        }
        QVERIFY(sum.norm() < 1e-12 && std::abs(square - 0.5) < 1e-12); // as of a disc of radius 1
    }

    void whatIsTooFarOrItsOwnIsNotSeen() {
        const std::string white = "Material w { ColorRGB=1,1,1 }\nStaticConfig Things { Plane floor { Material=w } }";
        const auto read = [&](const std::string& sensor, const std::string& pose) {
            SensorWorld w(above(white, sensor, pose));
            return w.ok() && w.run() ? w.value("r/eye/reflectance") : -1;
        };
        QCOMPARE(read("GroundSensor eye { Body=base Pos=0,0,-0.06 MaxHeight=0.041 }", "Pos=0,0,0.1"), 1.);
        QCOMPARE(read("GroundSensor eye { Body=base Pos=0,0,-0.06 MaxHeight=0.039 }", "Pos=0,0,0.1"), 0.);
        QCOMPARE(read("GroundSensor eye { Body=base Pos=0,0,0.06 MaxHeight=0.2 }", "Pos=0,0,0.1"), 1.); // through its own hull
        QCOMPARE(read("GroundSensor eye { Body=base Pos=0,0,-0.06 }", "Pos=0,0,0.1 HPR=0,0,180"), 0.);  // upwards
        QCOMPARE(read("GroundSensor eye { Body=base HPR=0,0,180 Pos=0,0,0.06 }", "Pos=0,0,0.1 HPR=0,0,180"), 1.);
        QCOMPARE(read("GroundSensor eye { Body=base Pos=0,0,-0.06 MaxHeight=0.06 }", "Pos=0,0,0.1 HPR=0,0,40"),
                 0.); // 0.0704 m along it
    }

    void noiseIsWhatTheFieldSays() {
        const std::string grey = "Material g { ColorRGB=0.7,0.7,0.7 }\nStaticConfig Things { Plane floor { Material=g } }";
        SensorWorld w(above(grey, eyes(std::vector<Vec3>(50, Vec3(0, 0, -0.06)), "Noise=0.05")));
        QVERIFY2(w.ok(), w.failure().c_str());
        std::vector<double> all;
        for (int i = 0; i < 2000; ++i) {
            QVERIFY(w.run());
            for (int k = 0; k < 50; ++k) {
                all.push_back((w.value("r/e" + std::to_string(k) + "/reflectance") - 0.49) / 0.05);
                QVERIFY(std::abs(w.value("r/e" + std::to_string(k) + "/trueReflectance") - 0.49) < 1e-12);
            }
        }
        const double n = static_cast<double>(all.size());
        const Moments m = momentsOf(all);
        qInfo("%.0f samples: mean %.4f, deviation %.4f, correlation %.4f", n, m.mean, m.deviation, correlationOf(all, 1));
        QVERIFY(std::abs(m.mean) < 4 / std::sqrt(n));
        QVERIFY(std::abs(m.deviation - 1) < 4 / std::sqrt(2 * n));
        QVERIFY(std::abs(correlationOf(all, 1)) < 4 / std::sqrt(n));
        QVERIFY(std::abs(correlationOf(all, 50)) < 4 / std::sqrt(n)); // of one sensor from tick to tick
    }

    void readingsAreMultiplesOfTheResolutionFromBlackToWhite() {
        const std::string white = "Material w { ColorRGB=0.98,0.98,0.98 }\nStaticConfig Things { Plane floor { Material=w } }";
        SensorWorld w(above(white, "GroundSensor eye { Body=base Pos=0,0,-0.06 Noise=0.3 Resolution=0.03 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        double most = 0;
        for (int t = 0; t < 200; ++t) {
            QVERIFY(w.run());
            const double r = w.value("r/eye/reflectance");
            QVERIFY(r >= 0 && r <= 1 && std::abs(r / 0.03 - std::round(r / 0.03)) < 1e-9);
            most = std::max(most, r);
        }
        QVERIFY(std::abs(most - 0.99) < 1e-12);
        QCOMPARE(roundedWithin(0.126, 0.01, 0.13, 0.05), 0.1); // 0.15 is too much
        QCOMPARE(roundedWithin(0.01, 0.012, 0.5, 0.05), 0.05);
        QCOMPARE(roundedWithin(0.3, 0.26, 0.29, 0.5), 0.29); // no multiple in between
        QCOMPARE(roundedWithin(7, 0.12, 3.5, 0.001), 3.5);
        QCOMPARE(roundedWithin(0.1, 0.12, 3.5, 0.001), 0.12);
        QCOMPARE(roundedWithin(0.37, 0, 1, 0), 0.37);
    }

    /// Marks are paint: visible, flat, and nothing touches them.
    void marksOnTheFloorAreSeen_data() {
        QTest::addColumn<QString>("mark");
        QTest::addColumn<double>("expected");
        QTest::newRow("line") << "Box mark { Pos=0,0,0.0005 Size=1,0.02,0.001 Collide=false Material=black }" << 0.;
        QTest::newRow("disc") << "Cylinder mark { Pos=0,0,0.001 Radius=0.01 Length=0.002 Collide=false Material=black }" << 0.;
        QTest::newRow("on top") << "Box low { Pos=0,0,0.0005 Size=1,1,0.001 Collide=false Material=black }\n"
                                   "Box high { Pos=0,0,0.0006 Size=1,0.02,0.001 Collide=false Material=grey }"
                                << 0.25;
        QTest::newRow("turned") << "Box mark { Pos=0,0,0.0005 HPR=45,0,0 Size=1,0.02,0.001 Collide=false Material=black }" << 0.;
        for (const int turn : {45, 90, 135, 180, -60}) { // the sensor is above one of its ends
            const double along = turn * kPi / 180;
            QTest::addRow("end, turned by %d", turn)
                << QString("Box mark { Pos=%1,%2,0.0005 HPR=%3,0,0 Size=1,0.02,0.001 Collide=false Material=black }")
                       .arg(0.48 * std::cos(along))
                       .arg(0.48 * std::sin(along))
                       .arg(turn)
                << 0.;
        }
        QTest::newRow("beside") << "Box mark { Pos=0,0.02,0.0005 Size=1,0.02,0.001 Collide=false Material=black }" << 1.;
        QTest::newRow("beside, turned")
            << "Box mark { Pos=0.1,-0.1,0.0005 HPR=45,0,0 Size=1,0.02,0.001 Collide=false Material=black }" << 1.;
        QTest::newRow("too thick") << "Box mark { Pos=0,0,0.0015 Size=1,0.02,0.003 Collide=false Material=black }" << 1.;
        QTest::newRow("hidden") << "Box mark { Pos=0,0,0.0005 Size=1,0.02,0.001 Collide=false Visible=false Material=black }"
                                << 1.;
        QTest::newRow("in the air") << "Box mark { Pos=0,0,0.003 Size=1,0.02,0.001 Collide=false Material=black }" << 1.;
    }
    void marksOnTheFloorAreSeen() {
        QFETCH(QString, mark);
        QFETCH(double, expected);
        SensorWorld w(
            above("Material w { ColorRGB=1,1,1 }\nMaterial black { ColorRGB=0,0,0 }\nMaterial grey { ColorRGB=0.5,0.5,0.5 "
                  "}\nStaticConfig Things { Plane floor { Material=w }\n" +
                  mark.toStdString() + " }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QVERIFY(w.run());
        QVERIFY2(std::abs(w.value("r/eye/reflectance") - expected) < 1e-12, QByteArray::number(w.value("r/eye/reflectance")));
    }

    void readingsComeLaterByTheLatency() {
        const std::string white = "Material w { ColorRGB=1,1,1 }\nStaticConfig Things { Plane floor { Material=w } }";
        SensorWorld w(above(white, "GroundSensor eye { Body=base Pos=0,0,-0.06 UpdatePeriod=0.05 Latency=0.02 }"));
        QVERIFY2(w.ok(), w.failure().c_str());
        QCOMPARE(w.value("r/eye/time"), -1.);
        QCOMPARE(w.value("r/eye/reflectance"), 0.);
        QVERIFY(w.run(2));
        QCOMPARE(w.value("r/eye/time"), 0.);
        QCOMPARE(w.value("r/eye/reflectance"), 1.);
        QVERIFY(w.run(4));
        QCOMPARE(w.value("r/eye/time"), 0.);
        QVERIFY(w.run());
        QVERIFY(std::abs(w.value("r/eye/time") - 0.05) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(GroundTest)
#include "ground_test.moc"
