// Files that edits create, and their undo, save and recovery.
#include <QTest>

#include "project/journal/state_folder.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

class MadeFilesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_fixture = std::make_unique<DocumentFixture>();
        m_document = std::make_unique<Document>(*m_application);
        QVERIFY(m_document->opening().open(m_fixture->main).ok());
    }
    void cleanup() { m_document.reset(); }

    void undoRemovesCreatedFile() {
        const std::string piece = this->piece(), text = kPiece;
        const auto make = [&] { return group(); };
        const auto onDisk = [&] { return std::filesystem::exists(piece); };
        QVERIFY(make());
        QVERIFY(!m_document->loaded()->diagnostics.hasErrors());
        QCOMPARE(m_document->loaded()->experiment->statics.size(), std::size_t(1));
        QCOMPARE(m_document->edits().history().entries().size(), std::size_t(1));
        QVERIFY(m_document->texts().isModified(piece) && !onDisk());
        m_document->disk().check(); // not reported as removed: it was never written
        m_document->edits().undo();
        QVERIFY(!m_document->texts().isModified());
        m_document->edits().redo();
        QCOMPARE(why(m_document->saving().save()), "");
        QCOMPARE(bytesOf(piece), text);
        QVERIFY(!m_document->texts().isModified());
        // Undo removes the file too, at the next save.
        m_document->edits().undo();
        QVERIFY(m_document->texts().isModified(piece) && onDisk());
        QCOMPARE(why(m_document->saving().save()), "");
        QVERIFY(!onDisk());
        QVERIFY(!m_document->texts().isModified());
        QCOMPARE(bytesOf(m_fixture->main), std::string(kMain));
        m_document->disk().check();
        QVERIFY(!m_document->texts().isModified());
        m_document->edits().redo();
        QCOMPARE(why(m_document->saving().save()), "");
        QCOMPARE(bytesOf(piece), text);
        // An existing file is not overwritten, and no file is created outside the project.
        m_fixture->write("configs/objects/other.sim", "// mine\n");
        for (const char* name :
             {"configs/objects/other.sim", "elsewhere.sim", "configs/../elsewhere.sim", "configs2.sim", "configs2/a.sim"})
            QVERIFY2(!m_document->edits().replaceText(QStringLiteral("Group"), m_fixture->path(name), "x").ok(), name);
        QCOMPARE(bytesOf(m_fixture->path("configs/objects/other.sim")), std::string("// mine\n"));
        QVERIFY(!std::filesystem::exists(m_fixture->path("elsewhere.sim")));
    }

    void recoveryTracksCreatedFiles_data() {
        QTest::addColumn<QString>("steps"); // g: group, s: save, u: undo, r: redo, x: another program removes the file
        QTest::addColumn<bool>("isThere");  // after recovery and a save
        QTest::newRow("never saved") << "g" << true;
        QTest::newRow("undone after a save") << "gsu" << false;
        QTest::newRow("undone and redone") << "gsur" << true;
        QTest::newRow("removed, then redone") << "gsusr" << true;
        QTest::newRow("undone, and removed by another program") << "gsux" << false;
    }
    void recoveryTracksCreatedFiles() {
        QFETCH(QString, steps);
        QFETCH(bool, isThere);
        for (const char step : steps.toStdString()) {
            if (step == 'g') QVERIFY(group());
            if (step == 's') QCOMPARE(why(m_document->saving().save()), "");
            if (step == 'u') m_document->edits().undo();
            if (step == 'r') m_document->edits().redo();
            if (step == 'x') std::filesystem::remove(piece());
        }
        std::string journal = journalOf(*m_document);
        if (steps == u"gsur") QVERIFY(journal.empty()); // no unsaved changes
        QVERIFY(restart(journal));
        const auto found = m_document->recovery().recoveries();
        if (!found.empty()) QCOMPARE(why(m_document->recovery().recover(found.at(0))), "");
        QVERIFY2(!m_document->loaded()->diagnostics.hasErrors(), messages(*m_document->loaded()).c_str());
        QCOMPARE(m_document->loaded()->experiment->statics.size(), std::size_t(isThere));
        QCOMPARE(why(m_document->saving().save()), "");
        QCOMPARE(std::filesystem::exists(piece()), isThere);
        if (isThere) QCOMPARE(bytesOf(piece()), std::string(kPiece));
        QVERIFY(!m_document->texts().isModified());
        if (found.empty()) return;
        m_document->edits().undo(); // undoes the recovery; again: the edit, with the file that it created
        QCOMPARE(why(m_document->saving().save()), "");
        QVERIFY(!m_document->texts().isModified());
        QVERIFY(!std::filesystem::exists(piece()) || bytesOf(piece()) == kPiece); // never an empty file
        m_document->edits().redo();
        QCOMPARE(why(m_document->saving().save()), "");
        QCOMPARE(std::filesystem::exists(piece()), isThere);
    }

    void aSaveThatWasCutOffIsFinished() {
        QVERIFY(group());
        QCOMPARE(why(m_document->saving().save()), "");
        m_document->edits().undo();
        const std::string journal = journalOf(*m_document);
        QCOMPARE(why(m_document->saving().save()), "");
        QVERIFY(restart(journal)); // everything was saved, only the journal was not removed
        QVERIFY(m_document->recovery().recoveries().empty());
    }

    void saveAsTracksCreatedFiles() {
        QVERIFY(group());
        QCOMPARE(why(m_document->saving().save()), "");
        const std::string copy = m_fixture->path("elsewhere/main.sim"), moved = m_fixture->path("elsewhere/objects/piece.sim");
        std::filesystem::create_directories(m_fixture->path("elsewhere"));
        QCOMPARE(why(m_document->saving().saveAs(copy)), "");
        QCOMPARE(bytesOf(moved), std::string(kPiece));
        m_document->edits().undo(); // undoes the changed import paths
        while (m_document->edits().history().canUndo()) m_document->edits().undo();
        QCOMPARE(why(m_document->saving().save()), "");
        QVERIFY(!std::filesystem::exists(moved));
        QCOMPARE(bytesOf(piece()), std::string(kPiece)); // the first experiment keeps its file
    }

