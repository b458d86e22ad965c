// Recovery after a crash, and two windows with the same project.

#include <QTest>

#include "eventually.h"
#include "project/journal/state_folder.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;
namespace fs = std::filesystem;

class RecoveryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }
    void init() {
        m_fixture = std::make_unique<DocumentFixture>();
        m_document = std::make_unique<Document>(*m_application);
    }
    void cleanup() { m_document.reset(); }

    void journalsEditsWithinTwoSeconds() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QVERIFY(!fs::exists(journals()));
        QVERIFY(d.setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
        QTRY_VERIFY_WITH_TIMEOUT(fs::exists(journals()), 2000);
        QVERIFY(d.recoveries().empty()); // its own journal is not offered
        QCOMPARE(why(d.save()), "");
        QVERIFY(!fs::exists(journals()));
        QVERIFY(d.setValues(u"Set"_qs, {{"Tick", "0.03"}}).ok());
        EVENTUALLY(fs::exists(journals()));
        d.undo();
        EVENTUALLY(!fs::exists(journals())); // no unsaved changes
        QVERIFY(d.setValues(u"Set"_qs, {{"Tick", "0.04"}}).ok());
        EVENTUALLY(fs::exists(journals()));
        d.close(); // the user was asked before close()
        QVERIFY(!fs::exists(m_fixture->path("configs/.trundle")));
    }

    /// An end request (such as SIGTERM) writes the journal at once, without its delay of half a second.
    void journalsEditsOnEndRequest() {
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QVERIFY(d.setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
        QVERIFY(!fs::exists(journals()));
        QMetaObject::invokeMethod(
            QCoreApplication::instance(), [] { QCoreApplication::exit(143); }, Qt::QueuedConnection);
        QCOMPARE(QCoreApplication::exec(), 143);
        QVERIFY(fs::exists(journals()));
    }

    void recovers() {
        leave({m_fixture->main, {}},
              {{m_fixture->main, {kMain, std::string(kMain) + "Seed = 9\n"}}, {m_fixture->robot, {kRover, "Seed=1\n"}}});
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        const auto found = d.recoveries();
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].head.opened, m_fixture->main);
        QCOMPARE(why(d.recover(found[0])), "");
        QCOMPARE(*d.text(m_fixture->main), std::string(kMain) + "Seed = 9\n");
        QCOMPARE(*d.text(m_fixture->robot), "Seed=1\n");
        QVERIFY(d.isModified());
        QCOMPARE(d.history().entries().size(), 1u);
        QVERIFY(d.recoveries().empty());
        QVERIFY(fs::exists(journals())); // now in this document's own journal
        d.undo();
        QVERIFY(!d.isModified());
        QCOMPARE(bytesOf(m_fixture->main), kMain);
    }

    void recoversFromTheWelcomePage() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {kMain, "Seed = 9\n"}}});
        Document& d = *m_document;
        QCOMPARE(why(d.recover(findRecoveries(m_fixture->path("configs")).at(0))), "");
        QCOMPARE(d.path(), m_fixture->main);
        QCOMPARE(*d.text(m_fixture->main), "Seed = 9\n");
    }

    void recoversOverAnotherText() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {kMain, std::string(kMain) + "Seed = 9\n"}}});
        m_fixture->write("configs/main.sim", std::string("Title=\"T\"\n") + kMain);
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        const std::string both = std::string("Title=\"T\"\n") + kMain + "Seed = 9\n";
        QCOMPARE(Document::recoveredText(m_fixture->main, d.recoveries().at(0).files.at(m_fixture->main)), both); // preview
        QCOMPARE(why(d.recover(d.recoveries().at(0))), "");
        QCOMPARE(*d.text(m_fixture->main), both);
        QVERIFY(d.diskChanges().empty());
    }

    void bothChangedTheSameLine() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {"Seed = 1\n", "Seed = 2\n"}}});
        m_fixture->write("configs/main.sim", "Seed = 3\n");
        Document& d = *m_document;
        QVERIFY(d.open(m_fixture->main).ok());
        QSignalSpy asked(&d, &Document::diskChanged);
        QCOMPARE(why(d.recover(d.recoveries().at(0))), "");
        QCOMPARE(asked.count(), 1);
        QCOMPARE(*d.text(m_fixture->main), "Seed = 2\n");
        QCOMPARE(*d.diskChanges().at(m_fixture->main), "Seed = 3\n");
        QVERIFY(!d.save().ok());
        QVERIFY(d.resolveDiskChange(m_fixture->main, Document::Resolution::Mine).ok());
        QCOMPARE(why(d.save()), "");
        QCOMPARE(bytesOf(m_fixture->main), "Seed = 2\n");
    }

    void restoresDeletedFile() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {kMain, "Seed = 9\n"}}});
        fs::remove(m_fixture->main);
        Document& d = *m_document;
        QVERIFY(!d.open(m_fixture->main).ok());
        QCOMPARE(why(d.recover(findRecoveries(m_fixture->path("configs")).at(0))), "");
        QCOMPARE(*d.text(m_fixture->main), "Seed = 9\n");
        QVERIFY(d.isModified());
        QCOMPARE(why(d.save()), "");
        QCOMPARE(bytesOf(m_fixture->main), "Seed = 9\n");
    }

    void restoresNewText() {
        {
            Document lost(*m_application);
            QVERIFY(lost.openNew("untitled.sim", "Tick = 1 ms\n").ok());
            QVERIFY(lost.setValues(u"Set"_qs, {{"Tick", "2 ms"}}).ok());
            const std::string state = m_fixture->path("state");
            EVENTUALLY(!journalsBelow(state).empty());
            const std::string journal = journalsBelow(state)[0];
            m_kept = bytesOf(journal);
            m_journal = journal;
        }
        QVERIFY(!fs::exists(m_journal));
        fs::create_directories(fs::path(m_journal).parent_path());
        std::ofstream(m_journal, std::ios::binary) << m_kept; // as after a crash
        Document& d = *m_document;
        const auto found = d.recoveries();
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].head.name, "untitled.sim");
        QCOMPARE(why(d.recover(found[0])), "");
        QVERIFY(d.isNew());
        QVERIFY(d.isModified());
        QCOMPARE(*d.text("untitled.sim"), "Tick = 2 ms\n");
        QVERIFY(d.recoveries().empty());
    }

    void secondWindowIsReadOnly() {
        Document& first = *m_document;
        Document second(*m_application);
        QSignalSpy reported(&second, &Document::readOnlyChanged), refused(&second, &Document::refused);
        QVERIFY(first.open(m_fixture->main).ok());
        QCOMPARE(why(second.open(m_fixture->robot)), "");
        QVERIFY(!first.isReadOnly());
        QVERIFY(second.isReadOnly());
        QCOMPARE(reported.count(), 1);
        QVERIFY(holds(reportOf(reported), "another window"));
        QVERIFY(!second.replaceText(u"Type"_qs, m_fixture->robot, "x").ok());
        QCOMPARE(refused.count(), 1);
        // What the first document saves is shown in the second.
        QVERIFY(first.setValues(u"Set"_qs, {{"RobotConfig.Rover.chassis.hull.Mass", "7"}}).ok());
        QCOMPARE(why(first.save()), "");
        EVENTUALLY_EQUAL(*second.text(m_fixture->robot), *first.text(m_fixture->robot));
        second.editAnyway();
        QVERIFY(!second.isReadOnly());
        QCOMPARE(why(second.replaceText(u"Type"_qs, m_fixture->robot, "x")), "");
        QCOMPARE(why(second.save()), "");
        first.close();
        second.close();
        QVERIFY(second.open(m_fixture->main).ok());
        QVERIFY(!second.isReadOnly());
    }

    void readOnlyWindowEditsAfterOtherCloses() {
        Document& first = *m_document;
        Document second(*m_application);
        QSignalSpy noticed(&second, &Document::notice);
        QVERIFY(first.open(m_fixture->main).ok());
        QCOMPARE(why(second.open(m_fixture->robot)), "");
        QVERIFY(!second.replaceText(u"Type"_qs, m_fixture->robot, "x").ok());
        first.close();
        QCOMPARE(why(second.replaceText(u"Type"_qs, m_fixture->robot, "x")), "");
        QVERIFY(!second.isReadOnly());
        QCOMPARE(noticed.count(), 1);
        QCOMPARE(why(second.save()), "");
        QVERIFY(first.open(m_fixture->main).ok());
        QVERIFY(first.isReadOnly()); // the second document has the lock now
        second.close();
        first.checkExternalChanges(); // the window does this when it is activated
        QVERIFY(!first.isReadOnly());
    }

    void samplesAndNewTextsNeedNoLock() {
        const std::string sample = std::string(TRUNDLE_SOURCE_DIR) + "/configs/experiments/linear_motion.sim";
        Document second(*m_application);
        QVERIFY(m_document->open(sample).ok() && second.open(sample).ok());
        QVERIFY(!second.isReadOnly());
        QVERIFY(m_document->openNew("a.sim", "").ok() && second.openNew("a.sim", "").ok());
        QVERIFY(!second.isReadOnly());
    }

private:
    [[nodiscard]] std::string journals() const { return projectStateFolder(m_fixture->path("configs")) + "/journal"; }
    static std::vector<std::string> journalsBelow(const std::string& folder) {
        std::vector<std::string> found;
        std::error_code none;
        for (fs::recursive_directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
            if (at->path().extension() == ".journal") found.push_back(at->path().string());
        return found;
    }

    /// Leaves a journal as a crashed window does.
    void leave(const JournalHead& head, const std::map<std::string, RecoveredText>& files) {
        Journal journal(m_fixture->path("configs"), head);
        for (const auto& [path, text] : files) QVERIFY(journal.note(path, text.base, text.text).ok());
    }

    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
    std::unique_ptr<Document> m_document;
    std::string m_kept, m_journal;
};

QTEST_GUILESS_MAIN(RecoveryTest)
#include "recovery_test.moc"
