// Child processes: pipes, time and memory limits.
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/platform/memory.h"
#include "base/platform/process.h"
#include "base/platform/process_identity.h"
#include "base/platform/program_path.h"

using namespace trundle;

namespace {

ProcessRequest shell(const std::string& script) {
    ProcessRequest request;
    request.program = "/bin/sh";
    request.arguments = {"-c", script};
    return request;
}

} // namespace

class ProcessTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void returnsOutputErrorsAndCode() {
        const auto result = runProcess(shell("echo out; echo err >&2; exit 3"));
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("out\n"));
        QCOMPARE(result.value().errors, std::string("err\n"));
        QCOMPARE(result.value().exitCode, 3);
        QVERIFY(!result.value().succeeded());
        QCOMPARE(describeEnd(shell(""), result.value()), std::string("exited with code 3"));
    }

    void passesOnWhatComes() {
        ProcessRequest request = shell("echo out; echo err >&2; exec sleep 600");
        std::string received;
        std::stop_source stop;
        request.stop = stop.get_token();
        request.seconds = 60;
        request.received = [&](std::string_view bytes) {
            received += bytes;
            if (received.size() >= 8) stop.request_stop(); // while the process still runs
        };
        const auto result = runProcess(request);
        QVERIFY(result.ok() && result.value().end == ProcessEnd::TimedOut);
        QVERIFY(received == "out\nerr\n" || received == "err\nout\n");
    }

    void itsTimeIsInSeconds() {
        QElapsedTimer clock;
        clock.start();
        const auto result = runProcess(shell("exit 0"));
        QVERIFY(result.ok() && result.value().seconds > 0);
        QVERIFY(result.value().seconds <= double(clock.nsecsElapsed()) * 1e-9);
    }

    void argumentsArriveAsTheyAre() {
        ProcessRequest request;
        request.program = "/usr/bin/printf";
        request.arguments = {"%s|%s|%s", "a b", "$HOME", "\"'\n"};
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("a b|$HOME|\"'\n"));
    }

    void passesLargeInputThroughProcess() {
        ProcessRequest request = shell("cat");
        request.input = std::string(3'000'000, 'x') + "end";
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QVERIFY(result.value().output == request.input);
    }

    void aChildThatReadsNothingIsNoFault() {
        ProcessRequest request = shell("exec 0<&-; echo done");
        request.input = std::string(3'000'000, 'x');
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("done\n"));
    }

    void withoutInputTheChildReadsNothing() {
        const auto result = runProcess(shell("cat; echo end"));
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("end\n"));
    }

    void anEndlessChildIsStoppedWithItsChildren() {
        ProcessRequest request = shell("sleep 1000 & sleep 1000");
        request.seconds = 0.2;
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(int(result.value().end), int(ProcessEnd::TimedOut));
        QCOMPARE(describeEnd(request, result.value()), std::string("took longer than 0.2 s"));
    }

    void aChildThatClosesItsOutputsAndStaysIsStoppedToo() {
        ProcessRequest request = shell("exec 1>&- 2>&-; exec sleep 1000");
        request.seconds = 0.2;
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(int(result.value().end), int(ProcessEnd::TimedOut));
    }

    void anEndlessWriterIsStoppedAtItsLimit() {
        ProcessRequest request = shell("while :; do echo yyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyyy; done");
        request.outputBytes = 100'000;
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(int(result.value().end), int(ProcessEnd::TooMuchOutput));
        QCOMPARE(result.value().output.size(), std::size_t(100'000));
    }

    void errorsBeyondTheirLimitAreDropped() {
        ProcessRequest request =
            shell("i=0; while [ $i -lt 5000 ]; do echo yyyyyyyyyyyyyyyyyyyyyyyy >&2; i=$((i+1)); done; echo fine");
        request.errorBytes = 1000;
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QVERIFY(result.value().succeeded());
        QCOMPARE(result.value().errors.size(), std::size_t(1000));
        QCOMPARE(result.value().output, std::string("fine\n"));
    }

    void aCrashIsASignalWithAName() {
        const auto result = runProcess(shell("kill -SEGV $$"));
        QVERIFY(result.ok());
        QCOMPARE(int(result.value().end), int(ProcessEnd::Signalled));
        QCOMPARE(result.value().signal, SIGSEGV);
        QVERIFY(describeEnd(shell(""), result.value()).find("Segmentation fault") != std::string::npos);
    }

    void memoryIsLimited() {
        if (memoryLimitsAreOff()) return; // a sanitizer's shadow memory needs terabytes of address space
        ProcessRequest request = shell("ulimit -v");
        request.limits.memoryBytes = 512u << 20;
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("524288\n"));
    }

    void toleratesClosedStandardStreams_data() {
        QTest::addColumn<int>("closed");
        for (int closed = 1; closed < 8; ++closed)
            QTest::addRow("%s%s%s", closed & 1 ? "0" : "", closed & 2 ? "1" : "", closed & 4 ? "2" : "") << closed;
    }
    /// As under a daemon: the pipes then get file descriptors of the standard streams.
    void toleratesClosedStandardStreams() {
        QFETCH(int, closed);
        const int kept[3] = {::dup(0), ::dup(1), ::dup(2)};
        for (int file = 0; file < 3; ++file)
            if (closed & 1 << file) ::close(file);
        ProcessRequest request = shell("cat; echo err >&2; exit 7");
        request.input = "in";
        const auto result = runProcess(request);
        for (int file = 0; file < 3; ++file) {
            ::dup2(kept[file], file);
            ::close(kept[file]);
        }
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("in"));
        QCOMPARE(result.value().errors, std::string("err\n"));
        QCOMPARE(result.value().exitCode, 7);
    }

    /// The program that waits for it is killed, without a chance to end it.
    void aChildEndsWithItsParent() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("pipe").toStdString();
        QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
        const pid_t parent = ::fork();
        if (parent == 0) {
            ProcessRequest request = shell("exec 9>" + path + "; echo $$ >&9; exec sleep 1000");
            request.seconds = 100;
            (void)runProcess(request);
            ::_exit(0);
        }
        const int end = ::open(path.c_str(), O_RDONLY);
        char text[32] = {};
        const ssize_t count = ::read(end, text, sizeof text - 1);
        const pid_t child = std::atoi(text);
        ::kill(parent, SIGKILL);
        ::waitpid(parent, nullptr, 0);
        QVERIFY(count > 0 && child > 1);
        // Only the child writes to the pipe, which closes with it.
        pollfd pipe{end, POLLIN, 0};
        const bool ended = ::poll(&pipe, 1, 10'000) == 1 && (pipe.revents & POLLHUP);
        if (!ended) ::kill(child, SIGKILL);
        ::close(end);
        QVERIFY(ended);
    }

    void usesGivenWorkingFolder() {
        ProcessRequest request = shell("pwd");
        request.folder = "/usr";
        const auto result = runProcess(request);
        QVERIFY(result.ok());
        QCOMPARE(result.value().output, std::string("/usr\n"));
    }

    void reportsUnrunnableProgram_data() {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QString>("word");
        QTest::newRow("missing") << "/nowhere/program"
                                 << "No such file";
        QTest::newRow("a folder") << "/usr"
                                  << "Permission denied";
        QTest::newRow("not executable") << "/etc/passwd"
                                        << "Permission denied";
    }
    void reportsUnrunnableProgram() {
        QFETCH(QString, program);
        QFETCH(QString, word);
        ProcessRequest request;
        request.program = program.toStdString();
        const auto result = runProcess(request);
        QVERIFY(!result.ok());
        QVERIFY2(QString::fromStdString(result.error().message).contains(word), result.error().message.c_str());
        QVERIFY(QString::fromStdString(result.error().message).contains(program));
    }

    /// A later process with the same id started at another time.
    void aProcessIsKnownByItsStart() {
        const ProcessIdentity own = thisProcess();
        QVERIFY(own.pid == ::getpid() && own.start > 0 && !own.host.empty() && isPossiblyAlive(own));
        const auto alive = [&](std::int64_t pid, std::uint64_t start, const std::string& host) {
            return isPossiblyAlive({pid, start, host});
        };
        QVERIFY(!alive(own.pid, own.start + 1, own.host) && !alive(own.pid, own.start - 1, own.host));
        QVERIFY(alive(own.pid, 0, own.host)); // unknown
        QVERIFY(alive(own.pid, own.start + 1, own.host + "x") && alive(0, 5, own.host + "x"));
        QVERIFY(!alive(0, 0, own.host) && !alive(-1, 0, own.host));
        const pid_t ended = ::fork();
        if (ended == 0) ::_exit(0);
        siginfo_t info{};
        QCOMPARE(::waitid(P_PID, static_cast<id_t>(ended), &info, WEXITED | WNOWAIT), 0);
        QVERIFY(!alive(ended, 0, own.host)); // it has ended, but is not waited for
        QCOMPARE(::waitpid(ended, nullptr, 0), ended);
        QVERIFY(!alive(ended, 0, own.host));
    }

    void identifiesOwnProcess() {
        QVERIFY(programPath().ends_with("/test_base_platform_process"));
        QVERIFY(programPath().starts_with(programFolder() + "/"));
        QVERIFY(peakMemoryKb() > 500);
    }
};

QTEST_APPLESS_MAIN(ProcessTest)
#include "process_test.moc"
