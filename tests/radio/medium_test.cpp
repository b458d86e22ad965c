// The radio medium: reception, collisions, buffers, reproducibility.
#include <QtTest>

#include <map>
#include <set>

#include <cstring>

#include "radio/air.h"

using namespace air;

namespace {

/// A hash over every record of heavy traffic between some motes.
std::uint64_t story(std::uint64_t seed, bool watched, std::int64_t tick) {
    MediumSettings settings;
    settings.model = PropagationModel::LogDistance;
    settings.exponent = 2.8;
    settings.shadowing = 4;
    settings.csma = settings.collisions = settings.packetErrors = true;
    settings.offsets = 1;
    settings.seed = seed;
    Medium medium(settings);
    for (int i = 0; i < 12; ++i) open(medium, "mote" + std::to_string(i) + "/radio", {(i % 4) * 9., (i / 4) * 8., 0.1});
    std::shared_ptr<RadioTrace> trace = medium.trace(), other;
    if (watched) other = medium.trace();
    for (std::int64_t us = 0; us < 2000000; us += tick) {
        if (us % 100000 == 0)
            for (RadioId i = 0; i < 12; ++i) send(medium, i, 20 + i, i % 3 == 0 ? kBroadcastAddress : (i + 1) % 12 + 1);
        medium.advance(us + tick);
        if (watched) (void)medium.link(0, 1), other->records.clear();
    }
    std::uint64_t hash = 1469598103934665603ull;
    const auto add = [&hash](double v) {
        std::uint64_t bits;
        std::memcpy(&bits, &v, sizeof bits);
        hash = (hash ^ bits) * 1099511628211ull;
    };
    for (const FrameRecord& r : trace->records)
        for (const double v : {r.time, 1. * r.from, 1. * r.to, r.link.power, r.rssi, r.sinr, 1. * static_cast<int>(r.outcome)})
            add(v);
    add(static_cast<double>(trace->records.size()));
    return isConserved(medium) ? hash : 0;
}

} // namespace

class MediumTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void twoMotes() {
        Medium medium({});
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, "b", {0, 10, 0});
        const std::uint8_t hello[] = {'h', 'i'};
        QVERIFY(medium.send(a, hello, kBroadcastAddress, -5));
        RadioPacket packet;
        medium.advance(500);
        QVERIFY(!medium.receive(b, packet)); // still being transmitted: 6 + 13 bytes take 608 us
        medium.advance(10000);
        QVERIFY(medium.receive(b, packet));
        QVERIFY(!medium.receive(b, packet));
        QVERIFY(!medium.receive(a, packet));
        QCOMPARE(packet.bytes, (std::vector<std::uint8_t>{'h', 'i'}));
        QVERIFY(std::abs(packet.rssi + 65.2311) < 1e-4);
        QVERIFY(std::abs(packet.time - 608e-6) < 1e-12);
        QCOMPARE(packet.from, medium.radio(a).address);
        QCOMPARE(packet.lqi, 110);
        QCOMPARE(medium.counts(a).sent, 1u);
        QCOMPARE(medium.counts(b).received, 1u);
    }

    /// A time is the number nearest to its microseconds, which is printed with few digits.
    void timesAreWholeMicroseconds() {
        Medium medium({});
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, "b", {0, 10, 0});
        const std::shared_ptr<RadioTrace> trace = medium.trace();
        medium.advance(50'000);
        QVERIFY(send(medium, a, 2));
        medium.advance(60'000);
        RadioPacket packet;
        QVERIFY(medium.receive(b, packet));
        QVERIFY(packet.time == 0.050608 && trace->records.at(0).time == 0.05 && trace->frames.at(0).time == 0.05);
    }

    void readingsAreSteppedAndClipped() {
        Medium medium({});
        const RadioId a = open(medium, "a", {0, 0, 0});
        RadioDefinition d = radioNamed("b");
        d.rssiStep = 1;
        d.maxReceivePower = -60;
        const RadioId b = open(medium, d, {5, 0, 0}), far = open(medium, "far", {5, 0, 0});
        RadioPacket packet;
        std::int64_t now = 0;
        for (const auto& [power, stepped] : {std::pair{-10., -64.}, {-10.6, -65.}, {0., -60.}}) {
            send(medium, a, 1, kBroadcastAddress, power);
            medium.advance(now += 1000);
            QVERIFY(medium.receive(b, packet));
            QCOMPARE(packet.rssi, stepped);
            QVERIFY(medium.receive(far, packet));
            QVERIFY(std::abs(packet.rssi - (power - 54.2105)) < 1e-4);
        }
    }

    /// Nor rounded above its limit: of -40.2 dBm, and of -52 dBm, a radio with steps of 7 dB up to -52 dBm reads -56.
    void readingsEndBelowTheirLimit() {
        Medium medium({});
        RadioDefinition d = radioNamed("b");
        d.rssiStep = 7;
        d.maxReceivePower = -52;
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, d, {1, 0, 0});
        const std::shared_ptr<RadioTrace> trace = medium.trace();
        RadioPacket packet;
        std::int64_t now = 0;
        for (const auto& [power, stepped] : {std::pair{0., -56.}, {-11.8, -56.}, {-19.4, -63.}}) {
            send(medium, a, 1, kBroadcastAddress, power);
            medium.advance(now += 1000);
            QVERIFY(medium.receive(b, packet));
            QCOMPARE(packet.rssi, stepped);
            QCOMPARE(trace->records.back().rssi, stepped);
        }
    }

    void weakerThanTheThresholdIsDropped() {
        Medium medium({});
        const RadioId a = open(medium, "a", {0, 0, 0});
        open(medium, "inside", {488, 0, 0});
        open(medium, "outside", {0, 488.1, 0});
        send(medium, a);
        medium.advance(10000);
        QCOMPARE(count(medium, ReceptionOutcome::Delivered), 1u);
        QCOMPARE(count(medium, ReceptionOutcome::TooWeak), 1u);
    }

    void levelsOfPower() {
        Medium medium({});
        RadioDefinition d = radioNamed("a");
        d.powerLevels = {0, -5, -25};
        d.transmitCurrents = {0.0174, 0.0139, 0.0085};
        d.receiveCurrent = 0.0188;
        d.supply = 3;
        const RadioId a = open(medium, d, {0, 0, 0}), b = open(medium, "b", {1, 0, 0});
        RadioPacket packet;
        for (const auto& [wanted, given] : {std::pair{10., 0.}, {-1., -5.}, {-5., -5.}, {-40., -25.}}) {
            send(medium, a, 1, kBroadcastAddress, wanted);
            medium.advance(static_cast<std::int64_t>(1e6 + 1e6 * (10 - wanted)));
            QVERIFY(medium.receive(b, packet));
            QVERIFY(std::abs(packet.rssi - (given - 40.2311)) < 1e-4);
        }
        // 4 frames of 576 us out of 51 s
        const double sending = 576e-6, all = 51,
                     energy = 3 * (sending * (.0174 + 2 * .0139 + .0085) + (all - 4 * sending) * .0188);
        QVERIFY(std::abs(medium.counts(a).energy - energy) < 1e-9);
        QCOMPARE(medium.counts(b).energy, 0.);
    }

    void currentOfALevel_data() {
        QTest::addColumn<QList<double>>("levels");
        QTest::addColumn<QList<double>>("currents");
        QTest::addColumn<double>("power");
        QTest::addColumn<double>("current");
        const QList<double> levels{-20, -10, 0}, each{.003, .005, .009};
        QTest::newRow("lowest") << levels << each << -15. << .003;
        QTest::newRow("middle") << levels << each << -1. << .005;
        QTest::newRow("highest") << levels << each << 9. << .009;
        QTest::newRow("one for all") << levels << QList<double>{.004} << -1. << .004;
        QTest::newRow("one for all powers") << QList<double>{} << QList<double>{.004} << -3.5 << .004;
        QTest::newRow("fewer than levels") << levels << QList<double>{.003, .005} << 9. << .003;
        QTest::newRow("none") << levels << QList<double>{} << -1. << 0.;
    }
    /// Energy of a second in which one frame is sent: while it is in the air its current flows, otherwise that of receiving.
    void currentOfALevel() {
        QFETCH(QList<double>, levels);
        QFETCH(QList<double>, currents);
        QFETCH(double, power);
        QFETCH(double, current);
        for (const double offsets : {0., 3.}) { // the spread of output powers moves all levels together
            MediumSettings settings;
            settings.offsets = offsets;
            Medium medium(settings);
            RadioDefinition d = radioNamed("a");
            d.powerLevels.assign(levels.begin(), levels.end());
            d.transmitCurrents.assign(currents.begin(), currents.end());
            d.receiveCurrent = 0.02;
            d.supply = 2.5;
            const RadioId a = open(medium, d, {0, 0, 0});
            send(medium, a, 40, kBroadcastAddress, power);
            medium.advance(1'000'000);
            const double sending = (40 + 17) * 32e-6; // header, check sum, preamble
            const double expected = 2.5 * (sending * current + (1 - sending) * 0.02);
            QVERIFY2(std::abs(medium.counts(a).energy - expected) < 1e-9,
                     qPrintable(QString("%1 %2").arg(medium.counts(a).energy).arg(expected)));
        }
    }

    void aFullBufferDropsTheNewest() {
        Medium medium({});
        RadioDefinition d = radioNamed("b");
        d.bufferLimit = 3;
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, d, {1, 0, 0});
        for (std::size_t i = 1; i <= 5; ++i) QVERIFY(send(medium, a, i));
        medium.advance(100000);
        QCOMPARE(medium.pending(b), std::size_t{3});
        QCOMPARE(medium.counts(b).dropped, 2u);
        QCOMPARE(count(medium, ReceptionOutcome::BufferFull), 2u);
        RadioPacket packet;
        for (std::size_t i = 1; i <= 3; ++i) {
            QVERIFY(medium.receive(b, packet));
            QCOMPARE(packet.bytes.size(), i);
        }
        for (int i = 0; i < 16; ++i) QVERIFY(send(medium, a));
        QVERIFY(!send(medium, a));
        QVERIFY(!send(medium, b, 117));
        QCOMPARE(medium.counts(a).refused, 1u);
        QVERIFY(isConserved(medium));
    }

    void sendingRadioReceivesNothing() {
        Medium medium({});
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, "b", {1, 0, 0}), c = open(medium, "c", {2, 0, 0});
        send(medium, a);
        send(medium, b);
        medium.advance(10000);
        QCOMPARE(medium.pending(a), std::size_t{0});
        QCOMPARE(medium.pending(b), std::size_t{0});
        QCOMPARE(medium.pending(c), std::size_t{2}); // collisions are off by default
        QCOMPARE(count(medium, ReceptionOutcome::Sending), 2u);
        QVERIFY(isConserved(medium));
    }

    void channelsAreApart() {
        Medium medium({});
        RadioDefinition d = radioNamed("b");
        d.channel = 11;
        const RadioId a = open(medium, "a", {0, 0, 0});
        open(medium, d, {1, 0, 0});
        send(medium, a);
        medium.advance(10000);
        QCOMPARE(medium.expected(), 0u);
        QVERIFY(isConserved(medium));
    }

    void addressesAreHeeded() {
        Medium medium({});
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, "b", {1, 0, 0}), c = open(medium, "c", {2, 0, 0});
        send(medium, a, 4, medium.radio(c).address);
        medium.advance(10000);
        QCOMPARE(medium.pending(b), std::size_t{0});
        QCOMPARE(medium.pending(c), std::size_t{1});
        QCOMPARE(count(medium, ReceptionOutcome::NotAddressed), 1u);
    }

    /// A radio without an Address gets one that no other has, so a packet to it is its own.
    void addressesThatAreNotGivenAreFree() {
        Medium medium({});
        RadioDefinition given = radioNamed("given"), next = radioNamed("next");
        given.address = 2;
        next.address = 3;
        medium.reserve(3);
        std::vector<RadioId> radios{open(medium, given, {0, 0, 0}), open(medium, "a", {1, 0, 0}), open(medium, next, {2, 0, 0})};
        for (const char* name : {"b", "c", "d"}) radios.push_back(open(medium, name, {1.0 * radios.size(), 0, 0}));
        std::set<std::uint32_t> addresses;
        for (const RadioId id : radios) addresses.insert(medium.radio(id).address);
        QCOMPARE(addresses.size(), radios.size());
        QVERIFY(!addresses.contains(0) && !addresses.contains(kBroadcastAddress));
        QCOMPARE(medium.radio(radios[0]).address, 2u);
        QCOMPARE(medium.radio(radios[2]).address, 3u);
        for (const RadioId to : {radios[0], radios[1], radios[3]}) {
            send(medium, radios[5], 4, medium.radio(to).address);
            medium.advance(10000 * (to + 1));
            for (const RadioId id : radios) QCOMPARE(medium.pending(id), std::size_t(id == to));
            RadioPacket packet;
            QVERIFY(medium.receive(to, packet));
            QCOMPARE(packet.from, medium.radio(radios[5]).address);
        }
    }

    void theStrongerSurvivesACollision() {
        MediumSettings settings;
        settings.collisions = true;
        for (const double distance : {1.2, 2.0}) { // 1.6 dB and 6 dB weaker than the one at 1 m
            Medium medium(settings);
            const RadioId near = open(medium, "near", {1, 0, 0}), far = open(medium, "far", {-distance, 0, 0}),
                          ear = open(medium, "ear", {0, 0, 0});
            send(medium, near);
            medium.advance(100);
            send(medium, far);
            medium.advance(10000);
            QCOMPARE(medium.pending(ear), std::size_t{distance > 1.5});
            QVERIFY(count(medium, ReceptionOutcome::Busy) > 0);
            QCOMPARE(count(medium, ReceptionOutcome::Collision), distance > 1.5 ? 0u : 1u);
            QVERIFY(isConserved(medium));
        }
    }

    void captureByTheWorstMoment_data() {
        QTest::addColumn<QList<double>>("distances"); // of interferers, one after the other, during one long frame from 1 m
        QTest::addColumn<bool>("survives");
        QTest::newRow("none") << QList<double>{} << true;
        QTest::newRow("weak ones") << QList<double>{4, 5, 4} << true;
        QTest::newRow("a strong one first") << QList<double>{1.2, 5, 5} << false;
        QTest::newRow("a strong one in the middle") << QList<double>{5, 1.2, 5} << false;
        QTest::newRow("a strong one last") << QList<double>{5, 5, 1.2} << false;
        QTest::newRow("a strong one, then nothing") << QList<double>{1.2} << false;
    }
    /// The ratio to the interference counts at its worst, however short, and whatever follows in the same frame.
    void captureByTheWorstMoment() {
        QFETCH(QList<double>, distances);
        QFETCH(bool, survives);
        MediumSettings settings;
        settings.collisions = true;
        Medium medium(settings);
        const RadioId sender = open(medium, "sender", {1, 0, 0}), ear = open(medium, "ear", {0, 0, 0});
        std::vector<RadioId> others;
        for (qsizetype i = 0; i < distances.size(); ++i)
            others.push_back(open(medium, "other" + std::to_string(i), {0, distances[i], 0}));
        const std::shared_ptr<RadioTrace> trace = medium.trace();
        send(medium, sender, 100); // 6 + 113 bytes take 3.8 ms, the others 0.6 ms each
        for (std::size_t i = 0; i < others.size(); ++i) {
            medium.advance(static_cast<std::int64_t>(200 + 1000 * i));
            send(medium, others[i], 2);
        }
        medium.advance(10000);
        QCOMPARE(medium.pending(ear), std::size_t{survives});
        double nearest = 1e9;
        for (const double d : distances) nearest = std::min(nearest, d);
        for (const FrameRecord& r : trace->records)
            if (r.from == sender && r.to == ear) {
                QCOMPARE(outcomeName(r.outcome),
                         outcomeName(survives ? ReceptionOutcome::Delivered : ReceptionOutcome::Collision));
                if (nearest < 1e9) QVERIFY(std::abs(r.sinr - 20 * std::log10(nearest)) < 0.1);
            }
        QVERIFY(isConserved(medium));
    }

    /// The spread of the readings is one offset of each radio: it is in the RSSI, the same for every sender, and not in the power.
    void readingsHaveAnOffset() {
        MediumSettings settings;
        settings.offsets = 3;
        Medium medium(settings);
        std::vector<RadioId> all;
        for (int i = 0; i < 4; ++i) all.push_back(open(medium, "r" + std::to_string(i), {double(i * i), 2. * i, 0}));
        const std::shared_ptr<RadioTrace> trace = medium.trace();
        std::int64_t now = 0;
        for (const RadioId id : all) {
            send(medium, id);
            medium.advance(now += 10000);
        }
        std::map<RadioId, std::set<int>> offsets; // micro dB
        for (const FrameRecord& r : trace->records) {
            QVERIFY(std::abs(r.link.power - (r.outputPower + r.link.sendGain + r.link.receiveGain - r.link.pathLoss)) < 1e-9);
            offsets[r.to].insert(static_cast<int>(std::lround(1e6 * (r.rssi - r.link.power))));
        }
        std::set<int> different;
        for (const RadioId id : all) {
            QCOMPARE(offsets[id].size(), std::size_t{1});
            different.insert(*offsets[id].begin());
            RadioPacket packet;
            QVERIFY(medium.receive(id, packet));
            for (const FrameRecord& r : trace->records)
                if (r.to == id && medium.radio(r.from).address == packet.from) QCOMPARE(packet.rssi, r.rssi);
        }
        QCOMPARE(different.size(), all.size());
        QVERIFY(std::abs(*different.begin()) > 1000 || std::abs(*different.rbegin()) > 1000);
    }

    void lossesFollowTheCurve_data() {
        QTest::addColumn<double>("power");
        QTest::addColumn<double>("rate");
        QTest::newRow("-94") << -94. << .99;
        QTest::newRow("0 dB") << -94.5 << .9670;
        QTest::newRow("-1 dB") << -95.5 << .7873;
        QTest::newRow("-2 dB") << -96.5 << .3383;
        QTest::newRow("-3 dB") << -97.5 << .0320;
    }
    void lossesFollowTheCurve() {
        QFETCH(double, power);
        QFETCH(double, rate);
        MediumSettings settings;
        settings.packetErrors = true;
        Medium medium(settings);
        RadioDefinition d = radioNamed("b");
        d.minReceivePower = -120;
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, d, {10, 0, 0});
        constexpr int kFrames = 20000;
        RadioPacket packet;
        int received = 0;
        for (int i = 0; i < kFrames; ++i) {
            send(medium, a, 15, kBroadcastAddress, power + 60.2311); // 26 bytes
            medium.advance((i + 1) * 2000);
            received += medium.receive(b, packet);
        }
        const double error = 4 * std::sqrt(rate * (1 - rate) / kFrames) + 1e-4;
        QVERIFY2(std::abs(received / double(kFrames) - rate) < error, qPrintable(QString::number(received)));
        QVERIFY(isConserved(medium));
    }

    void powersAddUpAsNoise() {
        // -80 dBm with a noise floor of -95 dBm and interferers of -90 and -88 dBm: 5.3743 dB
        MediumSettings settings;
        settings.collisions = true;
        settings.noiseFloor = -95;
        Medium medium(settings);
        const auto at = [](double power) { return std::pow(10, (-power - 40.2311) / 20); };
        const RadioId a = open(medium, "a", {at(-80), 0, 0}), b = open(medium, "b", {0, at(-90), 0}),
                      c = open(medium, "c", {0, -at(-88), 0});
        const RadioId ear = open(medium, "ear", {0, 0, 0});
        const std::shared_ptr<RadioTrace> trace = medium.trace();
        for (const RadioId id : {a, b, c}) send(medium, id);
        medium.advance(10000);
        for (const FrameRecord& r : trace->records)
            if (r.from == a && r.to == ear) QVERIFY2(std::abs(r.sinr - 5.3743) < 1e-3, qPrintable(QString::number(r.sinr)));
        QCOMPARE(medium.pending(ear), std::size_t{1});
    }

    void clocksDrift() {
        MediumSettings settings;
        settings.clockDrift = 40;
        Medium medium(settings);
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, "b", {1, 0, 0});
        medium.advance(100000000);
        send(medium, a);
        medium.advance(100010000);
        RadioPacket packet;
        QVERIFY(medium.receive(b, packet));
        QVERIFY(std::abs(packet.time - 100) > 1e-4 && std::abs(packet.time - 100) < 0.02);
    }

    void theSameSeedIsTheSameStory() {
        const std::uint64_t first = story(1, false, 10000);
        QVERIFY(first != 0);
        QCOMPARE(story(1, false, 10000), first);
        QCOMPARE(story(1, true, 10000), first);  // independent of observers
        QCOMPARE(story(1, false, 20000), first); // independent of the tick length
        QVERIFY(story(2, false, 10000) != first);
    }
};

QTEST_APPLESS_MAIN(MediumTest)
#include "medium_test.moc"
