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
