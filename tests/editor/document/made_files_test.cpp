// Files that edits make.
#include <QTest>

#include "sample_document.h"

using namespace trundle;
using namespace sample;

class MadeFilesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_desk = std::make_unique<Desk>();
        m_document = std::make_unique<Document>(*m_parts);
        QVERIFY(m_document->open(m_desk->main).ok());
    }
    void cleanup() { m_document.reset(); }

    void aFileThatAnEditMakesComesAndGoesWithIt() {
        const std::string piece = m_desk->path("configs/objects/piece.sim"), text = "StaticConfig Piece { Box b { Size=1,1,1 } }\n";
        const auto make = [&] {
            EditPlan plan;
            plan.edits[0] = {{{0, {0, 0}}, "#import objects/piece.sim\nStatic piece { Config=Piece }\n"}};
            const bool made = m_document->replaceText(QStringLiteral("Group"), piece, text, "group").ok() &&
                              m_document->carryOut(QStringLiteral("Group"), plan, "group").ok();
            m_document->endMerge();
            return made;
        };
        const auto onDisk = [&] { return std::filesystem::exists(piece); };
        QVERIFY(make());
        QVERIFY(!m_document->loaded()->diagnostics.hasErrors());
        QCOMPARE(m_document->loaded()->experiment->statics.size(), std::size_t(1));
        QCOMPARE(m_document->history().entries().size(), std::size_t(1));
        QVERIFY(m_document->isModified(piece) && !onDisk());
        m_document->lookAtDisk(); // it is not gone: it was never there
        m_document->undo();
        QVERIFY(!m_document->isModified());
        m_document->redo();
        QCOMPARE(why(m_document->save()), "");
        QCOMPARE(bytesOf(piece), text);
        QVERIFY(!m_document->isModified());
        // Undo takes back the file too, once it is saved.
        m_document->undo();
        QVERIFY(m_document->isModified(piece) && onDisk());
        QCOMPARE(why(m_document->save()), "");
        QVERIFY(!onDisk());
        QVERIFY(!m_document->isModified());
        QCOMPARE(bytesOf(m_desk->main), std::string(kMain));
        m_document->lookAtDisk();
        QVERIFY(!m_document->isModified());
        m_document->redo();
        QCOMPARE(why(m_document->save()), "");
        QCOMPARE(bytesOf(piece), text);
        // One that stands there already is not written over, and nothing is made outside the project.
        m_desk->write("configs/objects/other.sim", "// mine\n");
        for (const char* name : {"configs/objects/other.sim", "elsewhere.sim", "configs/../elsewhere.sim"})
            QVERIFY(!m_document->replaceText(QStringLiteral("Group"), m_desk->path(name), "x").ok());
        QCOMPARE(bytesOf(m_desk->path("configs/objects/other.sim")), std::string("// mine\n"));
        QVERIFY(!std::filesystem::exists(m_desk->path("elsewhere.sim")));
    }

private:
    std::unique_ptr<Parts> m_parts = makeParts();
    std::unique_ptr<Desk> m_desk;
    std::unique_ptr<Document> m_document;
};

QTEST_GUILESS_MAIN(MadeFilesTest)
#include "made_files_test.moc"
