// A rename in texts of the project that are not loaded: of the same object, not of others that have its path.
#include <QTest>

#include "editor/document/structure_edits.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

const char* const kHull = "Body hull { Box b { Size=1,1,1 Mass=1 } }";
const char* const kPiece = "Body wheel { Pos=0,1,0 Sphere s { Radius=0.1 Mass=1 } }\nHinge axle { Parent=hull Child=wheel }\n";

} // namespace

class ProjectRenameTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    void otherObjectsOfThatPath_data() {
        QTest::addColumn<std::string>("other");
        QTest::addColumn<bool>("isRenamed");
        const std::string hull = kHull, use = "Robot o { Config=Cart hull.b.Mass=2 }\n";
        QTest::newRow("a config with the same piece")
            << "RobotConfig Cart {\n  " + hull + "\n  #import piece.sim\n}\n" + use << true;
        QTest::newRow("a config of its own")
            << "RobotConfig Other {\n  " + hull + "\n  #import piece.sim\n}\nRobotConfig Cart { " + hull + " }\n" + use << false;
        QTest::newRow("without that path") << "RobotConfig Other {\n  " + hull + "\n  #import piece.sim\n}\n" << false;
    }
    void otherObjectsOfThatPath() {
        QFETCH(std::string, other);
        QFETCH(bool, isRenamed);
        const DocumentFixture fixture;
        fixture.write("configs/piece.sim", kPiece);
        const std::string file = fixture.write("configs/other.sim", other);
        const std::string own = fixture.write("configs/own.sim", "RobotConfig Cart {\n  " + std::string(kHull) +
                                                                     "\n  #import piece.sim\n}\nRobot r { Config=Cart }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(own).ok());
        QVERIFY(!d.loaded()->diagnostics.hasErrors());
        QVERIFY(d.structure().rename(u"Rename"_qs, "RobotConfig.Cart.hull", "base").ok());
        QVERIFY(holds(*d.texts().text(own), "Body base {"));
        QVERIFY(holds(*d.texts().text(fixture.path("configs/piece.sim")), "Parent=base"));
        QCOMPARE(d.texts().isModified(file), isRenamed);
        if (isRenamed) QVERIFY2(holds(*d.texts().text(file), "base.b.Mass=2"), d.texts().text(file)->c_str());
        QCOMPARE(d.edits().history().entries().size(), 1u);
        d.edits().undo();
        QVERIFY(!d.texts().isModified());
    }

    /// The notice has the name that the copy has got.
    void aShippedConfig() {
        const DocumentFixture fixture;
        Document d(*m_application);
        QVERIFY(
            d.opening()
                .open(fixture.write("configs/own.sim", "#import arenas/medium_arena.sim\nStatic arena { Config=MediumArena }\n"))
                .ok());
        QSignalSpy notices(&d, &Document::notice);
        QVERIFY(d.structure().rename(u"Rename"_qs, "StaticConfig.MediumArena", "Yard").ok());
        QVERIFY(holds(*d.texts().text(d.path()), "Config=Yard"));
        const std::string notice = reportOf(notices);
        QVERIFY2(holds(notice, "arena uses Yard, a copy of it") && !holds(notice, "MediumArena2"), notice.c_str());
    }

private:
    std::unique_ptr<Application> m_application;
};

QTEST_GUILESS_MAIN(ProjectRenameTest)
#include "project_rename_test.moc"
