// Signals described with a member: one table for the device, the C table and the port of a controller.
#include <QtTest>

#include <trundle/controller.h>
#include <trundle/device.h>

#include "sdk/host.h"

using namespace trundle;
using sdktest::Host;

namespace {

struct WinchSignals {
    static constexpr const char* kKind = "Winch";
    CommandSlot<double> speed;
    CommandSlot<bool> brake;
    OutputSlot<double> tension;
    OutputSlot<std::array<int, 2>> turns;
    TruthSlot<std::array<double, 3>> hook;

    template <class D> static void describe(D& d) {
        using S = WinchSignals;
        d.command("speed", &S::speed, "m/s", "Of the rope.");
        d.output("tension", &S::tension, "N", "Of the rope.");
        d.truth("hook", &S::hook, "m", "Where it hangs.");
        d.command("brake", &S::brake, "", "Holds it.");
        d.output("turns", &S::turns, "", "Of both drums.");
    }
};

struct Winch final : Device, WinchSignals {
    double length = 2;

    static void describe(Describe<Winch>& d) {
        d.field("Length", &Winch::length, metres(), "");
        WinchSignals::describe(d);
    }
    void setup(Mount&) override { hook.set(2, -length); } // already bound
    void act(Actuation& world) override { tension.set(brake.read(world) != 0 ? 0 : 10 * speed.read(world)); }
    void sense(Sensing&) override { turns.set(1, turns.get(1) + 1); }
};

/// A device that commands another one.
struct Crane final : Device {
    Port<WinchSignals> winch;
    static void describe(Describe<Crane>&) {}
    void setup(Mount& mount) override { winch = mount.peer<WinchSignals>("winch"); }
    void act(Actuation&) override { winch.set(&WinchSignals::speed, winch.get(&WinchSignals::tension) + 1); }
};

struct Driver final : Controller {
    Port<WinchSignals> winch;
    OutputSlot<double> lifted;
    OutputSlot<std::array<bool, 2>> lights;
    Slot plain;

    static void describe(Describe<Driver>& d) {
        d.output("lifted", &Driver::lifted, "m", "So far.");
        d.output("plain", "", "Described without a member.");
        d.output("lights", &Driver::lights, "", "Both.");
    }
    void setup(RobotPorts& robot) override {
        winch = robot.port<WinchSignals>(std::string("winch"));
        lifted.set(0.5); // already published
        plain = robot.publish("plain");
    }
    void update(Seconds) override {
        winch.set(&WinchSignals::speed, 0.25);
        winch.set(&WinchSignals::brake, true);
        lifted.set(winch.get(&WinchSignals::tension) + winch.get(&WinchSignals::turns, 1) + winch.get(&WinchSignals::speed));
    }
};

/// A signal of as many numbers as two fields say.
struct Comb final : Device {
    int teeth = 3;
    int sides = 2;
    OutputSlot<std::vector<double>> bent;
    static void describe(Describe<Comb>& d) {
        d.field("Teeth", &Comb::teeth, number().within(1, 100), "");
        d.field("Sides", &Comb::sides, number().within(1, 2), "");
        d.output("bent", &Comb::bent, "m", "Each tooth.", {"Teeth", "Sides"});
    }
    void setup(Mount&) override {}
};

std::string rows(const TrundleKind& kind) {
    std::string text;
    for (std::uint32_t i = 0; i < kind.signalCount; ++i) {
        const TrundleSignal& s = kind.signals[i];
        text += std::string(s.name) + " [" + s.unit + "] " + s.help + " type " + std::to_string(s.type) + " count " +
                std::to_string(s.count) + " direction " + std::to_string(s.direction) + "\n";
    }
    return text;
}

template <class P, class M>
concept Settable = requires(P port, M member) {
    port.set(member, 1.0);
};
template <class P, class M>
concept Gettable = requires(P port, M member) {
    port.get(member);
};
using WinchPort = Port<WinchSignals>;
static_assert(Settable<WinchPort, decltype(&WinchSignals::speed)> && Gettable<WinchPort, decltype(&WinchSignals::speed)>);
static_assert(!Settable<WinchPort, decltype(&WinchSignals::tension)> && Gettable<WinchPort, decltype(&WinchSignals::tension)>);
static_assert(!Settable<WinchPort, decltype(&WinchSignals::hook)> && !Gettable<WinchPort, decltype(&WinchSignals::hook)>);

/// A device host: slots of the host in memory, and warnings.
TrundleMount mountOf(Host& host) {
    TrundleMount mount{};
    mount.size = sizeof mount;
    mount.context = &host;
    mount.path = "robot7/winch";
    mount.signal = [](void* c, const char* name) { return Host::of(c).find(std::string("winch/") + name); };
    mount.peerSignal = [](void* c, const char* kind, const char* device, const char* signal) {
        return std::string(kind) == "Winch" ? Host::of(c).find(std::string(device) + "/" + signal) : nullptr;
    };
    return mount;
}

TrundleServices servicesOf(Host& host) {
    TrundleServices services{};
    services.size = sizeof services;
    services.context = &host;
    services.print = [](void* c, std::int32_t, const char* text) { Host::of(c).record(text); };
    return services;
}

void addWinch(Host& host) {
    host.slots = {{"winch/speed", {0}},      {"winch/brake", {0}},     {"winch/tension", {0}},  {"winch/turns", {0, 0}},
                  {"winch/hook", {0, 0, 0}}, {"brain/lifted", {0, 0}}, {"brain/plain", {0, 0}}, {"brain/lights", {0, 0}}};
    host.directions = {{"winch/speed", TRUNDLE_COMMAND},
                       {"winch/brake", TRUNDLE_COMMAND},
                       {"winch/tension", TRUNDLE_OUTPUT},
                       {"winch/turns", TRUNDLE_OUTPUT}};
}

} // namespace

class SignalsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSignalIsCountedByFields() {
        const auto table = deviceTable<Comb>("Comb");
        QCOMPARE(table->kind.signals[0].count, 1u);
        QCOMPARE(table->kind.signals[0].countFields, 1u | 2u << 16);
        Comb comb;
        const Describe<Comb>& d = descriptionOf<Comb>();
        QCOMPARE(d.countOf(d.signals()[0], comb), 6u);
        comb.teeth = 40;
        comb.sides = 1;
        QCOMPARE(d.countOf(d.signals()[0], comb), 40u);
    }

    /// Type and count come from the member; the order is that of describe().
    void theCTableIsMadeFromTheMembers() {
        const auto row = [](const char* start, int type, int count, int direction) {
            return std::string(start) + " type " + std::to_string(type) + " count " + std::to_string(count) + " direction " +
                   std::to_string(direction) + "\n";
        };
        QCOMPARE(rows(deviceTable<Winch>("Winch")->kind),
                 row("speed [m/s] Of the rope.", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_COMMAND) +
                     row("tension [N] Of the rope.", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT) +
                     row("hook [m] Where it hangs.", TRUNDLE_REAL_SIGNAL, 3, TRUNDLE_TRUTH) +
                     row("brake [] Holds it.", TRUNDLE_BOOLEAN_SIGNAL, 1, TRUNDLE_COMMAND) +
                     row("turns [] Of both drums.", TRUNDLE_INTEGER_SIGNAL, 2, TRUNDLE_OUTPUT));
        QCOMPARE(rows(controllerTable<Driver>("Driver")->kind),
                 row("lifted [m] So far.", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT) +
                     row("plain [] Described without a member.", TRUNDLE_REAL_SIGNAL, 1, TRUNDLE_OUTPUT) +
                     row("lights [] Both.", TRUNDLE_BOOLEAN_SIGNAL, 2, TRUNDLE_OUTPUT));
    }

    /// The members are bound before setup, in each object to its own slots.
    void aDeviceUsesItsMembersFromSetupOn() {
        const auto table = deviceTable<Winch>("Winch");
        Host hosts[2];
        void* winches[2];
        for (int i = 0; i < 2; ++i) {
            addWinch(hosts[i]);
            const TrundleMount mount = mountOf(hosts[i]);
            winches[i] = table->kind.create();
            QCOMPARE(table->kind.setupDevice(winches[i], &mount), 0);
            QCOMPARE(hosts[i].slots["winch/hook"][2], -2.0);
        }
        hosts[0].slots["winch/speed"][0] = 0.5;
        hosts[1].slots["winch/speed"][0] = 3;
        hosts[1].slots["winch/brake"][0] = 1;
        for (int i = 0; i < 2; ++i) {
            const TrundleServices services = servicesOf(hosts[i]);
            QCOMPARE(table->kind.act(winches[i], &services), 0);
            QCOMPARE(table->kind.sense(winches[i], &services), 0);
            table->kind.destroy(winches[i]);
        }
        QCOMPARE(hosts[0].slots["winch/tension"][0], 5.0);
        QCOMPARE(hosts[1].slots["winch/tension"][0], 0.0);
        QVERIFY(hosts[0].slots["winch/turns"][0] == 0 && hosts[0].slots["winch/turns"][1] == 1);
    }

    void aCommandThatIsNoNumberCountsAsZeroAndIsReportedOnce() {
        const auto table = deviceTable<Winch>("Winch");
        Host host;
        addWinch(host);
        const TrundleMount mount = mountOf(host);
        const TrundleServices services = servicesOf(host);
        void* winch = table->kind.create();
        QCOMPARE(table->kind.setupDevice(winch, &mount), 0);
        host.slots["winch/speed"][0] = std::numeric_limits<double>::quiet_NaN();
        host.slots["winch/tension"][0] = 7;
        for (int i = 0; i < 3; ++i) QCOMPARE(table->kind.act(winch, &services), 0);
        table->kind.destroy(winch);
        QCOMPARE(host.slots["winch/tension"][0], 0.0);
        QCOMPARE(host.calls, std::vector<std::string>{"speed was given a value that is no finite number; it counts as 0"});
    }

    void aControllerHoldsThePortOfTheSameTable() {
        const auto table = controllerTable<Driver>("Driver");
        Host host;
        addWinch(host);
        host.slots["winch/tension"] = {40};
        host.slots["winch/turns"] = {1, 2};
        void* driver = table->kind.create();
        QCOMPARE(table->kind.setupController(driver, &host.robot), 0);
        QCOMPARE(host.slots["brain/lifted"][0], 0.5);
        QCOMPARE(table->kind.update(driver, 0), 0);
        table->kind.destroy(driver);
        QVERIFY(host.slots["winch/speed"][0] == 0.25 && host.slots["winch/brake"][0] == 1);
        QCOMPARE(host.slots["brain/lifted"][0], 42.25);
        QVERIFY(host.slots["winch/tension"][0] == 40 && host.slots["winch/hook"][2] == 0);
    }

    void aDeviceHoldsThePortOfAnotherDevice() {
        const auto table = deviceTable<Crane>("Crane");
        Host host;
        addWinch(host);
        host.slots["winch/tension"] = {6};
        const TrundleMount mount = mountOf(host);
        const TrundleServices services = servicesOf(host);
        void* crane = table->kind.create();
        QCOMPARE(table->kind.setupDevice(crane, &mount), 0);
        QCOMPARE(table->kind.act(crane, &services), 0);
        table->kind.destroy(crane);
        QCOMPARE(host.slots["winch/speed"][0], 7.0);
        Host empty;
        const TrundleMount nothing = mountOf(empty);
        crane = table->kind.create();
        QVERIFY(table->kind.setupDevice(crane, &nothing) != 0);
        QCOMPARE(std::string(table->kind.lastError(crane)), std::string("there is no Winch 'winch' with a signal 'speed'"));
        table->kind.destroy(crane);
    }

    /// The device's module was built with another table: nothing is read beyond its end, no output is written.
    void aPortOfAnotherTableIsRefused_data() {
        QTest::addColumn<QString>("signal");
        QTest::addColumn<int>("count");
        QTest::addColumn<uint>("direction");
        QTest::newRow("fewer numbers") << "turns" << 1 << uint(TRUNDLE_OUTPUT);
        QTest::newRow("more numbers") << "tension" << 2 << uint(TRUNDLE_OUTPUT);
        QTest::newRow("an output") << "speed" << 1 << uint(TRUNDLE_OUTPUT);
    }
    void aPortOfAnotherTableIsRefused() {
        QFETCH(const QString, signal);
        QFETCH(const int, count);
        QFETCH(const uint, direction);
        Host host;
        addWinch(host);
        const std::string name = signal.toStdString();
        host.slots["winch/" + name] = std::vector<double>(static_cast<std::size_t>(count));
        host.directions["winch/" + name] = direction;
        RobotPorts robot(host.robot);
        const Port<WinchSignals> port = robot.port<WinchSignals>("winch");
        QVERIFY(!port.bound() && !robot.complete());
        QCOMPARE(host.calls, std::vector<std::string>{"fail the signal '" + name +
                                                      "' of 'winch' has another count or direction than the table Winch that the "
                                                      "controller was compiled with; build both modules with the same table"});
    }
};

QTEST_APPLESS_MAIN(SignalsTest)
#include "signals_test.moc"
