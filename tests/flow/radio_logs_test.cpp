// RadioLog, LinkMatrix and the capture file agree with each other and with the run: no frame is missing, none is invented.

#include "flow/cli.h"

#include <QtEndian>

namespace {

using Row = QMap<QByteArray, QByteArray>;

QList<Row> rowsOf(const QString& path) {
    QList<Row> rows;
    QList<QByteArray> lines = contentOf(path).split('\n');
    if (lines.isEmpty()) return rows;
    const QList<QByteArray> names = lines.takeFirst().split(',');
    for (const QByteArray& line : lines) {
        const QList<QByteArray> cells = line.split(',');
        if (cells.size() != names.size()) continue;
        Row row;
        for (qsizetype i = 0; i < names.size(); ++i) row[names[i]] = cells[i];
        rows << row;
    }
    return rows;
}

double number(const Row& row, const char* name) {
    bool good = false;
    const double value = row.value(name).toDouble(&good);
    return good ? value : std::nan("");
}

/// One frame of a capture file.
struct Captured {
    double time = 0;
    QByteArray bytes;
    [[nodiscard]] double end() const { return time + (6 + bytes.size()) * 32e-6; }
    [[nodiscard]] double sender() const { return qFromLittleEndian<quint16>(bytes.constData() + 7); }
    [[nodiscard]] bool isAck() const { return (bytes[0] & 7) == 2; }
};

/// Frames of a capture file of link type 195; empty if it is not one.
QList<Captured> capture(const QByteArray& file) {
    const auto word = [&](qsizetype at) { return qFromLittleEndian<quint32>(file.constData() + at); };
    QList<Captured> frames;
    if (file.size() < 24 || word(0) != 0xa1b2c3d4 || word(20) != 195) return frames;
    for (qsizetype at = 24; at + 16 <= file.size();) {
        const quint32 length = word(at + 8);
        if (length != word(at + 12) || at + 16 + length > file.size()) return {};
        frames << Captured{word(at) + word(at + 4) * 1e-6, file.mid(at + 16, length)};
        at += 16 + length;
    }
    return frames;
}

/// ITU-T CRC-16 over all bytes including the check sequence: 0 for an intact frame.
quint16 checked(const QByteArray& bytes) {
    quint16 crc = 0;
    for (const char byte : bytes)
        for (int bit = 0; bit < 8; ++bit) {
            const bool odd = (crc ^ (static_cast<quint8>(byte) >> bit)) & 1;
            crc = static_cast<quint16>(crc >> 1) ^ (odd ? 0x8408 : 0);
        }
    return crc;
}

const QByteArray kHead =
    "Tick = 0.01  Duration = 2\n#import robots/tmote_sky.sim\n#import arenas/open_floor.sim\n"
    "#loadModule controllers/mote\nStatic floor { Config=OpenFloor }\n"
    "RadioLog frames { }\nRadioLog sniffer { Format=pcap File=frames.pcap }\nLinkMatrix links { Interval=1 }\n";

const QByteArray kMotes =
    "Robot target { Config=TmoteSky  Mote brain { Target=true Period=0.02 } }\n"
    "Grid motes { Config=TmoteSky Pos=4,0,0 Count=3,2 Spacing=2,1.5  Mote brain { Period=0.02 } }\n"
    "Robot deaf { Config=TmoteSky Pos=0,3,0 radio.BufferLimit=2 }\n"                    // no controller reads from it
    "Robot far { Config=TmoteSky Pos=720,0,0 HPR=90,0,0  Mote brain { Power=-25 } }\n"; // all links too weak, in both directions

} // namespace

class RadioLogsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QJsonObject m_robots;

    QString file(const char* name) const { return m_folder.filePath(QString("logs/") + name); }
    Outcome run(const QByteArray& text) {
        const QString path = m_folder.filePath("x.sim");
        if (!writeFile(path, text)) return {};
        Outcome done = cli({"run", path, "--json", "--quiet", "--log-dir", m_folder.filePath("logs")});
        m_robots = QJsonDocument::fromJson(done.out).object()["robots"].toObject();
        return done;
    }
    /// A counter of the robot's radio, at the end of the run.
    double counted(const QString& robot, const char* signal) const {
        return m_robots[robot].toObject()["signals"].toObject()[QString("radio/") + signal].toDouble(-1);
    }

