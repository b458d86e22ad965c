// Well-behaved controllers for the tests of modules.
#include <limits>
#include <stdexcept>
#include <vector>

#include <trundle/controller.h>
#include <trundle/device.h>

namespace {

/// Drives forward and prints its sensor values.
struct Driver : trundle::Controller {
    double speed = 0.2;
    std::string text = "hello";
    std::optional<double> maybe;
    std::array<double, 2> pair{1, 2};
    bool loud = false;

    static void describe(trundle::Describe<Driver>& d) {
        d.help("Goes forward.");
        d.field("Speed", &Driver::speed, trundle::metresPerSecond().within(0, 2), "Cruising speed.");
        d.field("Text", &Driver::text, trundle::text(), "What it says.");
        d.field("Angle", &Driver::maybe, trundle::degrees().above(-90).below(90), "Nothing.");
        d.field("Pair", &Driver::pair, trundle::number(), "Two numbers.");
        d.field("Loud", &Driver::loud, trundle::flag(), "Says it.");
    }
    void setup(trundle::RobotPorts& robot) override {
        drive = robot.differentialDrive("base");
        touch = robot.touch("frontTouch");
        encoder = robot.encoder("leftEncoder");
        odometry = robot.signal("base", "odometry");
        hasRear = robot.has("rearTouch");
    }
    void update(trundle::Seconds sinceLast) override {
        drive.move(touch.pressed() ? 0 : speed, 0);
        odometry.set(0, 99); // an output: not written
        odometry.set(7, 99); // beyond its end
        if (loud) {
            print(text, " t=", time().value, " dt=", sinceLast.value, " n=", encoder.count(), " rear=", hasRear,
                  " pair=", pair[0] + pair[1]);
            warn("random ", randomBits(), " ", randomBits());
            auto log = openLog("own.txt");
            log.write("line\n");
        }
    }
    trundle::DifferentialDrivePort drive;
    trundle::TouchPort touch;
    trundle::EncoderPort encoder;
    trundle::SignalPort odometry;
    bool hasRear = true;
};

/// Fails in the phase that its property names.
struct Failing : trundle::Controller {
    std::string where;
    static void describe(trundle::Describe<Failing>& d) { d.field("Where", &Failing::where, trundle::text(), "Where it fails."); }
    void setup(trundle::RobotPorts& robot) override {
        if (where == "setup") throw std::runtime_error("no battery");
        if (where == "device") drive = robot.differentialDrive("bas");
        if (where == "kind") drive = robot.differentialDrive("frontTouch");
        if (where == "signal") (void)robot.signal("base", "speed");
        if (where == "truth") (void)robot.signal("base", "pose");
        if (where == "groundTruth") truth = robot.groundTruth("base/pos");
    }
    void update(trundle::Seconds) override {
        if (where == "update") throw 42;
        if (where == "give up") fail("the map is empty");
    }
    trundle::DifferentialDrivePort drive;
    trundle::SignalPort truth;
};

struct Cheating : trundle::Controller {
    static void describe(trundle::Describe<Cheating>& d) { d.help("Knows where it is."); }
    void setup(trundle::RobotPorts& robot) override {
        truth = robot.groundTruth();
        axle = robot.groundTruth("base/pose");
    }
    void update(trundle::Seconds) override {
        const auto pose = truth.pose();
        print(pose.position.x(), " ", pose.rotation.w(), " ", truth.angularVelocity().z(), " ", axle.get(2));
    }
    trundle::GroundTruthPort truth;
    trundle::SignalPort axle;
};

/// Captures an image and prints whether the next capture would give a new one.
struct Watcher : trundle::Controller {
    static void describe(trundle::Describe<Watcher>& d) { d.help("Looks twice."); }
    void setup(trundle::RobotPorts& robot) override {
        for (const char* name : {"still", "stream"}) eyes.push_back(robot.camera(name));
        print(trundle::CameraPort().capture().error());
    }
    void update(trundle::Seconds) override {
        for (trundle::CameraPort& eye : eyes) {
            const bool before = eye.fresh();
            const bool taken(eye.capture());
            print(taken, " ", before, " ", eye.fresh());
        }
    }
    std::vector<trundle::CameraPort> eyes;
};

/// A device in the same module as controllers.
struct Thermometer : trundle::Device {
    double offset = 0;
    std::optional<double> perDegree, degreesPer;
    static void describe(trundle::Describe<Thermometer>& d) {
        d.field("Offset", &Thermometer::offset, trundle::number(), "Degrees.");
        d.field("PerDegree", &Thermometer::perDegree, trundle::number(), "Volts per degree.");
        d.field("DegreesPer", &Thermometer::degreesPer, trundle::number(), "Degrees per volt.");
        d.exactlyOneOf("PerDegree|DegreesPer", "Offset");
        d.output("temperature", "", "Degrees.");
    }
    void setup(trundle::Mount& mount) override { out = mount.signal("temperature"); }
    void sense(trundle::Sensing&) override { out.set(20 + offset); }
    trundle::Slot out;
};

} // namespace

TRUNDLE_MODULE(registry) {
    registry.controller<Driver>("Driver");
    registry.controller<Failing>("Failing");
    registry.controller<Cheating>("Cheating");
    registry.controller<Watcher>("Watcher");
    registry.device<Thermometer>("Thermometer");
}
