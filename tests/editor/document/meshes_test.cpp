// Meshes are read once, by a separate process, and no edit waits for it.

#include <QTest>

#include "editor/document/structure_edits.h"
#include "eventually.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

const char* kCube = R"(v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 1 1 1
f 1 3 2
f 2 3 4
f 5 6 7
f 6 8 7
f 1 2 5
f 2 6 5
f 3 7 4
f 4 7 8
f 1 5 3
f 3 5 7
f 2 4 6
f 4 8 6
)";

std::string withMesh(const std::string& file) {
    return "StaticConfig Thing { Mesh shape { File=" + file + " } }\nStatic thing { Config=Thing }\n";
}

const TriangleMesh* meshOf(const LoadedProject& loaded) {
    const auto& statics = loaded.experiment->statics;
    return statics.empty() || statics[0].geoms->empty() ? nullptr : (*statics[0].geoms)[0].mesh.get();
}

/// The largest z of the mesh in metres; 0 if there is none.
double highest(const LoadedProject& loaded) {
    const TriangleMesh* mesh = meshOf(loaded);
    double z = 0;
    if (mesh)
        for (const auto& point : mesh->points) z = std::max(z, point[2]);
    return z;
}

} // namespace

class MeshesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }
    void init() {
        m_fixture = std::make_unique<DocumentFixture>();
        m_fixture->write("configs/cube.obj", kCube);
        m_fixture->write("configs/thing.sim", withMesh("cube.obj"));
    }

    void laterIsNotNow() {
        OpenOptions later;
        later.meshesLater = true;
        const std::string path = m_fixture->path("configs/thing.sim");
        const auto first = m_application->open(path, later).value();
        QVERIFY(first->pending);
        QVERIFY(holds(messages(*first), "cube.obj is being read"));
        const auto whole = m_application->open(path, {}).value();
        QVERIFY(!whole->pending);
        QVERIFY2(messages(*whole).empty(), messages(*whole).c_str());
        QVERIFY(meshOf(*whole));
        const auto again = m_application->open(path, later).value();
        QVERIFY(!again->pending);
        QVERIFY2(messages(*again).empty(), messages(*again).c_str());
    }

    void loadsTypedMesh() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QCOMPARE(why(d.edits().replaceText(u"Type"_qs, m_fixture->main, withMesh("cube.obj"))), "");
        QVERIFY(d.loaded()->pending);
        EVENTUALLY(!d.loaded()->pending);
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
        const TriangleMesh* mesh = meshOf(*d.loaded());
        QVERIFY(mesh);
        QCOMPARE(d.edits().history().entries().size(), 1u);
        const std::uint64_t revision = d.revision();
        QCOMPARE(why(d.structure().setValues(u"Move"_qs, {{"thing.Pos", "1,0,0"}})), "");
        QVERIFY(!d.loaded()->pending); // cached
        QCOMPARE(meshOf(*d.loaded()), mesh);
        QCOMPARE(d.revision(), revision + 1);
    }

    void cachesMeshResults() {
        const std::string file =
            m_fixture->write("configs/ball.sim", "Tick = 0.01\nRobotConfig Ball { Body b { Mesh shape { File=cube.obj Scale=2 "
                                                 "Density=1 } } }\nRobot r { Config=Ball }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
        const auto before = d.loaded();
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"Tick", "0.02"}}).ok());
        const BodySpec &old = before->experiment->robots[0].config->bodies[0],
                       &now = d.loaded()->experiment->robots[0].config->bodies[0];
        QVERIFY(old.geoms[0].mesh && old.geoms[0].mesh == now.geoms[0].mesh); // scaled only once
        QVERIFY(old.geoms[0].hull && old.geoms[0].hull == now.geoms[0].hull);
        QCOMPARE(now.mass.mass, 8.0);
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"RobotConfig.Ball.b.shape.Scale", "1,2,3"}}).ok());
        QCOMPARE(d.loaded()->experiment->robots[0].config->bodies[0].mass.mass, 6.0);
        d.edits().undo();
        QCOMPARE(d.loaded()->experiment->robots[0].config->bodies[0].mass.mass, 8.0);
    }

    void aMeshIsChosenInARow() {
        m_fixture->write("configs/other.obj", kCube);
        m_fixture->write("configs/broken.obj", "this is no mesh");
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->path("configs/thing.sim")).ok());
        QCOMPARE(why(d.structure().setValues(u"Set File"_qs, {{"StaticConfig.Thing.shape.File", "other.obj"}})), "");
        EVENTUALLY(!d.loaded()->pending);
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
        QCOMPARE(why(d.structure().setValues(u"Set File"_qs, {{"StaticConfig.Thing.shape.File", "broken.obj"}})), "");
        EVENTUALLY(!d.loaded()->pending);
        QVERIFY(holds(messages(*d.loaded()), "broken.obj"));
        QVERIFY(!d.structure().setValues(u"Set File"_qs, {{"StaticConfig.Thing.shape.File", "missing.obj"}}).ok());
    }

    void aMeshThatChangesOnTheDiskIsReadAgain() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->path("configs/thing.sim")).ok());
        QVERIFY(meshOf(*d.loaded()));
        QCOMPARE(highest(*d.loaded()), 1.0);
        std::string higher = kCube;
        for (std::size_t at = 0; (at = higher.find(" 1\nv", at)) != std::string::npos;) higher.replace(at, 2, " 3");
        m_fixture->write("configs/cube.obj", higher);
        EVENTUALLY_EQUAL(highest(*d.loaded()), 3.0);
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
        QVERIFY(!d.texts().isModified());
        QVERIFY(d.edits().history().entries().empty());
        // Replaced by rename, as most programs save.
        m_fixture->write("configs/new.obj", kCube);
        std::filesystem::rename(m_fixture->path("configs/new.obj"), m_fixture->path("configs/cube.obj"));
        EVENTUALLY_EQUAL(highest(*d.loaded()), 1.0);
        QVERIFY(!d.texts().isModified());
    }

    void reportsMissingAndReturnedMesh() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->path("configs/thing.sim")).ok());
        std::filesystem::remove(m_fixture->path("configs/cube.obj"));
        EVENTUALLY(holds(messages(*d.loaded()), "cube.obj"));
        m_fixture->write("configs/cube.obj", kCube);
        EVENTUALLY(messages(*d.loaded()).empty());
        QVERIFY(meshOf(*d.loaded()));
    }

    void aPictureThatChangesOnTheDiskIsReadAgain() {
        const auto picture = [](const char* grey) { return std::string("P2\n2 2\n255\n0 0\n0 ") + grey + "\n"; };
        m_fixture->write("configs/hill.pgm", picture("255"));
        const std::string file = m_fixture->write(
            "configs/hills.sim",
            "StaticConfig Hills { Heightfield hill { File=hill.pgm Size=1,1,1 } }\nStatic hills { Config=Hills }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
        const auto top = [&] {
            const auto& statics = d.loaded()->experiment->statics;
            const auto map = statics.empty() || statics[0].geoms->empty() ? nullptr : (*statics[0].geoms)[0].heightMap;
            return map ? *std::ranges::max_element(map->heights) : -1;
        };
        const double before = top();
        m_fixture->write("configs/hill.pgm", picture("100"));
        EVENTUALLY(top() > 0 && top() < before);
    }

    void loadsAppearingImport() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->write("configs/waits.sim", "#import later.sim\n")).ok());
        QVERIFY(holds(messages(*d.loaded()), "later.sim"));
        m_fixture->write("configs/later.sim", "Tick = 0.02\n");
        EVENTUALLY_EQUAL(d.loaded()->experiment->settings.tick, 0.02);
        QVERIFY(messages(*d.loaded()).empty());
    }

    void survivesClosingWhileMeshLoads() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->main).ok());
        QVERIFY(d.edits().replaceText(u"Type"_qs, m_fixture->main, withMesh("cube.obj")).ok());
        d.opening().close();
        QVERIFY(d.opening().open(m_fixture->path("configs/thing.sim")).ok());
        QVERIFY(d.edits().replaceText(u"Type"_qs, d.path(), withMesh("cube.obj") + "// more\n").ok());
        EVENTUALLY(!d.loaded()->pending);
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
    }

private:
    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
};

QTEST_GUILESS_MAIN(MeshesTest)
#include "meshes_test.moc"
