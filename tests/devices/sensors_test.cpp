// Encoder and touch sensor.
#include "bench_robot.h"
#include "devices/encoder.h"

#include <QtTest>

using namespace trundle;
using namespace trundle::test;

namespace {
constexpr double kTurn = 2 * M_PI;

BenchDevice& addEncoder(BenchRobot& robot, double counts) {
    BenchDevice& encoder = robot.device("Encoder", "encoder");
    robot.joint("axle");
    encoder.texts = {{"Joint", {"axle"}}};
    encoder.numbers = {{"CountsPerRevolution", {counts}}};
    return encoder;
}

TrundleContact contactOf(double force) {
    TrundleContact c{};
    c.force = force;
    return c;
}
} // namespace

class SensorsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void encoderCountsFullSteps_data() {
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("count");
        QTest::newRow("at the start") << 0. << 0.;
        QTest::newRow("just before the first edge") << kTurn / 512 * .999 << 0.;
        QTest::newRow("on the first edge") << kTurn / 512 << 1.;
        QTest::newRow("rounded onto an edge") << kTurn / 512 * 3 * (1 - 1e-15) << 3.;
        QTest::newRow("one turn") << kTurn << 512.;
        QTest::newRow("many turns") << 1e6 * kTurn + .001 << 512e6;
        QTest::newRow("a little backwards") << -.001 << -1.;
        QTest::newRow("rounding at rest") << -1e-17 << 0.;
        QTest::newRow("one step back") << -kTurn / 512 << -1.;
        QTest::newRow("a step and a half back") << -kTurn / 512 * 1.5 << -2.;
    }
    void encoderCountsFullSteps() {
        QFETCH(double, angle);
        QFETCH(double, count);
        QCOMPARE(encoderCount(angle, 512), count);
    }

    void encoderPublishesWhatItCounted_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {.01, .0025, .03}) QTest::addRow("%g s", tick) << tick;
    }
    void encoderPublishesWhatItCounted() {
        QFETCH(double, tick);
        BenchRobot robot(tick);
        addEncoder(robot, 100);
        QCOMPARE(robot.setup(), std::string());
        robot.joint("axle").rate = .033 / tick; // .525 counts a tick
        robot.tick();
        QCOMPARE(robot.signal("encoder/count")[0], 0.);
        QCOMPARE(robot.signal("encoder/rate")[0], 0.);
        robot.tick();
        QCOMPARE(robot.signal("encoder/count")[0], 1.);
        QCOMPARE(robot.signal("encoder/angle")[0], kTurn / 100);
        QVERIFY(std::abs(robot.signal("encoder/rate")[0] - kTurn / 100 / tick) < 1e-12 / tick);
        QCOMPARE(robot.signal("encoder/index")[0], 0.);
    }

    void quadratureCountsFourTimes() {
        BenchRobot robot(.01);
        addEncoder(robot, 100).numbers["Quadrature"] = {1};
        QCOMPARE(robot.setup(), std::string());
        robot.joint("axle").rate = 100 * kTurn; // one turn a tick
        robot.tick();
        QCOMPARE(robot.signal("encoder/count")[0], 400.);
        QVERIFY(std::abs(robot.signal("encoder/angle")[0] - kTurn) < 1e-12);
    }

    void indexPulsesOncePerTurn() {
        BenchRobot robot(.01);
        addEncoder(robot, 16).numbers["Index"] = {1};
        QCOMPARE(robot.setup(), std::string());
        robot.joint("axle").rate = 10 * kTurn; // a tenth of a turn a tick
        int pulses = 0;
        for (int i = 0; i < 35; ++i) {
            robot.tick();
            pulses += robot.signal("encoder/index")[0] != 0;
        }
        QCOMPARE(pulses, 3);
    }

    /// The mark is at 0: it passes once per turn in either direction, and once more when a turn is taken back.
    void indexPulsesBackwards() {
        BenchRobot robot(.01);
        addEncoder(robot, 16).numbers["Index"] = {1};
        QCOMPARE(robot.setup(), std::string());
        const auto pulsesOf = [&](double turnsPerTick, int ticks) {
            robot.joint("axle").rate = turnsPerTick * 100 * kTurn;
            int pulses = 0;
            for (int i = 0; i < ticks; ++i) {
                robot.tick();
                pulses += robot.signal("encoder/index")[0] != 0;
            }
            return pulses;
        };
        QCOMPARE(pulsesOf(-.1, 35), 4); // leaves 0 at once: 0, -1, -2, -3
        QCOMPARE(robot.signal("encoder/count")[0], -56.);
        QCOMPARE(pulsesOf(.1, 36), 4); // to +0.1
        QCOMPARE(pulsesOf(-.03, 3), 0);
        QCOMPARE(pulsesOf(-.03, 1), 1);
    }

    /// Rate and angle backwards, in quadrature.
    void encoderCountsBackwards() {
        BenchRobot robot(.01);
        addEncoder(robot, 100).numbers["Quadrature"] = {1};
        QCOMPARE(robot.setup(), std::string());
        robot.joint("axle").rate = -1.3 * kTurn; // 5.2 counts a tick
        robot.tick();
        QCOMPARE(robot.signal("encoder/count")[0], -6.);
        robot.tick();
        QCOMPARE(robot.signal("encoder/count")[0], -11.);
        QVERIFY(std::abs(robot.signal("encoder/rate")[0] + 5 * kTurn / 4) < 1e-12);
        QVERIFY(std::abs(robot.signal("encoder/angle")[0] + 11 * kTurn / 400) < 1e-12);
    }

    /// At 2.5 times its highest frequency it counts 2 of 5 lines, in quadrature with four counts each; below it all of them.
    void missesCountsAboveItsFrequency_data() {
        QTest::addColumn<double>("tick");
        for (const double tick : {.005, .01, .03}) QTest::addRow("%g ms", 1e3 * tick) << tick;
    }
    void missesCountsAboveItsFrequency() {
        QFETCH(double, tick);
        BenchRobot robot(tick);
        BenchDevice& encoder = addEncoder(robot, 100);
        encoder.numbers["Quadrature"] = {1};
        encoder.numbers["MaxFrequency"] = {230}; // lines per second
        QCOMPARE(robot.setup(), std::string());
        robot.joint("axle").rate = 2.2 * kTurn;
        robot.run(3);
        QCOMPARE(robot.signal("encoder/missed")[0], 0.);
        QVERIFY(std::abs(robot.signal("encoder/count")[0] - 2640) <= 1); // 3 s may end just before an edge
        robot.joint("axle").rate = -5.75 * kTurn;
        robot.run(6);
        QVERIFY(std::abs(robot.signal("encoder/count")[0] - (2640 - 6 * 4 * 230)) <= 1);
        QVERIFY(std::abs(robot.signal("encoder/missed")[0] - 6 * 4 * (575 - 230)) <= 2);
        QCOMPARE(robot.signal("encoder/count")[0] - robot.signal("encoder/missed")[0],
                 encoderCount(robot.joint("axle").position, 400)); // all backwards
    }

    void itsFrequencyIsThatAtAnyTick_data() {
        QTest::addColumn<double>("tick");
        QTest::addColumn<double>("lines"); // per second
        for (const double tick : {.1, .05, .02, .01, .004, .001})
            for (const double lines : {12.7, 19.99, 20.69, 31.83, 41., 450.})
                QTest::addRow("%g lines/s at %g ms", lines, 1e3 * tick) << tick << lines;
    }
    /// Of 20 lines per second it counts all that are slower, from the first one on, and 20 of those that are faster.
    void itsFrequencyIsThatAtAnyTick() {
        QFETCH(double, tick);
        QFETCH(double, lines);
        for (const bool quadrature : {false, true}) {
            BenchRobot robot(tick);
            BenchDevice& encoder = addEncoder(robot, 100);
            encoder.numbers["Quadrature"] = {double(quadrature)};
            encoder.numbers["MaxFrequency"] = {20};
            QCOMPARE(robot.setup(), std::string());
            robot.joint("axle").rate = -lines / 100 * kTurn; // the first edge is the one that it leaves at once
            robot.run(60);
            const double counted = -robot.signal("encoder/count")[0], missed = robot.signal("encoder/missed")[0];
            const double expected = 60 * std::min(lines, 20.) * (quadrature ? 4 : 1);
            QVERIFY2(std::abs(counted / expected - 1) < .01, qPrintable(QString("%1, not %2").arg(counted).arg(expected)));
            QCOMPARE(counted + missed, -encoderCount(robot.joint("axle").position, quadrature ? 400 : 100));
            if (lines < 20) QCOMPARE(missed, 0.);
        }
    }

    /// Bursts of 50 lines in 50 ms, each after a rest, of an encoder that counts 20 in a second.
    void aBurstIsCountedUpToTheFrequency() {
        BenchRobot robot(.001);
        addEncoder(robot, 100).numbers["MaxFrequency"] = {20};
        QCOMPARE(robot.setup(), std::string());
        for (int burst = 0; burst < 5; ++burst) {
            robot.joint("axle").rate = 0;
            robot.run(3);
            const double before = robot.signal("encoder/count")[0];
            robot.joint("axle").rate = 10 * kTurn;
            robot.run(.05);
            const double counted = robot.signal("encoder/count")[0] - before;
            QVERIFY2(counted == 1 || counted == 2, qPrintable(QString::number(counted)));
        }
    }

    void anAbsoluteEncoderWraps() {
        BenchRobot robot(.01);
        BenchDevice& encoder = addEncoder(robot, 360);
        encoder.texts["Type"] = {"absolute"};
        encoder.numbers["Offset"] = {kTurn / 4};
        QCOMPARE(robot.setup(), std::string());
        const auto codeAt = [&](double turns) {
            robot.joint("axle").position = turns * kTurn;
            robot.tick();
            return robot.signal("encoder/count")[0];
        };
        QCOMPARE(codeAt(0), 90.);
        QCOMPARE(codeAt(.5), 270.);
        QCOMPARE(codeAt(.749), 359.);
        QCOMPARE(codeAt(.75), 0.);
        QCOMPARE(codeAt(-.251), 359.);
        QVERIFY(std::abs(robot.signal("encoder/angle")[0] - kTurn * 359 / 360) < 1e-12);
        QCOMPARE(codeAt(1000), 90.);
        robot.joint("axle").rate = -kTurn; // 3.6 codes a tick, past 0 after 25 ticks
        for (int i = 0; i < 50; ++i) {
            robot.tick();
            QVERIFY(std::abs(robot.signal("encoder/rate")[0] + kTurn) < kTurn / 360 / .01);
        }
        QCOMPARE(robot.signal("encoder/count")[0], 270.);
    }

    /// A line of 0.02 mm; an index mark every 500 lines, which is 10 mm.
    void anEncoderOnASlider() {
        BenchRobot robot(.01);
        BenchDevice& encoder = addEncoder(robot, 500);
        encoder.numbers["Pitch"] = {2e-5};
        encoder.numbers["Quadrature"] = encoder.numbers["Index"] = {1};
        QCOMPARE(robot.setup(), std::string());
        robot.joint("axle").rate = .1;
        int pulses = 0;
        for (int i = 0; i < 35; ++i) {
            robot.tick();
            pulses += robot.signal("encoder/index")[0] != 0;
        }
        QCOMPARE(robot.signal("encoder/count")[0], 7000.);
        QVERIFY(std::abs(robot.signal("encoder/angle")[0] - .035) < 1e-12);
        QVERIFY(std::abs(robot.signal("encoder/rate")[0] - .1) < 1e-3);
        QCOMPARE(pulses, 3);
    }

    void anEncoderOfOneTypeHasNothingOfTheOther() {
        BenchRobot absolute(.01), incremental(.01);
        BenchDevice& a = addEncoder(absolute, 100);
        a.texts["Type"] = {"absolute"};
        a.numbers["MaxFrequency"] = {100};
        addEncoder(incremental, 100).numbers["Offset"] = {1};
        QVERIFY(absolute.setup().find("MaxFrequency") != std::string::npos);
        QVERIFY(incremental.setup().find("Offset") != std::string::npos);
    }

    /// Pressed from 2 N on, until less than 1 N.
    void touchHasHysteresis() {
        BenchRobot robot(.01);
        BenchDevice& touch = robot.device("TouchSensor", "touch");
        touch.texts = {{"Geom", {"body.pad"}}};
        touch.numbers = {{"MinForce", {2}}, {"ReleaseForce", {1}}};
        robot.contacts["body.pad"] = {};
        QCOMPARE(robot.setup(), std::string());
        const auto pressedAt = [&](double force) {
            robot.contacts["body.pad"] = {contactOf(force)};
            robot.tick();
            return robot.signal("touch/pressed")[0] != 0;
        };
        QVERIFY(!pressedAt(1.5) && !pressedAt(1.999) && pressedAt(2) && pressedAt(1.5) && pressedAt(1));
        QCOMPARE(robot.signal("touch/force")[0], 1.);
        QVERIFY(!pressedAt(.999) && !pressedAt(1.5) && pressedAt(3));
        robot.contacts["body.pad"].clear();
        robot.tick();
        QCOMPARE(robot.signal("touch/pressed")[0], 0.);
    }

    void touchRefusesAReleaseAboveItsThreshold() {
        BenchRobot robot(.01);
        BenchDevice& touch = robot.device("TouchSensor", "touch");
        touch.texts = {{"Geom", {"body.pad"}}};
        touch.numbers = {{"MinForce", {2}}, {"ReleaseForce", {3}}};
        robot.contacts["body.pad"] = {};
        QVERIFY(robot.setup().find("ReleaseForce") != std::string::npos);
    }

    /// A period below the tick, of one tick, and just above it: a picture at the first tick at or after each due time, numbered by those.
    void aCameraNearItsTick_data() {
        QTest::addColumn<double>("period");
        QTest::addColumn<QList<double>>("frames");
        QTest::newRow("0: none of its own") << 0. << QList<double>{0, 1, 2, 3, 4, 5, 6, 7};
        QTest::newRow("0.4 ticks") << .004 << QList<double>{0, 3, 6, 8, 11, 13, 16, 18};
        QTest::newRow("one tick") << .01 << QList<double>{0, 2, 3, 4, 5, 6, 7, 8};
        QTest::newRow("1.5 ticks") << .015 << QList<double>{0, 1, 2, 2, 3, 4, 4, 5};
        QTest::newRow("2 ticks") << .02 << QList<double>{0, 1, 1, 2, 2, 3, 3, 4};
    }
    void aCameraNearItsTick() {
        QFETCH(double, period);
        QFETCH(QList<double>, frames);
        BenchRobot robot(.01);
        BenchDevice& camera = robot.device("Camera", "eye");
        camera.texts = {{"Body", {"chassis"}}};
        camera.numbers = {{"UpdatePeriod", {period}}};
        QCOMPARE(robot.setup(), std::string());
        QList<double> seen;
        double lastFrame = -1;
        for (int i = 1; i <= frames.size(); ++i) {
            robot.tick();
            const double frame = robot.signal("eye/frame")[0], time = robot.signal("eye/time")[0];
            QCOMPARE(std::abs(time - i * .01) < 1e-12, frame != lastFrame); // a new picture is of now
            lastFrame = frame;
            seen << frame;
        }
        QCOMPARE(seen, frames);
    }

    void aCameraCountsThePicturesOfItsStream() {
        BenchRobot robot(.01);
        BenchDevice& camera = robot.device("Camera", "eye");
        camera.texts = {{"Body", {"chassis"}}};
        camera.numbers = {{"UpdatePeriod", {.025}}};
        QCOMPARE(robot.setup(), std::string());
        const std::vector<double> frames{0, 0, 1, 1, 2, 2, 2, 3, 3, 4}, times{.01, .01, .03, .03, .05, .05, .05, .08, .08, .1};
        for (std::size_t i = 0; i < frames.size(); ++i) {
            robot.tick();
            QCOMPARE(robot.signal("eye/frame")[0], frames[i]);
            QVERIFY(std::abs(robot.signal("eye/time")[0] - times[i]) < 1e-12);
        }
    }

    void aCameraWhoseFarIsNearIsRefused() {
        BenchRobot robot(.01);
        robot.device("Camera", "eye").numbers = {{"Near", {2}}, {"Far", {1}}};
        QCOMPARE(robot.setup(), std::string("Near must be smaller than Far"));
    }

    void touchIsPressedByContacts() {
        BenchRobot robot(.01);
        robot.contacts = {{"chassis.bumper", {}}, {"chassis.side", {}}};
        robot.device("TouchSensor", "touch").texts = {{"Geom", {"chassis.bumper", "chassis.side"}}};
        QCOMPARE(robot.setup(), std::string());
        robot.tick();
        QCOMPARE(robot.signal("touch/pressed")[0], 0.);
        robot.contacts["chassis.side"].assign(20, contactOf(.5)); // more than the initial capacity of the sensor
        robot.contacts["chassis.bumper"] = {contactOf(2)};
        robot.tick();
        QCOMPARE(robot.signal("touch/pressed")[0], 1.);
        QCOMPARE(robot.signal("touch/force")[0], 12.);
        QCOMPARE(robot.signal("touch/count")[0], 21.);
        robot.contacts["chassis.side"].clear();
        robot.contacts["chassis.bumper"].clear();
        robot.tick();
        QCOMPARE(robot.signal("touch/pressed")[0], 0.);
        QCOMPARE(robot.signal("touch/force")[0], 0.);
    }

    void touchIgnoresLessThanMinForce() {
        BenchRobot robot(.01);
        robot.contacts = {{"chassis.bumper", {contactOf(1), contactOf(1.5)}}};
        BenchDevice& touch = robot.device("TouchSensor", "touch");
        touch.texts = {{"Geom", {"chassis.bumper"}}};
        touch.numbers = {{"MinForce", {3}}};
        QCOMPARE(robot.setup(), std::string());
        robot.tick();
        QCOMPARE(robot.signal("touch/pressed")[0], 0.);
        robot.contacts["chassis.bumper"].push_back(contactOf(.5));
        robot.tick();
        QCOMPARE(robot.signal("touch/pressed")[0], 1.);
    }
};

QTEST_APPLESS_MAIN(SensorsTest)
#include "sensors_test.moc"
