// Arenas as files: what is written, and that a failure leaves nothing behind.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/arena_files.h"

using namespace trundle;

namespace {

const std::array<double, 3> kSize{4, 3, 0.5}; // m

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
}

std::string messageOf(const Result<NewArena>& made) { return made ? std::string() : made.error().message; }

} // namespace

class ArenaFilesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    const QByteArray m_picture = "P2 3 2 255\n0 10 20\n30 40 50\n";

    QString at(const QString& name) const { return m_folder.filePath(name); }
    std::string drawn(const QString& name) {
        QFile file(at(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(m_picture) != m_picture.size()) qFatal("cannot write");
        return file.fileName().toStdString();
    }

private Q_SLOTS:
    void aGroundBringsItsPicture() {
        const Result<NewArena> made =
            makeHeightsArena("Hills", drawn("grey.pgm"), kSize, m_folder.path().toStdString(), findLocations());
        QVERIFY2(made.ok(), messageOf(made).c_str());
        QCOMPARE(made.value().files, (std::vector<std::string>{"hills.sim", "hills_drive.sim", "grey.pgm"}));
        QCOMPARE(made.value().experiment, at("hills/hills_drive.sim").toStdString());
        QCOMPARE(contentOf(at("hills/grey.pgm")), m_picture);
        const QByteArray text = contentOf(at("hills/hills.sim"));
        QVERIFY2(text.contains("grey.pgm"), text);
        const Result<NewArena> again =
            makeHeightsArena("Hills", drawn("other.pgm"), kSize, m_folder.path().toStdString(), findLocations());
        QVERIFY2(messageOf(again).find("it exists") != std::string::npos, messageOf(again).c_str());
        QCOMPARE(contentOf(at("hills/hills.sim")), text); // the first one is whole
        QCOMPARE(QDir(at("hills")).entryList(QDir::Files).size(), 3);
    }

    /// The view is from as far as the longer side of the arena is, and the robot where it is free.
    void theViewShowsTheLongerSide_data() {
        QTest::addColumn<double>("length"); // m, along x
        QTest::addColumn<double>("width");
        QTest::addColumn<QByteArray>("eye");
        QTest::newRow("along x") << 8. << 4. << QByteArray("Eye=-0.8,-5.6,7.2 ");
        QTest::newRow("along y") << 4. << 10. << QByteArray("Eye=-1,-7,9 ");
        QTest::newRow("small") << 1.2 << 1. << QByteArray("Eye=-0.15,-1.05,1.35 ");
    }
    void theViewShowsTheLongerSide() {
        QFETCH(double, length);
        QFETCH(double, width);
        QFETCH(QByteArray, eye);
        const QTemporaryDir folder;
        const std::string parent = folder.path().toStdString();
        const auto check = [&](const Result<NewArena>& made, const QByteArray& robot) {
            QVERIFY2(made.ok(), messageOf(made).c_str());
            const QByteArray text = contentOf(QString::fromStdString(made.value().experiment));
            QVERIFY2(text.contains(eye) && text.contains("Robot robot0 { Config=SimpleRobot Pos=" + robot), text);
        };
        FloorPlan plan;
        plan.cell = 0.1;
        plan.columns = static_cast<std::uint32_t>(std::lround(length / plan.cell));
        plan.rows = static_cast<std::uint32_t>(std::lround(width / plan.cell));
        plan.walls = {{0, 0, 1, 2}};
        plan.freest = {0.3, -0.2};
        plan.room = 0.3;
        check(makePlanArena("Plan", plan, 0.5, "plan.png", parent), "0.3,-0.2,0 ");
        ObstacleField field;
        field.length = length;
        field.width = width;
        field.count = 0;
        if (const Result<NewArena> made = makeObstacleArena("Field", field, parent)) check(made, "0,0,0 ");
        RoomPlan room;
        room.length = length;
        room.width = width;
        room.startX = -0.4;
        room.startY = 0.1;
        room.walls = {{"north", 0, width / 2, length, 0.1}};
        check(makeRoomArena("Room", room, "a room", parent), "-0.4,0.1,0 ");
        QVERIFY(drawn("slope.pgm") == at("slope.pgm").toStdString());
        check(makeHeightsArena("Slope", at("slope.pgm").toStdString(), {length, width, 0.5}, parent, findLocations()), "0,0,");
    }

    void wallsHaveAHeightAndRoom() {
        const QTemporaryDir folder;
        FloorPlan plan;
        plan.cell = 0.1;
        plan.columns = plan.rows = 30;
        plan.walls = {{0, 0, 1, 2}};
        int number = 0;
        const auto makes = [&](double height, double room) {
            plan.room = room;
            return makePlanArena("Plan" + std::to_string(number++), plan, height, "plan.png", folder.path().toStdString()).ok();
        };
        QVERIFY(makes(0.01, 0.26) && makes(100, 0.26));
        QVERIFY(!makes(0.0099, 0.26) && !makes(100.1, 0.26) && !makes(std::nan(""), 0.26));
        QVERIFY(!makes(0.5, 0.24));
    }

    /// A path may have 4095 bytes: here the texts have room and the picture, with its long name, has none.
    void aPictureThatCannotBeCopiedLeavesNothing() {
        const std::string picture = drawn(QString(240, 'p') + ".pgm");
        QString parent = m_folder.path();
        while (parent.size() < 3900) parent += "/" + QString(std::min<qsizetype>(200, 3900 - parent.size()), 'd');
        QVERIFY(QDir().mkpath(parent));
        const auto make = [&](const std::string& from) {
            return makeHeightsArena("Dunes", from, kSize, parent.toStdString(), findLocations());
        };
        const Result<NewArena> failed = make(picture);
        QCOMPARE(failed.ok() ? Code::OutOfRange : failed.error().code, Code::FileUnwritable);
        QVERIFY2(messageOf(failed).find("cannot be copied") != std::string::npos, messageOf(failed).c_str());
        QVERIFY(QDir(parent).isEmpty());
        const Result<NewArena> made = make(drawn("short.pgm")); // the name is free
        QVERIFY2(made.ok(), messageOf(made).c_str());
        QCOMPARE(QDir(parent + "/dunes").entryList(QDir::Files), (QStringList{"dunes.sim", "dunes_drive.sim", "short.pgm"}));
    }

    void aPictureThatCannotBeReadLeavesNothing() {
        const std::string parent = m_folder.path().toStdString();
        const auto fails = [&](const std::string& name, const std::string& picture) {
            return !makeHeightsArena(name, picture, kSize, parent, findLocations()).ok();
        };
        QVERIFY(fails("Lost", at("none.pgm").toStdString()));
        QVERIFY(fails("No name", drawn("fine.pgm")));
        QVERIFY(!makeHeightsArena("Lost", drawn("fine.pgm"), kSize, parent + "/none", findLocations()).ok());
        for (const char* name : {"lost", "no name", "none"}) QVERIFY(!QDir(at(name)).exists());
    }
};

QTEST_APPLESS_MAIN(ArenaFilesTest)
#include "arena_files_test.moc"
