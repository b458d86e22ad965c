// Save As copies the files that the texts refer to: meshes, images and modules.

#include <QTest>

#include "eventually.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;
namespace fs = std::filesystem;

namespace {

const char* kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const char* kThing = R"(// A thing.
StaticConfig Thing {
  Mesh shape { File=parts/thing.obj } // below
  Mesh other { File="../common/other.obj" Pos=2,0,0 }
}
Static thing { Config=Thing }
)";

} // namespace

class CompanionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }
    void init() {
        m_fixture = std::make_unique<DocumentFixture>();
        m_fixture->write("configs/things/parts/thing.obj", kTetrahedron);
        m_fixture->write("configs/common/other.obj", kTetrahedron);
        m_thing = m_fixture->write("configs/things/thing.sim", kThing);
        fs::create_directory(m_fixture->path("far"));
    }

    void copiesMeshes() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_thing).ok());
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
        const std::string target = m_fixture->path("far/thing.sim");
        const Result<Companions> along = d.saving().companionsAt(target);
        QVERIFY(along.ok());
        QCOMPARE(along.value().files,
                 (std::vector{m_fixture->path("configs/common/other.obj"), m_fixture->path("configs/things/parts/thing.obj")}));
        QVERIFY(along.value().modules.empty());
        QVERIFY(!fs::exists(target)); // companionsAt() writes nothing

        QSignalSpy notice(&d, &Document::notice);
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QCOMPARE(bytesOf(m_fixture->path("far/parts/thing.obj")), kTetrahedron);
        QCOMPARE(bytesOf(m_fixture->path("far/other.obj")), kTetrahedron);
        std::string expected = kThing; // only paths that led out of the folder change
        expected.replace(expected.find("\"../common/other.obj\""), 21, "\"other.obj\"");
        QCOMPARE(bytesOf(target), expected);
        QVERIFY(!d.texts().isModified());
        QVERIFY(holds(reportOf(notice), "parts/thing.obj"));
        fs::remove_all(m_fixture->path("configs"));
        Document again(*m_application);
        QVERIFY(again.opening().open(target).ok());
        QVERIFY2(messages(*again.loaded()).empty(), messages(*again.loaded()).c_str());
        d.edits().undo(); // the changed paths are an ordinary edit
        QVERIFY(d.texts().isModified());
        QCOMPARE(*d.texts().text(target), kThing);
    }

    void inTheSameProjectTheyStay() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_thing).ok());
        const std::string target = m_fixture->path("configs/copy.sim");
        QVERIFY(d.saving().companionsAt(target).value().empty());
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QVERIFY(!fs::exists(m_fixture->path("configs/parts")));
        QVERIFY2(holds(bytesOf(target), "File=\"things/parts/thing.obj\""), bytesOf(target).c_str());
        EVENTUALLY(!d.loaded()->pending);
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
    }

    /// What is named like a file, and Params that no file has, keep their words.
    void onlyFileNamesAreRewritten() {
        m_fixture->write("configs/things/deck.png", "png");
        const std::string text =
            "Param picture = deck\nParam paint = deck\n"
            "Material deck { Texture=deck }\nMaterial board { Texture=$picture }\n"
            "StaticConfig Floor { Box b { Size=1,1,1 Material=deck } Box c { Size=1,1,1 Material=$paint } }\n"
            "StaticConfig Thing { Param mesh = \"parts/thing.obj\"  Mesh shape { File=$mesh } }\n"
            "StaticConfig Twin { Config=Thing shape.Material=deck }\n"
            "Static a { Config=Floor }\nStatic b { Config=Twin mesh=\"parts/thing.obj\" }\n"
            "Static c { Config=Thing shape.File=parts/thing.obj }\n";
        std::string expected = text;
        for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
                 {"picture = deck", "picture = \"things/deck.png\""},
                 {"Texture=deck", "Texture=\"things/deck.png\""},
                 {"mesh = \"parts", "mesh = \"things/parts"},
                 {"mesh=\"parts", "mesh=\"things/parts"},
                 {"shape.File=parts/thing.obj", "shape.File=\"things/parts/thing.obj\""}})
            expected.replace(expected.find(from), from.size(), to);
        Document d(*m_application);
        QVERIFY(d.opening().open(m_fixture->write("configs/things/deck.sim", text)).ok());
        const std::string target = m_fixture->path("configs/deck2.sim");
        QCOMPARE(why(d.saving().saveAs(target)), "");
        QCOMPARE(bytesOf(target), expected);
    }

    void copiesMeshesOfImportedText() {
        Document d(*m_application);
        const std::string main = m_fixture->write("configs/main2.sim", "#import things/thing.sim\nTick = 0.01\n");
        QVERIFY(d.opening().open(main).ok());
        QCOMPARE(why(d.saving().saveAs(m_fixture->path("far/main2.sim"))), "");
        QVERIFY(fs::exists(m_fixture->path("far/things/parts/thing.obj")));
        EVENTUALLY(!d.loaded()->pending);
        QVERIFY2(messages(*d.loaded()).empty(), messages(*d.loaded()).c_str());
    }

    void noOtherFileIsOverwritten() {
        Document d(*m_application);
        QVERIFY(d.opening().open(m_thing).ok());
        const std::string taken = m_fixture->write("far/parts/thing.obj", "v 0 0 0\n");
        const Status saved = d.saving().saveAs(m_fixture->path("far/thing.sim"));
        QVERIFY(!saved.ok());
        QVERIFY2(holds(why(saved), "far/parts/thing.obj"), why(saved).c_str());
        QCOMPARE(bytesOf(taken), "v 0 0 0\n");
        QVERIFY(!fs::exists(m_fixture->path("far/thing.sim")) && !fs::exists(m_fixture->path("far/other.obj")));
        QCOMPARE(d.path(), m_thing);
        m_fixture->write("far/parts/thing.obj", kTetrahedron); // the same bytes, so it is not copied
        QCOMPARE(why(d.saving().saveAs(m_fixture->path("far/thing.sim"))), "");
    }

    void copiesGltfBuffers() {
        Document d(*m_application);
        m_fixture->write("configs/scan.gltf",
                         R"({"asset":{"version":"2.0"},"buffers":[{"uri":"bits/scan.bin","byteLength":4}]})");
        m_fixture->write("configs/bits/scan.bin", "1234");
        QVERIFY(d.opening().open(m_fixture->write("configs/scan.sim", "StaticConfig S { Mesh m { File=scan.gltf } }\n")).ok());
        QCOMPARE(why(d.saving().saveAs(m_fixture->path("far/scan.sim"))), "");
        QVERIFY(fs::exists(m_fixture->path("far/scan.gltf")));
        QCOMPARE(bytesOf(m_fixture->path("far/bits/scan.bin")), "1234");
    }

    void modulesAreCopiedOrNamed_data() {
        QTest::addColumn<bool>("copied");
        QTest::newRow("copied") << true;
        QTest::newRow("named") << false;
    }
    void modulesAreCopiedOrNamed() {
        QFETCH(bool, copied);
        const std::string library = m_fixture->path("configs/mine/libgood.so");
        fs::create_directories(m_fixture->path("configs/mine"));
        for (const char* end : {"", ".kinds.json"})
            fs::copy_file(std::string(TRUNDLE_BINARY_DIR "/tests/modules/controllers/libgood.so") + end, library + end);
        const std::string text = "#loadModule mine/good // beside\n#loadModule controllers/linear_motion\n";
        Document d(*m_application);
        QVERIFY(d.opening()
                    .open(m_fixture->write("configs/driven.sim", text))
                    .ok()); // its folder is not trusted; it is copied anyway
        const std::string target = m_fixture->path("far/driven.sim");
        QCOMPARE(d.saving().companionsAt(target).value().modules, std::vector{library});
        QCOMPARE(why(d.saving().saveAs(target, copied ? ModuleCopies::Make : ModuleCopies::Name)), "");
        QCOMPARE(fs::exists(m_fixture->path("far/mine/libgood.so")), copied);
        QCOMPARE(fs::exists(m_fixture->path("far/mine/libgood.so.kinds.json")), copied);
        std::string expected = text;
        if (!copied) expected.replace(expected.find("mine/good"), 9, "\"" + m_fixture->path("configs/mine/good") + "\"");
        QCOMPARE(bytesOf(target), expected);
        OpenOptions trusted;
        trusted.trust = true;
        const auto there = m_application->open(target, trusted);
        QVERIFY(there.ok());
        QCOMPARE(there.value()->experiment->modules.size(), 2u);
        QVERIFY(there.value()->diagnostics.all().empty());
        QCOMPARE(there.value()->experiment->modules[0].library, copied ? m_fixture->path("far/mine/libgood.so") : library);
    }

    void aSampleNeedsNothingOfItsFolder() {
        Document d(*m_application);
        QVERIFY(d.opening().open(TRUNDLE_SOURCE_DIR "/configs/experiments/linear_motion.sim").ok());
        QVERIFY(d.saving().companionsAt(m_fixture->path("far/mine.sim")).value().empty());
    }

private:
    std::unique_ptr<Application> m_application;
    std::unique_ptr<DocumentFixture> m_fixture;
    std::string m_thing;
};

QTEST_GUILESS_MAIN(CompanionsTest)
#include "companions_test.moc"
