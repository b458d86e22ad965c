// File operations: atomic writes, temporary files, locks, symbolic links, size limits.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <filesystem>

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "base/platform/atomic_file.h"
#include "base/platform/file_lock.h"
#include "base/platform/locked_file.h"
#include "base/platform/read_file.h"

using namespace trundle;

class FilesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void readsWrittenBytes() {
        const std::string bytes("a\0b\r\n\xff", 6);
        QVERIFY(writeFileAtomically(at("new.sim"), bytes).ok());
        const auto read = readRegularFile(at("new.sim"));
        QVERIFY(read.ok());
        QVERIFY(read.value() == bytes);
        QCOMPARE(names(), QStringList{"new.sim"}); // no temporary file is left
    }

    void removesTemporaryFilesOfKilledWriter() {
        const auto make = [&](const char* name, int ageS) {
            QFile file(QString::fromStdString(at(name)));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("half") == 4);
            QVERIFY(file.flush() &&
                    file.setFileTime(QDateTime::currentDateTime().addSecs(-ageS), QFileDevice::FileModificationTime));
        };
        make(".trundle-4242-0.tmp", 120); // abandoned
        make(".trundle-4242-1.tmp", 0);   // being created, perhaps on another machine
        make(".trundle-4242-2.tmp", 120); // still being written
        make(".trundle-mine.tmp", 120);   // not one of Trundle's names
        make("other.tmp", 120);
        QCOMPARE(::symlink("other.tmp", at(".trundle-1-1.tmp").c_str()), 0);
        const auto locks = FileLock::takeAll({at(".trundle-4242-2.tmp")}, std::chrono::seconds(1));
        QVERIFY(locks.ok() && locks.value().size() == 1);
        QVERIFY(writeFileAtomically(at("new.sim"), "x").ok());
        const QStringList left{".trundle-1-1.tmp", ".trundle-4242-1.tmp", ".trundle-4242-2.tmp", ".trundle-mine.tmp", "new.sim",
                               "other.tmp"};
        QStringList found = names();
        found.sort();
        QCOMPARE(found, left);
    }

    void aLockOutlivesTheFileThatIsReplaced() {
        QVERIFY(writeFileAtomically(at("a.sim"), "one").ok());
        QCOMPARE(::symlink("a.sim", at("link.sim").c_str()), 0);
        {
            const auto first = FileLock::takeAll({at("a.sim"), at("none.sim")}, std::chrono::milliseconds(0));
            QVERIFY(first.ok() && first.value().size() == 1);
            const auto second = FileLock::takeAll({at("link.sim")}, std::chrono::milliseconds(0));
            QVERIFY(!second.ok());
            QVERIFY(QString::fromStdString(second.error().message).contains("is being changed by another program"));
            QVERIFY(writeFileAtomically(at("a.sim"), "two").ok());
        }
        const auto third = FileLock::takeAll({at("a.sim")}, std::chrono::milliseconds(0));
        QVERIFY(third.ok() && third.value().size() == 1);
        QVERIFY(!FileLock::takeAll({at("link.sim")}, std::chrono::milliseconds(0)).ok());
    }

    /// As on a full disk: the file keeps its old size, and the next append follows what was there.
    void aFailedAppendLeavesTheFileAsItWas() {
        Result<LockedFile> made = LockedFile::make(at("journal"));
        QVERIFY(made.ok());
        LockedFile file = std::move(made).value();
        QVERIFY(file.append("first\n").ok());
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const auto old = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{100, before.rlim_max};
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
        const Status failed = file.append(std::string(200, 'x')); // its first part is written
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &before), 0);
        std::signal(SIGXFSZ, old);
        QVERIFY(!failed.ok());
        QVERIFY(failed.error().message.find("journal") != std::string::npos);
        QCOMPARE(std::filesystem::file_size(at("journal")), std::uintmax_t{6});
        QVERIFY(file.append("second\n").ok());
        QCOMPARE(readRegularFile(at("journal"), 1000).value(), std::string("first\nsecond\n"));
    }

    void keepsModeOfRewrittenFile() {
        QVERIFY(writeFileAtomically(at("script"), "one").ok());
        QCOMPARE(::chmod(at("script").c_str(), 0751), 0);
        QVERIFY(writeFileAtomically(at("script"), "two").ok());
        struct stat state {};
        QCOMPARE(::stat(at("script").c_str(), &state), 0);
        QCOMPARE(int(state.st_mode & 07777), 0751);
    }

    void aNewFileHasTheUsualMode() {
        const mode_t old = ::umask(027);
        const bool written = writeFileAtomically(at("fresh"), "x").ok();
        ::umask(old);
        QVERIFY(written);
        struct stat state {};
        QCOMPARE(::stat(at("fresh").c_str(), &state), 0);
        QCOMPARE(int(state.st_mode & 07777), 0640);
    }

    void aLinkStaysALinkAndItsTargetChanges() {
        QVERIFY(QDir(m_folder->path()).mkdir("deep"));
        QVERIFY(writeFileAtomically(at("deep/real.sim"), "old").ok());
        QCOMPARE(::symlink("deep/real.sim", at("near").c_str()), 0);
        QCOMPARE(::symlink("near", at("far").c_str()), 0);
        QVERIFY(writeFileAtomically(at("far"), "new").ok());
        QVERIFY(QFileInfo(QString::fromStdString(at("far"))).isSymLink());
        QCOMPARE(readRegularFile(at("deep/real.sim")).value(), std::string("new"));
        QCOMPARE(QDir(m_folder->filePath("deep")).entryList(QDir::Files | QDir::Hidden), QStringList{"real.sim"});
    }

    void aLinkToNothingMakesNoFileElsewhere() {
        QCOMPARE(::symlink("later.sim", at("link").c_str()), 0);
        const Status written = writeFileAtomically(at("link"), "x");
        QVERIFY(!written.ok());
        QVERIFY2(written.error().message.find("later.sim, which does not exist") != std::string::npos,
                 written.error().message.c_str());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden).size(), 0);
    }

    void failedWriteLeavesNoFile_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("a folder") << ".";
        QTest::newRow("a missing folder") << "missing/x.sim";
        QTest::newRow("a pipe") << "pipe";
        QTest::newRow("a circle of links") << "circle";
        QTest::newRow("a name too long") << QString(300, 'n');
        QTest::newRow("a device") << "null";
    }
    void failedWriteLeavesNoFile() {
        QFETCH(QString, name);
        QCOMPARE(::mkfifo(at("pipe").c_str(), 0600), 0);
        QCOMPARE(::symlink("circle", at("circle").c_str()), 0);
        QCOMPARE(::symlink("/dev/null", at("null").c_str()), 0);
        const QStringList before = names();
        const Status status = writeFileAtomically(at(name.toStdString()), "x");
        QVERIFY(!status.ok());
        QCOMPARE(int(status.error().code), int(Code::FileUnwritable));
        QVERIFY(QString::fromStdString(status.error().message).contains(name));
        QCOMPARE(names(), before);
    }

    void rejectsNonFilesAtOnce_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("word");
        QTest::newRow("missing") << "missing"
                                 << "No such file";
        QTest::newRow("folder") << "."
                                << "folder";
        QTest::newRow("pipe without a writer") << "pipe"
                                               << "pipe";
        QTest::newRow("socket") << "socket"
                                << "socket";
        QTest::newRow("endless device") << "zero"
                                        << "device";
        QTest::newRow("circle") << "circle"
                                << "symbolic links";
        QTest::newRow("below a file") << "file/x"
                                      << "Not a directory";
    }
    void rejectsNonFilesAtOnce() {
        QFETCH(QString, name);
        QFETCH(QString, word);
        QCOMPARE(::mkfifo(at("pipe").c_str(), 0600), 0);
        QCOMPARE(::symlink("/dev/zero", at("zero").c_str()), 0);
        QCOMPARE(::symlink("circle", at("circle").c_str()), 0);
        QVERIFY(writeFileAtomically(at("file"), "x").ok());
        const int door = makeSocket("socket");
        const auto read = readRegularFile(at(name.toStdString()));
        const auto stamp = regularFileStamp(at(name.toStdString()));
        ::close(door);
        QVERIFY(!read.ok());
        QVERIFY(!stamp.ok());
        QCOMPARE(int(read.error().code), int(Code::FileUnreadable));
        QVERIFY2(QString::fromStdString(read.error().message).contains(word), read.error().message.c_str());
        QCOMPARE(read.error().message, stamp.error().message);
    }

    void theSizeLimitIsInclusive() {
        QVERIFY(writeFileAtomically(at("ten"), "0123456789").ok());
        QVERIFY(readRegularFile(at("ten"), 10).ok());
        const auto read = readRegularFile(at("ten"), 9);
        QVERIFY(!read.ok());
        QVERIFY2(QString::fromStdString(read.error().message).contains("larger than 9 bytes"), read.error().message.c_str());
    }

    void filesThatHideTheirSizeAreReadToTheirEnd() {
        const auto read = readRegularFile("/proc/self/status");
        QVERIFY(read.ok());
        QVERIFY(read.value().find("VmHWM") != std::string::npos);
        QVERIFY(!readRegularFile("/proc/self/status", 10).ok());
    }

    void aChangedFileHasAnotherStamp() {
        QVERIFY(writeFileAtomically(at("x"), "1").ok());
        const auto first = regularFileStamp(at("x"));
        QVERIFY(first.value() == regularFileStamp(at("x")).value());
        QVERIFY(writeFileAtomically(at("x"), "2").ok());
        QVERIFY(!(first.value() == regularFileStamp(at("x")).value()));
    }

private:
    std::string at(const std::string& name) const { return (m_folder->path() + "/").toStdString() + name; }
    QStringList names() const {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }

    // Bound with a short relative name: the path of a socket is limited to 107 bytes.
    int makeSocket(const char* name) const {
        const int door = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        const QString here = QDir::currentPath();
        QDir::setCurrent(m_folder->path());
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        qstrncpy(address.sun_path, name, sizeof address.sun_path);
        const int bound = ::bind(door, reinterpret_cast<const sockaddr*>(&address), sizeof address);
        QDir::setCurrent(here);
        return bound == 0 ? door : -1;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(FilesTest)
#include "files_test.moc"
