// Search and rename in project files that the experiment does not load.

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "editor/text/two_balls.h"
#include "eventually.h"

using namespace trundle;
using namespace trundle::test;

namespace {

constexpr char kOther[] = "#import parts.sim\nRobot third { Config=Ball size=0.3 }\nRobot fourth { Config=Ball }\n";
constexpr char kOwnBall[] = "RobotConfig Ball { Body b { Sphere s { Radius=1 Mass=1 } } }\nRobot r { Config=Ball }\n";

/// TwoBalls, with more files in the project.
struct SearchedProject : TwoBalls {
    std::string other = write("other.sim", kOther), own = write("own.sim", kOwnBall);

    QStringList listed(const QString& words) {
        key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        auto* find = child<QLineEdit>("findText");
        find->clear();
        QTest::keyClicks(find, words);
        QStringList rows;
        auto* list = child<QTreeWidget>("foundList");
        for (int i = 0; i < list->topLevelItemCount(); ++i) rows << list->topLevelItem(i)->text(0);
        return rows;
    }
    [[nodiscard]] QByteArray onDisk(const std::string& file) const {
        QFile disk(QString::fromStdString(file));
        return disk.open(QIODevice::ReadOnly) ? disk.readAll() : QByteArray();
    }
};

} // namespace

class ProjectSearchTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void findsInTheProjectsFolder();
    void findsWhatIsNotSaved();
    void replacesInTheProject();
    void replaceAllLeavesWhatCameWithTheProgram();
    void renamesInOtherTexts_data();
    void renamesInOtherTexts();
    void aNameThatIsTakenElsewhereIsRefused();
    void whatCameWithTheProgramIsNotRenamed();
};

void ProjectSearchTest::findsInTheProjectsFolder() {
    SearchedProject w;
    QTemporaryDir outside;
    QFile secret(outside.filePath(QStringLiteral("secret.sim")));
    QVERIFY(secret.open(QIODevice::WriteOnly) && secret.write("// third\n") > 0);
    secret.close();
    QVERIFY(QFile::link(secret.fileName(), w.folder.filePath(QStringLiteral("link.sim"))));
    QVERIFY(QFile::link(outside.path(), w.folder.filePath(QStringLiteral("linked"))));
    for (const char* folder : {"logs", ".git", "controllers"}) QVERIFY(QDir(w.folder.path()).mkdir(QLatin1String(folder)));
    w.write("logs/run.txt", "third\n");
    w.write(".git/third.sim", "third\n");
    w.write(".hidden.sim", "third\n");
    w.write("picture.png", "third\n");
    w.write("binary.txt", QByteArray("third\0x\n", 8));
    w.write("controllers/walk.cpp", "// for third\n");
    w.write("large.sim", QByteArray(5 << 20, ' ') + "third");
    QCOMPARE(w.listed(QStringLiteral("third")),
             (QStringList{QStringLiteral("controllers/walk.cpp:1"), QStringLiteral("other.sim:2")}));
    QCOMPARE(w.child<QLabel>("foundTitle")->text(), QStringLiteral("2 found in 2 files; 1 larger file(s) not searched"));
    auto* list = w.child<QTreeWidget>("foundList");
    list->setCurrentItem(list->topLevelItem(1));
    QTest::keyClick(list, Qt::Key_Return); // opens the file in a tab
    QCOMPARE(w.page().file(), w.other);
    QCOMPARE(w.selected(), QByteArray("third"));
    QVERIFY(!w.document.texts().isModified());
    QTest::keyClick(list, Qt::Key_Home);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(w.page().edit().styling().language(), CodeLanguage::Cpp); // not part of the experiment
}

void ProjectSearchTest::findsWhatIsNotSaved() {
    SearchedProject w;
    w.panel.openFile(w.other);
    QVERIFY(w.document.edits().replaceText(QStringLiteral("Type"), w.other, "// fifth\n").ok());
    QCOMPARE(w.listed(QStringLiteral("fifth")), QStringList{QStringLiteral("other.sim:1")});
    QCOMPARE(w.listed(QStringLiteral("fourth")), QStringList()); // the file on disk still has it
    QCOMPARE(w.onDisk(w.other), QByteArray(kOther));
    QVERIFY(w.document.texts().isModified(w.other));
    QVERIFY(w.document.saving().save().ok());
    QCOMPARE(w.onDisk(w.other), QByteArray("// fifth\n"));
}

void ProjectSearchTest::replacesInTheProject() {
    SearchedProject w;
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("fourth"));
    w.child<QCheckBox>("findEverywhere")->click();
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("last"));
    QTest::mouseClick(w.child<QPushButton>("replaceAll"), Qt::LeftButton);
    QVERIFY(w.text(w.other).contains("Robot last {"));
    QCOMPARE(w.history(), QStringList{QStringLiteral("Replace All")});
    QCOMPARE(w.document.texts().modifiedFiles(), std::vector<std::string>{w.other});
    QVERIFY(w.panel.pageOf(w.other)); // each modified file has a tab
    w.document.edits().undo();
    QCOMPARE(w.text(w.other), QByteArray(kOther));
    QVERIFY(!w.document.texts().isModified());
}

