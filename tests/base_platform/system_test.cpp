// Folders held open, children that are fed, limits, descriptors, folders of the user, and what crash handlers read.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/platform/buffered_file.h"
#include "base/platform/file_lock.h"
#include "base/platform/folder_handle.h"
#include "base/platform/limits.h"
#include "base/platform/locked_file.h"
#include "base/platform/piped_process.h"
#include "base/platform/process.h"
#include "base/platform/quiet_errors.h"
#include "base/platform/recent_runs.h"
#include "base/platform/standard_descriptors.h"
#include "base/platform/user_folder.h"
#include "eventually.h"

using namespace trundle;

namespace {

/// The exit code of a child that runs `work`.
template <class Work> int inChild(Work work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

QByteArray contentOf(const std::string& path) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(missing)");
}

/// An environment variable for the lifetime of this object.
struct Variable {
    Variable(const char* name, const char* value) : m_name(name), m_before(qgetenv(name)) { ::setenv(name, value, 1); }
    ~Variable() { ::setenv(m_name, m_before.constData(), 1); }
    const char* m_name;
    QByteArray m_before;
};

} // namespace

class SystemTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void aFolderMakesReadsAndRenamesFiles() {
        Result<FolderHandle> made = FolderHandle::make(at("a/b"));
        QVERIFY(made.ok());
        FolderHandle& folder = made.value();
        for (const char* text : {"old text", "new"}) { // the second replaces the first
            const Result<std::FILE*> file = folder.makeFile("x.txt");
            QVERIFY(file.ok());
            std::fputs(text, file.value());
            std::fclose(file.value());
        }
        QCOMPARE(contentOf(at("a/b/x.txt")), QByteArray("new"));
        QCOMPARE(folder.readFile("x.txt", 3).value(), std::string("new"));
        QVERIFY(!folder.readFile("x.txt", 2).ok() && !folder.readFile("y.txt", 9).ok());
        QVERIFY(folder.rename("x.txt", "y.txt").ok() && !folder.hasFile("x.txt") && folder.hasFile("y.txt"));
        QVERIFY(!folder.rename("x.txt", "z.txt").ok());
        QVERIFY(folder.removeFile("y.txt") && !folder.removeFile("y.txt") && !folder.hasFile("y.txt"));
        // The folder is the same when its name is another one.
        QVERIFY(QDir().rename(QString::fromStdString(at("a")), QString::fromStdString(at("c"))));
        std::fclose(folder.makeFile("late").value());
        QVERIFY(QFile::exists(QString::fromStdString(at("c/b/late"))));
        FolderHandle other = std::move(folder);
        QVERIFY(other.hasFile("late"));
        Result<FolderHandle> third = FolderHandle::open(at("c"));
        other = std::move(third).value();
        QVERIFY(!other.hasFile("late") && other.openFolder("b").value().hasFile("late"));
    }

    void aNameIsOnePart_data() {
        QTest::addColumn<std::string>("name");
        const std::pair<const char*, std::string> all[] = {{"empty", ""},        {"here", "."},
                                                           {"above", ".."},      {"path", "b/x"},
                                                           {"absolute", "/tmp"}, {"zero", std::string("x\0y", 3)}};
        for (const auto& [row, name] : all) QTest::newRow(row) << name;
    }
    void aNameIsOnePart() {
        QFETCH(std::string, name);
        FolderHandle folder = FolderHandle::make(at("a")).value();
        std::fclose(folder.makeFile("x").value());
        QVERIFY(!folder.makeFile(name).ok() && !folder.makeFolder(name).ok() && !folder.openFolder(name).ok());
        QVERIFY(!folder.readFile(name, 100).ok() && !folder.hasFile(name) && !folder.hasOwnFile(name));
        QVERIFY(!folder.removeFile(name) && !folder.rename("x", name).ok() && !folder.rename(name, "y").ok());
        QVERIFY(folder.hasFile("x"));
    }

    void foldersInFoldersAndWhatIsNone() {
        FolderHandle folder = FolderHandle::make(at("a")).value();
        QVERIFY(folder.makeFolder("in").ok() && folder.makeFolder("in").ok() && folder.openFolder("in").ok());
        QVERIFY(!folder.openFolder("none").ok());
        std::fclose(folder.makeFile("file").value());
        QCOMPARE(::symlink("in", at("a/link").c_str()), 0);
        QCOMPARE(folder.openFolder("file").error().message, std::string("it is not a folder"));
        QCOMPARE(folder.makeFolder("file").error().message, std::string("it is not a folder"));
        const std::string link = "it is a symbolic link, which could lead to another place";
        QCOMPARE(folder.openFolder("link").error().message, link);
        QCOMPARE(folder.makeFile("link").error().message, link);
        QCOMPARE(folder.readFile("link", 9).error().message, link);
        QVERIFY(!folder.makeFile("in").ok() && !folder.readFile("in", 9).ok() && !folder.removeFile("in"));
        QCOMPARE(FolderHandle::open(at("a/file")).error().message, std::string("it is not a folder"));
        QVERIFY(!FolderHandle::open(at("b")).ok() && !FolderHandle::make(at("a/file/b")).ok());
    }

    /// A file that others can write is not this user's own.
    void ownFiles() {
        FolderHandle folder = FolderHandle::make(at("a")).value();
        std::fclose(folder.makeFile("x").value());
        const auto withMode = [&](mode_t mode) { return ::chmod(at("a/x").c_str(), mode) == 0 && folder.hasOwnFile("x"); };
        QVERIFY(withMode(0644) && withMode(0600) && !withMode(0664) && !withMode(0646) && !folder.hasOwnFile("y"));
        QVERIFY(folder.makeFolder("in").ok() && !folder.hasOwnFile("in"));
    }

    void aFedChild() {
        const std::string out = at("out");
        const int file = ::open(out.c_str(), O_RDWR | O_CREAT, 0600);
        auto started = PipedProcess::start(
            "sh", {"-c", "cat > " + std::string(PipedProcess::kGivenFile) + "; echo no >&2; echo last >&2; exit $0", "0"}, file);
        ::close(file);
        QVERIFY(started.ok());
        const std::string bytes(3'000'000, 'x');
        QVERIFY(started.value()->feed(bytes.data(), bytes.size()) && started.value()->feed("end", 3));
        QVERIFY(started.value()->finish());
        QCOMPARE(started.value()->lastErrorOutput(), std::string("last"));
        QVERIFY(contentOf(out) == QByteArray::fromStdString(bytes + "end"));
        QVERIFY(!started.value()->feed("x", 1));
    }

    void aChildThatFailsOrAcceptsNoMore() {
        auto failing = PipedProcess::start("sh", {"-c", "exit 3"});
        QVERIFY(failing.ok() && !failing.value()->finish());
        QCOMPARE(failing.value()->lastErrorOutput(), std::string());
        auto killed = PipedProcess::start("sh", {"-c", "kill -9 $$"});
        QVERIFY(killed.ok() && !killed.value()->finish());
        auto deaf = PipedProcess::start("sh", {"-c", "exec 0<&-; echo deaf >&2"});
        const std::string bytes(1 << 20, 'x');
        bool fed = true;
        for (int i = 0; i < 100 && fed; ++i) fed = deaf.value()->feed(bytes.data(), bytes.size());
        QVERIFY(!fed);
        QVERIFY(!PipedProcess::start("trundle-no-such-program", {}).ok());
    }

    /// Terminated, not killed, and waited for.
    void aChildThatIsDropped() {
        const std::string mark = at("mark"), ready = at("ready");
        {
            auto child = PipedProcess::start(
                "sh", {"-c", "trap 'echo ended > " + mark + "; exit' TERM; echo > " + ready + "; while :; do :; done"});
            QVERIFY(child.ok());
            EVENTUALLY(QFile::exists(QString::fromStdString(ready)));
        }
        QCOMPARE(contentOf(mark), QByteArray("ended\n"));
    }

    void installedPrograms() {
        QVERIFY(isInstalled("sh") && !isInstalled("trundle-no-such-program"));
        const std::string tool = at("tool");
        QFile(QString::fromStdString(tool)).open(QIODevice::WriteOnly);
        {
            const Variable path("PATH", (":/nowhere:" + m_folder->path().toStdString()).c_str());
            QVERIFY(!isInstalled("tool")); // not executable
            QCOMPARE(::chmod(tool.c_str(), 0700), 0);
            QVERIFY(isInstalled("tool") && !isInstalled("sh"));
        }
        const Variable path("PATH", "");
        QVERIFY(!isInstalled("tool"));
    }

    void limitsOfAChild_data() {
        QTest::addColumn<int>("which");
        QTest::newRow("none") << 0;
        QTest::newRow("memory") << 1;
        QTest::newRow("time") << 2;
        QTest::newRow("files") << 3;
        QTest::newRow("core dumps") << 4;
    }
    /// One limit at a time; the others stay as they were.
    void limitsOfAChild() {
        QFETCH(int, which);
        ResourceLimits limits;
        if (which == 1) limits.memoryBytes = 3ull << 30;
        if (which == 2) limits.cpuSeconds = 123;
        if (which == 3) limits.fileBytes = 4096 * 512;
        limits.coreDumps = which != 4;
        const int changed = inChild([&] {
            constexpr __rlimit_resource kAll[] = {RLIMIT_AS, RLIMIT_CPU, RLIMIT_FSIZE, RLIMIT_CORE};
            const rlim_t wanted[] = {3ull << 30, 123, 4096 * 512, 0};
            rlimit before[4], after[4];
            for (int i = 0; i < 4; ++i) ::getrlimit(kAll[i], &before[i]);
            if (!applyLimits(limits)) return 99;
            int found = 0;
            for (int i = 0; i < 4; ++i) {
                ::getrlimit(kAll[i], &after[i]);
                const bool set = after[i].rlim_cur == wanted[i] && after[i].rlim_max == wanted[i];
                const bool same = after[i].rlim_cur == before[i].rlim_cur && after[i].rlim_max == before[i].rlim_max;
                if (set && i + 1 == which) found = which;
                else if (!same) return 50 + i;
            }
            return found;
        });
        const bool isSanitized = which == 1 && memoryLimitsAreOff();
        QCOMPARE(changed, isSanitized ? 0 : which);
        // A limit above what is allowed becomes what is allowed.
        QCOMPARE(inChild([] {
                     const rlimit low{100, 200};
                     ::setrlimit(RLIMIT_CPU, &low);
                     ResourceLimits more;
                     more.cpuSeconds = 1000;
                     rlimit now{};
                     return applyLimits(more) && ::getrlimit(RLIMIT_CPU, &now) == 0 && now.rlim_cur == 200 ? 7 : 1;
                 }),
                 7);
    }

    void closedStandardDescriptors() {
        for (const int closed : {0, 1, 2}) {
            const int found = inChild([&] {
                ::close(closed);
                const bool hadOutput = openStandardDescriptors();
                if (hadOutput != (closed != 1)) return 1;
                const int flags = ::fcntl(closed, F_GETFL);
                if (flags < 0 || (flags & O_ACCMODE) != (closed == 0 ? O_RDONLY : O_WRONLY)) return 2;
                struct stat nowhere {
                }, is{};
                ::stat("/dev/null", &nowhere);
                ::fstat(closed, &is);
                if (is.st_rdev != nowhere.st_rdev || (::fcntl(closed, F_GETFD) & FD_CLOEXEC)) return 3;
                return openStandardDescriptors() && openIfClosed(closed) ? 0 : 4; // open now
            });
            QCOMPARE(found, 0);
        }
        QCOMPARE(inChild([] {
                     ::close(1);
                     return openIfClosed(1) ? 1 : 0;
                 }),
                 0);
        // A descriptor that is not the lowest free one.
        QCOMPARE(inChild([] {
                     ::close(0);
                     ::close(2);
                     return !openIfClosed(2) && ::fcntl(2, F_GETFL) >= 0 && ::fcntl(0, F_GETFL) < 0 ? 0 : 1;
                 }),
                 0);
    }

    void restoresStandardError() {
        const std::string path = at("errors");
        QCOMPARE(inChild([&] {
                     const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
                     ::dup2(file, 2);
                     const auto say = [](const char* text) { (void)!::write(2, text, std::strlen(text)); };
                     say("before ");
                     {
                         const QuietErrors quiet;
                         say("during ");
                     }
                     say("after");
                     return 0;
                 }),
                 0);
        QCOMPARE(contentOf(path), QByteArray("before after"));
    }

    void foldersOfTheUser() {
        {
            const Variable home("HOME", "/some/where");
            QCOMPARE(homeFolder(), std::string("/some/where"));
        }
        for (const char* odd : {"", "relative/path"}) {
            const Variable home("HOME", odd);
            QVERIFY(homeFolder() != odd && homeFolder().starts_with('/'));
        }
        const std::string& folder = privateTemporaryFolder();
        struct stat there {};
        QVERIFY(!folder.empty() && ::stat(folder.c_str(), &there) == 0 && (there.st_mode & 0777) == 0700);
        QVERIFY(&privateTemporaryFolder() == &folder);
        ::rmdir(folder.c_str());
    }

    void allBuffersAreWrittenAtTheEnd() {
        QCOMPARE(inChild([&]() -> int {
                     BufferedFile one(std::fopen(at("one").c_str(), "wb")), two(std::fopen(at("two").c_str(), "wb"));
                     (void)one.write("first");
                     (void)two.write("second");
                     BufferedFile::writeOutAll();
                     ::_exit(0); // what has written out accepts no more and is not closed again
                 }),
                 0);
        QCOMPARE(contentOf(at("one")), QByteArray("first"));
        QCOMPARE(contentOf(at("two")), QByteArray("second"));
    }

    /// A lock that is assigned to releases what it held before.
    void locksThatAreMoved() {
        for (const char* name : {"a", "b"}) std::fclose(std::fopen(at(name).c_str(), "w"));
        LockedFile first = LockedFile::make(at("c")).value(), second = LockedFile::make(at("d")).value();
        QVERIFY(LockedFile::isHeld(at("c")) && LockedFile::isHeld(at("d")));
        first = std::move(second);
        QVERIFY(!LockedFile::isHeld(at("c")) && LockedFile::isHeld(at("d")));
        QCOMPARE(first.path(), at("d"));
        QVERIFY(first.append("x").ok());
        LockedFile& same = first;
        first = std::move(same);
        QVERIFY(LockedFile::isHeld(at("d")));
        const auto none = std::chrono::milliseconds(0);
        {
            auto locks = FileLock::takeAll({at("a"), at("b")}, none).value();
            QVERIFY(!FileLock::takeAll({at("b")}, none).ok());
            locks[0] = std::move(locks[1]);
            locks.pop_back();
            QCOMPARE(int(FileLock::takeAll({at("a")}, none).ok()) + int(FileLock::takeAll({at("b")}, none).ok()), 1);
        }
        QVERIFY(FileLock::takeAll({at("a"), at("b")}, none).ok());
    }

    void recentRunsNewestFirst() {
        QVERIFY(!runOfThread());
        std::vector<std::shared_ptr<CallMonitor>> all;
        for (int i = 0; i < 20; ++i) {
            all.push_back(std::make_shared<CallMonitor>());
            const RunOfThread run(all.back());
            QVERIFY(runOfThread() == all.back().get());
            const auto recent = recentRuns();
            for (int k = 0; k < 16; ++k) QVERIFY(recent[k] == (k <= i ? all[i - k].get() : nullptr));
        }
        QVERIFY(!runOfThread());
        QCOMPARE(all[3].use_count(), 1L); // replaced by a later one
        QCOMPARE(all[4].use_count(), 2L);
    }

private:
    [[nodiscard]] std::string at(const std::string& name) const { return m_folder->filePath(name.c_str()).toStdString(); }
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(SystemTest)
#include "system_test.moc"
