// Antennas on moving bodies: on a turret that rotates on a tumbling robot, compared with the closed form.
#include <QtTest>

#include <map>
#include <random>

#include "devices/builtin.h"
#include "radio/medium.h"
#include "world/fixtures.h"

using namespace fixture;

namespace {

constexpr double kLight = 299792458.0;

const TrundleKind* code(const std::string& kind) { return kind == "Row" ? Row::kind() : findBuiltInDevice(kind); }

ResolvedValue vectorValue(const Vec3& v) { return {{PropertyType::Number, {v.x(), v.y(), v.z()}, {}}, {}, Origin::Config}; }

/// Mounting of an antenna on a robot.
struct Carrier {
    Vec3 hinge, axis, hingeToAntenna, turn; ///< in the base, but the last two in the turret; `turn` is HPR
    std::string antenna;
};

std::shared_ptr<RobotConfigSpec> carrying(const Carrier& c) {
    auto config = std::make_shared<RobotConfigSpec>();
    const Vec3 base(0.3, 0.2, 0.1), turret(0.1, 0.1, 0.1);
    config->bodies.push_back(body("base", {}, massOfBox(5, base), {box("hull", base)}));
    config->bodies.push_back(body("turret", {c.hinge, Quat::Identity()}, massOfBox(0.2, turret), {}));
    config->joints.push_back(joint("neck", JointType::Hinge, 0, 1, c.hinge, c.axis));
    config->devices.push_back(row("motor", "neck"));
    ComponentSpec radio;
    radio.kind = "Transceiver";
    radio.name = "radio";
    radio.values["Body"] = textValue("turret");
    radio.values["Pos"] = vectorValue(c.hingeToAntenna);
    radio.values["HPR"] = vectorValue(c.turn);
    radio.values["Antenna"] = textValue(c.antenna);
    config->devices.push_back(radio);
    return config;
}

/// Gain in dBi towards a direction, the antenna rotated by `r`; an independent implementation of the formulas.
double gainTowards(const std::string& antenna, const Mat3& r, const Vec3& way) {
    const Vec3 d = r.transpose() * way.normalized();
    double power = 1;
    if (antenna == "cosine") power = d.x() > 0 ? 6 * d.x() * d.x() : 0;
    if (antenna == "dipole") power = 1.6409224 * std::pow(std::cos(kPi / 2 * d.z()), 2) / std::max(1e-12, 1 - d.z() * d.z());
    if (antenna == "inverted_f") power = 1.5 * (0.7 * (1 - d.z() * d.z()) + 0.3 * (1 - d.y() * d.y()));
    return power > 0 ? std::max(-30., 10 * std::log10(power)) : -30;
}

/// The antenna's pose, computed from the base's pose and the hinge angle.
Pose antennaOf(World& world, const std::string& robot, const Carrier& c) {
    const double* p = slot(world, robot + "/base/pose");
    const Pose base{Vec3(p), Quat(p[3], p[4], p[5], p[6])};
    const Quat turned(Eigen::AngleAxisd(value(world, robot + "/motor/position"), c.axis.normalized()));
    return base * Pose{c.hinge, turned} * Pose{c.hingeToAntenna, rotationFromHpr(c.turn)};
}

} // namespace

class RadiosTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// A radio without an Address gets none that another one of the experiment has, wherever that is in the text.
    void addressesThatAreNotGivenAreFree() {
        Scene scene(0.01);
        const double given[] = {0, 1, 0, 2, 0, 7, 7, 5, 0};
        for (const double address : given) {
            const auto config = carrying({Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero(), "isotropic"});
            if (address > 0) config->devices.back().values["Address"] = numberValue(address);
            const double x = static_cast<double>(scene.spec->robots.size());
            scene.robot("r" + std::to_string(scene.spec->robots.size()), at(x, 0, 1), config);
        }
        auto world = scene.build(code);
        QVERIFY(world);
        std::map<double, int> users;
        for (std::size_t i = 0; i < std::size(given); ++i) {
            const double address = value(*world, "r" + std::to_string(i) + "/radio/address");
            QCOMPARE(given[i] > 0 ? given[i] : address, address);
            ++users[address];
        }
        QCOMPARE(users.size(), std::size(given) - 1); // two ask for 7
        QCOMPARE(users[7], 2);
        QVERIFY(!users.contains(0));
    }

    void hingedAntennasMatchTheClosedForm() {
        std::mt19937_64 random(20261122);
        const auto within = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(random); };
        const auto vector = [&](double size) { return Vec3(within(size), within(size), within(size)); };
        constexpr int kRobots = 10, kTicks = 100, kPause = 5; // 10 links x 100 moments
        const char* antennas[] = {"cosine", "dipole", "inverted_f", "isotropic"};

        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        std::vector<Carrier> carriers;
        for (int i = 0; i < kRobots; ++i) {
            carriers.push_back({vector(0.2), vector(1).normalized(), vector(0.3), vector(3), antennas[i % 4]});
            scene.robot("r" + std::to_string(i), {Vec3(4. * i, within(3), within(3)), rotationFromHpr(vector(3))},
                        carrying(carriers.back()));
        }
        Diagnostics diagnostics;
        const auto world = scene.build(code, diagnostics);
        QVERIFY2(world, diagnostics.all().empty() ? "" : diagnostics.all().front().message.c_str());
        for (int i = 0; i < kRobots; ++i) command(*world, "r" + std::to_string(i) + "/motor", within(3) + 4, 0, 5);

        const Medium& medium = *world->medium();
        double worst = 0;
        for (int moment = 0; moment < kTicks; ++moment) {
            for (int tick = 0; tick < kPause; ++tick) QVERIFY(world->tick());
            for (int i = 0; i < kRobots; ++i) {
                const int j = (i + 1 + moment % 3) % kRobots;
                const Pose from = antennaOf(*world, "r" + std::to_string(i), carriers[i]),
                           to = antennaOf(*world, "r" + std::to_string(j), carriers[j]);
                const Vec3 way = to.position - from.position;
                const double expected = gainTowards(carriers[i].antenna, from.rotation.toRotationMatrix(), way) +
                                        gainTowards(carriers[j].antenna, to.rotation.toRotationMatrix(), -way) -
                                        20 * std::log10(4 * kPi * way.norm() * 2.45e9 / kLight);
                const auto a = medium.find("r" + std::to_string(i) + "/radio"),
                           b = medium.find("r" + std::to_string(j) + "/radio");
                QVERIFY(a && b);
                const double off = std::abs(medium.link(*a, *b).power - expected);
                worst = std::max(worst, off);
                QVERIFY2(off < 0.01, qPrintable(QString("moment %1, r%2 to r%3: %4 dB").arg(moment).arg(i).arg(j).arg(off)));
            }
        }
        qInfo("1000 geometries, worst %.5f dB", worst);
        // the turrets rotated
        for (int i = 0; i < kRobots; ++i) QVERIFY(std::abs(value(*world, "r" + std::to_string(i) + "/motor/position")) > 0.5);
    }

    /// Whatever it is called: a name may begin as that of one of the two.
    void aRobotBetweenTwoOthersWeakensTheirLink() {
        const char* const cases[][3] = {{"r1", "r10", "r2"}, {"r2", "r10", "r1"}, {"r1", "q", "r2"}, {"r10", "r1", "r100"}};
        for (const auto& names : cases) {
            auto config = std::make_shared<RobotConfigSpec>();
            config->bodies.push_back(body("base", {}, massOfBox(1, {0.2, 0.3, 0.4}), {box("hull", {0.2, 0.3, 0.4})}));
            ComponentSpec radio;
            radio.kind = "Transceiver";
            radio.name = "radio";
            radio.values["Body"] = textValue("base");
            config->devices.push_back(radio);
            Scene scene;
            scene.spec->settings.gravity = Vec3::Zero();
            scene.spec->medium.wallLoss = 5;
            for (int i = 0; i < 3; ++i) scene.robot(names[i], at(2. * i, 0, 0), config);
            scene.robot("aside", at(2, 3, 0), config);
            Diagnostics diagnostics;
            const auto world = scene.build(code, diagnostics);
            QVERIFY(world && world->tick().ok());
            const Medium& medium = *world->medium();
            const auto idOf = [&](const std::string& robot) { return *medium.find(robot + "/radio"); };
            const auto lost = [&](const char* from, const char* to) { return medium.link(idOf(from), idOf(to)).wallLoss; };
            QCOMPARE(lost(names[0], names[2]), 5.);
            QCOMPARE(lost(names[2], names[0]), 5.);
            QCOMPARE(lost(names[0], names[1]), 0.); // their own bodies do not count
            QCOMPARE(lost(names[2], names[1]), 0.);
            QCOMPARE(lost("aside", names[0]), 0.);
        }
    }

    /// Each field of a Transceiver is the one of its radio, and each output the one that the medium counts.
    void fieldsAndOutputsOfATransceiver() {
        auto config = std::make_shared<RobotConfigSpec>();
        config->bodies.push_back(body("base", {}, massOfBox(1, {0.1, 0.1, 0.1}), {box("hull", {0.1, 0.1, 0.1})}));
        const std::map<std::string, double> numbers{{"MaxOutputPower", -3}, {"MinReceivePower", -81}, {"MaxReceivePower", -7},
                                                    {"RssiStep", 0.25},     {"BufferLimit", 2},       {"Channel", 13},
                                                    {"BitRate", 123456},    {"Address", 77},          {"ReceiveCurrent", 0.021},
                                                    {"SupplyVoltage", 3.3}};
        ComponentSpec radio;
        radio.kind = "Transceiver";
        radio.name = "radio";
        for (const auto& [name, number] : numbers) radio.values[name] = numberValue(number);
        radio.values["Body"] = textValue("base");
        radio.values["PowerLevels"] = {{PropertyType::Number, {-20, -9, -3}, {}}, {}, Origin::Config};
        radio.values["TransmitCurrent"] = {{PropertyType::Number, {0.011}, {}}, {}, Origin::Config};
        config->devices.push_back(radio);
        auto other = std::make_shared<RobotConfigSpec>(*config);
        other->devices[0].values["Address"] = numberValue(78);
        Scene scene;
        scene.spec->settings.gravity = Vec3::Zero();
        scene.robot("a", at(0, 0, 0), config);
        scene.robot("b", at(1, 0, 0), other);
        Diagnostics diagnostics;
        const auto world = scene.build(code, diagnostics);
        QVERIFY(world);

        Medium& medium = *world->medium();
        const RadioId a = *medium.find("a/radio"), b = *medium.find("b/radio");
        const RadioDefinition& r = medium.radio(a);
        QCOMPARE(r.maxOutputPower, -3.);
        QCOMPARE(r.minReceivePower, -81.);
        QCOMPARE(r.maxReceivePower, -7.);
        QCOMPARE(r.rssiStep, 0.25);
        QCOMPARE(r.bufferLimit, 2u);
        QCOMPARE(r.channel, 13u);
        QCOMPARE(r.bitRate, 123456.);
        QCOMPARE(r.address, 77u);
        QCOMPARE(r.receiveCurrent, 0.021);
        QCOMPARE(r.supply, 3.3);
        QCOMPARE(r.powerLevels, (std::vector<double>{-20, -9, -3}));
        QCOMPARE(r.transmitCurrents, std::vector<double>{0.011});
        QCOMPARE(medium.radio(b).address, 78u);

        // a sends 5 packets, 2 of which find room in its queue at once; b reads none and holds 2
        const std::vector<std::uint8_t> bytes(20, 7);
        for (int round = 0; round < 3; ++round) {
            for (int i = 0; i < 5; ++i) (void)medium.send(a, bytes, 78, -3);
            for (int i = 0; i < 10; ++i) QVERIFY(world->tick());
        }
        (void)medium.send(b, bytes, 77, -3);
        for (int i = 0; i < 10; ++i) QVERIFY(world->tick());
        (void)medium.send(a, bytes, 78, -3);
        (void)medium.send(a, bytes, 78, -3);
        (void)world->tick();
        for (const auto& [robot, radio] : {std::pair("a", a), {"b", b}}) {
            const std::string path = std::string(robot) + "/radio/";
            const RadioId id = radio;
            const RadioCounts& c = medium.counts(id);
            const auto output = [&](const char* signal) { return value(*world, path + signal); };
            QCOMPARE(output("address"), double(medium.radio(id).address));
            QCOMPARE(output("rssi"), c.lastRssi);
            QCOMPARE(output("lqi"), double(c.lastLqi));
            QCOMPARE(output("pending"), double(medium.pending(id)));
            QCOMPARE(output("queued"), double(medium.queued(id)));
            QCOMPARE(output("sent"), double(c.sent));
            QCOMPARE(output("received"), double(c.received));
            QCOMPARE(output("dropped"), double(c.dropped));
            QCOMPARE(output("failed"), double(c.refused + c.noChannel + c.noAck));
            QCOMPARE(output("energy"), c.energy);
        }
        QCOMPARE(value(*world, "b/radio/pending"), 2.);
        QVERIFY(value(*world, "b/radio/dropped") > 0 && value(*world, "a/radio/failed") > 0);
        QVERIFY(value(*world, "a/radio/received") == 1 && value(*world, "b/radio/received") > 1);
        QVERIFY(value(*world, "a/radio/energy") > 0 && value(*world, "a/radio/rssi") < -30);
    }
};

QTEST_APPLESS_MAIN(RadiosTest)
#include "radios_test.moc"
