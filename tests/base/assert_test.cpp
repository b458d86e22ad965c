// Checks that are on in every build.

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/result.h"

#include <QtTest>

using namespace trundle;

namespace {

/// The signal that ends a process which calls this; 0 if it ends by itself. Its words are thrown away.
template <class Call> int signalOf(Call call) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit none{0, 0};
        ::setrlimit(RLIMIT_CORE, &none);
        ::close(STDERR_FILENO);
        std::signal(SIGABRT, SIG_DFL);
        call();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

} // namespace

class AssertTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aConditionThatHoldsDoesNothing() {
        QCOMPARE(signalOf([] { TRUNDLE_ASSERT(1 + 1 == 2); }), 0);
        QCOMPARE(signalOf([] { (void)Result<int>(3).value(); }), 0);
    }

    void aViolationEndsTheProgramInEveryBuild() {
        QCOMPARE(signalOf([] { TRUNDLE_ASSERT(1 + 1 == 3); }), SIGABRT);
        QCOMPARE(signalOf([] { (void)Result<int>(Error{Code::Internal, "no"}).value(); }), SIGABRT);
        QCOMPARE(signalOf([] { (void)Result<int>(3).error(); }), SIGABRT);
        QCOMPARE(signalOf([] { (void)Status().error(); }), SIGABRT);
    }
};

QTEST_APPLESS_MAIN(AssertTest)
#include "assert_test.moc"
