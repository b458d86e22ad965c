// Save, Save As, and changes that other programs make to the files meanwhile.

#include <QTest>

#include "editor/document/structure_edits.h"
#include "eventually.h"
#include "file_limit.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;
namespace fs = std::filesystem;

class SavingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }
    void init() {
        m_fixture = std::make_unique<DocumentFixture>();
        m_document = std::make_unique<Document>(*m_application);
        QVERIFY(m_document->opening().open(m_fixture->main).ok());
    }
    void cleanup() { m_document.reset(); }

    void everyModifiedFileIsWritten() {
        Document& d = *m_document;
        QSignalSpy modified(&d.texts(), &DocumentTexts::modifiedChanged);
        set("robot0.Pos", "1,0,0");
        set("RobotConfig.Rover.chassis.hull.Mass", "3");
        QCOMPARE(modified.count(), 2);
        QCOMPARE(why(d.saving().save()), "");
        QVERIFY(!d.texts().isModified());
        QCOMPARE(bytesOf(m_fixture->main), *d.texts().text(m_fixture->main));
        QCOMPARE(bytesOf(m_fixture->robot), *d.texts().text(m_fixture->robot));
        QCOMPARE(modified.count(), 3);
        d.edits().undo();
        QVERIFY(d.texts().isModified(m_fixture->robot));
        QVERIFY(!d.texts().isModified(m_fixture->main));
        d.edits().redo();
        QVERIFY(!d.texts().isModified());
    }

    /// What is dragged or typed on after a save is an edit of its own: undo goes back to what is saved.
    void aSaveEndsADrag() {
        Document& d = *m_document;
        for (const char* x : {"1", "2"})
            QVERIFY(d.structure().setValues(u"Move"_qs, {{"robot0.Pos", x + std::string(",0,0")}}, "drag").ok());
        QCOMPARE(why(d.saving().save()), "");
        QVERIFY(d.structure().setValues(u"Move"_qs, {{"robot0.Pos", "3,0,0"}}, "drag").ok());
        QCOMPARE(d.edits().history().entries().size(), 2u);
        d.edits().undo();
        QVERIFY(!d.texts().isModified());
        QCOMPARE(*d.texts().text(m_fixture->main), bytesOf(m_fixture->main));
    }

    void keepsBytesOfUneditedFiles() {
        const std::string strange = "\xef\xbb\xbfTick = 0.01\r\n\r\n// \xff\xfe\rDuration=3 \t\n#import robots/rover.sim\n\n\n";
        m_fixture->write("configs/main.sim", strange);
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        set("Duration", "4");
        QCOMPARE(why(d.saving().save()), "");
        std::string expected = strange;
        expected.replace(expected.find("Duration=3"), 10, "Duration=4");
        QCOMPARE(bytesOf(m_fixture->main), expected);
    }

    void aFileThatCannotBeWritten() {
        Document& d = *m_document;
        set("robot0.Pos", "1,0,0");
        set("RobotConfig.Rover.chassis.hull.Mass", "3");
        fs::remove(m_fixture->main);
        fs::create_directory(m_fixture->main); // fails for root as well: a folder cannot be written as a file
        const Status saved = d.saving().save();
        QVERIFY(!saved.ok());
        QVERIFY(saved.error().message.find("main.sim") != std::string::npos);
        QVERIFY(d.texts().isModified(m_fixture->main));
        QVERIFY(d.texts().isModified(m_fixture->robot)); // all files or none
        QCOMPARE(bytesOf(m_fixture->robot), kRover);
    }

    /// The folder of one file is missing, which only its write detects: files written before it are restored.
    void rollsBackPartialWrites() {
        Document& d = *m_document;
        set("robot0.Pos", "1,0,0");
        set("RobotConfig.Rover.chassis.hull.Mass", "3");
        fs::remove_all(fs::path(m_fixture->robot).parent_path());
        QVERIFY(!d.saving().save().ok());
        QVERIFY(d.texts().isModified(m_fixture->main) && d.texts().isModified(m_fixture->robot));
        QCOMPARE(bytesOf(m_fixture->main), kMain);
        fs::create_directories(fs::path(m_fixture->robot).parent_path());
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(m_fixture->robot), *d.texts().text(m_fixture->robot));
    }

    /// In reverse order: on a full disk there is room for the older text of the file written last.
    void rollsBackInReverseOrder() {
        Document& d = *m_document;
        const std::string third = m_fixture->write("configs/z/third.sim", "Seed = 1\n");
        m_fixture->write("configs/main.sim", std::string("#import z/third.sim\n") + kMain);
        QVERIFY(d.opening().open(m_fixture->main).ok());
        set("robot0.Pos", "1,0,0");
        set("RobotConfig.Rover.chassis.hull.Mass", "3");
        set("Seed", "2");
        fs::remove_all(fs::path(third).parent_path());
        const fs::file_time_type before = fs::last_write_time(m_fixture->main);
        QVERIFY(!d.saving().save().ok());
        QCOMPARE(bytesOf(m_fixture->robot), kRover);
        QVERIFY(fs::last_write_time(m_fixture->main) > before); // written, then restored
        QVERIFY(fs::last_write_time(m_fixture->main) >= fs::last_write_time(m_fixture->robot));
    }

    void reportsFailedRollback() {
        Document& d = *m_document;
        const std::string remark = "// " + std::string(40'000, 'x') + "\n";
        m_fixture->write("configs/main.sim", remark + kMain);
        m_fixture->write("configs/robots/rover.sim", remark + kRover);
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QCOMPARE(why(d.edits().apply(u"Shorten"_qs, EditPlan{{{0, {{{0, {0, std::uint32_t(remark.size())}}, ""}}}}, {}})), "");
        set("RobotConfig.Rover.chassis.hull.Mass", "3");
        Status saved;
        {
            const FileLimit limit(20'000);
            saved = d.saving().save();
        }
        QVERIFY(!saved.ok());
        QVERIFY2(holds(saved.error().message, "rover.sim: File too large; files already written cannot be restored: ") &&
                     holds(saved.error().message, "main.sim: File too large"),
                 why(saved).c_str());
        QCOMPARE(bytesOf(m_fixture->robot), remark + kRover);
    }

    /// Save As under the same name copies the sample and writes the user's own files, or writes nothing.
    void saveAsInPlaceIsAllOrNothing() {
        Document& d = *m_document;
        const std::string own = "#import robots/simple_robot.sim\n#import part.sim\nRobot a { Config=SimpleRobot }\n";
        const std::string remark = "// " + std::string(40'000, 'x') + "\n";
        const auto mine = m_fixture->write("configs/mine.sim", own);
        const std::string part = m_fixture->write("configs/part.sim", "Seed = 1\n" + remark);
        const std::string copy = m_fixture->path("configs/robots/simple_robot.sim");
        QVERIFY(d.opening().open(mine).ok());
        set("a.Pos", "1,0,0");
        typeResistance();
        set("Seed", "2");
        Status saved;
        {
            const FileLimit limit(20'000);
            saved = d.saving().saveAs(mine);
        }
        QVERIFY2(!saved.ok() && holds(saved.error().message, "part.sim: File too large"), why(saved).c_str());
        QCOMPARE(bytesOf(mine), own);
        QVERIFY(!fs::exists(copy));
        QVERIFY(d.texts().isModified(mine) && d.texts().isModified(part));
        QCOMPARE(why(d.saving().saveAs(mine)), "");
        QVERIFY(!d.texts().isModified());
        QCOMPARE(bytesOf(part), "Seed = 2\n" + remark);
        QCOMPARE(bytesOf(mine), *d.texts().text(mine));
        QVERIFY(holds(bytesOf(copy), "Resistance=3"));
    }

    /// An edit that changes both the user's experiment and a robot that is shipped with the program.
    void halfAnEditIsNotSaved() {
        Document& d = *m_document;
        const std::string own = "#import robots/simple_robot.sim\n#import part.sim\nRobot a { Config=SimpleRobot "
                                "leftMotor.Resistance=3 }\n";
        const auto mine = m_fixture->write("configs/mine.sim", own), part = m_fixture->write("configs/part.sim", "Seed = 1\n");
        fs::remove_all(m_fixture->path("configs/robots"));
        QVERIFY(d.opening().open(mine).ok());
        QVERIFY(!d.edits().apply(u"Push"_qs, planPushOverride(*d.loaded(), "a.leftMotor.Resistance")).ok() &&
                !d.texts().isModified());
        typeResistance();
        const char* text = "#import robots/simple_robot.sim\n#import part.sim\nRobot a { Config=SimpleRobot }\n";
        QCOMPARE(why(d.edits().replaceText(u"Typing"_qs, mine, text)), "");
        set("Seed", "2");
        const Status saved = d.saving().save();
        QVERIFY(!saved.ok());
        QVERIFY2(holds(saved.error().message, "simple_robot.sim") && holds(saved.error().message, "Save As"), why(saved).c_str());
        QCOMPARE(bytesOf(mine), own);
        QCOMPARE(bytesOf(part), "Seed = 1\n");
        QVERIFY(d.texts().isModified(mine) && d.texts().isModified(part));

        QCOMPARE(why(d.saving().saveAs(mine)), "");
        QVERIFY(!d.texts().isModified());
        QVERIFY(holds(bytesOf(m_fixture->path("configs/robots/simple_robot.sim")), "Resistance=3"));
        QVERIFY(!holds(bytesOf(mine), "Resistance"));
        QCOMPARE(bytesOf(part), "Seed = 2\n");
        QVERIFY(!d.loaded()->diagnostics.hasErrors());
        QCOMPARE(d.loaded()->paths.at(1), m_fixture->path("configs/robots/simple_robot.sim"));
        for (int i = 0; i < 3; ++i) d.edits().undo();
        QVERIFY(d.saving().save().ok() && bytesOf(mine) == own);
    }

    void neverOverwritesSamples() {
        Document& d = *m_document;
        const std::string sample = std::string(TRUNDLE_SOURCE_DIR) + "/configs/experiments/linear_motion.sim";
        const std::string before = bytesOf(sample);
        QVERIFY(d.opening().open(sample).ok());
        QVERIFY(d.texts().isSample(sample));
        set("robot0.Pos", "0.5,0,0");
        typeResistance();
        const Status saved = d.saving().save();
        QVERIFY(!saved.ok());
        QVERIFY(saved.error().message.find("Save As") != std::string::npos);
        QVERIFY(!d.saving().saveAs(fs::path(sample).replace_filename("mine.sim").string()).ok());

        QSignalSpy notice(&d, &Document::notice);
        const std::string mine = m_fixture->path("mine/mine.sim");
        QVERIFY(!d.saving().saveAs(mine).ok()); // the folder does not exist
        fs::create_directory(m_fixture->path("mine"));
        QCOMPARE(why(d.saving().saveAs(mine)), "");
        QCOMPARE(d.path(), mine);
        QVERIFY(!d.texts().isModified());
        // The edited robot is copied beside it; the unedited arena stays a sample.
        QCOMPARE(bytesOf(mine), *d.texts().text(mine));
        QVERIFY(bytesOf(m_fixture->path("mine/robots/simple_robot.sim")).find("Resistance=3") != std::string::npos);
        QVERIFY(!fs::exists(m_fixture->path("mine/arenas")));
        QCOMPARE(notice.count(), 1);
        QVERIFY(holds(reportOf(notice), "robots/simple_robot.sim"));
        QCOMPARE(bytesOf(sample), before);
        QVERIFY(!d.loaded()->diagnostics.hasErrors());

        // The history is kept.
        d.edits().undo();
        QVERIFY(d.texts().isModified(m_fixture->path("mine/robots/simple_robot.sim")));
        d.edits().undo();
        QCOMPARE(*d.texts().text(mine), before);
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(mine), before);

        Document again(*m_application);
        QVERIFY(again.opening().open(mine).ok());
        QVERIFY(!again.loaded()->diagnostics.hasErrors());
    }

    void saveAsCopiesUnreachableFiles() {
        Document& d = *m_document;
        fs::create_directory(m_fixture->path("other"));
        const std::string target = m_fixture->path("other/copy.sim");
        set("robot0.Pos", "1,0,0");
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QCOMPARE(bytesOf(m_fixture->path("other/robots/rover.sim")), kRover);
        QCOMPARE(bytesOf(m_fixture->main), kMain); // the first file is unchanged
        QCOMPARE(d.texts().files(), (std::vector<std::string>{target, m_fixture->path("other/robots/rover.sim")}));
        QVERIFY(!d.loaded()->diagnostics.hasErrors());
    }

    void saveAsInProjectCopiesNothing() {
        Document& d = *m_document;
        fs::create_directory(m_fixture->path("configs/deep"));
        const std::string target = m_fixture->path("configs/deep/copy.sim");
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QVERIFY(!fs::exists(m_fixture->path("configs/deep/robots")));
        QCOMPARE(d.texts().files(), (std::vector<std::string>{target, m_fixture->robot}));
    }

    void rewritesBrokenImports() {
        Document& d = *m_document;
        m_fixture->write("configs/deep/one.sim", "#import ../robots/rover.sim // up\nRobot robot0 { Config=Rover }\n");
        QVERIFY(d.opening().open(m_fixture->path("configs/deep/one.sim")).ok());
        fs::create_directory(m_fixture->path("other"));
        const std::string target = m_fixture->path("other/copy.sim");
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QCOMPARE(bytesOf(target), "#import \"rover.sim\" // up\nRobot robot0 { Config=Rover }\n");
        QCOMPARE(bytesOf(m_fixture->path("other/rover.sim")), kRover);
        QVERIFY(!d.texts().isModified());
        QVERIFY(!d.loaded()->diagnostics.hasErrors());
    }

    void importsInTheProjectAreAdjusted() {
        Document& d = *m_document;
        m_fixture->write("configs/exp/one.sim",
                         "#import ../robots/rover.sim\n#import own/ball.sim\nRobot robot0 { Config=Rover }\n");
        m_fixture->write("configs/exp/own/ball.sim", "Material red { ColorRGB=1,0,0 }\n");
        QVERIFY(d.opening().open(m_fixture->path("configs/exp/one.sim")).ok());
        fs::create_directories(m_fixture->path("configs/sub/deep"));
        const std::string target = m_fixture->path("configs/sub/deep/x.sim");
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QCOMPARE(bytesOf(target), "#import \"../../robots/rover.sim\"\n#import \"../../exp/own/ball.sim\"\n"
                                  "Robot robot0 { Config=Rover }\n");
        QCOMPARE(std::distance(fs::directory_iterator(m_fixture->path("configs/sub/deep")), {}), 1);
        QVERIFY(!d.loaded()->diagnostics.hasErrors());
    }

    void noOtherFileIsOverwritten() {
        Document& d = *m_document;
        const std::string taken = m_fixture->write("other/robots/rover.sim", "Tick = 1\n");
        const Status saved = d.saving().saveAs(m_fixture->path("other/copy.sim"));
        QVERIFY(!saved.ok());
        QVERIFY(saved.error().message.find("rover.sim") != std::string::npos);
        QCOMPARE(bytesOf(taken), "Tick = 1\n");
        QVERIFY(!fs::exists(m_fixture->path("other/copy.sim")));
        QCOMPARE(d.path(), m_fixture->main);
        QVERIFY(!d.saving().saveAs(m_fixture->robot).ok()); // one of its own imports
    }

    // --- changes on disk ---

    void loadsExternalChange() {
        Document& d = *m_document;
        m_fixture->write("configs/main.sim", std::string("Seed = 5\n") + kMain);
        EVENTUALLY_EQUAL(d.loaded()->experiment->settings.seed, 5u);
        QVERIFY(!d.texts().isModified());
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QCOMPARE(d.edits().history().entries()[0].name, u"Changed on disk"_qs);
        // Replaced by rename, as most programs save.
        m_fixture->write("configs/new", std::string("Seed = 6\n") + kMain);
        fs::rename(m_fixture->path("configs/new"), m_fixture->main);
        EVENTUALLY_EQUAL(d.loaded()->experiment->settings.seed, 6u);
        m_fixture->write("configs/main.sim", std::string("Seed = 7\n") + kMain);
        EVENTUALLY_EQUAL(d.loaded()->experiment->settings.seed, 7u);
        d.edits().undo();
        QVERIFY(d.texts().isModified());
    }

    void changesApartAreMerged() {
        Document& d = *m_document;
        set("robot1.Pos", "5,0,0");
        m_fixture->write("configs/main.sim", std::string("Seed = 5\n") + kMain);
        EVENTUALLY_EQUAL(d.loaded()->experiment->settings.seed, 5u);
        QCOMPARE(d.loaded()->experiment->robots[1].pose.position, Vec3(5, 0, 0));
        QVERIFY(d.texts().isModified());
        QCOMPARE(why(d.saving().save()), "");
        QVERIFY(bytesOf(m_fixture->main).starts_with("Seed = 5\n"));
        d.edits().undo();
        d.edits().undo();
        d.edits().undo();
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
    }

    void asksAboutConflictingLines_data() {
        QTest::addColumn<bool>("mine");
        QTest::newRow("mine") << true;
        QTest::newRow("theirs") << false;
    }
    void asksAboutConflictingLines() {
        QFETCH(bool, mine);
        Document& d = *m_document;
        QSignalSpy asked(&d.disk(), &ExternalChanges::conflictFound);
        set("Tick", "0.02");
        std::string theirs = kMain;
        theirs.replace(theirs.find("0.01"), 4, "0.03");
        m_fixture->write("configs/main.sim", theirs);
        EVENTUALLY_EQUAL(asked.count(), 1);
        QCOMPARE(reportOf(asked), m_fixture->main);
        d.disk().check(); // the same bytes: already asked about
        QCOMPARE(asked.count(), 1);
        QCOMPARE(d.loaded()->experiment->settings.tick, 0.02);
        QCOMPARE(*d.disk().conflicts().at(m_fixture->main), theirs);
        QVERIFY(!d.saving().save().ok());
        QCOMPARE(bytesOf(m_fixture->main), theirs);
        QCOMPARE(why(d.disk().resolve(m_fixture->main,
                                      mine ? ExternalChanges::Resolution::Mine : ExternalChanges::Resolution::Theirs)),
                 "");
        QVERIFY(d.disk().conflicts().empty());
        QCOMPARE(d.texts().isModified(), mine);
        QCOMPARE(d.loaded()->experiment->settings.tick, mine ? 0.02 : 0.03);
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(m_fixture->main), *d.texts().text(m_fixture->main));
        d.edits().moveTo(0);
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
    }

    void rollsBackAfterFailure() {
        Document& d = *m_document;
        QSignalSpy asked(&d.disk(), &ExternalChanges::conflictFound);
        set("Tick", "0.02");
        m_fixture->write("configs/main.sim", "Tick = 0.03\n");
        EVENTUALLY_EQUAL(asked.count(), 1);
        m_fixture->write("configs/main.sim", kMain);
        EVENTUALLY(d.disk().conflicts().empty());
        QCOMPARE(why(d.saving().save()), "");
    }

    // The file watcher may report late or never, so the bytes are compared.
    void refusesToOverwriteUnseenChange() {
        Document& d = *m_document;
        set("Tick", "0.02");
        std::string theirs = kMain;
        theirs.replace(theirs.find("0.01"), 4, "0.03");
        m_fixture->write("configs/main.sim", theirs);
        const Status saved = d.saving().save();
        QVERIFY(!saved.ok());
        QCOMPARE(bytesOf(m_fixture->main), theirs);
        QCOMPARE(d.disk().conflicts().size(), 1u);
    }

    void mergeIsShownBeforeSaving() {
        Document& d = *m_document;
        set("robot1.Pos", "5,0,0");
        m_fixture->write("configs/main.sim", std::string("Seed = 5\n") + kMain);
        QVERIFY(!d.saving().save().ok());
        QCOMPARE(bytesOf(m_fixture->main), std::string("Seed = 5\n") + kMain);
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(m_fixture->main), *d.texts().text(m_fixture->main));
        QVERIFY(d.texts().text(m_fixture->main)->starts_with("Seed = 5\n"));
    }

    void keepsTextOfDeletedFile() {
        Document& d = *m_document;
        QSignalSpy notice(&d, &Document::notice);
        fs::remove(m_fixture->robot);
        EVENTUALLY(d.texts().isModified());
        QCOMPARE(notice.count(), 1);
        set("Tick", "0.02");
        QVERIFY(!d.loaded()->diagnostics.hasErrors()); // its text is still in memory
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(m_fixture->robot), kRover);
        QVERIFY(!d.texts().isModified());
        fs::remove(m_fixture->robot);
        EVENTUALLY(d.texts().isModified());
        m_fixture->write("configs/robots/rover.sim", kRover);
        EVENTUALLY(!d.texts().isModified());
    }

    void ignoresOwnSaves() {
        Document& d = *m_document;
        QSignalSpy asked(&d.disk(), &ExternalChanges::conflictFound);
        for (int i = 1; i <= 5; ++i) {
            set("Tick", "0.0" + std::to_string(i + 1));
            QCOMPARE(why(d.saving().save()), "");
        }
        d.disk().check();
        QCOMPARE(d.edits().history().entries().size(), 5u);
        QCOMPARE(asked.count(), 0);
    }

private:
    void typeResistance() {
        const std::string robot = canonicalPath(TRUNDLE_SOURCE_DIR "/configs/robots/simple_robot.sim");
        QByteArray text = QByteArray::fromStdString(*m_document->texts().text(robot));
        QVERIFY(m_document->edits()
                    .replaceText(u"Typing"_qs, robot, text.replace("Resistance=2", "Resistance=3").toStdString())
                    .ok());
    }
    void set(const std::string& path, const std::string& text) {
        QCOMPARE(why(m_document->structure().setValues(u"Set"_qs, {{path, text}})), "");
    }

    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
    std::unique_ptr<Document> m_document;
};

QTEST_GUILESS_MAIN(SavingTest)
#include "saving_test.moc"
