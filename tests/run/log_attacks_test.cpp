// Attacks on the log folder by the content of a foreign project and by the names of logs: nothing outside the project's own
// `logs/<experiment>` may be created, changed or removed.

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <thread>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <QtTest>

#include "run/logs/log_folder.h"

using namespace trundle;
namespace fs = std::filesystem;

namespace {

QByteArray contentOf(const std::string& path) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(missing)");
}

bool write(const std::string& path, const QByteArray& text) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

/// A foreign project, and files of the user beside it.
struct LogFixture {
    QTemporaryDir folder;
    std::string root = fs::canonical(folder.path().toStdString()).string();
    std::string project = root + "/project", logs = project + "/logs", own = logs + "/attack", outside = root + "/outside";

    LogFixture() {
        fs::create_directories(own);
        fs::create_directories(outside + "/folder");
        write(outside + "/precious.csv", "precious");
        write(outside + "/folder/x.csv", "precious too");
        write(project + "/attack.sim", "Tick = 1 ms\n");
    }
    [[nodiscard]] LogLocation location() const { return logsOf(project, project + "/attack.sim"); }
    /// Type and content of every entry outside the project, by path.
    [[nodiscard]] std::map<std::string, QByteArray> state() const {
        std::map<std::string, QByteArray> all;
        for (const auto& entry : fs::recursive_directory_iterator(outside)) {
            const fs::file_status status = entry.symlink_status();
            all[entry.path().string()] =
                QByteArray::number(int(status.type())) + (fs::is_regular_file(status) ? contentOf(entry.path().string()) : "");
        }
        return all;
    }
    void replaceByLink(const std::string& at, const std::string& target) const {
        fs::remove_all(at);
        fs::create_symlink(target, at);
    }
};

enum class Outcome { Refused, Inside }; // Inside: written to a new file whose real path is in the project

struct Attack {
    const char* name;
    Outcome outcome;
    std::string file; ///< file name of the log
    std::function<void(const LogFixture&)> prepare;
    const char* says = ""; ///< words of the refusal
};