private Q_SLOTS:
    void accountsForEveryPacket_data() {
        QTest::addColumn<QByteArray>("medium");
        QTest::addColumn<QByteArrayList>("outcomes"); // all must occur
        QTest::newRow("ideal") << QByteArray("RadioMedium air { }\n")
                               << QByteArrayList{"delivered", "was sending", "too weak", "buffer full"};
        QTest::newRow("collisions") << QByteArray("RadioMedium air { Collisions=true }\n")
                                    << QByteArrayList{"delivered", "was sending", "too weak", "collision", "heard another"};
        QTest::newRow("csma") << QByteArray("RadioMedium air { Collisions=true Mac=csma }\n")
                              << QByteArrayList{"delivered", "too weak", "buffer full"};
        QTest::newRow("bit errors") << QByteArray("RadioMedium air { Model=log_distance Exponent=4.6 Mac=csma Collisions=true "
                                                  "PacketErrors=true NoiseFloor=-78 }\n")
                                    << QByteArrayList{"delivered", "bit errors"};
    }
    void accountsForEveryPacket() {
        QFETCH(QByteArray, medium);
        QFETCH(QByteArrayList, outcomes);
        const Outcome done = run(kHead + medium + kMotes);
        QVERIFY2(done.code == 0, shown(done));
        const QStringList robots = m_robots.keys();
        QCOMPARE(robots.size(), 9);

        QMap<QByteArray, QMap<QByteArray, int>> outcomeAt; // counts by receiver
        QMap<QByteArray, int> of;
        QMap<QByteArray, int> rowsFrom;
        for (const Row& row : rowsOf(file("frames.csv"))) {
            QCOMPARE(row["kind"], QByteArray("data"));
            ++outcomeAt[row["to"]][row["fate"]];
            ++of[row["fate"]];
            ++rowsFrom[row["from"]];
        }
        for (const QByteArray& outcome : outcomes) QVERIFY2(of.value(outcome) > 0, outcome);

        // One row for each frame and each other radio; frames still being sent at the end have no row yet.
        const QList<Captured> frames = capture(contentOf(file("frames.pcap")));
        double allSent = 0;
        for (const QString& robot : robots) allSent += counted(robot, "sent");
        QVERIFY(allSent > 400);
        QCOMPARE(double(frames.size()), allSent);
        QMap<double, int> ended; // finished frames, by sender address
        for (const Captured& frame : frames) ended[frame.sender()] += frame.end() <= 2;
        const int receivers = outcomeAt.contains("far/radio") ? 8 : 7; // a receiver out of range of all senders has no rows
        for (const QString& robot : robots) {
            const int rows = rowsFrom.value(robot.toUtf8() + "/radio"), sent = ended.value(counted(robot, "address"));
            QVERIFY2(rows == receivers * sent || (robot == "far" && rows == 0),
                     qPrintable(QString("%1: %2 rows of %3 frames").arg(robot).arg(rows).arg(sent)));
        }

        for (const QString& robot : robots) {
            const QByteArray radio = robot.toUtf8() + "/radio";
            QCOMPARE(double(outcomeAt[radio].value("delivered")), counted(robot, "received"));
            QCOMPARE(double(outcomeAt[radio].value("buffer full")), counted(robot, "dropped"));
        }
        QCOMPARE(counted("deaf", "received"), 2.); // a full buffer drops the newest frames, not the oldest
        QCOMPARE(counted("deaf", "pending"), 2.);
        QVERIFY(counted("deaf", "dropped") > 10);
        QCOMPARE(counted("far", "received"), 0.);
    }

    void aRowAddsUp() {
        const Outcome done =
            run(kHead + "RadioMedium air { Model=log_distance Exponent=2.5 Shadowing=3 Mac=csma Collisions=true }\n" + kMotes);
        QVERIFY2(done.code == 0, shown(done));
        const QList<Row> rows = rowsOf(file("frames.csv"));
        QVERIFY(rows.size() > 1000);
        for (const Row& row : rows) {
            const double sum = number(row, "output power [dBm]") + number(row, "send gain [dBi]") +
                               number(row, "receive gain [dBi]") - number(row, "path loss [dB]") - number(row, "shadowing [dB]") -
                               number(row, "wall loss [dB]");
            const double power = number(row, "received power [dBm]");
            QVERIFY2(std::abs(sum - power) < 0.004, row["time [s]"]);
            QVERIFY2(std::abs(number(row, "RSSI [dBm]") - std::min(power, 0.)) <= 0.5005, row["time [s]"]);
            QCOMPARE(row["fate"] == "too weak", power < -94);
        }
    }

    void theCaptureReadsBack() {
        const Outcome done = run(kHead + "RadioMedium air { Mac=csma Collisions=true }\n" + kMotes);
        QVERIFY2(done.code == 0, shown(done));
        const QList<Captured> frames = capture(contentOf(file("frames.pcap")));
        QVERIFY(frames.size() > 400);
        QMap<quint16, QList<quint8>> sequences;
        double last = 0;
        for (const Captured& frame : frames) {
            QVERIFY(frame.time >= last);
            last = frame.time;
            QCOMPARE(checked(frame.bytes), quint16(0));
            QVERIFY(!frame.isAck()); // beacons are broadcast
            QCOMPARE(frame.bytes.size(), qsizetype(17));
            QCOMPARE(qFromLittleEndian<quint16>(frame.bytes.constData()), quint16(0x8841)); // data, short addresses
            QCOMPARE(qFromLittleEndian<quint16>(frame.bytes.constData() + 5), quint16(0xffff));
            QCOMPARE(quint8(frame.bytes[9]), quint8(0xb1)); // beacon of a mote
            sequences[qFromLittleEndian<quint16>(frame.bytes.constData() + 7)] << quint8(frame.bytes[2]);
        }
        QCOMPARE(sequences.size(), 8);               // all but deaf: it sends nothing
        for (const QList<quint8>& ofOne : sequences) // gaps: frames not sent because the channel was never clear
            for (qsizetype i = 1; i < ofOne.size(); ++i) QVERIFY(quint8(ofOne[i] - ofOne[i - 1]) - 1u < 9u);
    }

    /// Logs of some robots: the capture has what they send and receive, the table also what they do not receive, the matrix the
    /// links between them.
    void logsOfSomeRobots() {
        const Outcome done = run(kHead + "RadioMedium air { Mac=csma Collisions=true }\n" +
                                 QByteArray(kMotes).replace("Robot far {", "Robot far { radio.MinReceivePower=-80") +
                                 "RadioLog few { Robot=target }\nRadioLog heard { Robot=target Format=pcap File=few.pcap }\n"
                                 "LinkMatrix three { Robot=target,deaf,far Interval=1 }\n");
        QVERIFY2(done.code == 0, shown(done));
        const QList<Captured> all = capture(contentOf(file("frames.pcap"))), few = capture(contentOf(file("few.pcap")));
        using Frame = std::pair<qint64, int>; // start in us, sequence number
        QSet<Frame> captured, expected;
        for (const Captured& frame : few) captured << Frame{std::llround(frame.time * 1e6), quint8(frame.bytes[2])};
        const QByteArrayList received{"delivered", "not for it", "buffer full", "duplicate"};
        qsizetype fromOthers = 0;
        for (const Row& row : rowsOf(file("frames.csv"))) {
            const bool ofOther = row["to"] == "target/radio" && received.contains(row["fate"]);
            fromOthers += ofOther;
            if (ofOther || row["from"] == "target/radio")
                expected << Frame{std::llround(number(row, "time [s]") * 1e6), row["sequence"].toInt()};
        }
        QVERIFY(fromOthers > 20 && captured.size() - fromOthers > 20 && few.size() < all.size());
        QCOMPARE(captured, expected);

        qsizetype ofTarget = 0, sent = 0;
        for (const Row& row : rowsOf(file("frames.csv")))
            ofTarget += row["from"] == "target/radio" || row["to"] == "target/radio";
        const QList<Row> rows = rowsOf(file("few.csv"));
        for (const Row& row : rows) {
            QVERIFY(row["from"] == "target/radio" || row["to"] == "target/radio");
            sent += row["from"] == "target/radio";
        }
        QCOMPARE(rows.size(), ofTarget);
        QVERIFY(sent > 0 && sent < rows.size());

        const QList<Row> links = rowsOf(file("three.csv"));
        QCOMPARE(links.size(), qsizetype(3 * 2 * 3)); // at 0, 1 and 2 s
        for (const Row& row : links)                  // what a link has to spare is up to its receiver
            QVERIFY2(std::abs(number(row, "margin [dB]") - number(row, "received power [dBm]") -
                              (row["to"] == "far/radio" ? 80 : 94)) < 0.002,
                     row["from"] + " " + row["to"]);
    }

    void aLinkMatrixHasEveryLinkTermByTerm() {
        const Outcome done = run(kHead + "RadioMedium air { }\n" + kMotes + "PoseLog path { Interval=1 }\n");
        QVERIFY2(done.code == 0, shown(done));
        const QList<Row> rows = rowsOf(file("links.csv"));
        QCOMPARE(rows.size(), qsizetype(9 * 8 * 3)); // at 0, 1 and 2 s
        QMap<QByteArray, double> powers;
        for (const Row& row : rows) {
            if (row["time [s]"] != "0") continue;
            powers[row["from"] + ">" + row["to"]] = number(row, "received power [dBm]");
            const double loss = 20 * std::log10(4 * M_PI * number(row, "distance [m]") * 2.45e9 / 299792458.);
            QVERIFY2(std::abs(number(row, "path loss [dB]") - loss) < 0.01, row["from"] + " " + row["to"]);
            QVERIFY(std::abs(number(row, "margin [dB]") - number(row, "received power [dBm]") - 94) < 0.002);
        }
        for (auto it = powers.cbegin(); it != powers.cend(); ++it) {
            const QByteArrayList ends = it.key().split('>');
            QCOMPARE(powers.value(ends[1] + ">" + ends[0]), it.value());
        }
        // Inverted F antennas: one is seen from the front, 10 log10(1.5), the other from the side, where 0.3 of the power
        // is missing.
        const double ahead =
            -(20 * std::log10(4 * M_PI * 720 * 2.45e9 / 299792458.)) + 10 * std::log10(1.5) + 10 * std::log10(1.5 * 0.7);
        QVERIFY(std::abs(powers["target/radio>far/radio"] - ahead) < 0.01);
    }
};

QTEST_GUILESS_MAIN(RadioLogsTest)
#include "radio_logs_test.moc"
