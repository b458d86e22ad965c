// Which frames a capture file has for some of the robots: those that their radios send, and those that they receive in any way.
#include <QtTest>

#include "radio/air.h"
#include "run/fake_world.h"
#include "run/logs/log_kinds.h"

using namespace air;

namespace {

/// Robots with radios of the test.
class AirWorld final : public FakeWorld {
public:
    explicit AirWorld(const MediumSettings& settings) : FakeWorld(experimentOf({"a", "b", "c"})), m_medium(settings) {}
    Medium* medium() const override { return &m_medium; }

private:
    mutable Medium m_medium;
};

std::unique_ptr<RunLog> captureOf(const World& world, const std::string& robot) {
    Diagnostics diagnostics;
    return makeRadioLog(logSpec("RadioLog", "log", {{"Format", textValue({"pcap"})}, {"Robot", textValue({robot})}}), world,
                        diagnostics);
}

/// The number of frames whose payload is a letter.
qsizetype framesIn(RunLog& log, const World& world, char letter, std::size_t bytes) {
    std::string text;
    log.rows(world, 0, text);
    return QByteArray::fromStdString(text).count(QByteArray(qsizetype(bytes), letter));
}

} // namespace

class RadioCaptureTest : public QObject {
    Q_OBJECT

    static MediumSettings csma() {
        MediumSettings settings;
        settings.csma = true;
        return settings;
    }
    static bool sendLetters(Medium& medium, RadioId from, char letter, std::size_t bytes, std::uint32_t to) {
        return medium.send(from, std::vector<std::uint8_t>(bytes, static_cast<std::uint8_t>(letter)), to, 0);
    }

private Q_SLOTS:
    /// The acknowledgements of b are too weak for a: a repeats its packet three times, and b receives it each time.
    void aRepetitionIsReceivedToo() {
        const AirWorld world(csma());
        Medium& medium = *world.medium();
        RadioDefinition weak = radioNamed("b/radio"), deaf = radioNamed("c/radio");
        weak.maxOutputPower = -90;
        deaf.minReceivePower = 10;
        const RadioId a = open(medium, "a/radio", {0, 0, 0}), b = open(medium, weak, {5, 0, 0});
        open(medium, deaf, {5, 1, 0});
        const auto ofSender = captureOf(world, "a"), ofReceiver = captureOf(world, "b"), ofDeaf = captureOf(world, "c");
        QVERIFY(ofSender && ofReceiver && ofDeaf);
        QVERIFY(sendLetters(medium, a, 'x', 9, medium.radio(b).address));
        medium.advance(1'000'000);
        QCOMPARE(count(medium, ReceptionOutcome::Duplicate), std::uint64_t(3));
        QCOMPARE(framesIn(*ofSender, world, 'x', 9), qsizetype(4));
        QCOMPARE(framesIn(*ofReceiver, world, 'x', 9), qsizetype(4));
        QCOMPARE(framesIn(*ofDeaf, world, 'x', 9), qsizetype(0)); // too weak for it
    }

    /// What finds no room in the buffer, or is for another radio, was received all the same.
    void whatIsNotReadIsReceivedToo() {
        const AirWorld world{MediumSettings()};
        Medium& medium = *world.medium();
        RadioDefinition small = radioNamed("b/radio");
        small.bufferLimit = 1;
        const RadioId a = open(medium, "a/radio", {0, 0, 0}), b = open(medium, small, {1, 0, 0}),
                      c = open(medium, "c/radio", {2, 0, 0});
        const auto ofB = captureOf(world, "b");
        for (int i = 0; i < 3; ++i) {
            QVERIFY(sendLetters(medium, a, 'x', 7, medium.radio(b).address));
            medium.advance((i + 1) * 20'000);
        }
        QCOMPARE(count(medium, ReceptionOutcome::BufferFull), std::uint64_t(2));
        QCOMPARE(framesIn(*ofB, world, 'x', 7), qsizetype(3));
        QVERIFY(sendLetters(medium, a, 'y', 8, medium.radio(c).address));
        medium.advance(100'000);
        QVERIFY(count(medium, ReceptionOutcome::NotAddressed) > 0);
        QCOMPARE(framesIn(*ofB, world, 'y', 8), qsizetype(1));
    }

    /// A frame whose end is in the next rows is written there.
    void aFrameInTheAirIsWrittenLater() {
        const AirWorld world{MediumSettings()};
        Medium& medium = *world.medium();
        const RadioId a = open(medium, "a/radio", {0, 0, 0});
        open(medium, "b/radio", {1, 0, 0});
        const auto ofB = captureOf(world, "b");
        QVERIFY(sendLetters(medium, a, 'z', 60, kBroadcastAddress));
        qsizetype written = 0;
        int parts = 0;
        for (std::int64_t us = 200; us <= 20'000; us += 200) { // the frame takes 2.6 ms
            medium.advance(us);
            const qsizetype now = framesIn(*ofB, world, 'z', 60);
            written += now;
            parts += now == 0 ? 1 : 0;
        }
        QCOMPARE(written, qsizetype(1));
        QVERIFY(parts > 90);
    }

    /// The margin is that of the receiving end; only pairs of the chosen robots, on one channel, have rows.
    void linksAreOfTheChosenPairs() {
        const AirWorld world{MediumSettings()};
        Medium& medium = *world.medium();
        RadioDefinition sharp = radioNamed("b/radio"), other = radioNamed("c/radio");
        sharp.minReceivePower = -97;
        other.channel = 12;
        const RadioId a = open(medium, "a/radio", {0, 0, 0}), b = open(medium, sharp, {3, 0, 0});
        open(medium, other, {1, 0, 0});
        Diagnostics diagnostics;
        const auto rowsOf = [&](std::vector<std::string> robots) {
            const auto log =
                makeLinkMatrix(logSpec("LinkMatrix", "log", {{"Robot", textValue(std::move(robots))}}), world, diagnostics);
            std::string text;
            log->rows(world, 0.5, text);
            return QString::fromStdString(text).split('\n', Qt::SkipEmptyParts);
        };
        const QStringList rows = rowsOf({});
        QCOMPARE(rows.size(), 2);
        QVERIFY(rows[0].startsWith("0.5,a/radio,b/radio,3,") && rows[1].startsWith("0.5,b/radio,a/radio,3,"));
        const double power = medium.link(a, b).power;
        QVERIFY(std::abs(rows[0].section(',', -1).toDouble() - (power + 97)) < 0.001);
        QVERIFY(std::abs(rows[1].section(',', -1).toDouble() - (medium.link(b, a).power - medium.radio(a).minReceivePower)) <
                0.001);
        QCOMPARE(rowsOf({"a"}).size(), 0);
        QCOMPARE(rowsOf({"a", "b"}).size(), 2);
    }
};

QTEST_APPLESS_MAIN(RadioCaptureTest)
#include "radio_capture_test.moc"
