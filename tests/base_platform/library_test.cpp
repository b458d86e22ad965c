// Shared libraries: opening, calling, private copies, error messages.
#include <QTemporaryDir>
#include <QtTest>

#include "base/platform/dynamic_library.h"
#include "base/platform/read_file.h"

using namespace trundle;

namespace {
const std::string kFolder = std::string(TRUNDLE_BINARY_DIR) + "/tests/";
}

class LibraryTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aFunctionOfAnOpenedLibraryCanBeCalled() {
        const auto library = DynamicLibrary::open(kFolder + "platform_sample.so");
        QVERIFY2(library.ok(), library.ok() ? "" : library.error().message.c_str());
        const auto answer = library.value().function<int()>("sampleAnswer");
        QVERIFY(answer != nullptr);
        QCOMPARE(answer(), 42);
        QVERIFY(library.value().symbol("noSuchThing") == nullptr);
    }

    void movingHandsTheLibraryOver() {
        auto library = DynamicLibrary::open(kFolder + "platform_sample.so");
        QVERIFY(library.ok());
        DynamicLibrary second;
        second = std::move(library).value();
        const DynamicLibrary third = std::move(second);
        QVERIFY(!second.loaded());
        QVERIFY(second.symbol("sampleAnswer") == nullptr);
        QVERIFY(third.symbol("sampleAnswer") != nullptr);
    }

    void persistentLibraryStaysLoaded() {
        int (*answer)() = nullptr;
        {
            auto library = DynamicLibrary::open(kFolder + "platform_sample.so");
            QVERIFY(library.ok());
            library.value().keepLoaded();
            answer = library.value().function<int()>("sampleAnswer");
        }
        QCOMPARE(answer(), 42);
    }

    /// The file is overwritten in place, as by a linker or cp.
    void copyIsIndependentOfItsFile() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("lib.so"));
        QVERIFY(QFile::copy(QString::fromStdString(kFolder + "platform_sample.so"), path));
        const std::string bytes = readRegularFile(path.toStdString()).value();
        const auto library = DynamicLibrary::openCopy(path.toStdString(), bytes);
        QVERIFY2(library.ok(), library.ok() ? "" : library.error().message.c_str());
        QCOMPARE(library.value().path(), path.toStdString());
        QVERIFY(QFile(path).resize(0));
        const auto answer = library.value().function<int()>("sampleAnswer");
        QVERIFY(answer != nullptr);
        QCOMPARE(answer(), 42);
        const auto second = DynamicLibrary::openCopy(path.toStdString(), bytes);
        QVERIFY(second.ok());
        QVERIFY(second.value().function<int()>("sampleAnswer") != answer);
    }

    void reportsOriginalFileOfBrokenCopy() {
        const std::string path = kFolder + "platform_broken.so";
        const auto library = DynamicLibrary::openCopy(path, readRegularFile(path).value());
        QVERIFY(!library.ok());
        QCOMPARE(library.error().code, Code::ModuleMissingSymbol);
        QVERIFY2(library.error().message.starts_with(path + ": "), library.error().message.c_str());
    }

    void copiesLeaveNoFilesOpen() {
        const std::string path = kFolder + "platform_sample.so", bytes = readRegularFile(path).value();
        const auto open = [] { return QDir(QStringLiteral("/proc/self/fd")).entryList(QDir::NoDotAndDotDot | QDir::AllEntries); };
        const auto before = open().size();
        for (int i = 0; i < 20; ++i) QVERIFY(DynamicLibrary::openCopy(path, bytes).ok());
        QCOMPARE(open().size(), before);
    }

    void reportsWhyLibraryCannotBeOpened_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("word");
        QTest::newRow("missing file") << "/nowhere/x.so" << int(Code::ModuleUnreadable) << "No such file";
        QTest::newRow("missing symbol") << QString::fromStdString(kFolder + "platform_broken.so")
                                        << int(Code::ModuleMissingSymbol) << "undefinedSymbol";
        QTest::newRow("a text") << QString(TRUNDLE_SOURCE_DIR "/CMakeLists.txt") << int(Code::ModuleUnreadable)
                                << "CMakeLists.txt";
        QTest::newRow("a folder") << QString(TRUNDLE_SOURCE_DIR) << int(Code::ModuleUnreadable) << "";
        QTest::newRow("no slash: the system's libraries are not searched")
            << "libc.so.6" << int(Code::ModuleUnreadable) << "slash";
    }
    void reportsWhyLibraryCannotBeOpened() {
        QFETCH(QString, path);
        QFETCH(int, code);
        QFETCH(QString, word);
        const auto library = DynamicLibrary::open(path.toStdString());
        QVERIFY(!library.ok());
        QCOMPARE(int(library.error().code), code);
        QVERIFY2(QString::fromStdString(library.error().message).contains(word), library.error().message.c_str());
    }
};

QTEST_APPLESS_MAIN(LibraryTest)
#include "library_test.moc"
