// Live values of objects, read from snapshots.
#include <QtTest>

#include <cmath>
#include <numbers>

#include "run/live/live_values.h"
#include "run/number_scale.h"
#include "world/signal_plan.h"

using namespace trundle;

namespace {

Kind motorKind() {
    Kind motor;
    motor.name = "Motor";
    motor.signals = {{"current", "A", "Through the winding.", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT}};
    return motor;
}

void setSlot(SignalBlock& block, std::uint32_t at, double value) { block.slots()[at] = value; }

/// One robot with the signal layout of a world: two bodies, a hinge, a motor, and the controller's published signals.
struct Bench {
    std::shared_ptr<ExperimentSpec> experiment = std::make_shared<ExperimentSpec>();
    std::shared_ptr<SignalLayout> layout = std::make_shared<SignalLayout>();
    std::shared_ptr<Registry> registry = std::make_shared<Registry>();
    std::shared_ptr<SignalBlock> block;
    LiveSnapshot snapshot;
    std::unique_ptr<LiveObjects> objects;

    explicit Bench(const std::string& name = "robot0") {
        auto config = std::make_shared<RobotConfigSpec>();
        BodySpec chassis, wheel;
        chassis.name = "chassis";
        wheel.name = "wheel";
        GeomSpec hull;
        hull.name = "hull";
        hull.pose.position = {0.1, 0, 0};
        chassis.geoms = {hull};
        config->bodies = {chassis, wheel};
        JointSpec axle;
        axle.name = "axle";
        config->joints = {axle};
        config->devices = {{"Motor", "motor", {}, {}, {}}};
        RobotSpec robot;
        robot.name = name;
        robot.config = config;
        robot.controllers = {{{"Driver", "brain", {}, {}, {}}, {}}};
        experiment->robots = {robot};
        (void)planRobot(*layout, experiment->robots[0]);
        layout->add("motor/voltage", "V", SignalType::Real, SignalDirection::Command);
        layout->add("motor/current", "A", SignalType::Real, SignalDirection::Output);
        layout->add("motor/count", "", SignalType::Integer, SignalDirection::Output);
        layout->add("motor/hot", "", SignalType::Boolean, SignalDirection::Output);
        layout->add("motor/ranges", "m", SignalType::Real, SignalDirection::Output, 360);
        layout->add("motor/six", "m", SignalType::Real, SignalDirection::Output, 6); // the most that is shown whole
        layout->add("motor/odometry", "", SignalType::Real, SignalDirection::Output, 3);
        layout->add("brain/charge", "J", SignalType::Real, SignalDirection::Output);
        if (!registry->add(motorKind())) qFatal("no kind");
        block = std::make_shared<SignalBlock>(*layout);
        for (const char* path : {"/pose", "/chassis/pose", "/wheel/pose"}) set((name + path).c_str(), 1, 3);
        snapshot.block = block;
        objects = std::make_unique<LiveObjects>(experiment, layout, registry);
    }
    void set(const char* path, double value, std::uint32_t slot = 0) {
        setSlot(*block, layout->find(path)->offset + slot, value);
    }
    /// Live values of an object as "current = 0.213 A; ...", read from a new snapshot.
    std::string read(const char* path) {
        auto next = std::make_shared<SignalBlock>(*layout);
        next->copyFrom(*block);
        snapshot.block = next;
        std::string all;
        for (const LiveValue& v : objects->read(path, snapshot))
            all += (all.empty() ? "" : "; ") + v.name + " = " + v.text() + (v.unit.empty() ? "" : " " + v.unit);
        return all;
    }
};

} // namespace

class LiveValuesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void showsWhatARobotDoesInWordsOfTheLanguage() {
        Bench b;
        b.set("robot0/pose", 1.25, 0);
        b.set("robot0/pose", -0.5, 1);
        b.set("robot0/pose", std::sqrt(0.5), 3);
        b.set("robot0/pose", std::sqrt(0.5), 6); // a quarter turn to the left
        b.set("robot0/velocity", 0.3, 0);
        b.set("robot0/velocity", 0.4, 1);
        b.set("robot0/velocity", 2, 5);
        b.set("robot0/brain/charge", 1500);
        QCOMPARE(b.read("robot0"), std::string("position = 1.250, -0.500, 0.000 m; HPR = 90.00, 0.00, 0.00 °; speed = 0.500 m/s; "
                                               "velocity = 0.300, 0.400, 0.000 m/s; angular rate = 0.000, 0.000, 2.000 rad/s; "
                                               "charge = 1500 J"));
    }

    /// A member of a Repeat in the world has a name of several words.
    void aMemberOfARepeatIsFoundByItsName() {
        Bench b("row_3.cart");
        b.set("row_3.cart/pose", 1.25, 0);
        b.set("row_3.cart/motor/current", 0.5);
        QVERIFY(b.read("row_3.cart").starts_with("position = 1.250, 0.000, 0.000 m"));
        QVERIFY(b.read("row_3.cart.motor").find("current = 0.500 A") != std::string::npos);
        QVERIFY(b.read("row_3.cart.chassis.hull").starts_with("position = 0.100, 0.000, 0.000 m"));
        QVERIFY(b.read("row_3").empty() && b.read("row_2.cart").empty());
    }

    /// What is between robots has its signals below its own name, of several words in a Repeat in the world.
    void whatIsBetweenRobotsIsFoundByItsName() {
        Bench b;
        Kind region;
        region.name = "Region";
        region.signals = {{"count", "", "How many are inside.", TRUNDLE_INTEGER_SIGNAL, 1, TRUNDLE_OUTPUT}};
        QVERIFY(b.registry->add(region));
        for (const char* name : {"goal", "lane_1.goal"}) {
            b.experiment->regions.emplace_back().name = name;
            b.layout->beginRobot(name);
            b.layout->add("count", "", SignalType::Integer, SignalDirection::Output);
        }
        b.layout->beginRobot("lane_1.hitch");
        b.layout->add("position", "rad", SignalType::Real, SignalDirection::Output);
        b.block = std::make_shared<SignalBlock>(*b.layout);
        b.set("goal/count", 1);
        b.set("lane_1.goal/count", 2);
        b.set("lane_1.hitch/position", std::numbers::pi);
        QCOMPARE(b.read("goal"), std::string("count = 1"));
        QCOMPARE(b.read("lane_1.goal"), std::string("count = 2"));
        QCOMPARE(b.objects->read("lane_1.goal", b.snapshot)[0].help, std::string("How many are inside."));
        QCOMPARE(b.read("lane_1.hitch"), std::string("position = 180.0 °"));
        QVERIFY(b.read("lane_1").empty() && b.read("lane_2.goal").empty() && b.read("goal.x").empty());
    }

    void aGeomIsWhereItsBodyCarriesIt() {
        Bench b;
        b.set("robot0/chassis/pose", 1, 0);
        b.set("robot0/chassis/pose", std::sqrt(0.5), 3);
        b.set("robot0/chassis/pose", std::sqrt(0.5), 6);
        b.set("robot0/chassis/velocity", 2, 5); // turns on the spot: the geom, 10 cm off, goes sideways
        const std::string hull = b.read("robot0.chassis.hull");
        QVERIFY2(hull.starts_with("position = 1.000, 0.100, 0.000 m"), hull.c_str());
        // The robot faces +y, the geom is 10 cm ahead of it and goes to -x.
        QVERIFY2(hull.find("speed = 0.200 m/s; velocity = -0.200, 0.000, 0.000 m/s") != std::string::npos, hull.c_str());
        QVERIFY(b.read("robot0.chassis").starts_with("position = 1.000, 0.000, 0.000 m"));
        QVERIFY(b.read("robot0.chassis").find("speed = 0.000 m/s") != std::string::npos);
    }

    /// The prefix at the edges of each range, by the largest magnitude, whatever its sign; lengths and angles have none.
    void prefixes_data() {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("shown");
        const auto row = [](const char* unit, double value, const char* shown) {
            QTest::addRow("%g %s", value, unit) << unit << value << shown;
        };
        row("V", 0.0999, "99.90 mV");
        row("V", 0.1, "0.100 V");
        row("V", -0.5, "-0.500 V");
        row("A", 9999, "9999 A");
        row("N m", 10000, "10.00 kN m");
        row("W", -123456, "-123.5 kW");
        row("J", 1e6, "1.000 MJ");
        row("m", 0.05, "0.050 m");
        row("m", 12345.678, "12345.678 m");
        row("rad", 0.001, "0.057 °");
        row("", 0.05, "0.050 ");
    }
    void prefixes() {
        QFETCH(QString, unit);
        QFETCH(double, value);
        QFETCH(QString, shown);
        NumberScale scale(unit.toStdString());
        scale.note(value);
        QCOMPARE(QString::fromStdString(scale.text(value) + " " + scale.unit()), shown);
        scale.note(value / 1000); // never back
        QCOMPARE(QString::fromStdString(scale.text(value) + " " + scale.unit()), shown);
    }

    void jointsDevicesAndControllersShowTheirSignals() {
        Bench b;
        b.set("robot0/axle/position", std::numbers::pi);
        b.set("robot0/axle/rate", -1.5);
        QCOMPARE(b.read("robot0.axle"), std::string("position = 180.0 °; rate = -1.500 rad/s"));
        b.set("robot0/motor/voltage", 6);
        b.set("robot0/motor/current", 0.0123456);
        b.set("robot0/motor/count", 123456789);
        b.set("robot0/motor/hot", 1);
        b.set("robot0/motor/ranges", 2.5, 3);
        b.set("robot0/motor/ranges", -0.5, 7);
        b.set("robot0/motor/odometry", std::numbers::pi / 2, 2);
        QCOMPARE(
            b.read("robot0.motor"),
            std::string("voltage = 6.000 V; current = 12.35 mA; count = 123456789; hot = true; ranges least, greatest = -0.500, "
                        "2.500 m; six = 0.000, 0.000, 0.000, 0.000, 0.000, 0.000 m; odometry x, y = 0.000, "
                        "0.000 m; odometry heading = 90.00 °"));
        const auto& values = b.objects->read("robot0.motor", b.snapshot);
        QVERIFY(values[0].commanded && !values[1].commanded);
        QCOMPARE(values[1].signal, std::string("robot0/motor/current"));
        QCOMPARE(values[1].help, std::string("Through the winding."));
        QCOMPARE(b.read("robot0.brain"), std::string("charge = 0.000 J"));
    }

    void digitsStayWhereTheyAre() {
        Bench b;
        b.set("robot0/motor/current", 1.5);
        (void)b.read("robot0.motor");
        for (const auto& [amperes, shown] : {std::pair(0.0123, "0.012"), {-0.5, "-0.500"}, {-1e-9, "0.000"}, {0.0, "0.000"}}) {
            b.set("robot0/motor/current", amperes);
            (void)b.read("robot0.motor");
            const LiveValue& current = b.objects->read("robot0.motor", b.snapshot)[1];
            QCOMPARE(current.text(), std::string(shown));
            QCOMPARE(current.unit, std::string("A"));
        }
        b.set("robot0/motor/current", 12345);
        QVERIFY(b.read("robot0.motor").find("current = 12.35 kA") != std::string::npos);
        b.set("robot0/motor/current", std::nan(""));
        QVERIFY(b.read("robot0.motor").find("current = not a number kA") != std::string::npos);
    }

    void theRunItselfHasItsFigures() {
        Bench b;
        b.snapshot.time = 1.5;
        b.snapshot.tick = 150;
        b.snapshot.contactCount = 7;
        b.snapshot.stepMs = 0.25;
        b.snapshot.realTimeFactor = 12;
        QCOMPARE(b.read(""), std::string("time = 1.500 s; ticks = 150; contacts = 7; real-time factor = 12.00; time per tick = "
                                         "0.250 ms"));
    }

    void objectsOutsideRunHaveNoValues() {
        Bench b;
        for (const char* path :
             {"robot1", "robot0.nothing", "robot0.chassis.nothing", "robot0.motor.x", "RobotConfig.Rover.motor", "."})
            QCOMPARE(b.read(path), std::string());
    }
};

QTEST_GUILESS_MAIN(LiveValuesTest)
#include "live_values_test.moc"
