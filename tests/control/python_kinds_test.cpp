// The description of a Python module that is kept: it counts as long as each of the files that it consists of is the same.
#include <QtTest>

#include <filesystem>
#include <fstream>

#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include "base/platform/read_file.h"
#include "control/kinds_json.h"
#include "control/python_kinds.h"

using namespace trundle;
namespace fs = std::filesystem;

class PythonKindsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    [[nodiscard]] std::string path(const char* name) const { return (fs::path(m_folder.path().toStdString()) / name).string(); }
    static void write(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

    /// Keeps a description of a module of two files.
    void keep() const {
        Kind kind;
        kind.name = "Walker";
        kind.role = Role::Controller;
        auto json = nlohmann::json::parse(kindsToJson({kind}));
        for (const char* name : {"walk.py", "helper.py"}) {
            const auto stamp = regularFileStamp(path(name));
            QVERIFY(stamp.ok());
            json["sources"].push_back({path(name), stamp.value().size, stamp.value().modifiedNs});
        }
        cachePythonKinds(path("walk.py"), json.dump());
    }
    [[nodiscard]] bool isKept() const {
        const auto kinds = cachedPythonKinds(path("walk.py"));
        return kinds && kinds->size() == 1 && kinds->front().name == "Walker";
    }

private Q_SLOTS:
    void init() {
        qputenv("XDG_CACHE_HOME", m_folder.filePath(QStringLiteral("cache")).toUtf8());
        write(path("walk.py"), "import helper\n");
        write(path("helper.py"), "SPEED = 1\n");
        keep();
        QVERIFY(isKept());
    }

    void anyChangeOfAnyFileCounts_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::newRow("itself") << QByteArray("walk.py");
        QTest::newRow("what it imports") << QByteArray("helper.py");
    }
    void anyChangeOfAnyFileCounts() {
        QFETCH(QByteArray, file);
        const std::string changed = path(file.constData());
        const std::string text = readRegularFile(changed).value();
        const auto time = fs::last_write_time(changed);
        fs::last_write_time(changed, time + std::chrono::seconds(1)); // of the same size
        QVERIFY(!isKept());
        fs::last_write_time(changed, time);
        QVERIFY(isKept());
        write(changed, text + "\n");
        fs::last_write_time(changed, time); // of the same time
        QVERIFY(!isKept());
        fs::remove(changed);
        QVERIFY(!isKept());
    }

    void whatIsNotOfTheFileDoesNotCount() {
        QVERIFY(!cachedPythonKinds(path("helper.py")));
        cachePythonKinds(path("walk.py"), "{}");
        QVERIFY(!isKept());
        cachePythonKinds(path("walk.py"), "no description");
        QVERIFY(!isKept());
    }
};

QTEST_GUILESS_MAIN(PythonKindsTest)
#include "python_kinds_test.moc"
