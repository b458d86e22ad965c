// Kills a program that edits and saves at random moments: recovery loses at most the edits of the last two seconds.

#include <QTest>

#include <memory>
#include <random>
#include <thread>

#include <QElapsedTimer>
#include <QProcess>

#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

/// The number in "Seed = 12
/// ...// end 12
/// "; -1 if the text is incomplete.
int numberOf(const std::string& text) {
    if (!text.starts_with("Seed = ")) return -1;
    const int number = std::atoi(text.c_str() + 7);
    const std::string end = "// end " + std::to_string(number) + "\n";
    std::size_t lines = 0;
    const std::string line = "// " + std::to_string(number) + " is the number of the edit\n";
    for (std::size_t at = text.find('\n') + 1; at < text.size(); at += line.size(), ++lines)
        if (text.compare(at, line.size(), line) != 0) return text.substr(at) == end ? number : -1;
    return -1;
}

struct Edit {
    int number = 0;
    qint64 at = 0;         ///< ms after the program was ready
    std::size_t texts = 0; ///< hash of all texts, if printed
};

/// What the program printed until it was killed.
struct Heard {
    std::vector<Edit> edits;
    int saved = 0;
    qint64 killedAt = 0; ///< ms after the program was ready

    /// The newest edit that is at least two seconds old.
    [[nodiscard]] int old() const {
        int number = 0;
        for (const Edit& edit : edits)
            if (edit.at + 2000 <= killedAt) number = edit.number;
        return number;
    }
};

/// One program that is killed.
struct Round {
    int seed = 0, afterMs = 0;
    QStringList how = {}; ///< that the program edits
    DocumentFixture fixture = {};
    Heard heard = {};
    QString fault = {}; ///< of the test
};
using Rounds = std::vector<std::unique_ptr<Round>>;

void take(QProcess& program, qint64 now, Heard& heard) {
    while (program.canReadLine()) {
        const QByteArray line = program.readLine();
        const QList<QByteArray> words = line.trimmed().split(' ');
        if (words[0] == "edit") heard.edits.push_back({words[1].toInt(), now, words.value(2).toULongLong()});
        if (words[0] == "saved") heard.saved = words[1].toInt();
    }
}

void editUntilKilled(Round& round) {
    QProcess program;
    program.start(QString::fromUtf8(TRUNDLE_BINARY_DIR "/tests/edit_and_save"),
                  QStringList{QString::fromStdString(round.fixture.main), QString::number(round.seed)} + round.how);
    if (!program.waitForStarted()) return void(round.fault = u"not started"_qs);
    while (!program.canReadLine() && program.waitForReadyRead(10000)) continue;
    if (program.readLine() != "ready\n") round.fault = u"not ready"_qs;
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < round.afterMs && program.state() == QProcess::Running) {
        program.waitForReadyRead(static_cast<int>(std::max<qint64>(1, round.afterMs - clock.elapsed())));
        take(program, clock.elapsed(), round.heard);
    }
    round.heard.killedAt = clock.elapsed();
    program.kill();
    if (!program.waitForFinished() || program.exitStatus() != QProcess::CrashExit) round.fault = u"not killed"_qs;
    take(program, round.heard.killedAt, round.heard);
}

/// The programs do little, and wait: many at a time.
void editUntilKilled(const Rounds& rounds) {
    constexpr std::size_t kTogether = 20;
    for (std::size_t begin = 0; begin < rounds.size(); begin += kTogether) {
        std::vector<std::jthread> threads;
        for (std::size_t i = begin; i < std::min(rounds.size(), begin + kTogether); ++i)
            threads.emplace_back([&round = *rounds[i]] { editUntilKilled(round); });
    }
}

/// As printed by the program.
std::size_t hashOf(const Document& document) {
    std::string all;
    for (const std::string& file : document.texts().files()) all += *document.texts().text(file) + '\0';
    return std::hash<std::string>()(all);
}

const std::string kWalls = "StaticConfig Wall { Box b { Size=1,1,1 Pos=0,0,0.5 } }\n"
                           "Static a { Config=Wall }\nStatic b { Config=Wall Pos=3,0,0 }\n";

