// The window: builds the parts, joins them, goes.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <thread>

#include <QApplication>

#include "base/platform/buffered_file.h"
#include "base/platform/end_requests.h"
#include "base/platform/standard_descriptors.h"
#include "editor/shell/main_window.h"
#include "editor/widgets/preferences.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"
#include "trundle/options.h"
#include "trundle/picture_taker.h"
#include "trundle/problem.h"

namespace {

QtMessageHandler g_report = nullptr; // Qt's own

/// Without a screen Qt says with each window what it cannot do there; whoever takes pictures so has nothing of that.
void report(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (!message.startsWith(QStringLiteral("This plugin does not support")))
        g_report(type, context, trundle::forTerminal(message)); // it may name a file
}

/// While Qt looks for a display. Where it finds none it would tell of plugins and abort.
void reportStart(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (type == QtFatalMsg) {
        const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
        const QString why =
            platform.isEmpty()
                ? QStringLiteral("there is no display for a window")
                : QStringLiteral("no window can be opened with QT_QPA_PLATFORM=%1").arg(QString::fromLocal8Bit(platform));
        trundle::printProblem(QStringLiteral("%1: set QT_QPA_PLATFORM=offscreen for --screenshot, or use trundle-cli").arg(why));
        std::_Exit(2);
    }
    if (!std::string_view(context.category ? context.category : "").starts_with("qt.qpa.")) report(type, context, message);
}

/// --help and --version, which need no display.
bool asksForWords(int argc, char** argv) {
    constexpr std::string_view kWords[] = {"-h", "--help", "--help-all", "-v", "--version"};
    return std::any_of(argv + 1, argv + std::max(argc, 1),
                       [&](const char* word) { return std::ranges::find(kWords, word) != std::end(kWords); });
}

bool g_leaving = false; // the program goes by itself

/// Code of a controller called exit(), or Qt lost its display: this thread would take down what the others use.
void onExit() {
    if (g_leaving) return;
    for (const int fault : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) // in threads that still use what exit() destroys
        std::signal(fault, [](int) { std::_Exit(4); });
    std::fputs("trundle: ended from within, by code of a module or as the display is gone; unsaved edits are offered at the next "
               "start\n",
               stderr); // and no more than that: other threads fall already
    std::_Exit(4);
}

constexpr std::chrono::seconds kLastWait(5);
std::atomic<bool> g_toldToEnd = false; // from outside

/// SIGTERM and its like: at the end of a session, say. Nobody is there to answer questions, so unsaved texts are kept for the next start.
void endOnRequest() {
    trundle::watchEndRequests(
        [](int exitCode) {
            g_toldToEnd = true;
            QMetaObject::invokeMethod(
                QCoreApplication::instance(), [exitCode] { QCoreApplication::exit(exitCode); }, Qt::QueuedConnection);
        },
        kLastWait);
}

/// The window writes what is to be kept as the first thing of its end; what comes then may wait for a picture that takes minutes, and
/// nobody would see why the program is still there.
void endSoon(int code) {
    g_leaving = true;
    std::thread([code] {
        std::this_thread::sleep_for(kLastWait);
        std::_Exit(code);
    }).detach();
}

} // namespace

int main(int argc, char** argv) {
    using namespace trundle;
    openStandardDescriptors();     // else the display's socket gets a closed one's number, and what a module prints goes there
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files fails the write, not the program
    QCoreApplication::setApplicationName(QStringLiteral("Trundle"));
    QCoreApplication::setOrganizationName(QStringLiteral("Trundle"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TRUNDLE_VERSION));
    if (asksForWords(argc, argv)) {
        const QCoreApplication application(argc, argv);
        (void)readOptions(application); // says them and ends
    }
    g_report = qInstallMessageHandler(reportStart);
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QApplication application(argc, argv);
    qInstallMessageHandler(report);

    const WindowOptions options = readOptions(application);
    const Preferences preferences = loadPreferences();
    const ThemeKind system = themeOf(preferences.theme); // asks the desktop before the first theme is applied
    applyTheme(application, options.theme.value_or(system), preferences.fonts);
    QApplication::setWindowIcon(themedIcon(QStringLiteral("kind-robot")));

    const std::unique_ptr<Parts> parts = makeParts();
    const std::unique_ptr<RenderService> render = RenderService::startInBackground();
    MainWindow window(*parts, render.get(), findLocations());
    if (options.screenshot.isEmpty()) window.rememberViews();
    else window.leaveNoTrace(); // and a picture is the same whoever takes it
    if (options.size.isValid()) {
        window.setWindowState(Qt::WindowNoState); // the last one may have been maximized
        window.resize(options.size);
    }
    window.show();
    PictureTaker taker(window, options); // does what the options ask for, once the window stands
    // Before what is made from now on goes: the later something is registered, the sooner it is called.
    QObject::connect(&window.session(), &RunSession::stateChanged, &window, [] { std::atexit(onExit); });
    std::atexit(onExit);
    endOnRequest();
    const int code = QApplication::exec();
    if (g_toldToEnd) { // the journal was written as the first thing of the end
        BufferedFile::writeOutAll();
        std::_Exit(code);
    }
    if (window.session().endRuns()) {
        endSoon(code);
        return code;
    }
    // Code of a controller does not come back. What it uses must stay as long as it is there, so nothing is taken down.
    window.putAway();
    std::_Exit(code);
}