void makeSocket(const std::string& path) {
    const int made = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    QCOMPARE(::bind(made, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    ::close(made);
}

const std::vector<Attack>& attacks() {
    using enum Outcome;
    const auto nothing = [](const LogFixture&) {};
    static const std::vector<Attack> all{
        {"logs is a link", Refused, "precious.csv", [](const LogFixture& d) { d.replaceByLink(d.logs, d.outside); },
         "symbolic link"},
        {"the experiment's folder is a link", Refused, "precious.csv",
         [](const LogFixture& d) { d.replaceByLink(d.own, d.outside); }, "symbolic link"},
        {"a folder below it is a link", Refused, "way/precious.csv",
         [](const LogFixture& d) { d.replaceByLink(d.own + "/way", d.outside); }, "symbolic link"},
        {"the folder of pictures is a link", Refused, "eye/frames/eye_000000.png",
         [](const LogFixture& d) {
             fs::create_directories(d.own + "/eye");
             d.replaceByLink(d.own + "/eye/frames", d.outside + "/folder");
         },
         "symbolic link"},
        {"the log file is a link", Refused, "x.csv",
         [](const LogFixture& d) { d.replaceByLink(d.own + "/x.csv", d.outside + "/precious.csv"); }, "symbolic link"},
        {"logs is a link to nothing yet", Refused, "x.csv",
         [](const LogFixture& d) { d.replaceByLink(d.logs, d.outside + "/new"); }, "symbolic link"},
        {"the experiment's folder is a link to nothing yet", Refused, "x.csv",
         [](const LogFixture& d) { d.replaceByLink(d.own, d.outside + "/new"); }, "symbolic link"},
        {"the log file is a link to nothing yet", Refused, "x.csv",
         [](const LogFixture& d) { d.replaceByLink(d.own + "/x.csv", d.outside + "/new.csv"); }, "symbolic link"},
        {"a relative link", Refused, "precious.csv", [](const LogFixture& d) { d.replaceByLink(d.logs, "../outside"); },
         "symbolic link"},
        {"a link to a link", Refused, "precious.csv",
         [](const LogFixture& d) {
             fs::create_symlink(d.outside, d.project + "/way");
             d.replaceByLink(d.logs, "way");
         },
         "symbolic link"},
        {"a link that leads back to itself", Refused, "x.csv", [](const LogFixture& d) { d.replaceByLink(d.logs, "logs"); },
         "symbolic link"},
        {"a link into the project itself", Refused, "attack.sim", [](const LogFixture& d) { d.replaceByLink(d.own, "../.."); },
         "symbolic link"},
        {"a link of the system", Refused, "x.csv", [](const LogFixture& d) { d.replaceByLink(d.own, "/proc/self/cwd"); },
         "symbolic link"},
        {"a link to a device", Refused, "x.csv", [](const LogFixture& d) { d.replaceByLink(d.own + "/x.csv", "/dev/null"); },
         "symbolic link"},
        {"logs is a file", Refused, "x.csv",
         [](const LogFixture& d) {
             fs::remove_all(d.logs);
             write(d.logs, "a file");
         },
         "not a folder"},
        {"the experiment's folder is a file", Refused, "x.csv",
         [](const LogFixture& d) {
             fs::remove_all(d.own);
             write(d.own, "a file");
         },
         "not a folder"},
        {"the log file is a folder", Refused, "x.csv", [](const LogFixture& d) { fs::create_directories(d.own + "/x.csv"); },
         "it is a folder"},
        {"the log file is a pipe", Refused, "x.csv",
         [](const LogFixture& d) { QCOMPARE(::mkfifo((d.own + "/x.csv").c_str(), 0666), 0); }, "it is a pipe"},
        {"the log file is a socket", Refused, "x.csv", [](const LogFixture& d) { makeSocket(d.own + "/x.csv"); },
         "it is a socket"},
        {"the log file is a hard link to one outside", Inside, "x.csv",
         [](const LogFixture& d) { fs::create_hard_link(d.outside + "/precious.csv", d.own + "/x.csv"); }},
        {"two dots", Refused, "../../../outside/precious.csv", nothing, "leaves the log folder"},
        {"two dots behind a folder", Refused, "a/../../../../outside/precious.csv", nothing, "leaves the log folder"},
        {"two dots with backslashes", Refused, "..\\..\\..\\outside\\precious.csv", nothing, "leaves the log folder"},
        {"an absolute path", Refused, "/etc/trundle-attack.csv", nothing, "inside the log folder"},
        {"a drive", Refused, "C:\\x.csv", nothing, "inside the log folder"},
        {"a zero byte", Refused, std::string("x.csv\0.png", 10), nothing, "control character"},
        {"a line break", Refused, "x\n[0] robot0] all is well.csv", nothing, "control character"},
        {"an escape sequence", Refused, "\x1b]0;x\x07.csv", nothing, "control character"},
        {"the list of logs", Refused, "./.trundle-logs", nothing, "has that name"},
        {"a folder and no file", Refused, "a/.", nothing, "names no file"},
        {"a name too long for any file", Refused, std::string(300, 'a'), nothing, "longer than 255"},
    };
    return all;
}

} // namespace

class LogAttacksTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingOutsideIsTouched_data() {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < attacks().size(); ++i) QTest::newRow(attacks()[i].name) << int(i);
        QVERIFY(attacks().size() >= 22);
    }
    void nothingOutsideIsTouched() {
        QFETCH(int, row);
        const Attack& attack = attacks()[std::size_t(row)];
        const LogFixture cameraCapture;
        attack.prepare(cameraCapture);
        const auto before = cameraCapture.state();
        const QByteArray text = contentOf(cameraCapture.project + "/attack.sim");
        {
            LogFolder logs(cameraCapture.location());
            const Result<LogFile*> file = logs.create(attack.file);
            QCOMPARE(file.ok(), attack.outcome == Outcome::Inside);
            if (file) file.value()->write("a log");
            if (!file) {
                QCOMPARE(file.error().code, Code::LogUnwritable);
                QVERIFY2(file.error().message.find(attack.says) != std::string::npos, file.error().message.c_str());
                QVERIFY2(file.error().message.find_first_of("\n\x1b\x07") == std::string::npos, "the message is clean");
            }
            for (const auto& each : logs.files()) QVERIFY(each->close().ok());
            logs.settle();
            if (file) logs.remove(*file.value());
        }
        QCOMPARE(cameraCapture.state(), before);
        QCOMPARE(contentOf(cameraCapture.project + "/attack.sim"), text);
        QVERIFY(!fs::exists("/etc/trundle-attack.csv"));
    }

    // The folder is valid when the first log is opened, and is replaced during the run.
    void aFolderThatIsExchangedLater() {
        const LogFixture cameraCapture;
        LogFolder logs(cameraCapture.location());
        LogFile* const first = logs.create("folder/x.csv").value();
        QVERIFY(logs.create("precious.csv").ok());
        for (const auto& each : logs.files()) QVERIFY(each->close().ok());
        const auto before = cameraCapture.state();
        for (const bool all : {false, true}) {
            cameraCapture.replaceByLink(all ? cameraCapture.logs : cameraCapture.own, cameraCapture.outside);
            logs.remove(*first); // an incomplete image
            logs.settle();
            QVERIFY(!logs.create(all ? "b.csv" : "a.csv").ok());
            QCOMPARE(cameraCapture.state(), before);
            if (!all) fs::remove(cameraCapture.own);
        }
    }

    // A forged list of an earlier run's logs in the project: it must not remove files outside or symbolic links.
    void aHostileListOfLogs() {
        const LogFixture cameraCapture;
        fs::create_symlink(cameraCapture.outside + "/precious.csv", cameraCapture.own + "/way.csv");
        QVERIFY(write(cameraCapture.own + "/.trundle-logs",
                      "logs of the last run, removed by the next\n../../attack.sim\n/etc/hostname\nway.csv\n"
                      "../../../outside/precious.csv\n"));
        const auto before = cameraCapture.state();
        LogFolder(cameraCapture.location()).settle();
        QCOMPARE(cameraCapture.state(), before);
        QVERIFY(fs::is_symlink(cameraCapture.own + "/way.csv"));
        QVERIFY(fs::exists(cameraCapture.project + "/attack.sim"));
        cameraCapture.replaceByLink(cameraCapture.own + "/.trundle-logs", cameraCapture.outside + "/precious.csv");
        LogFolder logs(cameraCapture.location());
        QVERIFY(logs.create("x.csv").ok());
        logs.settle();
        QCOMPARE(cameraCapture.state(), before);
    }

    // A folder and a link to one outside are swapped continuously: there must be no race between checking and opening.
    void aRaceIsNotWon_data() {
        QTest::addColumn<int>("level");
        for (int level = 0; level < 3; ++level) QTest::newRow(qPrintable(QString::number(level))) << level;
    }
    void aRaceIsNotWon() {
        QFETCH(int, level);
        const LogFixture cameraCapture;
        fs::create_directories(cameraCapture.own + "/sub");
        fs::create_directories(cameraCapture.outside + "/attack/sub");
        const std::string place = level == 0 ? cameraCapture.logs : level == 1 ? cameraCapture.own : cameraCapture.own + "/sub";
        const std::string link = cameraCapture.project + "/link";
        fs::create_symlink(level == 0   ? cameraCapture.outside
                           : level == 1 ? cameraCapture.outside + "/attack"
                                        : cameraCapture.outside + "/attack/sub",
                           link);
        const auto before = cameraCapture.state();
        std::atomic<bool> done{false};
        std::atomic<long> exchanges{0};
        std::thread other([&] {
            while (!done)
                if (::renameat2(AT_FDCWD, place.c_str(), AT_FDCWD, link.c_str(), RENAME_EXCHANGE) == 0) ++exchanges;
        });
        int written = 0, refused = 0;
        for (int round = 0; round < 100000 && (round < 3000 || written < 200 || refused < 200 || exchanges < 200); ++round) {
            LogFolder logs(cameraCapture.location());
            const Result<LogFile*> file = logs.create("sub/x.csv");
            (file ? written : refused)++;
            if (file) file.value()->write("a log");
        }
        done = true;
        other.join();
        QVERIFY2(written >= 200 && refused >= 200, "both were met");
        QCOMPARE(cameraCapture.state(), before);
    }

    void twoLogsOfOneFile() {
        const LogFixture cameraCapture;
        LogFolder logs(cameraCapture.location());
        QVERIFY(logs.create("a/x.csv").ok());
        for (const char* name : {"a/x.csv", "a//./x.csv", "a\\x.csv", "a", "a/x.csv/y.csv"})
            QVERIFY2(!logs.create(name).ok(), name);
    }

    // A folder given by the user may be a symbolic link.
    void aFolderThatIsNamedMayBeALink() {
        const LogFixture cameraCapture;
        const std::string link = cameraCapture.root + "/results";
        fs::create_symlink(cameraCapture.outside, link);
        for (const std::string& named : {link, link + "/new/deep"}) {
            LogFolder logs{LogLocation(named)};
            LogFile* const file = logs.create("log.csv").value();
            file->write("a log");
            QVERIFY(file->close().ok());
        }
        QCOMPARE(contentOf(cameraCapture.outside + "/log.csv"), QByteArray("a log"));
        QCOMPARE(contentOf(cameraCapture.outside + "/new/deep/log.csv"), QByteArray("a log"));
        fs::create_symlink(cameraCapture.project, cameraCapture.outside + "/way"); // a link below it is still refused
        QVERIFY(!LogFolder(LogLocation(link)).create("way/x.csv").ok());
    }

    void theDefaultIsOneFolderOfTheProject() {
        QCOMPARE(logsOf("/p", "/p/a/run.sim").path(), std::string("/p/logs/run"));
        for (const char* file : {"/p/...", "/p/..sim", "/p/.", "", "/"}) {
            const std::string name = experimentName(file);
            QVERIFY2(!name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos, file);
        }
    }
};

QTEST_APPLESS_MAIN(LogAttacksTest)
#include "log_attacks_test.moc"