const std::string kCart =
    "PartConfig Wheel { Param r = 0.05 { Min=0.01 Max=1 } Body wheel { Sphere tyre { Radius=$r Mass=0.1 } } Hinge axle { "
    "Parent=$on Child=wheel Axis=0,1,0 } }\n"
    "RobotConfig Cart { Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.06 Mass=2 } }\n"
    "  Part left { Config=Wheel In=chassis Pos=0,0.1,0 on=chassis } Part right { Config=Wheel In=chassis Pos=0,-0.1,0 "
    "Mirror=y "
    "on=chassis }\n  Ring bolt { Count=3 Radius=0.05 Body head { Sphere s { Radius=0.01 Mass=0.01 } } Fixed nail { "
    "Parent=chassis Child=head } }\n  Latch magnet { Body=chassis } }\nRobotConfig Tall { Config=Cart left.r=0.06 }\n";

void writeConfigs(const DocumentFixture& fixture) {
    fixture.write("configs/robots/cart.sim", kCart);
    fixture.write("configs/main.sim", "#import robots/rover.sim\n#import robots/cart.sim\nRobot robot0 { Config=Rover }\n"
                                      "Robot robot1 { Config=Cart Pos=1,0,0 }\nNoContact = robot0,robot1\n"
                                      "Repeat row { Count=2 Pos=$(2 + index),0,0 Robot tall { Config=Tall } Region goal { "
                                      "Size=1,1,1 Robots=tall } }\n"
                                      "Spring rope { Parent=robot0.chassis Child=row_1.tall.left.wheel Stiffness=1 }\n");
}

} // namespace

class CrashTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    void crashLosesLittle() {
        const int kills = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 200 : 20;
        std::mt19937 random(11);
        int offered = 0;
        for (const auto& round : killed(kills, [&](Round& r) {
                 r.seed = static_cast<int>(random() & 0xffff);
                 r.afterMs = static_cast<int>(random() % 2500);
                 r.fixture.write("configs/main.sim", "Seed = 0\n// end 0\n");
             })) {
            checkNumbers(*round, offered);
            if (QTest::currentTestFailed()) return;
        }
        QVERIFY2(offered >= kills / 4, qPrintable(QString::number(offered))); // many kills hit unsaved work
    }

    /// Group into Piece, saved, undone, redone: the experiment and the file that it creates appear and disappear together.
    void aPieceIsThereWithItsExperimentOrNotAtAll() {
        const int kills = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 100 : 10;
        std::mt19937 random(5);
        int offered = 0, removed = 0;
        for (int i = 0; i == 0 || (offered < kills / 4 && i < 4); ++i) // on a busy machine fewer hit unsaved work
            for (const auto& round : killed(kills, [&](Round& r) {
                     r.seed = static_cast<int>(random() & 0xffff);
                     r.afterMs = static_cast<int>(600 + random() % 2500);
                     r.how = {u"pieces"_qs};
                     r.fixture.write("configs/main.sim", kWalls);
                 })) {
                checkPieces(*round, offered, removed);
                if (QTest::currentTestFailed()) return;
            }
        QVERIFY2(offered >= kills / 4 && removed > 0, qPrintable(QStringLiteral("%1, %2").arg(offered).arg(removed)));
    }

    /// A config changed for all, and a copy of another one made for this experiment: after a kill all texts are those of one moment.
    void bothChoicesForSharedConfigsSurvive() {
        const int kills = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 100 : 8;
        std::mt19937 random(7);
        int offered = 0, copied = 0, changedForAll = 0;
        for (const auto& round : killed(kills, [&](Round& r) {
                 r.seed = static_cast<int>(random() & 0xffff);
                 r.afterMs = static_cast<int>(1500 + random() % 3000);
                 r.how = {u"configs"_qs};
                 writeConfigs(r.fixture);
             })) {
            checkConfigs(*round, offered, copied, changedForAll);
            if (QTest::currentTestFailed()) return;
        }
        const QString counts = QStringLiteral("%1, %2, %3").arg(offered).arg(copied).arg(changedForAll);
        QVERIFY2(offered >= kills / 4 && copied > 0 && changedForAll > 0, qPrintable(counts));
    }

