#include <QtTest>

#include "radio/air.h"

using namespace air;

namespace {

MediumSettings csma() {
    MediumSettings settings;
    settings.csma = settings.collisions = true;
    return settings;
}

/// `nodes` around a sink that always have something to send to it; how many packets a second arrive.
double saturated(int nodes, std::uint64_t* given = nullptr) {
    Medium medium(csma());
    const RadioId sink = open(medium, "sink", {0, 0, 0});
    for (int i = 0; i < nodes; ++i) {
        const double angle = 2 * M_PI * i / nodes;
        open(medium, "mote" + std::to_string(i), {5 * std::cos(angle), 5 * std::sin(angle), 0});
    }
    RadioPacket packet;
    std::uint64_t received = 0;
    constexpr int kTicks = 1000;
    for (int tick = 1; tick <= kTicks; ++tick) {
        for (RadioId i = 1; i <= static_cast<RadioId>(nodes); ++i)
            while (medium.queued(i) < 8) send(medium, i, 39, medium.radio(sink).address); // 50 bytes
        medium.advance(tick * 10000);
        while (medium.receive(sink, packet)) ++received;
    }
    if (given) {
        *given = 0;
        for (RadioId i = 1; i <= static_cast<RadioId>(nodes); ++i) *given += medium.counts(i).noChannel + medium.counts(i).noAck;
    }
    return isConserved(medium) ? received / (kTicks * 0.01) : -1;
}

} // namespace

class CsmaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void packetsAreAcknowledged() {
        Medium medium(csma());
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, "b", {1, 0, 0});
        for (int i = 0; i < 10; ++i) send(medium, a, 4, medium.radio(b).address);
        medium.advance(200000);
        QCOMPARE(medium.pending(b), std::size_t{10});
        QCOMPARE(medium.counts(a).acknowledged, 10u);
        QCOMPARE(medium.counts(a).sent, 10u);
        QCOMPARE(medium.counts(a).noAck, 0u);
    }

    void nobodyAnswersThreeRepetitions() {
        Medium medium(csma());
        const RadioId a = open(medium, "a", {0, 0, 0});
        send(medium, a, 4, 77);
        medium.advance(1000000);
        QCOMPARE(medium.counts(a).sent, 4u);
        QCOMPARE(medium.counts(a).noAck, 1u);
        QCOMPARE(medium.queued(a), std::size_t{0});
    }

    void aLostAcknowledgementMakesNoSecondPacket() {
        // the way back is lost: b sends too weakly for a
        Medium medium(csma());
        RadioDefinition weak = radioNamed("b");
        weak.maxOutputPower = -90;
        const RadioId a = open(medium, "a", {0, 0, 0}), b = open(medium, weak, {5, 0, 0});
        send(medium, a, 4, medium.radio(b).address);
        medium.advance(1000000);
        QCOMPARE(medium.pending(b), std::size_t{1});
        QCOMPARE(count(medium, Fate::Duplicate), 3u);
        QCOMPARE(medium.counts(a).noAck, 1u);
        QVERIFY(isConserved(medium));
    }

    void whoHearsOthersWaits() {
        // three that begin at the same moment, again and again: without listening nobody hears anything
        const auto delivered = [](bool listens) {
            MediumSettings settings = csma();
            settings.csma = listens;
            Medium medium(settings);
            std::vector<RadioId> motes;
            for (int i = 0; i < 3; ++i) motes.push_back(open(medium, "mote" + std::to_string(i), {1. * i, 0, 0}));
            for (int round = 1; round <= 200; ++round) {
                for (const RadioId mote : motes) send(medium, mote, 100);
                medium.advance(round * 50000);
            }
            const std::uint64_t heard = count(medium, Fate::Delivered) + count(medium, Fate::BufferFull);
            return isConserved(medium) ? double(heard) / double(medium.expected()) : -1;
        };
        QCOMPARE(delivered(false), 0.);
        QVERIFY2(delivered(true) > 0.7, qPrintable(QString::number(delivered(true))));
    }

    void hiddenTerminalsCollide() {
        // two that hear the middle one and not each other
        const auto arriving = [](double distance) {
            MediumSettings settings = csma();
            settings.carrierSense = -77;
            Medium medium(settings);
            const RadioId middle = open(medium, "middle", {0, 0, 0}), left = open(medium, "left", {-distance, 0, 0}),
                          right = open(medium, "right", {distance, 0, 0});
            for (int i = 0; i < 400; ++i) {
                send(medium, left, 100);
                send(medium, right, 100);
                medium.advance((i + 1) * 20000);
            }
            return medium.counts(middle).received + medium.counts(middle).dropped;
        };
        const std::uint64_t hearing = arriving(20),
                            hidden = arriving(300); // the other is at 40 m or, below the threshold, at 600 m
        QVERIFY2(hearing > 600, qPrintable(QString::number(hearing)));
        QVERIFY2(hidden < hearing * 0.6, qPrintable(QString::number(hidden)));
    }

    void throughputHasItsShape() {
        // The saturated throughput of unslotted 802.15.4 with acknowledgements rises to a maximum at a few nodes and falls slowly as
        // collisions and given up packets grow (Kohvakka et al., PE-WASUN 2006; Buratti and Verdone, IEEE Trans. Veh. Tech. 58(7), 2009).
        std::uint64_t few = 0, many = 0;
        const double two = saturated(2), five = saturated(5, &few), twenty = saturated(20), fifty = saturated(50, &many);
        QVERIFY(two > 0 && five > 0 && twenty > 0 && fifty > 0);
        qInfo("packets/s at 2, 5, 20, 50 nodes: %.1f %.1f %.1f %.1f", two, five, twenty, fifty);
        const double most = 1e6 / (1792 + 192 + 352 + 128 + 192); // one after the other without any backoff
        for (const double rate : {two, five, twenty, fifty}) QVERIFY(rate < most);
        QVERIFY(twenty < five);
        QVERIFY(fifty < twenty);
        QVERIFY(fifty < 0.5 * five);
        QVERIFY(many > few);
    }
};

QTEST_APPLESS_MAIN(CsmaTest)
#include "csma_test.moc"
