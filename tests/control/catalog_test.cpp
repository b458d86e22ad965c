// Finding modules in their search folders.
#include "base/platform/read_file.h"
#include "control/directory_catalog.h"
#include "control/kinds_json.h"
#include "control/module_store.h"

#include <QtTest>

#include <QTemporaryDir>

using namespace trundle;

namespace {
const std::string kGood = std::string(TRUNDLE_BINARY_DIR) + "/tests/modules/controllers/libgood.so";
} // namespace

class CatalogTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void fileNamesInTheOrderTheyAreTried_data() {
        QTest::addColumn<QString>("written");
        const QString all = "controllers/libdrive.so controllers/drive.so libdrive.so drive.so";
        QTest::newRow("controllers/drive") << "controllers/libdrive.so controllers/drive.so controllers/drive.py libdrive.so drive.so drive.py";
        QTest::newRow("controllers/drive.py") << "controllers/drive.py drive.py";
        QTest::newRow("controllers/drive.dll") << all;
        QTest::newRow("controllers\\drive.DLL") << all;
        QTest::newRow("controllers/drive.so") << all;
        QTest::newRow("drive") << "libdrive.so drive.so drive.py";
    }
    void fileNamesInTheOrderTheyAreTried() {
        QFETCH(QString, written);
        QStringList names;
        for (const std::string& name : moduleFileNames(QTest::currentDataTag())) names << QString::fromStdString(name);
        QCOMPARE(names.join(' '), written);
    }

    void findsAModuleInTheProgramsFolder() {
        put("program/controllers/libgood.so", true);
        DirectoryCatalog catalog({{}, path("program"), {}, false});
        const auto found = catalog.find("controllers/good", path("experiments"));
        QVERIFY2(found.ok(), found.ok() ? "" : found.error().message.c_str());
        QCOMPARE(found.value().library, path("program/controllers/libgood.so"));
        QVERIFY(found.value().described);
        QCOMPARE(found.value().kinds.size(), std::size_t(5));
        QVERIFY(found.value().kinds[0].find("UpdatePeriod") && found.value().kinds[0].find("Speed"));
        for (const char* written : {"Controllers\\good.dll", "good", "x/libgood.so"}) {
            put("program/libgood.so", false);
            const auto other = catalog.find(written, path("experiments"));
            QVERIFY2(other.ok() && !other.value().described, written);
        }
    }

    void searchesModuleFoldersBeforeProgramFolder() {
        put("program/libgood.so", true);
        put("mine/libgood.so", false);
        DirectoryCatalog catalog({{path("mine")}, path("program"), {}, false});
        QCOMPARE(catalog.find("good", path("experiments")).value().library, path("mine/libgood.so"));
    }

    void besideTheFileOnlyWhereTrusted() {
        put("experiments/libgood.so", true);
        const auto untrusted = DirectoryCatalog({{}, path("program"), {}, false}).find("good", path("experiments"));
        QVERIFY(!untrusted.ok());
        QCOMPARE(untrusted.error().code, Code::ModuleNotTrusted);
        QVERIFY(untrusted.error().message.find("--trust") != std::string::npos);
        QVERIFY(DirectoryCatalog({{}, path("program"), {}, true}).find("good", path("experiments")).ok());
        QVERIFY(DirectoryCatalog({{}, path("program"), {path("experiments")}, false}).find("good", path("experiments")).ok());
        QVERIFY(DirectoryCatalog({{path("experiments/")}, path("program"), {}, false}).find("good", path("experiments")).ok());
    }

    void anUntrustedOneDoesNotHideATrustedOne() {
        put("experiments/libgood.so", true);
        put("program/libgood.so", true);
        const auto found = DirectoryCatalog({{}, path("program"), {}, false}).find("good", path("experiments"));
        QVERIFY(found.ok());
        QCOMPARE(found.value().library, path("program/libgood.so"));
    }

    void climbingOutOfATrustedFolderIsNotTrusted() {
        put("evil/libgood.so", true);
        QDir().mkpath(m_folder->filePath("program/controllers"));
        DirectoryCatalog catalog({{}, path("program"), {}, false});
        QCOMPARE(catalog.find("../evil/good", path("experiments")).error().code, Code::ModuleNotTrusted);
        QCOMPARE(catalog.find("controllers/../../evil/good", path("experiments")).error().code, Code::ModuleNotTrusted);
        QCOMPARE(catalog.find(path("evil/good"), path("experiments")).error().code, Code::ModuleNotTrusted);
        QVERIFY(DirectoryCatalog({{path("evil")}, path("program"), {}, false}).find(path("evil/good"), path("experiments")).ok());
    }

    /// The same from an experiment at another depth, so that only a trusted search folder leads to the module.
    void climbingOutOfASearchFolderIsNotTrusted() {
        put("evil/libgood.so", true);
        put("program/sub/libgood.so", true);
        for (const char* folder : {"program", "mine", "known/deep"}) QDir().mkpath(m_folder->filePath(folder));
        const std::string experiment = path("somewhere/quite/else");
        for (const CatalogFolders& folders : {CatalogFolders{{}, path("program"), {}, false},
                                              {{path("mine")}, "", {}, false},
                                              {{path("mine")}, path("program"), {path("known")}, false}}) {
            DirectoryCatalog catalog(folders);
            for (const char* written : {"../evil/good", "sub/../../evil/good", "..\\evil\\good.dll", "./../evil/libgood.so"}) {
                const auto found = catalog.find(written, experiment);
                QVERIFY2(!found.ok() && found.error().code == Code::ModuleNotTrusted, written);
            }
        }
        // Inside the folder, or in another trusted one, it may climb.
        QVERIFY(DirectoryCatalog({{}, path("program"), {}, false}).find("x/../sub/good", experiment).ok());
        QVERIFY(DirectoryCatalog({{}, path("program"), {path("evil")}, false}).find("../evil/good", experiment).ok());
        // A folder is not below one whose name only begins like its own.
        put("program2/libgood.so", true);
        QCOMPARE(DirectoryCatalog({{}, path("program"), {}, false}).find("../program2/good", experiment).error().code,
                 Code::ModuleNotTrusted);
    }

    void namesAllThatWasTried() {
        const auto missing =
            DirectoryCatalog({{path("mine")}, path("program"), {}, false}).find("controllers/gone", path("experiments"));
        QCOMPARE(missing.error().code, Code::ModuleNotFound);
        for (const char* tried :
             {"experiments/controllers/libgone.so", "mine/controllers/gone.so", "program/libgone.so", "program/gone.so"})
            QVERIFY2(missing.error().message.find(path(tried)) != std::string::npos, tried);
    }

    void namesSourcesThatAreNotBuilt() {
        put("experiments/walker/CMakeLists.txt", false);
        for (const char* written : {"walker", "walker/build/walker"}) {
            const auto missing = DirectoryCatalog({{}, path("program"), {}, false}).find(written, path("experiments"));
            QCOMPARE(missing.error().code, Code::ModuleNotFound);
            QVERIFY2(missing.error().message.find(", but sources in the folder walker: build them, and name walker/build/walker; tried ") !=
                         std::string::npos,
                     missing.error().message.c_str());
        }
    }

    void suggestsSimilarModule_data() {
        QTest::addColumn<QString>("meant");
        QTest::newRow("controllers/goood") << "controllers/good";
        QTest::newRow("good") << "controllers/good";                  // without its folder
        QTest::newRow("Controllers\\good.dll") << "controllers/good"; // the thesis's spelling of the folder
        QTest::newRow("mine") << "";
    }
    void suggestsSimilarModule() {
        QFETCH(QString, meant);
        put("program/controllers/libgood.so", true);
        QVERIFY(QFile::link("libmine.so", m_folder->filePath("program/libmine.so"))); // a link to itself
        const auto missing =
            DirectoryCatalog({{path("nowhere")}, path("program"), {}, false}).find(QTest::currentDataTag(), path("experiments"));
        QCOMPARE(missing.error().code, Code::ModuleNotFound);
        const QString message = QString::fromStdString(missing.error().message);
        QCOMPARE(message.contains(" (did you mean " + meant + "?); tried "), !meant.isEmpty());
        QCOMPARE(message.contains("did you mean"), !meant.isEmpty());
    }

    void findsModuleOfKind() {
        put("program/controllers/libgood.so", true);
        put("mine/libother.so", true);
        DirectoryCatalog catalog({{path("mine")}, path("program"), {}, false});
        const std::string kind = catalog.find("controllers/good", path("experiments")).value().kinds.at(0).name;
        QCOMPARE(catalog.moduleWith(kind), "controllers/good");
        QCOMPARE(catalog.moduleWith("NoSuchKind"), "");
        QCOMPARE(DirectoryCatalog({{path("mine")}, "", {}, false}).moduleWith(kind), ""); // not in the catalog's folders
    }

    /// A Python file is described on request only, and only where it is trusted.
    void findsPythonModule() {
        QDir().mkpath(m_folder->filePath("experiments"));
        QFile file(m_folder->filePath("experiments/brain.py"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        std::vector<std::string> described;
        const PythonDescription describe = [&](const std::string& path) -> Result<std::vector<Kind>> {
            described.push_back(path);
            Kind kind;
            kind.name = "Brain";
            kind.role = Role::Controller;
            return std::vector<Kind>{kind};
        };
        const CatalogFolders untrusted{{}, path("program"), {}, false}, trusted{{path("experiments")}, path("program"), {}, false};
        for (const char* written : {"brain", "brain.py"}) {
            QCOMPARE(DirectoryCatalog(untrusted, describe).find(written, path("experiments")).error().code, Code::ModuleNotTrusted);
            QVERIFY(described.empty());
            const auto unknown = DirectoryCatalog(trusted).find(written, path("experiments"));
            QVERIFY(unknown.ok() && !unknown.value().described);
            const auto found = DirectoryCatalog(trusted, describe).find(written, path("experiments"));
            QVERIFY(found.ok() && found.value().described);
            QCOMPARE(found.value().library, path("experiments/brain.py"));
            QVERIFY(found.value().kinds.at(0).find("Budget")); // as of every controller
            QCOMPARE(described, std::vector<std::string>{path("experiments/brain.py")});
            described.clear();
        }
        QCOMPARE(DirectoryCatalog(trusted, describe).find("other.py", path("experiments")).error().code, Code::ModuleNotFound);
        put("experiments/libbrain.so", true); // comes before the Python file, unless that is named
        QCOMPARE(DirectoryCatalog(trusted, describe).find("brain", path("experiments")).value().library, path("experiments/libbrain.so"));
        QCOMPARE(DirectoryCatalog(trusted, describe).find("brain.py", path("experiments")).value().library, path("experiments/brain.py"));
    }

    void inspectsFileWithoutRunningIt() {
        QDir().mkpath(m_folder->filePath("program"));
        QFile file(m_folder->filePath("program/libtext.so"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("not a library") > 0);
        file.close();
        QCOMPARE(DirectoryCatalog({{}, path("program"), {}, false}).find("text", path("x")).error().code,
                 Code::ModuleWrongFormat);
    }

    void fileNamesOfOtherFoldersAndSystems() {
        const auto names = [](const char* written) {
            QStringList all;
            for (const std::string& name : moduleFileNames(written)) all << QString::fromStdString(name);
            return all.join(' ');
        };
        QCOMPARE(names("/abs/drive"), QString("/abs/libdrive.so /abs/drive.so /abs/drive.py"));
        QCOMPARE(names("x/libdrive.so"), QString("x/liblibdrive.so x/libdrive.so liblibdrive.so libdrive.so"));
        QCOMPARE(names("x/drive.DLZ"),
                 QString("x/libdrive.DLZ.so x/drive.DLZ.so x/drive.DLZ.py libdrive.DLZ.so drive.DLZ.so drive.DLZ.py"));
        QCOMPARE(names("libbrain.py"), QString("libbrain.py"));
    }

    /// The first of several untrusted ones is named; sources count in the folder of their build alone.
    void namesTheFirstThatIsNotTrusted() {
        put("experiments/libgood.so", false);
        put("experiments/good.so", false);
        const auto untrusted = DirectoryCatalog({{}, path("program"), {}, false}).find("good", path("experiments"));
        QVERIFY(untrusted.error().message.find(path("experiments/libgood.so")) != std::string::npos);
        put("experiments/walker/CMakeLists.txt", false);
        const auto missing = DirectoryCatalog({{}, path("program"), {}, false}).find("walker/other/walker", path("experiments"));
        QVERIFY(missing.error().code == Code::ModuleNotFound && missing.error().message.find("sources") == std::string::npos);
    }

    /// Of two libraries with a kind the first by name; of the folders below alone; suggestions keep the names of Python files.
    void kindsOfTheProgramsFolder() {
        put("program/b/libgood.so", true);
        put("program/a/libgood.so", true);
        DirectoryCatalog catalog({{}, path("program"), {}, false});
        const std::string kind = catalog.find("a/good", path("experiments")).value().kinds.at(0).name;
        QCOMPARE(catalog.moduleWith(kind), "a/good");
        put("program/c/deep/libfar.so", false);
        QFile script(m_folder->filePath("program/a/libtool.py"));
        QVERIFY(script.open(QIODevice::WriteOnly));
        const auto meant = [&](const char* written) {
            return DirectoryCatalog({{}, path("program"), {}, false}).find(written, path("experiments")).error().message;
        };
        QVERIFY2(meant("a/libtol.py").find("did you mean a/libtool.py?") != std::string::npos, meant("a/libtol.py").c_str());
        QVERIFY2(meant("c/far").find("did you mean") == std::string::npos, meant("c/far").c_str());
    }

    void handlesStrangeNames() {
        DirectoryCatalog catalog({{}, path("program"), {}, true});
        for (const std::string& written : {std::string(), std::string("/"), std::string(".."), std::string(5000, 'x'),
                                           std::string("a\0b", 3), std::string(".so")})
            QVERIFY(!catalog.find(written, path("experiments")).ok());
    }

private:
    [[nodiscard]] std::string path(const char* name) const { return m_folder->filePath(name).toStdString(); }
    void put(const char* name, bool described) {
        const QString target = m_folder->filePath(name);
        QDir().mkpath(QFileInfo(target).path());
        QFile::remove(target);
        QVERIFY(QFile::copy(QString::fromStdString(kGood), target));
        if (described) QVERIFY(writeKindsJson(kGood, kindsJsonPath(target.toStdString())).ok());
    }
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(CatalogTest)
#include "catalog_test.moc"
