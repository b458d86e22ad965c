// Document: opening, edits, undo and loading on a worker thread.
#include <QTest>

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
        QCOMPARE(why(d.open(m_fixture->main)), "");
        QVERIFY(d.isOpen());
        QCOMPARE(opened.count(), 1);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(d.files(), (std::vector<std::string>{m_fixture->main, m_fixture->robot}));
        QCOMPARE(d.path(), m_fixture->main);
        QCOMPARE(*d.text(m_fixture->robot), kRover);
        QVERIFY(!d.text("/nowhere.sim"));
        QCOMPARE(d.loaded()->experiment->robots.size(), 2u);
        QVERIFY(d.lastValid() == d.loaded());
        QVERIFY(!d.isModified());
        QCOMPARE(d.shown(m_fixture->robot), "robots/rover.sim");
        d.close();
        QVERIFY(!d.isOpen());
        QVERIFY(!d.loaded());
        QVERIFY(d.files().empty());
        QVERIFY(!d.edit(u"x"_qs, {{0, {{{0, {0, 0}}, "x"}}}}).ok());
    }

    void failedOpenKeepsState() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        const auto loaded = d.loaded();
        QVERIFY(!d.open(m_fixture->path("none.sim")).ok());
        QVERIFY(!d.open(m_fixture->path("configs")).ok());
        QVERIFY(d.loaded() == loaded);
    }

    void opensTextWithErrorsAndKeepsLastValid() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        const auto good = d.loaded();
        QCOMPARE(why(d.replaceText(u"Typing"_qs, m_fixture->main, "Robot robot0 { Config=")), "");
        QVERIFY(d.loaded()->diagnostics.hasErrors());
        QVERIFY(d.lastValid() == good);
        d.undo();
        QVERIFY(d.lastValid() == d.loaded());
        QCOMPARE(why(d.open(m_fixture->write("configs/broken.sim", "}}} {"))), "");
        QVERIFY(!d.lastValid());
    }

    void setsValueInPlace() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QCOMPARE(why(d.setValues(u"Set Pos"_qs, {{"robot0.Pos", "1,2,0"}})), "");
        std::string expected = kMain;
        expected.replace(expected.find("Pos=0,0,0"), 9, "Pos=1,2,0");
        QCOMPARE(*d.text(m_fixture->main), expected);
        QCOMPARE(d.loaded()->parses, 1u);
        QCOMPARE(d.loaded()->experiment->robots[0].pose.position, Vec3(1, 2, 0));
        QVERIFY(d.isModified());
        QVERIFY(d.isModified(m_fixture->main));
        QVERIFY(!d.isModified(m_fixture->robot));
        QCOMPARE(d.history().entries().size(), 1u);
        d.undo();
        QCOMPARE(*d.text(m_fixture->main), kMain);
        QVERIFY(!d.isModified());
        d.redo();
        QCOMPARE(*d.text(m_fixture->main), expected);
    }

    void discardedMergeLeavesNoEntry() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QVERIFY(d.setValues(u"Set Tick"_qs, {{"Tick", "5 ms"}}).ok());
        d.undo();
        QSignalSpy modified(&d, &Document::modifiedChanged);
        for (const char* x : {"1", "2", "3"})
            QVERIFY(d.setValues(u"Move"_qs, {{"robot0.Pos", x + std::string(",0,0")}}, "drag").ok());
        QVERIFY(!d.history().canRedo());
        QCOMPARE(modified.count(), 1);
        d.discardMerge("another");
        QVERIFY(d.isModified());
        d.discardMerge("drag");
        QCOMPARE(*d.text(m_fixture->main), kMain);
        QCOMPARE(modified.count(), 2);
        QVERIFY(!d.isModified());
        QCOMPARE(d.loaded()->experiment->robots[0].pose.position, Vec3(0, 0, 0));
        QCOMPARE(d.history().entries().size(), 1u);
        QVERIFY(!d.history().canUndo());
        d.redo(); // the drag has not removed the redo entry yet
        QVERIFY(holds(*d.text(m_fixture->main), "Tick = 5 ms"));
        d.discardMerge("drag");
        QVERIFY(d.isModified());
    }

    void severalValuesAreOneEntryInTheirFiles() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QCOMPARE(why(d.setValues(
                     u"Set"_qs,
                     {{"Tick", "5 ms"}, {"RobotConfig.Rover.chassis.hull.Mass", "3 kg"}, {"robot1.chassis.hull.Mass", "4"}})),
                 "");
        QCOMPARE(d.history().entries().size(), 1u);
        QVERIFY(d.text(m_fixture->robot)->find("Mass=3 kg") != std::string::npos);
        QVERIFY(d.text(m_fixture->main)->find("Tick = 5 ms") != std::string::npos);
        QCOMPARE(d.loaded()->experiment->robots[1].config->bodies[0].mass.mass, 4.0);
        d.undo();
        QCOMPARE(*d.text(m_fixture->main), kMain);
        QCOMPARE(*d.text(m_fixture->robot), kRover);
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
        QVERIFY(d.open(m_fixture->main).ok());
        QSignalSpy refused(&d, &Document::refused), changed(&d, &Document::changed);
        const Status status =
            d.setValues(u"Set"_qs, {{"Duration", "20"}, {path.toStdString(), text.toStdString()}}); // all values or none
        QVERIFY(!status.ok());
        QVERIFY2(status.error().message.find(reason.toStdString()) != std::string::npos, status.error().message.c_str());
        QVERIFY(!status.error().message.empty());
        QCOMPARE(refused.count(), 1);
        QCOMPARE(reportOf(refused), status.error().message);
        QCOMPARE(changed.count(), 0);
        QCOMPARE(*d.text(m_fixture->main), kMain);
        QVERIFY(d.history().entries().empty());
    }

    void theSameValueIsNoEdit() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QSignalSpy changed(&d, &Document::changed);
        QCOMPARE(why(d.setValues(u"Set"_qs, {{"Tick", "0.01"}})), "");
        QCOMPARE(why(d.replaceText(u"Type"_qs, m_fixture->main, kMain)), "");
        QCOMPARE(changed.count(), 0);
        QVERIFY(d.history().entries().empty());
    }

    void editsThatDoNotFitChangeNothing() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QSignalSpy refused(&d, &Document::refused);
        QVERIFY(!d.edit(u"x"_qs, {{0, {{{0, {5, 100000}}, "x"}}}}).ok());
        QVERIFY(!d.edit(u"x"_qs, {{7, {{{7, {0, 0}}, "x"}}}}).ok());
        QVERIFY(!d.edit(u"x"_qs, {{0, {{{0, {0, 9}}, "x"}, {{0, {5, 12}}, "y"}}}}).ok());
        QVERIFY(!d.replaceText(u"x"_qs, "/etc/passwd", "x").ok());
        QVERIFY(!d.replaceText(u"x"_qs, m_fixture->main, std::string((64u << 20) + 1, ' ')).ok());
        QCOMPARE(refused.count(), 5);
        QCOMPARE(*d.text(m_fixture->main), kMain);
        QCOMPARE(d.loaded()->experiment->robots.size(), 2u);
    }

    void aPlanSelectsWhatItMade() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QSignalSpy wanted(&d, &Document::selectionRequested), refused(&d, &Document::refused);
        const std::string added = "Robot robot2 { Config=Rover Pos=2,0,0 }\n";
        const auto end = static_cast<std::uint32_t>(std::string_view(kMain).size());
        QCOMPARE(why(d.apply(u"Insert"_qs, EditPlan{{{0, {{{0, {end, end}}, added}}}}, {"robot2"}})), "");
        QCOMPARE(*d.text(m_fixture->main), kMain + added);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][0].value<std::vector<std::string>>(), std::vector<std::string>{"robot2"});
        QVERIFY(!d.apply(u"Insert"_qs, Error{Code::NoSuchPath, "there is no robot7"}).ok());
        QCOMPARE(reportOf(refused), "there is no robot7");
    }

    void aDragIsOneEntry() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        for (int i = 1; i <= 5; ++i)
            QCOMPARE(why(d.setValues(u"Move robot0"_qs, {{"robot0.Pos", std::to_string(i) + ",0,0"}}, "drag")), "");
        QCOMPARE(d.history().entries().size(), 1u);
        d.endMerge();
        QCOMPARE(why(d.setValues(u"Move robot0"_qs, {{"robot0.Pos", "9,0,0"}}, "drag")), "");
        QCOMPARE(d.history().entries().size(), 2u);
        d.undo();
        QCOMPARE(d.loaded()->experiment->robots[0].pose.position, Vec3(5, 0, 0));
        d.undo();
        QCOMPARE(*d.text(m_fixture->main), kMain);
    }

    void anImportThatIsTypedIsOpened() {
        Document& d = *m_document;
        m_fixture->write("configs/arena.sim", "Surface floor { Friction=1 }\n");
        QVERIFY(d.open(m_fixture->main).ok());
        QCOMPARE(why(d.replaceText(u"Type"_qs, m_fixture->main, std::string("#import arena.sim\n") + kMain)), "");
        QCOMPARE(d.files().size(), 3u);
        QVERIFY(d.text(m_fixture->path("configs/arena.sim")));
        QCOMPARE(why(d.setValues(u"Set"_qs, {{"Surface.floor.Friction", "0.5"}})), "");
        d.undo();
        d.undo();
        QCOMPARE(d.files().size(), 2u);
        d.moveTo(2);
        QCOMPARE(*d.text(m_fixture->path("configs/arena.sim")), "Surface floor { Friction=0.5 }\n");
    }

    void aNewTextNeedsNoFile() {
        Document& d = *m_document;
        QCOMPARE(why(d.openNew("untitled.sim", "Tick = 1 ms\n#import robots/simple_robot.sim\n")), "");
        QVERIFY(d.isNew());
        QCOMPARE(d.path(), "untitled.sim");
        QVERIFY(!d.isModified());
        QVERIFY2(!d.loaded()->diagnostics.hasErrors(),
                 d.loaded()->diagnostics.all().empty() ? "" : d.loaded()->diagnostics.all()[0].message.c_str());
        QCOMPARE(d.shown(d.files()[0]), "untitled.sim");
        QCOMPARE(d.loaded()->trees[0]->source().path(), "untitled.sim");
        QCOMPARE(why(d.setValues(u"Set"_qs, {{"Tick", "2 ms"}})), "");
        QVERIFY(d.isModified());
        QVERIFY(!d.save().ok());
        QCOMPARE(why(d.replaceText(u"Type"_qs, "untitled.sim", "Tick = 3 ms\n")), "");
        QCOMPARE(why(d.saveAs(m_fixture->path("configs/mine.sim"))), "");
        QVERIFY(!d.isNew());
        QVERIFY(!d.isModified());
        QCOMPARE(d.path(), m_fixture->path("configs/mine.sim"));
        QCOMPARE(bytesOf(d.path()), "Tick = 3 ms\n");
        QVERIFY(!d.openNew("a/b.sim", "").ok());
    }

    void openingLaterDoesNotWait() {
        Document& d = *m_document;
        QSignalSpy opened(&d, &Document::opened), failed(&d, &Document::openFailed);
        d.openLater(m_fixture->main);
        QVERIFY(d.isOpening());
        QVERIFY(!d.isOpen());
        EVENTUALLY_EQUAL(opened.count(), 1);
        QVERIFY(d.isOpen());
        QVERIFY(!d.isOpening());

        d.openLater(m_fixture->path("none.sim"));
        QVERIFY(!d.setValues(u"Set"_qs, {{"Tick", "1 ms"}}).ok()); // an edit while a file loads would be lost
        d.undo();
        EVENTUALLY_EQUAL(failed.count(), 1);
        QVERIFY(holds(failed[0][1].toString().toStdString(), "does not exist"));
        QCOMPARE(d.path(), m_fixture->main);
        QCOMPARE(why(d.setValues(u"Set"_qs, {{"Tick", "1 ms"}})), "");
    }

    void anOpeningThatIsCancelledLeavesWhatIsOpen() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QVERIFY(d.setValues(u"Set"_qs, {{"Tick", "1 ms"}}).ok());
        QSignalSpy opened(&d, &Document::opened), failed(&d, &Document::openFailed), read(&d, &Document::aboutToOpen);
        d.openLater(m_fixture->robot);
        d.cancelOpening();
        QVERIFY(!d.isOpening());
        d.undo(); // loading ended, so edits are accepted again
        QVERIFY(!d.isModified());
        d.openLater(m_fixture->path("none.sim")); // queued behind the first
        EVENTUALLY_EQUAL(failed.count(), 1);
        QCOMPARE(opened.count(), 0);
        QCOMPARE(read.count(), 0);
        QCOMPARE(d.path(), m_fixture->main);
    }

    /// The file is read already, and only waits for the window to have handled that.
    void anOpeningCanBeCancelledOnceTheFileIsRead() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QSignalSpy opened(&d, &Document::opened), read(&d, &Document::aboutToOpen), failed(&d, &Document::openFailed);
        const auto cancel = connect(&d, &Document::aboutToOpen, &d, &Document::cancelOpening);
        d.openLater(m_fixture->robot);
        EVENTUALLY_EQUAL(read.count(), 1);
        disconnect(cancel);
        QVERIFY(!d.isOpening());
        d.openLater(m_fixture->path("none.sim")); // handled after the first would have been
        EVENTUALLY_EQUAL(failed.count(), 1);
        QCOMPARE(opened.count(), 0);
        QCOMPARE(d.path(), m_fixture->main);
    }

    void theNewestOpeningWins() {
        Document& d = *m_document;
        QSignalSpy opened(&d, &Document::opened);
        d.openLater(m_fixture->main);
        d.openLater(m_fixture->robot);
        EVENTUALLY(!d.isOpening());
        QCOMPARE(d.path(), m_fixture->robot);
        d.openLater(m_fixture->main);
        QVERIFY(d.open(m_fixture->robot).ok());
        d.openLater(m_fixture->main);
        d.close();
        QTest::qWait(0);
        EVENTUALLY(!d.isOpening());
        QVERIFY(!d.isOpen());
        d.openLater(m_fixture->main);
        m_document.reset(); // the worker thread may still be reading
    }

    void trustedModulesAreReadAgain() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QVERIFY(d.setValues(u"Set"_qs, {{"Tick", "1 ms"}}).ok());
        QSignalSpy changed(&d, &Document::changed);
        OpenOptions options;
        options.includes = {m_fixture->path("elsewhere")};
        d.setOptions(options);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(d.loaded()->experiment->settings.tick, 0.001);
        QVERIFY(d.isModified());
    }

private:
    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
    std::unique_ptr<Document> m_document;
};

QTEST_GUILESS_MAIN(DocumentTest)
#include "document_test.moc"
