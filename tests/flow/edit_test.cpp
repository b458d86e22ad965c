// trundle-cli edit: changes only the characters of the value, in the file that it belongs to.
#include <future>

#include "flow/cli.h"

class EditTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    /// Works on copies of the configs, so that edits do not write to the source tree.
    QString copied(const QString& name) {
        for (const QString& path : allConfigs()) {
            const QString to = m_folder.filePath("configs/" + QDir(TRUNDLE_SOURCE_DIR "/configs").relativeFilePath(path));
            QDir().mkpath(QFileInfo(to).path());
            QFile::remove(to);
            QFile::copy(path, to);
        }
        return m_folder.filePath("configs/" + name);
    }

private Q_SLOTS:
    void anEditChangesOnlyTheValuesCharacters();
    void anEditOfAConfigIsWrittenIntoTheFileThatOwnsIt();
    void withoutWriteNothingIsWritten();
    void aNewOverrideIsAddedToTheInstance();
    void awrongPathChangesNothing();
    void commentsBetweenElementsStay();
    void aValueThatBreaksAnotherIsRefused();
    void concurrentEditsAllSurvive();
};

/// Two concurrent edits, sixty times: of the same file, and of a file that both import.
void EditTest::concurrentEditsAllSurvive() {
    const QString path = copied("experiments/linear_motion.sim"), owner = m_folder.filePath("configs/robots/simple_robot.sim");
    for (int i = 0; i < 60; ++i) {
        const QByteArray distance = "Distance=" + QByteArray::number(2 + i),
                         resistance = "Resistance=" + QByteArray::number(3 + i);
        const QStringList first{"edit", path, "--set", "robot0.brain." + distance, "--write"};
        const QStringList second{"edit",   path,
                                 "--set",  "Duration=" + QString::number(100 + i),
                                 "--set",  "RobotConfig.SimpleRobot.leftMotor." + resistance,
                                 "--write"};
        auto running = std::async(std::launch::async, [&] { return cli(first); });
        const Outcome two = cli(second), one = running.get();
        QVERIFY2(one.code == 0 && two.code == 0, shown(one) + shown(two));
        const QByteArray text = contentOf(path);
        QVERIFY2(text.contains(distance) && text.contains("Duration = " + QByteArray::number(100 + i)), text);
        QVERIFY2(contentOf(owner).contains(resistance), contentOf(owner));
    }
    QCOMPARE(QDir(QFileInfo(path).path()).entryList({".trundle-*"}, QDir::Files | QDir::Hidden), QStringList());
}

void EditTest::anEditChangesOnlyTheValuesCharacters() {
    const QString path = copied("experiments/linear_motion.sim");
    const QByteArray before = contentOf(path);
    const Outcome edit = cli({"edit", path, "--set", "robot0.brain.Distance=2.5", "--write"});
    QVERIFY2(edit.code == 0, shown(edit));
    QByteArray expected = before;
    QCOMPARE(expected.count("Distance=1.0"), 1);
    expected.replace("Distance=1.0", "Distance=2.5");
    QCOMPARE(contentOf(path), expected);
}

void EditTest::anEditOfAConfigIsWrittenIntoTheFileThatOwnsIt() {
    const QString path = copied("experiments/linear_motion.sim");
    const QByteArray before = contentOf(path);
    const QString owner = m_folder.filePath("configs/robots/simple_robot.sim");
    QByteArray expected = contentOf(owner);
    const qsizetype at = expected.indexOf("Resistance=2");
    expected.replace(at, 12, "Resistance=3");
    const Outcome edit = cli({"edit", path, "--set", "RobotConfig.SimpleRobot.leftMotor.Resistance=3", "--write"});
    QVERIFY2(edit.code == 0, shown(edit));
    QCOMPARE(contentOf(owner), expected);
    QCOMPARE(contentOf(path), before);
}

void EditTest::withoutWriteNothingIsWritten() {
    const QString path = copied("experiments/linear_motion.sim");
    const QByteArray before = contentOf(path);
    const Outcome edit = cli({"edit", path, "--set", "Duration=5"});
    QVERIFY2(edit.code == 0, shown(edit));
    QByteArray expected = before;
    expected.replace("Duration = 12", "Duration = 5");
    QCOMPARE(edit.out, expected);
    QCOMPARE(contentOf(path), before);
}

void EditTest::aNewOverrideIsAddedToTheInstance() {
    const QString path = copied("experiments/linear_motion.sim");
    const Outcome edit = cli({"edit", path, "--set", "robot0.leftMotor.Resistance=3", "--write"});
    QVERIFY2(edit.code == 0, shown(edit));
    QVERIFY2(contentOf(path).contains("leftMotor.Resistance"), contentOf(path));
    const Outcome check = cli({"check", path});
    QVERIFY2(check.code == 0, shown(check));
}

void EditTest::awrongPathChangesNothing() {
    const QString path = copied("experiments/linear_motion.sim");
    const QByteArray before = contentOf(path);
    const Outcome edit = cli({"edit", path, "--set", "robot0.leftMoter.Resistance=3", "--write"});
    QVERIFY2(edit.code == 1, shown(edit));
    QVERIFY2(edit.err.contains("leftMotor"), shown(edit));
    QCOMPARE(contentOf(path), before);
}

void EditTest::commentsBetweenElementsStay() {
    const QString path = m_folder.filePath("commented.sim");
    const QByteArray text = "Gravity = 0, // along\n  0, /* across */ -9.81 // down\nRegion goal { Pos=1, // ahead\n  2, 3 Size=1,1,1 } // end\n"
                            "Param list = 1, // first\n  2\n";
    QVERIFY(writeFile(path, text));
    const Outcome edit = cli({"edit", path, "--set", "goal.Pos=4,5,6", "--set", "Gravity=0,0,-1.62", "--set", "list=7,8", "--write"});
    QVERIFY2(edit.code == 0, shown(edit));
    QCOMPARE(contentOf(path), QByteArray(text).replace("-9.81", "-1.62").replace("Pos=1, // ahead\n  2, 3", "Pos=4, // ahead\n  5, 6")
                                  .replace("list = 1, // first\n  2", "list = 7, // first\n  8"));
}

/// Fewer members than another value needs.
void EditTest::aValueThatBreaksAnotherIsRefused() {
    const QString path = m_folder.filePath("row.sim");
    const QByteArray text = "#import common/materials.sim\n#import common/surfaces.sim\nRobotConfig Kit { Body b { Repeat o { Count=3 "
                            "Pos=$index,0,0 Sphere s { Radius=0.1 Mass=0.1 Material=red Surface=rubber } } } }\n"
                            "Robot a { Config=Kit b.o_1.s.Mass=0.2 }\n";
    QVERIFY(writeFile(path, text));
    const Outcome edit = cli({"edit", path, "--set", "a.b.o.Count=1", "--write"});
    QVERIFY2(edit.code == 1 && edit.err.contains("error E314: Repeat o has no member o_1") && edit.err.contains("nothing is changed"),
             shown(edit));
    QCOMPARE(contentOf(path), text);
    // What has errors already can be edited.
    QVERIFY(writeFile(path, QByteArray(text).replace("o_1", "o_7")));
    QCOMPARE(cli({"edit", path, "--set", "RobotConfig.Kit.b.o.s.Mass=0.3", "--write"}).code, 0);
    QVERIFY(contentOf(path).contains("Mass=0.3"));
}

QTEST_GUILESS_MAIN(EditTest)
#include "edit_test.moc"
