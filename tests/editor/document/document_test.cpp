// Document: opening, edits, undo and loading on a worker thread.
#include <QTest>

#include "editor/document/structure_edits.h"
#include "eventually.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

class DocumentTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }
    void init() {
        m_fixture = std::make_unique<DocumentFixture>();
        m_document = std::make_unique<Document>(*m_application);
    }
    void cleanup() { m_document.reset(); }

    void opens() {
        Document& d = *m_document;
        QSignalSpy opened(&d, &Document::opened), changed(&d, &Document::changed);
        QVERIFY(!d.isOpen());
        QCOMPARE(why(d.opening().open(m_fixture->main)), "");
        QVERIFY(d.isOpen());
        QCOMPARE(opened.count(), 1);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(d.texts().files(), (std::vector<std::string>{m_fixture->main, m_fixture->robot}));
        QCOMPARE(d.path(), m_fixture->main);
        QCOMPARE(*d.texts().text(m_fixture->robot), kRover);
        QVERIFY(!d.texts().text("/nowhere.sim"));
        QCOMPARE(d.loaded()->experiment->robots.size(), 2u);
        QVERIFY(d.lastValid() == d.loaded());
        QVERIFY(!d.texts().isModified());
        QCOMPARE(d.texts().shown(m_fixture->robot), "robots/rover.sim");
        d.opening().close();
        QVERIFY(!d.isOpen());
        QVERIFY(!d.loaded());
        QVERIFY(d.texts().files().empty());
        QVERIFY(!d.edits().edit(u"x"_qs, {{0, {{{0, {0, 0}}, "x"}}}}).ok());
    }

    void failedOpenKeepsState() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        const auto loaded = d.loaded();
        QVERIFY(!d.opening().open(m_fixture->path("none.sim")).ok());
        QVERIFY(!d.opening().open(m_fixture->path("configs")).ok());
        QVERIFY(d.loaded() == loaded);
    }

    void opensTextWithErrorsAndKeepsLastValid() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        const auto good = d.loaded();
        QCOMPARE(why(d.edits().replaceText(u"Typing"_qs, m_fixture->main, "Robot robot0 { Config=")), "");
        QVERIFY(d.loaded()->diagnostics.hasErrors());
        QVERIFY(d.lastValid() == good);
        d.edits().undo();
        QVERIFY(d.lastValid() == d.loaded());
        QCOMPARE(why(d.opening().open(m_fixture->write("configs/broken.sim", "}}} {"))), "");
        QVERIFY(!d.lastValid());
    }

    void setsValueInPlace() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QCOMPARE(why(d.structure().setValues(u"Set Pos"_qs, {{"robot0.Pos", "1,2,0"}})), "");
        std::string expected = kMain;
        expected.replace(expected.find("Pos=0,0,0"), 9, "Pos=1,2,0");
        QCOMPARE(*d.texts().text(m_fixture->main), expected);
        QCOMPARE(d.loaded()->parses, 1u);
        QCOMPARE(d.loaded()->experiment->robots[0].pose.position, Vec3(1, 2, 0));
        QVERIFY(d.texts().isModified());
        QVERIFY(d.texts().isModified(m_fixture->main));
        QVERIFY(!d.texts().isModified(m_fixture->robot));
        QCOMPARE(d.edits().history().entries().size(), 1u);
        d.edits().undo();
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
        QVERIFY(!d.texts().isModified());
        d.edits().redo();
        QCOMPARE(*d.texts().text(m_fixture->main), expected);
    }

    void discardedMergeLeavesNoEntry() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(d.structure().setValues(u"Set Tick"_qs, {{"Tick", "5 ms"}}).ok());
        d.edits().undo();
        QSignalSpy modified(&d.texts(), &DocumentTexts::modifiedChanged);
        for (const char* x : {"1", "2", "3"})
            QVERIFY(d.structure().setValues(u"Move"_qs, {{"robot0.Pos", x + std::string(",0,0")}}, "drag").ok());
        QVERIFY(!d.edits().history().canRedo());
        QCOMPARE(modified.count(), 1);
        d.edits().discardMerge("another");
        QVERIFY(d.texts().isModified());
        d.edits().discardMerge("drag");
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
        QCOMPARE(modified.count(), 2);
        QVERIFY(!d.texts().isModified());
        QCOMPARE(d.loaded()->experiment->robots[0].pose.position, Vec3(0, 0, 0));
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QVERIFY(!d.edits().history().canUndo());
        d.edits().redo(); // the drag has not removed the redo entry yet
        QVERIFY(holds(*d.texts().text(m_fixture->main), "Tick = 5 ms"));
        d.edits().discardMerge("drag");
        QVERIFY(d.texts().isModified());
    }

    void severalValuesAreOneEntryInTheirFiles() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QCOMPARE(why(d.structure().setValues(
                     u"Set"_qs,
                     {{"Tick", "5 ms"}, {"RobotConfig.Rover.chassis.hull.Mass", "3 kg"}, {"robot1.chassis.hull.Mass", "4"}})),
                 "");
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QVERIFY(d.texts().text(m_fixture->robot)->find("Mass=3 kg") != std::string::npos);
        QVERIFY(d.texts().text(m_fixture->main)->find("Tick = 5 ms") != std::string::npos);
        QCOMPARE(d.loaded()->experiment->robots[1].config->bodies[0].mass.mass, 4.0);
        d.edits().undo();
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
        QCOMPARE(*d.texts().text(m_fixture->robot), kRover);
    }

    void aWrongValueIsRefusedWithTheReason_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* path, const char* text, const char* reason) {
            QTest::addRow("%s=%s", path, text) << path << text << reason;
        };
        row("RobotConfig.Rover.chassis.hull.Mass", "-1", "Mass");
        row("robot0.Pos", "1,2", "Pos");
        row("robot0.Config", "Nobody", "Nobody");
        row("robot0.Pos", "", "");
        row("robot9.Pos", "0,0,0", "robot9");
        row("robot0.Nonsense", "1", "Nonsense");
        row("Tick", "3 kg", "Tick");
        row("Tick", "0.01 Duration=3", "");
        row("Tick", "0.01 } Robot x {", "");
        row("", "1", "");
        row("Tick", "\"", "");
        row("robot0.Pos", "1,2,3,", "");
    }
    void aWrongValueIsRefusedWithTheReason() {
        QFETCH(QString, path);
        QFETCH(QString, text);
        QFETCH(QString, reason);
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QSignalSpy refused(&d, &Document::refused), changed(&d, &Document::changed);
        const Status status = d.structure().setValues(
            u"Set"_qs, {{"Duration", "20"}, {path.toStdString(), text.toStdString()}}); // all values or none
        QVERIFY(!status.ok());
        QVERIFY2(status.error().message.find(reason.toStdString()) != std::string::npos, status.error().message.c_str());
        QVERIFY(!status.error().message.empty());
        QCOMPARE(refused.count(), 1);
        QCOMPARE(reportOf(refused), status.error().message);
        QCOMPARE(changed.count(), 0);
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
        QVERIFY(d.edits().history().entries().empty());
    }

    void theSameValueIsNoEdit() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QSignalSpy changed(&d, &Document::changed);
        QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{"Tick", "0.01"}})), "");
        QCOMPARE(why(d.edits().replaceText(u"Type"_qs, m_fixture->main, kMain)), "");
        QCOMPARE(changed.count(), 0);
        QVERIFY(d.edits().history().entries().empty());
    }

    void editsThatDoNotFitChangeNothing() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QSignalSpy refused(&d, &Document::refused);
        QVERIFY(!d.edits().edit(u"x"_qs, {{0, {{{0, {5, 100000}}, "x"}}}}).ok());
        QVERIFY(!d.edits().edit(u"x"_qs, {{7, {{{7, {0, 0}}, "x"}}}}).ok());
        QVERIFY(!d.edits().edit(u"x"_qs, {{0, {{{0, {0, 9}}, "x"}, {{0, {5, 12}}, "y"}}}}).ok());
        QVERIFY(!d.edits().replaceText(u"x"_qs, "/etc/passwd", "x").ok());
        QVERIFY(!d.edits().replaceText(u"x"_qs, m_fixture->main, std::string((64u << 20) + 1, ' ')).ok());
        QCOMPARE(refused.count(), 5);
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
        QCOMPARE(d.loaded()->experiment->robots.size(), 2u);
    }

    void aPlanSelectsWhatItMade() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QSignalSpy wanted(&d, &Document::selectionRequested), refused(&d, &Document::refused);
        const std::string added = "Robot robot2 { Config=Rover Pos=2,0,0 }\n";
        const auto end = static_cast<std::uint32_t>(std::string_view(kMain).size());
        QCOMPARE(why(d.edits().apply(u"Insert"_qs, EditPlan{{{0, {{{0, {end, end}}, added}}}}, {"robot2"}})), "");
        QCOMPARE(*d.texts().text(m_fixture->main), kMain + added);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].value<std::vector<std::string>>(), std::vector<std::string>{"robot2"});
        QVERIFY(!d.edits().apply(u"Insert"_qs, Error{Code::NoSuchPath, "there is no robot7"}).ok());
        QCOMPARE(reportOf(refused), "there is no robot7");
    }

    void aDragIsOneEntry() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        for (int i = 1; i <= 5; ++i)
            QCOMPARE(why(d.structure().setValues(u"Move robot0"_qs, {{"robot0.Pos", std::to_string(i) + ",0,0"}}, "drag")), "");
        QCOMPARE(d.edits().history().entries().size(), 1u);
        d.edits().endMerge();
        QCOMPARE(why(d.structure().setValues(u"Move robot0"_qs, {{"robot0.Pos", "9,0,0"}}, "drag")), "");
        QCOMPARE(d.edits().history().entries().size(), 2u);
        d.edits().undo();
        QCOMPARE(d.loaded()->experiment->robots[0].pose.position, Vec3(5, 0, 0));
        d.edits().undo();
        QCOMPARE(*d.texts().text(m_fixture->main), kMain);
    }

    void anImportThatIsTypedIsOpened() {
        Document& d = *m_document;
        m_fixture->write("configs/arena.sim", "Surface floor { Friction=1 }\n");
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QCOMPARE(why(d.edits().replaceText(u"Type"_qs, m_fixture->main, std::string("#import arena.sim\n") + kMain)), "");
        QCOMPARE(d.texts().files().size(), 3u);
        QVERIFY(d.texts().text(m_fixture->path("configs/arena.sim")));
        QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{"Surface.floor.Friction", "0.5"}})), "");
        d.edits().undo();
        d.edits().undo();
        QCOMPARE(d.texts().files().size(), 2u);
        d.edits().moveTo(2);
        QCOMPARE(*d.texts().text(m_fixture->path("configs/arena.sim")), "Surface floor { Friction=0.5 }\n");
    }

    void aNewTextNeedsNoFile() {
        Document& d = *m_document;
        QCOMPARE(why(d.opening().openNew("untitled.sim", "Tick = 1 ms\n#import robots/simple_robot.sim\n")), "");
        QVERIFY(d.isNew());
        QCOMPARE(d.path(), "untitled.sim");
        QVERIFY(!d.texts().isModified());
        QVERIFY2(!d.loaded()->diagnostics.hasErrors(),
                 d.loaded()->diagnostics.all().empty() ? "" : d.loaded()->diagnostics.all()[0].message.c_str());
        QCOMPARE(d.texts().shown(d.texts().files()[0]), "untitled.sim");
        QCOMPARE(d.loaded()->trees[0]->source().path(), "untitled.sim");
        QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{"Tick", "2 ms"}})), "");
        QVERIFY(d.texts().isModified());
        QVERIFY(!d.saving().save().ok());
        QCOMPARE(why(d.edits().replaceText(u"Type"_qs, "untitled.sim", "Tick = 3 ms\n")), "");
        QCOMPARE(why(d.saving().saveAs(m_fixture->path("configs/mine.sim"))), "");
        QVERIFY(!d.isNew());
        QVERIFY(!d.texts().isModified());
        QCOMPARE(d.path(), m_fixture->path("configs/mine.sim"));
        QCOMPARE(bytesOf(d.path()), "Tick = 3 ms\n");
        QVERIFY(!d.opening().openNew("a/b.sim", "").ok());
    }

    void openingLaterDoesNotWait() {
        Document& d = *m_document;
        QSignalSpy opened(&d, &Document::opened), failed(&d.opening(), &ProjectOpening::failed);
        d.opening().openLater(m_fixture->main);
        QVERIFY(d.opening().isOpening());
        QVERIFY(!d.isOpen());
        EVENTUALLY_EQUAL(opened.count(), 1);
        QVERIFY(d.isOpen());
        QVERIFY(!d.opening().isOpening());

        d.opening().openLater(m_fixture->path("none.sim"));
        QVERIFY(!d.structure().setValues(u"Set"_qs, {{"Tick", "1 ms"}}).ok()); // an edit while a file loads would be lost
        d.edits().undo();
        EVENTUALLY_EQUAL(failed.count(), 1);
        QVERIFY(holds(failed[0][1].toString().toStdString(), "does not exist"));
        QCOMPARE(d.path(), m_fixture->main);
        QCOMPARE(why(d.structure().setValues(u"Set"_qs, {{"Tick", "1 ms"}})), "");
    }

    void anOpeningThatIsCancelledLeavesWhatIsOpen() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "1 ms"}}).ok());
        QSignalSpy opened(&d, &Document::opened), failed(&d.opening(), &ProjectOpening::failed),
            read(&d.opening(), &ProjectOpening::aboutToOpen);
        d.opening().openLater(m_fixture->robot);
        d.opening().cancel();
        QVERIFY(!d.opening().isOpening());
        d.edits().undo(); // loading ended, so edits are accepted again
        QVERIFY(!d.texts().isModified());
        d.opening().openLater(m_fixture->path("none.sim")); // queued behind the first
        EVENTUALLY_EQUAL(failed.count(), 1);
        QCOMPARE(opened.count(), 0);
        QCOMPARE(read.count(), 0);
        QCOMPARE(d.path(), m_fixture->main);
    }

    /// The file is read already, and only waits for the window to have handled that.
    void anOpeningCanBeCancelledOnceTheFileIsRead() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QSignalSpy opened(&d, &Document::opened), read(&d.opening(), &ProjectOpening::aboutToOpen),
            failed(&d.opening(), &ProjectOpening::failed);
        const auto cancel = connect(&d.opening(), &ProjectOpening::aboutToOpen, &d.opening(), &ProjectOpening::cancel);
        d.opening().openLater(m_fixture->robot);
        EVENTUALLY_EQUAL(read.count(), 1);
        disconnect(cancel);
        QVERIFY(!d.opening().isOpening());
        d.opening().openLater(m_fixture->path("none.sim")); // handled after the first would have been
        EVENTUALLY_EQUAL(failed.count(), 1);
        QCOMPARE(opened.count(), 0);
        QCOMPARE(d.path(), m_fixture->main);
    }

    void theNewestOpeningWins() {
        Document& d = *m_document;
        QSignalSpy opened(&d, &Document::opened);
        d.opening().openLater(m_fixture->main);
        d.opening().openLater(m_fixture->robot);
        EVENTUALLY(!d.opening().isOpening());
        QCOMPARE(d.path(), m_fixture->robot);
        d.opening().openLater(m_fixture->main);
        QVERIFY(d.opening().open(m_fixture->robot).ok());
        d.opening().openLater(m_fixture->main);
        d.opening().close();
        QTest::qWait(0);
        EVENTUALLY(!d.opening().isOpening());
        QVERIFY(!d.isOpen());
        d.opening().openLater(m_fixture->main);
        m_document.reset(); // the worker thread may still be reading
    }

    void trustedModulesAreReadAgain() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "1 ms"}}).ok());
        QSignalSpy changed(&d, &Document::changed);
        OpenOptions options;
        options.includes = {m_fixture->path("elsewhere")};
        d.setOptions(options);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(d.loaded()->experiment->settings.tick, 0.001);
        QVERIFY(d.texts().isModified());
    }

private:
    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
    std::unique_ptr<Document> m_document;
};

QTEST_GUILESS_MAIN(DocumentTest)
#include "document_test.moc"