private:
    template <class Prepare> static Rounds killed(int count, Prepare prepare) {
        Rounds rounds;
        for (int i = 0; i < count; ++i) prepare(*rounds.emplace_back(std::make_unique<Round>()));
        editUntilKilled(rounds);
        return rounds;
    }

    /// Opens the experiment after the kill and restores its journal, if one is offered.
    static void restore(Document& document, const DocumentFixture& fixture, bool& isOffered) {
        QVERIFY(document.opening().open(fixture.main).ok());
        const std::vector<Recovery> found = document.recovery().recoveries();
        QVERIFY(found.size() <= 1);
        isOffered = !found.empty();
        if (isOffered) QCOMPARE(why(document.recovery().recover(found[0])), "");
        QVERIFY2(!document.loaded()->diagnostics.hasErrors(), messages(*document.loaded()).c_str());
    }

    void checkConfigs(const Round& round, int& offered, int& copied, int& changedForAll) {
        QCOMPARE(round.fault, QString());
        const DocumentFixture& fixture = round.fixture;
        const Heard& heard = round.heard;
        Document document(*m_application);
        bool isOffered = false;
        restore(document, fixture, isOffered);
        if (QTest::currentTestFailed()) return;
        offered += isOffered;
        int kept = -1;
        for (const Edit& edit : heard.edits)
            if (edit.texts == hashOf(document)) kept = edit.number;
        const int old = heard.old();
        QVERIFY2(kept >= old, qPrintable(QStringLiteral("edit %1 of two seconds before is lost, %2 is kept").arg(old).arg(kept)));
        QCOMPARE(why(document.saving().save()), "");
        QCOMPARE(bytesOf(fixture.path("configs/robots/cart.sim")), kCart); // its instance has a copy
        copied += holds(bytesOf(fixture.main), "RobotConfig Cart2");
        changedForAll += bytesOf(fixture.robot) != kRover;
    }

    void checkPieces(const Round& round, int& offered, int& removed) {
        QCOMPARE(round.fault, QString());
        const DocumentFixture& fixture = round.fixture;
        const std::string piece = fixture.path("configs/objects/piece.sim");
        const bool wasThere = std::filesystem::exists(piece);
        Document document(*m_application);
        bool isOffered = false;
        restore(document, fixture, isOffered);
        if (QTest::currentTestFailed()) return;
        offered += isOffered;
        QCOMPARE(why(document.saving().save()), "");
        const bool isGrouped = bytesOf(fixture.main) != kWalls;
        QVERIFY(!isGrouped || holds(bytesOf(piece), "StaticConfig Piece"));
        QVERIFY(!std::filesystem::exists(piece) || holds(bytesOf(piece), "StaticConfig Piece")); // never an empty file
        if (isOffered) QCOMPARE(std::filesystem::exists(piece), isGrouped);
        removed += wasThere && !std::filesystem::exists(piece);
    }

    void checkNumbers(const Round& round, int& offered) {
        QCOMPARE(round.fault, QString());
        const DocumentFixture& fixture = round.fixture;
        const Heard& heard = round.heard;
        const int onDisk = numberOf(bytesOf(fixture.main));
        QVERIFY2(onDisk >= heard.saved, "the file is torn, or a save is lost");
        const int old = heard.old();

        Document document(*m_application);
        QVERIFY(document.opening().open(fixture.main).ok());
        QVERIFY(!document.access().isReadOnly()); // the lock of a killed process is not valid
        const std::vector<Recovery> found = document.recovery().recoveries();
        QVERIFY(found.size() <= 1);
        int kept = onDisk;
        if (!found.empty()) {
            ++offered;
            const std::string text = found[0].files.at(fixture.main).text;
            QVERIFY2(numberOf(text) >= 0, "the journal is torn");
            QVERIFY(document.recovery().recover(found[0]).ok());
            kept = std::max(kept, numberOf(text));
        }
        QVERIFY2(kept >= old, qPrintable(QStringLiteral("edit %1 of two seconds before is lost, %2 is kept").arg(old).arg(kept)));
    }

    std::unique_ptr<Application> m_application;
};

QTEST_GUILESS_MAIN(CrashTest)
#include "crash_test.moc"