/// It could not be saved, and nothing else with it.
void ProjectSearchTest::replaceAllLeavesWhatCameWithTheProgram() {
    SearchedProject w;
    const std::string drive = w.write("drive.sim", "#import robots/simple_robot.sim\nRobot r { Config=SimpleRobot }\n");
    w.open(drive);
    w.key(Qt::Key_H, Qt::ControlModifier);
    QTest::keyClicks(w.child<QLineEdit>("findText"), QStringLiteral("SimpleRobot"));
    w.child<QCheckBox>("findEverywhere")->click();
    QTest::keyClicks(w.child<QLineEdit>("replaceText"), QStringLiteral("Mine"));
    QTest::mouseClick(w.child<QPushButton>("replaceAll"), Qt::LeftButton);
    QVERIFY(w.text().contains("Config=Mine }"));
    QCOMPARE(w.document.texts().modifiedFiles(), std::vector<std::string>{drive});
    const QString said = w.child<QLabel>("findSaid")->text();
    QVERIFY2(said.startsWith(QStringLiteral("1 replaced; ")) && said.contains(QStringLiteral("read-only")), qPrintable(said));
    QVERIFY(w.document.saving().save().ok());
}

void ProjectSearchTest::renamesInOtherTexts_data() {
    QTest::addColumn<bool>("others");
    QTest::newRow("everywhere") << true;
    QTest::newRow("only what is loaded") << false;
}

void ProjectSearchTest::renamesInOtherTexts() {
    QFETCH(bool, others);
    SearchedProject w;
    w.caretAt("Ball size", 1);
    w.key(Qt::Key_F2);
    auto* name = w.child<QLineEdit>("renameText");
    auto* box = w.child<QCheckBox>("renameOthers");
    QVERIFY(name && box && box->isVisible() && box->isChecked());
    QCOMPARE(box->text(), QStringLiteral("Also in other.sim, which is not loaded (2)")); // own.sim has a Ball of its own
    QCOMPARE(box->toolTip(), QStringLiteral("other.sim: 2"));
    if (!others) box->click();
    EVENTUALLY(name->hasFocus());
    QTest::keyClicks(name, QStringLiteral("Sphere1"));
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(w.text(w.parts).contains("RobotConfig Sphere1 {"));
    QCOMPARE(w.text().count("Config=Sphere1"), 2);
    QCOMPARE(w.history(), QStringList{QStringLiteral("Rename Ball to Sphere1")});
    if (others) QCOMPARE(w.text(w.other), QByteArray(kOther).replace("Ball", "Sphere1"));
    else QVERIFY(w.text(w.other).isEmpty());
    QCOMPARE(w.onDisk(w.other), QByteArray(kOther));
    QVERIFY(w.document.saving().save().ok());
    QCOMPARE(w.onDisk(w.other), others ? QByteArray(kOther).replace("Ball", "Sphere1") : QByteArray(kOther));
    QCOMPARE(w.onDisk(w.own), QByteArray(kOwnBall));
    w.document.edits().undo();
    QCOMPARE(w.text(), QByteArray(kTwoBalls));
    if (others) QCOMPARE(w.text(w.other), QByteArray(kOther));
}

void ProjectSearchTest::aNameThatIsTakenElsewhereIsRefused() {
    SearchedProject w;
    w.write("other.sim", QByteArray(kOther) + "RobotConfig Crate { Body b { Sphere s { Radius=1 Mass=1 } } }\n");
    w.caretAt("Ball size", 1);
    w.key(Qt::Key_F2);
    auto* name = w.child<QLineEdit>("renameText");
    EVENTUALLY(name->hasFocus());
    QTest::keyClicks(name, QStringLiteral("Crate"));
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(name->isVisible());
    QVERIFY2(w.child<QLabel>("renameError")->text().startsWith(QStringLiteral("other.sim: ")),
             qPrintable(w.child<QLabel>("renameError")->text()));
    QCOMPARE(w.text(w.parts), QByteArray(kBallConfig));
    w.child<QCheckBox>("renameOthers")->click(); // without the other files there is no conflict
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY(w.text(w.parts).contains("RobotConfig Crate {"));
}

/// Also if other files of the project use it.
void ProjectSearchTest::whatCameWithTheProgramIsNotRenamed() {
    SearchedProject w;
    constexpr char kUser[] = "#import robots/simple_robot.sim\nRobot r { Config=SimpleRobot }\n";
    const std::string other = w.write("other.sim", kUser);
    w.open(w.write("drive.sim", kUser));
    w.caretAt("SimpleRobot }", 1);
    w.key(Qt::Key_F2);
    auto* name = w.child<QLineEdit>("renameText");
    QVERIFY(name && !w.child<QCheckBox>("renameOthers")->isVisible());
    EVENTUALLY(name->hasFocus());
    QTest::keyClicks(name, QStringLiteral("Mine"));
    QTest::keyClick(name, Qt::Key_Return);
    QVERIFY2(w.child<QLabel>("renameError")->text().contains(QStringLiteral("read-only")),
             qPrintable(w.child<QLabel>("renameError")->text()));
    QVERIFY(!w.document.texts().isModified());
    QCOMPARE(w.text(), QByteArray(kUser));
    QVERIFY(w.text(other).isEmpty());
}

QTEST_MAIN(ProjectSearchTest)
#include "project_search_test.moc"
