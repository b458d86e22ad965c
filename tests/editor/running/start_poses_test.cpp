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
        QTest::newRow("less than a step") << Vec3(4e-7, 0, 0) << Vec3(4e-5, 0, 0) << QString();
        QTest::newRow("moved") << Vec3(0, 0.25, 0) << none << "Pos=1,2.25,0 HPR=0,0,0";
        QTest::newRow("moved a little") << Vec3(0, 2e-6, 0) << none << "Pos=1,2.000002,0 HPR=0,0,0";
        QTest::newRow("turned") << none << Vec3(90, 0, 0) << "Pos=1,2,0 HPR=90,0,0";
        QTest::newRow("turned a little") << none << Vec3(0.0002, 0, 0) << "Pos=1,2,0 HPR=0.0002,0,0";
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
};

QTEST_GUILESS_MAIN(StartPosesTest)
#include "start_poses_test.moc"
