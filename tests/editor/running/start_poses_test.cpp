// The values that make robots start where they are: of those alone that moved or turned.
#include <QtTest>

#include "editor/running/session_fixture.h"
#include "editor/running/start_poses.h"

using namespace trundle;

class StartPosesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void onlyWhatMovedOrTurnedIsWritten_data() {
        QTest::addColumn<Vec3>("by");  // m
        QTest::addColumn<Vec3>("hpr"); // degrees
        QTest::addColumn<QString>("expected");
        const Vec3 none = Vec3::Zero();
        QTest::newRow("nothing") << none << none << QString();
        QTest::newRow("sunk into the floor") << Vec3(0, 0, -3.9e-5) << Vec3(0, 0.0026, 0) << QString();
        QTest::newRow("almost moved") << Vec3(9.9e-5, 0, 0) << Vec3(0.0099, 0, 0) << QString();
        QTest::newRow("moved") << Vec3(0, 0.25, 0) << none << "Pos=1,2.25,0 HPR=0,0,0";
        QTest::newRow("moved a little") << Vec3(0, 1.01e-4, 0) << none << "Pos=1,2.000101,0 HPR=0,0,0";
        QTest::newRow("turned") << none << Vec3(90, 0, 0) << "Pos=1,2,0 HPR=90,0,0";
        QTest::newRow("turned a little") << none << Vec3(0.0101, 0, 0) << "Pos=1,2,0 HPR=0.0101,0,0";
        QTest::newRow("fallen over") << none << Vec3(0, 0, 90) << "Pos=1,2,0 HPR=0,0,90";
        QTest::newRow("both") << Vec3(1, 0, 0.5) << Vec3(0, 30, 0) << "Pos=2,2,0.5 HPR=0,30,0";
    }
    void onlyWhatMovedOrTurnedIsWritten() {
        QFETCH(Vec3, by);
        QFETCH(Vec3, hpr);
        QFETCH(QString, expected);
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot).replace("SimpleRobot Pos=0,0,0", "SimpleRobot Pos=1,2,0")));
        const StartPoses found = startPoses(*o.document.loaded(), [&](const std::string& robot) -> std::optional<Pose> {
            if (robot != "robot0") return std::nullopt;
            return Pose{Vec3(1, 2, 0) + by, rotationFromHpr(hpr * (std::acos(-1.0) / 180))};
        });
        QCOMPARE(found.values.empty(), expected.isEmpty());
        if (!expected.isEmpty()) QVERIFY(o.document.structure().setValues(QStringLiteral("Keep"), found.values).ok());
        const std::string file = o.document.texts().files().front();
        const std::string text = *o.document.texts().text(file);
        const QString line = expected.isEmpty() ? QStringLiteral("Pos=1,2,0 HPR=0,0,0") : expected;
        QVERIFY2(text.find("SimpleRobot " + line.toStdString() + " }") != std::string::npos, text.c_str());
        QCOMPARE(found.refusal, expected.isEmpty() ? QStringLiteral("Every robot is at its start pose.") : QString());
    }

    /// Of the triples that mean the new rotation the one with the most written angles: pitch beyond 90 degrees, a roll beside a pitch
    /// of 90 degrees.
    void aTurnKeepsTheAnglesThatAreWritten_data() {
        QTest::addColumn<Vec3>("written"); // degrees
        QTest::addColumn<double>("by");    // degrees, about z
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("upright") << Vec3(0, 30, 20) << 10.0 << QByteArray("10,30,20");
        QTest::newRow("pitch beyond 90") << Vec3(0, 170, 0) << 10.0 << QByteArray("10,170,0");
        QTest::newRow("pitch of 90") << Vec3(0, 90, 30) << 20.0 << QByteArray("20,90,30");
        QTest::newRow("pitch of -90") << Vec3(0, -90, 30) << 20.0 << QByteArray("20,-90,30");
        QTest::newRow("more than half a turn") << Vec3(190, 15, 0) << 20.0 << QByteArray("-150,15,0");
        QTest::newRow("not turned") << Vec3(190, 170, 200) << 0.0 << QByteArray("190,170,200");
    }
    void aTurnKeepsTheAnglesThatAreWritten() {
        QFETCH(Vec3, written);
        QFETCH(double, by);
        QFETCH(QByteArray, expected);
        constexpr double kRadians = M_PI / 180;
        SessionFixture o;
        const QByteArray triple =
            QByteArray::number(written.x()) + ',' + QByteArray::number(written.y()) + ',' + QByteArray::number(written.z());
        QVERIFY(o.open(QByteArray(kStandingRobot).replace("HPR=0,0,0", "HPR=" + triple)));
        const Quat before = rotationFromHpr(written * kRadians);
        QVERIFY(o.document.loaded()->experiment->robots[0].pose.rotation.angularDistance(before) < 1e-9);
        const Quat now = (rotationFromHpr({by * kRadians, 0, 0}) * before).normalized();
        const StartPoses found = startPoses(*o.document.loaded(), [&](const std::string&) {
            return std::optional(Pose{Vec3(1, 0, 0), now});
        });
        QVERIFY(o.document.structure().setValues(QStringLiteral("Keep"), found.values).ok());
        const std::string text = *o.document.texts().text(o.document.texts().files().front());
        QVERIFY2(text.find("Pos=1,0,0 HPR=" + expected.toStdString() + " }") != std::string::npos, text.c_str());
        QVERIFY(o.document.loaded()->experiment->robots[0].pose.rotation.angularDistance(now) < 1e-6);
    }
};

QTEST_GUILESS_MAIN(StartPosesTest)
#include "start_poses_test.moc"
