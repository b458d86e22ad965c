// The SDK's classes as a module uses them, on a host in memory.
#include <QtTest>

#include <trundle/controller.h>
#include <trundle/device.h>

#include "sdk/host.h"

using namespace trundle;
using sdktest::Host;

namespace {

struct Everything : Controller {
    double number = 1.5;
    int whole = 3;
    bool on = true;
    std::string word = "slow", name;
    std::array<double, 3> triple{1, 2, 3};
    std::vector<double> list{4, 5};
    std::vector<std::string> names{"a", "b"};
    std::optional<double> maybe, other;
    Slot reach;

    static void describe(Describe<Everything>& d) {
        d.help("Uses everything.");
        d.field("Number", &Everything::number, degrees().above(-1).below(90).live(), "An angle.");
        d.field("Whole", &Everything::whole, trundle::number().within(0, 9), "");
        d.field("On", &Everything::on, flag(), "");
        d.field("Word", &Everything::word, oneOf("slow|fast"), "");
        d.field("Name", &Everything::name, reference("Hinge|Slider").required(), "");
        d.field("Triple", &Everything::triple, metres(), "");
        d.field("List", &Everything::list, milliseconds().counted(1, 4), "");
        d.field("Names", &Everything::names, text(), "");
        d.field("Maybe", &Everything::maybe, volts().atLeast(0), "");
        d.field("Other", &Everything::other, volts().atMost(0), "");
        d.exactlyOneOf("Maybe|Other", "Number");
        d.output("reach", "m", "", 2).truth("real", "m", "").command("asked", "m", "", 1, TRUNDLE_BOOLEAN_SIGNAL);
    }
    void setup(RobotPorts& robot) override {
        if (word == "throw") throw std::runtime_error("no battery");
        if (word == "missing") (void)robot.motor("nothing");
        reach = robot.publish("reach");
    }
    void update(Seconds sinceLast) override {
        reach.set(1, sinceLast);
        print("at ", time(), " ", whole);
        warn("w");
        Log log = openLog("a.csv"), refused = openLog("no.csv");
        log.write("row\n");
        refused.write("lost");
        if (log.open() && !refused.open()) finish("done " + std::to_string(random(2, 6)));
        if (word == "odd") throw 7;
        if (word == "fail") fail("stuck");
    }
};

struct Counts : Device {
    std::uint8_t byte = 1;
    unsigned whole = 2;
    std::int16_t few = 3;
    int any = 4;
    static void describe(Describe<Counts>& d) {
        d.field("Byte", &Counts::byte, trundle::number(), "");
        d.field("Whole", &Counts::whole, trundle::number().atMost(9), "");
        d.field("Few", &Counts::few, trundle::number().within(-5, 1e6), "");
        d.field("Any", &Counts::any, trundle::number(), "");
    }
    void setup(Mount&) override {}
};

/// A device that uses every service; what it saw is in `seen`.
struct Probe : Device {
    std::vector<double> seen;
    std::string joint = "j";
    JointId id;
    BodyId body;
    GeomId geom;
    RadioId radio;
    static void describe(Describe<Probe>& d) { d.field("Joint", &Probe::joint, text(), ""); }
    void setup(Mount& m) override {
        id = m.joint(joint);
        body = m.body("b");
        geom = m.geom("b.g");
        TrundleRadioSettings settings{};
        radio = m.radio(settings);
        m.signal("out").set(m.peerNumber("motor", "Gear", 7) + m.peerNumber("motor", "None", 0.5));
        m.peer("RotaryMotor", "motor", "voltage").set(m.tick());
        m.addAxialInertia(id, 0.25);
        m.addRotor(id, 0.5, 3);
        m.warn(m.path() + " " + m.peerText("motor", "Joint") + m.peerText("motor", "None"));
    }
    void act(Actuation& w) override {
        w.motorRow(id, 1, 2, 3);
        w.jointTorque(id, 4);
        w.bodyForce(body, {1, 2, 3}, {4, 5, 6});
        w.surfaceVelocity(geom, {7, 8, 9});
    }
};

std::vector<std::string> g_calls; ///< of the device's host, which has static functions only

void recordCall(std::string call) { g_calls.push_back(std::move(call)); }
std::string three(const double v[3]) { return Host::text(v[0]) + "," + Host::text(v[1]) + "," + Host::text(v[2]); }

} // namespace

class SdkTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyHeaderIsCompiledAlone() {
        QStringList listed = QStringLiteral(SDK_HEADERS).split(','), there;
        for (const QString& name : QDir(QStringLiteral(TRUNDLE_SOURCE_DIR "/core/sdk/include/trundle")).entryList({"*.h"}))
            there << name.chopped(2);
        listed.sort();
        QCOMPARE(listed, there);
    }

    void quantities() {
        struct {
            Quantity q;
            const char* unit;
            double scale;
        } const units[] = {{number(), "", 1},
                           {metres(), "m", 1},
                           {kilograms(), "kg", 1},
                           {seconds(), "s", 1},
                           {milliseconds(), "ms", 1e-3},
                           {degrees(), "deg", std::numbers::pi / 180},
                           {newtons(), "N", 1},
                           {newtonMetres(), "Nm", 1},
                           {metresPerSecond(), "m/s", 1},
                           {metresPerSecondSquared(), "m/s^2", 1},
                           {radiansPerSecond(), "rad/s", 1},
                           {radiansPerSecondSquared(), "rad/s^2", 1},
                           {volts(), "V", 1},
                           {amperes(), "A", 1},
                           {ohms(), "ohm", 1},
                           {hertz(), "Hz", 1},
                           {decibels(), "dB", 1},
                           {decibelMilliwatts(), "dBm", 1},
                           {flag(), "", 1},
                           {text(), "", 1}};
        for (const auto& u : units) {
            QCOMPARE(u.q.unit, u.unit);
            QCOMPARE(u.q.scale, u.scale);
            QVERIFY(u.q.minimum == -HUGE_VAL && u.q.maximum == HUGE_VAL && u.q.flags == 0);
        }
        const Quantity q = unitOf("x", 2).above(1).below(3).required().live().counted(2, 4);
        QVERIFY(q.minimum == 1 && q.maximum == 3 && q.minCount == 2 && q.maxCount == 4 && q.scale == 2);
        QCOMPARE(q.flags, unsigned(TRUNDLE_MIN_EXCLUSIVE | TRUNDLE_MAX_EXCLUSIVE | TRUNDLE_REQUIRED | TRUNDLE_LIVE));
        QVERIFY(metres().within(-1, 2).minimum == -1 && metres().within(-1, 2).maximum == 2 && metres().within(-1, 2).flags == 0);
        QVERIFY(oneOf("a|b").type == TRUNDLE_CHOICE && file("png").type == TRUNDLE_FILE &&
                reference("Body").type == TRUNDLE_REFERENCE);
    }

    void slots_() {
        double numbers[3] = {1, std::nan(""), 3};
        Slot slot(numbers, 3), none(nullptr, 3);
        slot.set(2, 30);
        slot.set(3, 40); // beyond
        slot.set(10);
        QVERIFY(slot.bound() && slot.count() == 3 && numbers[0] == 10 && numbers[2] == 30 && slot.get(3) == 0);
        QVERIFY(slot.finite() == 10 && Slot(numbers + 1).finite() == 0);
        none.set(1);
        QVERIFY(!none.bound() && none.count() == 0 && none.get() == 0);
    }

    /// HPR there and back, at and between the quarter turns; poses compose as their matrices do.
    void geometry() {
        for (const double h : {-170., -90., 0., 35., 180.})
            for (const double p : {-90., -60., 0., 89., 90.})
                for (const double r : {-90., 0., 20., 135.}) {
                    const Vec3 hpr = Vec3(h, p, r) * (std::numbers::pi / 180);
                    const Quat q = rotationFromHpr(hpr), again = rotationFromHpr(hprFromRotation(q));
                    QVERIFY(q.angularDistance(again) < 1e-7);
                    const Mat3 m = (Eigen::AngleAxisd(hpr[0], Vec3::UnitZ()) * Eigen::AngleAxisd(hpr[1], Vec3::UnitY()) *
                                    Eigen::AngleAxisd(hpr[2], Vec3::UnitX()))
                                       .toRotationMatrix();
                    QVERIFY((q.toRotationMatrix() - m).norm() < 1e-12);
                    if (std::abs(p) < 89.5) QVERIFY((hprFromRotation(q) - hpr).norm() < 1e-9 || h == 180);
                }
        QCOMPARE(rotationFromHpr({std::numbers::pi, 0, 0}) * Vec3(1, 0, 0), Vec3(-1, 0, 0)); // exact
        const Pose a{{1, 2, 3}, rotationFromHpr({0.3, -0.5, 0.7})}, b{{-4, 0.5, 2}, rotationFromHpr({-1, 0.2, 0.1})};
        const Vec3 point(0.1, -0.2, 0.3);
        QVERIFY(((a * b) * point - a * (b * point)).norm() < 1e-12);
        QVERIFY((a.inverse() * (a * point) - point).norm() < 1e-12);
    }

    /// Limits of the kind, or of what the member's type can hold.
    void integersAreWithinTheirType() {
        const auto table = deviceTable<Counts>("Counts");
        const double limits[][2] = {{0, 255}, {0, 9}, {-5, 32767}, {-HUGE_VAL, HUGE_VAL}};
        QCOMPARE(table->kind.fieldCount, 4u);
        for (std::uint32_t i = 0; i < 4; ++i) {
            QCOMPARE(table->kind.fields[i].minimum, limits[i][0]);
            QCOMPARE(table->kind.fields[i].maximum, limits[i][1]);
        }
    }

    void tablesOfAKind() {
        ModuleRegistry registry;
        registry.controller<Everything>("Everything");
        registry.device<Probe>("Probe");
        const TrundleModule* module = registry.module();
        QVERIFY(module->magic == TRUNDLE_MAGIC && module->kindCount == 2 && module->abiMinor == TRUNDLE_ABI_MINOR);
        const TrundleKind& kind = *module->kinds[0];
        QCOMPARE(kind.name, "Everything");
        QCOMPARE(kind.help, "Uses everything.");
        std::string types;
        for (std::uint32_t i = 0; i < kind.fieldCount; ++i) {
            const TrundleField& f = kind.fields[i];
            types += std::string(f.name) + std::to_string(f.type) + ":" + std::to_string(f.minCount) + "-" +
                     std::to_string(f.maxCount) + "/" + std::to_string(f.flags) + "=" + std::to_string(f.defaultValue.count) +
                     " ";
        }
        const auto row = [](const char* name, int type, const char* counts, int flags, int defaults) {
            return std::string(name) + std::to_string(type) + ":" + counts + "/" + std::to_string(flags) + "=" +
                   std::to_string(defaults) + " ";
        };
        QCOMPARE(types,
                 row("Number", TRUNDLE_NUMBER, "1-1", TRUNDLE_LIVE | TRUNDLE_MIN_EXCLUSIVE | TRUNDLE_MAX_EXCLUSIVE, 1) +
                     row("Whole", TRUNDLE_INTEGER, "1-1", 0, 1) + row("On", TRUNDLE_BOOLEAN, "1-1", 0, 1) +
                     row("Word", TRUNDLE_CHOICE, "1-1", 0, 1) + row("Name", TRUNDLE_REFERENCE, "1-1", TRUNDLE_REQUIRED, 0) +
                     row("Triple", TRUNDLE_NUMBER, "3-3", 0, 3) + row("List", TRUNDLE_NUMBER, "1-4", 0, 2) +
                     row("Names", TRUNDLE_TEXT, "0-100000", 0, 2) + row("Maybe", TRUNDLE_NUMBER, "1-1", TRUNDLE_OPTIONAL, 0) +
                     row("Other", TRUNDLE_NUMBER, "1-1", TRUNDLE_OPTIONAL, 0));
        QCOMPARE(kind.fields[5].defaultValue.numbers[2], 3.0);
        QCOMPARE(kind.fields[7].defaultValue.texts[1], "b");
        QVERIFY(kind.alternativesCount == 1 && std::string(kind.alternatives[0].names) == "Maybe|Other");
        QVERIFY(kind.signalCount == 3 && kind.signals[0].count == 2 && kind.signals[0].direction == TRUNDLE_OUTPUT &&
                kind.signals[1].direction == TRUNDLE_TRUTH && kind.signals[2].direction == TRUNDLE_COMMAND &&
                kind.signals[2].type == TRUNDLE_BOOLEAN_SIGNAL);
        QVERIFY(kind.setupController && kind.update && !kind.act && !kind.sense);
        const TrundleKind& device = *module->kinds[1];
        QVERIFY(device.setupDevice && device.act && !device.sense && !device.update); // sense is not overridden
    }

    void aControllerThroughItsTable() {
        const auto table = controllerTable<Everything>("Everything");
        const TrundleKind& kind = table->kind;
        const auto run = [&](const char* word, Host& host) {
            host.slots["brain/reach"] = {0, 0};
            void* one = kind.create();
            const double five = 5;
            const TrundleValue value{nullptr, &word, 1}, whole{&five, nullptr, 1};
            bool good = kind.set(one, 3, &value) == 0 && kind.set(one, 1, &whole) == 0;
            good = good && kind.set(one, 99, &value) != 0; // no such field
            good = good && kind.setupController(one, &host.robot) == 0 && kind.update(one, 0.75) == 0;
            const std::string error = kind.lastError(one);
            kind.destroy(one);
            return good ? "" : error.empty() ? "?" : error;
        };
        Host host;
        QCOMPARE(run("fast", host), std::string());
        QCOMPARE(host.slots["brain/reach"][1], 0.75);
        const std::vector<std::string> calls{"print 1 at 3.25 5", "print 2 w",     "open a.csv",
                                             "open no.csv",       "write 5 row\n", "finish done 5.000000"};
        QCOMPARE(host.calls, calls); // random() of bits 11 is 0.75
        Host bad;
        QCOMPARE(run("throw", bad), std::string("no battery"));
        QCOMPARE(run("missing", bad), std::string("a port is missing"));
        QCOMPARE(run("odd", bad), std::string("an exception that is no std::exception"));
        Host failing;
        QCOMPARE(run("fail", failing), std::string());
        QCOMPARE(failing.calls.back(), std::string("fail stuck"));
    }

    void ports() {
        Host host;
        for (const char* s :
             {"linearVelocity", "angularVelocity", "linearAmount", "angularAmount", "sequence", "done", "busy", "finished"})
            host.slots[std::string("base/") + s] = {0};
        host.slots["base/odometry"] = {1, 2, 3};
        for (const char* s :
             {"voltage", "targetRate", "servo", "current", "terminalVoltage", "torque", "rate", "saturated", "temperature"})
            host.slots[std::string("motor/") + s] = {double(s[0])};
        for (const char* s : {"count", "angle", "rate", "index", "missed"})
            host.slots[std::string("encoder/") + s] = {double(s[0])};
        for (const char* s : {"pressed", "force", "count"}) host.slots[std::string("touch/") + s] = {double(s[0])};
        host.slots["groundTruth/pose"] = {1, 2, 3, 0.5, 0.5, 0.5, 0.5};
        host.slots["groundTruth/velocity"] = {4, 5, 6, 7, 8, 9};
        host.slots["/pose"] = std::vector<double>(7); // by signalInfo without a component
        host.slots["arm/goal"] = {0, 0};
        host.slots["arm/force"] = {8};
        host.directions = {{"arm/goal", TRUNDLE_COMMAND}, {"arm/force", TRUNDLE_OUTPUT}, {"/pose", TRUNDLE_TRUTH}};
        RobotPorts robot(host.robot);
        QVERIFY(robot.name() == "robot7" && robot.tick() == 0.02 && robot.has("arm", "goal") && !robot.has("arm", "gaol"));

        DifferentialDrivePort base = robot.differentialDrive(std::string("base"));
        const auto at = [&](const char* s) { return host.slots[std::string("base/") + s][0]; };
        base.move(0.5, -1);
        QVERIFY(at("linearVelocity") == 0.5 && at("angularVelocity") == -1 && at("sequence") == 0 && base.done());
        base.drive(1, 2, 3, 4);
        QVERIFY(at("linearVelocity") == 1 && at("angularVelocity") == 2 && at("linearAmount") == 3 && at("angularAmount") == 4 &&
                at("sequence") == 1);
        QVERIFY(!base.done());
        host.slots["base/finished"] = {1};
        QVERIFY(base.done());
        base.turn(0.7, -2);
        QVERIFY(at("linearVelocity") == 0 && at("angularVelocity") == -0.7 && at("angularAmount") == -2 && at("sequence") == 2 &&
                !base.done());
        base.turn(0.7, 0); // no turn, where an amount of 0 would have no end
        QVERIFY(at("angularVelocity") == 0 && at("angularAmount") == 0 && at("sequence") == 3);
        base.move(0, 1);
        base.stop();
        QVERIFY(at("angularVelocity") == 0 && at("angularAmount") == 0);
        QVERIFY(base.odometry().x == 1 && base.odometry().y == 2 && base.odometry().heading == 3);

        MotorPort motor = robot.motor("motor");
        motor.setVoltage(6);
        QVERIFY(host.slots["motor/voltage"][0] == 6 && host.slots["motor/servo"][0] == 0);
        QVERIFY(motor.current() == 'c' && motor.torque() == 't' && motor.rate() == 'r');
        const EncoderPort encoder = robot.encoder("encoder");
        QVERIFY(encoder.count() == 'c' && encoder.angle() == 'a' && encoder.rate() == 'r' && encoder.index());
        const TouchPort touch = robot.touch("touch");
        QVERIFY(touch.pressed() && touch.force() == 'f' && touch.contacts() == 'c');
        const GroundTruthPort truth = robot.groundTruth();
        QVERIFY(truth.pose().position == Vec3(1, 2, 3) && truth.linearVelocity() == Vec3(4, 5, 6) &&
                truth.angularVelocity() == Vec3(7, 8, 9));
        QVERIFY((truth.pose() * Vec3(1, 0, 0) - Vec3(1, 3, 3)).norm() < 1e-12); // w x y z
        SignalPort goal = robot.signal("arm", "goal"), force = robot.signal("arm", "force");
        goal.set(1, 5);
        force.set(5); // an output
        QVERIFY(goal.count() == 2 && host.slots["arm/goal"][1] == 5 && force.get() == 8);
        QVERIFY(robot.groundTruth("pose").get(2) == 3 && robot.complete());
        QVERIFY(robot.motor("nothing").rate() == 0 && !robot.complete());
    }

    void camerasAndRadio() {
        Host host;
        host.slots = {{"eye/frame", {4}}, {"eye/time", {0}}, {"blind/frame", {0}}, {"blind/time", {0}}};
        RobotPorts robot(host.robot);
        CameraPort eye = robot.camera("eye"), blind = robot.camera("blind"), unbound;
        QVERIFY(eye.fresh());
        const Picture p = eye.capture();
        QVERIFY(p && p.width() == 3 && p.height() == 2 && p.time() == 0.5 && p.error().empty() && p.pixels().size() == 18);
        QVERIFY(!eye.fresh());
        host.slots["eye/frame"][0] = 5;
        QVERIFY(eye.fresh());
        QVERIFY((p.at(2, 1) == Colour{15, 16, 17}) && (p.at(3, 0) == Colour{}) && (p.at(-1, 0) == Colour{}));
        QVERIFY(p.depth(1, 1) == 5 && std::isinf(p.depth(0, 2)) && p.object(0, 1) == 3 && p.object(0, 2) == 0);
        QVERIFY(!blind.capture() && blind.capture().error() == "it is dark");
        QVERIFY(!unbound.capture() && !unbound.save("a.png") && !Picture());
        QVERIFY(eye.save("a.png") && !eye.save("no.png") && eye.error() == "it is dark");
        QVERIFY(eye.objectName(7) == "robot1/chassis" && eye.objectName(8).empty());

        host.calls.clear();
        RadioPort radio = robot.radio("radio"), none;
        QVERIFY(radio.bound() && radio.address() == 900 && !none.bound() && none.address() == 0 && !none.send("x"));
        QVERIFY(radio.send("hi") && radio.send(std::vector<std::uint8_t>{'o', 'k'}, -5, 12));
        QVERIFY(!radio.send(std::string(117, 'x')) && radio.send(std::string(116, 'x')));
        QCOMPARE(host.calls.at(0), std::string("send 9 hi to 65535 1000"));
        QCOMPARE(host.calls.at(1), std::string("send 9 ok to 12 -5"));
        QCOMPARE(host.calls.size(), std::size_t{3});
        QVERIFY(!radio.receive());
        host.packet = {'h', 'o'};
        const std::optional<Packet> packet = radio.receive();
        QVERIFY(packet && packet->text() == "ho" && packet->rssi == -60 && packet->lqi == 99 && packet->time == 1.5 &&
                packet->from == 3 && packet->to == 4);
        QVERIFY(robot.complete() && !robot.radio("none").bound() && !robot.complete());
    }

    void aDeviceThroughItsTable() {
        g_calls.clear();
        static double out, voltage;
        TrundleMountRadio openRadio{
            sizeof(TrundleMountRadio), 0,
            [](void*, const TrundleRadioSettings*, std::uint32_t* id) -> std::int32_t { return *id = 6, 0; }};
        TrundleMount mount{};
        mount.size = sizeof mount;
        mount.path = "r/probe";
        mount.tick = 0.03;
        mount.signal = [](void*, const char*) { return &out; };
        mount.joint = [](void*, const char* n, std::uint32_t* id) -> std::int32_t { return *n == 'j' ? *id = 1, 0 : 1; };
        mount.body = [](void*, const char*, std::uint32_t* id) -> std::int32_t { return *id = 2, 0; };
        mount.geom = [](void*, const char*, std::uint32_t* id) -> std::int32_t { return *id = 3, 0; };
        mount.peerSignal = [](void*, const char*, const char*, const char*) { return &voltage; };
        mount.peerNumber = [](void*, const char*, const char* f, double* v) -> std::int32_t {
            return *f == 'G' ? *v = 30, 0 : 1;
        };
        mount.peerText = [](void*, const char*, const char* f) { return *f == 'J' ? "axle" : nullptr; };
        mount.fail = [](void*, const char* t) { recordCall(std::string("fail ") + t); };
        mount.addAxialInertia = [](void*, std::uint32_t id, double i) -> std::int32_t {
            recordCall("inertia " + std::to_string(id) + " " + Host::text(i));
            return id == 1 ? 0 : 1;
        };
        mount.addRotor = [](void*, std::uint32_t id, double i, double ratio) -> std::int32_t {
            recordCall("rotor " + std::to_string(id) + " " + Host::text(i) + "," + Host::text(ratio));
            return id == 1 ? 0 : 1;
        };
        mount.print = [](void*, std::int32_t s, const char* t) { recordCall("print " + std::to_string(s) + " " + t); };
        mount.radio = &openRadio;
        TrundleServices services{};
        services.motorRow = [](void*, std::uint32_t j, double a, double b, double c) {
            recordCall("row " + std::to_string(j) + " " + Host::text(a) + "," + Host::text(b) + "," + Host::text(c));
        };
        services.jointTorque = [](void*, std::uint32_t j, double t) {
            recordCall("torque " + std::to_string(j) + " " + Host::text(t));
        };
        services.bodyForce = [](void*, std::uint32_t b, const double f[3], const double p[3]) {
            recordCall("force " + std::to_string(b) + " " + three(f) + " " + three(p));
        };
        services.surfaceVelocity = [](void*, std::uint32_t g, const double v[3]) {
            recordCall("belt " + std::to_string(g) + " " + three(v));
        };
        const auto table = deviceTable<Probe>("Probe");
        void* probe = table->kind.create();
        QCOMPARE(table->kind.setupDevice(probe, &mount), 0);
        QCOMPARE(out, 30.5);
        QCOMPARE(voltage, 0.03);
        QCOMPARE(table->kind.act(probe, &services), 0);
        const std::vector<std::string> calls{"inertia 1 0.25", "rotor 1 0.5,3",       "print 2 r/probe axle", "row 1 1,2,3",
                                             "torque 1 4",     "force 2 1,2,3 4,5,6", "belt 3 7,8,9"};
        QCOMPARE(g_calls, calls);
        g_calls.clear();
        mount.size = offsetof(TrundleMount, addRotor); // of an older Trundle: the child has the whole inertia
        QCOMPARE(table->kind.setupDevice(probe, &mount), 0);
        QCOMPARE(g_calls.at(1), std::string("inertia 1 4.5"));
        const char* wrong = "x";
        const TrundleValue value{nullptr, &wrong, 1};
        QCOMPARE(table->kind.set(probe, 0, &value), 0);
        QVERIFY(table->kind.setupDevice(probe, &mount) != 0);
        QCOMPARE(std::string(table->kind.lastError(probe)), std::string("there is no joint 'x'"));
        table->kind.destroy(probe);
    }

    /// More contacts than there was room for are all read.
    void contactsOfAService() {
        TrundleServices services{};
        services.contacts = [](void*, std::uint32_t geom, TrundleContact* list, std::uint32_t capacity) {
            for (std::uint32_t i = 0; i < geom && i < capacity; ++i) list[i].force = i;
            return geom;
        };
        Sensing world(services);
        std::vector<TrundleContact> found;
        for (const std::uint32_t count : {0u, 3u, 8u, 9u, 40u, 2u}) {
            world.contacts(GeomId{count}, found);
            QCOMPARE(found.size(), std::size_t(count));
            if (count) QCOMPARE(found.back().force, double(count - 1));
        }
    }
};

QTEST_APPLESS_MAIN(SdkTest)
#include "sdk_test.moc"
