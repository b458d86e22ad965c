// Recovery after a crash, and two windows with the same project.

#include <QSignalSpy>
#include <QTest>

#include "editor/document/journal_writer.h"
#include "editor/document/structure_edits.h"
#include "eventually.h"
#include "file_limit.h"
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
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(!fs::exists(journals()));
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
        QTRY_VERIFY_WITH_TIMEOUT(fs::exists(journals()), 2000);
        QVERIFY(d.recovery().recoveries().empty()); // its own journal is not offered
        QCOMPARE(why(d.saving().save()), "");
        QVERIFY(!fs::exists(journals()));
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "0.03"}}).ok());
        EVENTUALLY(fs::exists(journals()));
        d.edits().undo();
        EVENTUALLY(!fs::exists(journals())); // no unsaved changes
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "0.04"}}).ok());
        EVENTUALLY(fs::exists(journals()));
        d.opening().close(); // the user was asked before close()
        QVERIFY(!fs::exists(m_fixture->path("configs/.trundle")));
    }

    /// An end request (such as SIGTERM) writes the journal at once, without its delay of half a second.
    void journalsEditsOnEndRequest() {
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
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
        QVERIFY(d.opening().open(m_fixture->main).ok());
        const auto found = d.recovery().recoveries();
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].head.opened, m_fixture->main);
        QCOMPARE(why(d.recovery().recover(found[0])), "");
        QCOMPARE(*d.texts().text(m_fixture->main), std::string(kMain) + "Seed = 9\n");
        QCOMPARE(*d.texts().text(m_fixture->robot), "Seed=1\n");
        QVERIFY(d.texts().isModified());
        QCOMPARE(d.edits().history().entries().size(), 1u);
        QVERIFY(d.recovery().recoveries().empty());
        QVERIFY(fs::exists(journals())); // now in this document's own journal
        d.edits().undo();
        QVERIFY(!d.texts().isModified());
        QCOMPARE(bytesOf(m_fixture->main), kMain);
    }

    void recoversFromTheWelcomePage() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {kMain, "Seed = 9\n"}}});
        Document& d = *m_document;
        QCOMPARE(why(d.recovery().recover(findRecoveries(m_fixture->path("configs")).at(0))), "");
        QCOMPARE(d.path(), m_fixture->main);
        QCOMPARE(*d.texts().text(m_fixture->main), "Seed = 9\n");
    }

    void recoversOverAnotherText() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {kMain, std::string(kMain) + "Seed = 9\n"}}});
        m_fixture->write("configs/main.sim", std::string("Title=\"T\"\n") + kMain);
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        const std::string both = std::string("Title=\"T\"\n") + kMain + "Seed = 9\n";
        QCOMPARE(DocumentRecovery::recoveredText(m_fixture->main, d.recovery().recoveries().at(0).files.at(m_fixture->main)),
                 both); // preview
        QCOMPARE(why(d.recovery().recover(d.recovery().recoveries().at(0))), "");
        QCOMPARE(*d.texts().text(m_fixture->main), both);
        QVERIFY(d.disk().conflicts().empty());
    }

    void bothChangedTheSameLine() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {"Seed = 1\n", "Seed = 2\n"}}});
        m_fixture->write("configs/main.sim", "Seed = 3\n");
        Document& d = *m_document;
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QSignalSpy asked(&d.disk(), &ExternalChanges::conflictFound);
        QCOMPARE(why(d.recovery().recover(d.recovery().recoveries().at(0))), "");
        QCOMPARE(asked.count(), 1);
        QCOMPARE(*d.texts().text(m_fixture->main), "Seed = 2\n");
        QCOMPARE(*d.disk().conflicts().at(m_fixture->main), "Seed = 3\n");
        QVERIFY(!d.saving().save().ok());
        QVERIFY(d.disk().resolve(m_fixture->main, ExternalChanges::Resolution::Mine).ok());
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(m_fixture->main), "Seed = 2\n");
    }

    void restoresDeletedFile() {
        leave({m_fixture->main, {}}, {{m_fixture->main, {kMain, "Seed = 9\n"}}});
        fs::remove(m_fixture->main);
        Document& d = *m_document;
        QVERIFY(!d.opening().open(m_fixture->main).ok());
        QCOMPARE(why(d.recovery().recover(findRecoveries(m_fixture->path("configs")).at(0))), "");
        QCOMPARE(*d.texts().text(m_fixture->main), "Seed = 9\n");
        QVERIFY(d.texts().isModified());
        QCOMPARE(why(d.saving().save()), "");
        QCOMPARE(bytesOf(m_fixture->main), "Seed = 9\n");
    }

    void restoresNewText() {
        {
            Document lost(*m_application);
            QVERIFY(lost.opening().openNew("untitled.sim", "Tick = 1 ms\n").ok());
            QVERIFY(lost.structure().setValues(u"Set"_qs, {{"Tick", "2 ms"}}).ok());
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
        const auto found = d.recovery().recoveries();
        QCOMPARE(found.size(), 1u);
        QCOMPARE(found[0].head.name, "untitled.sim");
        QCOMPARE(why(d.recovery().recover(found[0])), "");
        QVERIFY(d.isNew());
        QVERIFY(d.texts().isModified());
        QCOMPARE(*d.texts().text("untitled.sim"), "Tick = 2 ms\n");
        QVERIFY(d.recovery().recoveries().empty());
    }

    /// Restoring asks about unsaved changes only where it replaces what is open.
    void whatIsOpenIsReplacedByEditsOfAnotherText() {
        Document& d = *m_document;
        const auto of = [](const std::string& opened, const std::string& name = {}) {
            Recovery recovery;
            recovery.head = {opened, name};
            return recovery;
        };
        QVERIFY(!d.recovery().isReplacedBy(of(m_fixture->main))); // nothing is open
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(!d.recovery().isReplacedBy(of(m_fixture->main)));
        QVERIFY(d.recovery().isReplacedBy(of(m_fixture->robot)));
        QVERIFY(d.recovery().isReplacedBy(of(m_fixture->main, "untitled.sim"))); // edits of a new text
        QVERIFY(d.opening().openNew("untitled.sim", "Tick = 0.01\n").ok());
        QVERIFY(d.recovery().isReplacedBy(of(m_fixture->main)));
        QVERIFY(d.recovery().isReplacedBy(of("untitled.sim")));
    }

    /// Each time that the journal cannot be written it is said once, not at every edit.
    void aJournalThatFailsIsReportedOnceEachTime() {
        OpenFiles files;
        files.take(m_fixture->main, std::make_shared<const std::string>(kMain));
        JournalWriter writer(files);
        QSignalSpy failed(&writer, &JournalWriter::failed);
        writer.start(m_fixture->path("configs"), {m_fixture->main, {}});
        int version = 0;
        const auto write = [&](bool full) {
            files.find(m_fixture->main)->text = std::make_shared<const std::string>(kMain + std::to_string(++version));
            const FileLimit limit(full ? 0 : RLIM_INFINITY);
            writer.writeNow();
            return int(failed.count());
        };
        QCOMPARE(write(false), 0);
        QCOMPARE(write(true), 1);
        QCOMPARE(write(true), 1);
        QCOMPARE(write(false), 1);
        QCOMPARE(write(true), 2);
        QVERIFY(!reportOf(failed).empty());
        QVERIFY(!writer.path().empty());
        writer.stop();
        QVERIFY(writer.path().empty());
        writer.later();
        writer.writeNow(); // without a journal nothing happens
        QCOMPARE(failed.count(), 2);
    }

    void secondWindowIsReadOnly() {
        Document& first = *m_document;
        Document second(*m_application);
        QSignalSpy reported(&second.access(), &ProjectAccess::changed), refused(&second, &Document::refused);
        QVERIFY(first.opening().open(m_fixture->main).ok());
        QCOMPARE(why(second.opening().open(m_fixture->robot)), "");
        QVERIFY(!first.access().isReadOnly());
        QVERIFY(second.access().isReadOnly());
        QCOMPARE(reported.count(), 1);
        QVERIFY(holds(reportOf(reported), "another window"));
        QVERIFY(!second.edits().replaceText(u"Type"_qs, m_fixture->robot, "x").ok());
        QCOMPARE(refused.count(), 1);
        // What the first document saves is shown in the second.
        QVERIFY(first.structure().setValues(u"Set"_qs, {{"RobotConfig.Rover.chassis.hull.Mass", "7"}}).ok());
        QCOMPARE(why(first.saving().save()), "");
        EVENTUALLY_EQUAL(*second.texts().text(m_fixture->robot), *first.texts().text(m_fixture->robot));
        second.access().editAnyway();
        QVERIFY(!second.access().isReadOnly());
        QCOMPARE(why(second.edits().replaceText(u"Type"_qs, m_fixture->robot, "x")), "");
        QCOMPARE(why(second.saving().save()), "");
        first.opening().close();
        second.opening().close();
        QVERIFY(second.opening().open(m_fixture->main).ok());
        QVERIFY(!second.access().isReadOnly());
    }

    void readOnlyWindowEditsAfterOtherCloses() {
        Document& first = *m_document;
        Document second(*m_application);
        QSignalSpy noticed(&second, &Document::notice);
        QVERIFY(first.opening().open(m_fixture->main).ok());
        QCOMPARE(why(second.opening().open(m_fixture->robot)), "");
        QVERIFY(!second.edits().replaceText(u"Type"_qs, m_fixture->robot, "x").ok());
        first.opening().close();
        QCOMPARE(why(second.edits().replaceText(u"Type"_qs, m_fixture->robot, "x")), "");
        QVERIFY(!second.access().isReadOnly());
        QCOMPARE(noticed.count(), 1);
        QCOMPARE(why(second.saving().save()), "");
        QVERIFY(first.opening().open(m_fixture->main).ok());
        QVERIFY(first.access().isReadOnly()); // the second document has the lock now
        second.opening().close();
        first.disk().check(); // the window does this when it is activated
        QVERIFY(!first.access().isReadOnly());
    }

    void samplesAndNewTextsNeedNoLock() {
        const std::string sample = std::string(TRUNDLE_SOURCE_DIR) + "/configs/experiments/linear_motion.sim";
        Document second(*m_application);
        QVERIFY(m_document->opening().open(sample).ok() && second.opening().open(sample).ok());
        QVERIFY(!second.access().isReadOnly());
        QVERIFY(m_document->opening().openNew("a.sim", "").ok() && second.opening().openNew("a.sim", "").ok());
        QVERIFY(!second.access().isReadOnly());
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
        for (const auto& [path, text] : files)
            QVERIFY(journal.note(path, std::make_shared<std::string>(text.base), std::make_shared<std::string>(text.text)).ok());
    }

    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
    std::unique_ptr<Document> m_document;
    std::string m_kept, m_journal;
};

QTEST_GUILESS_MAIN(RecoveryTest)
#include "recovery_test.moc"
