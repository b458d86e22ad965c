// Links computed without a run equal those of a run.

#include <QtTest>

#include "radio/air.h"
#include "radio/ieee802154.h"
#include "radio/radio_nodes.h"

using namespace air;

namespace {

/// A tilted patch, a dipole with the CC2420's levels, and one on another channel.
std::vector<RadioNode> threeNodes() {
    std::vector<RadioNode> nodes(3);
    nodes[0].radio = radioNamed("robot0/radio");
    nodes[0].radio.antenna = std::make_shared<const AntennaPattern>(AntennaPattern::of(AntennaModel::Patch));
    nodes[0].mounting = {{0.1, 0, 0.3}, rotationFromHpr({0.4, 0.2, -0.1})};
    nodes[1].radio = radioNamed("mote/radio");
    nodes[1].radio.antenna = std::make_shared<const AntennaPattern>(AntennaPattern::of(AntennaModel::Dipole));
    nodes[1].radio.powerLevels = {-25, 0, -5, -10};
    nodes[1].radio.rssiStep = 1;
    nodes[1].body = 2;
    nodes[2].radio = radioNamed("other/radio");
    nodes[2].radio.channel = 11;
    nodes[2].body = 3;
    return nodes;
}

const std::vector<Pose> kBodies{{{1, 2, 0}, rotationFromHpr({0.7, 0, 0})},
                                {{9, 9, 9}, Quat::Identity()},
                                {{4, -1, 0.5}, rotationFromHpr({2, 0.3, 0})},
                                {{0, 6, 0.2}, Quat::Identity()}};

MediumSettings harshMedium() {
    MediumSettings m;
    m.model = PropagationModel::LogDistance;
    m.exponent = 2.6;
    m.shadowing = 4;
    m.offsets = 1.5;
    m.wallLoss = 3;
    m.noiseFloor = -90;
    m.packetErrors = true;
    return m;
}

int twoWalls(RadioId, const Vec3&, RadioId, const Vec3&) { return 2; }

} // namespace

class RadioNodesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLinkIsThatOfARun() {
        RadioNodes nodes(harshMedium(), threeNodes());
        nodes.setWalls(twoWalls);
        nodes.place(kBodies);
        Medium medium(harshMedium());
        medium.setWalls(twoWalls);
        for (const RadioNode& node : nodes.all()) medium.place(medium.open(node.radio), kBodies[node.body] * node.mounting);
        for (RadioId from = 0; from < 3; ++from)
            for (RadioId to = 0; to < 3; ++to) {
                if (from == to) continue;
                const LinkReport report = nodes.link(from, to, 99); // limited to its maximum power
                const LinkBudget expected = medium.link(from, to);
                QCOMPARE(report.link.power, expected.power);
                QCOMPARE(report.link.shadow, expected.shadow);
                QCOMPARE(report.link.wallLoss, 6.);
                QCOMPARE(report.sameChannel, from != 2 && to != 2);
                QCOMPARE(nodes.reach(from, nodes.antenna(to), 99).power, expected.power);
            }
        QVERIFY(nodes.offsets(0).power != 0 && nodes.offsets(0).power != nodes.offsets(1).power);
        QCOMPARE(nodes.find("mote/radio"), std::optional<RadioId>(1));
        QVERIFY(!nodes.find("mote"));
    }

    void aPacketInTheAirReadsTheSame() {
        RadioNodes nodes(harshMedium(), threeNodes());
        nodes.place(kBodies);
        MediumSettings settings = harshMedium();
        settings.wallLoss = 0;
        Medium medium(settings);
        for (const RadioNode& node : nodes.all()) medium.place(medium.open(node.radio), kBodies[node.body] * node.mounting);
        const auto trace = medium.trace();
        QVERIFY(send(medium, 0, 30, kBroadcastAddress, -2.5));
        QVERIFY(send(medium, 1, 30, kBroadcastAddress, -7)); // its nearest level below is -10
        medium.advance(100000);
        QCOMPARE(trace->records.size(), std::size_t(2));
        for (const FrameRecord& r : trace->records) {
            const LinkReport report = nodes.link(r.from, r.to, r.from == 0 ? -2.5 : -7, 30);
            QCOMPARE(report.outputPower, r.outputPower);
            QCOMPARE(report.link.power, r.link.power);
            QCOMPARE(report.rssi, r.rssi);
            QCOMPARE(report.lqi, r.lqi);
            QCOMPARE(report.snr, r.link.power + 90);
        }
        QCOMPARE(nodes.link(1, 0, -7).outputPower, -10 + nodes.offsets(1).power);
    }

    void losesPacketsByNoiseOrThreshold() {
        MediumSettings settings;
        settings.noiseFloor = -75;
        std::vector<RadioNode> two = threeNodes();
        two.pop_back();
        RadioNodes sharp(settings, two);
        sharp.place(kBodies);
        QCOMPARE(sharp.link(0, 1, 0).packetLoss, 0.);
        QVERIFY(sharp.link(0, 1, 0).margin > 0);
        QCOMPARE(sharp.link(0, 1, -90).packetLoss, 1.);
        QVERIFY(sharp.link(0, 1, -90).margin < 0);
        settings.packetErrors = true;
        RadioNodes noisy(settings, two);
        noisy.place(kBodies);
        // A power at which some but not all packets are lost.
        double power = 0;
        while (power > -60 && noisy.link(0, 1, power).packetLoss < 0.2) power -= 0.05;
        const LinkReport report = noisy.link(0, 1, power, 50);
        QVERIFY(report.packetLoss > 0.2 && report.packetLoss < 1);
        QCOMPARE(report.packetLoss, 1 - receptionRate(report.snr - settings.implementationLoss, 8. * 61));
        QVERIFY(noisy.link(0, 1, power, 100).packetLoss > report.packetLoss);
    }

    void anAntennaWithoutABodyStays() {
        std::vector<RadioNode> nodes = threeNodes();
        nodes[2].body = 77;
        RadioNodes placed(MediumSettings(), nodes);
        placed.place(kBodies);
        QCOMPARE(placed.antenna(2).pose.position, Vec3(Vec3::Zero()));
        QVERIFY((placed.antenna(0).pose.position - kBodies[0] * Vec3(0.1, 0, 0.3)).norm() < 1e-12);
    }
};

QTEST_GUILESS_MAIN(RadioNodesTest)
#include "nodes_test.moc"