private:
    static constexpr const char* kPiece = "StaticConfig Piece { Box b { Size=1,1,1 } }\n";
    [[nodiscard]] std::string piece() const { return m_fixture->path("configs/objects/piece.sim"); }
    bool group() {
        EditPlan plan;
        plan.edits[0] = {{{0, {0, 0}}, "#import objects/piece.sim\nStatic piece { Config=Piece }\n"}};
        const bool made = m_document->edits().replaceText(QStringLiteral("Group"), piece(), kPiece, "group").ok() &&
                          m_document->edits().apply(QStringLiteral("Group"), plan, "group").ok();
        m_document->edits().endMerge();
        return made;
    }
    /// The bytes of the journal, "" if there is none.
    std::string journalOf(Document& document) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(), [] { QCoreApplication::exit(0); }, Qt::QueuedConnection);
        QCoreApplication::exec(); // journals pending changes when it quits
        std::error_code none;
        const std::string folder = projectStateFolder(m_fixture->path("configs")) + "/journal";
        for (std::filesystem::directory_iterator at(folder, none), end; !none && at != end; at.increment(none))
            if (document.texts().isModified()) return bytesOf(at->path().string());
        return {};
    }
    /// Opens a new document, as if the first window had been killed and had left this journal.
    bool restart(const std::string& journal) {
        m_document = std::make_unique<Document>(*m_application);
        const std::filesystem::path folder = projectStateFolder(m_fixture->path("configs")) + "/journal";
        std::filesystem::create_directories(folder);
        if (!journal.empty()) std::ofstream(folder / "1.journal", std::ios::binary) << journal;
        return m_document->opening().open(m_fixture->main).ok();
    }

    std::unique_ptr<Application> m_application = makeApplication();
    std::unique_ptr<DocumentFixture> m_fixture;
    std::unique_ptr<Document> m_document;
};

QTEST_GUILESS_MAIN(MadeFilesTest)
#include "made_files_test.moc"
