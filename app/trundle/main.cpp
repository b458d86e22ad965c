// The desktop application: creates the application's objects, connects them and runs the event loop.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include <QApplication>

#include "app/application.h"
#include "base/platform/buffered_file.h"
#include "base/platform/end_requests.h"
#include "base/platform/output_cleaner.h"
#include "base/platform/program_path.h"
#include "base/platform/standard_descriptors.h"
#include "crash/crash_watch.h"
#include "crash/exit_hook.h"
#include "editor/shell/commands/project_questions.h"
#include "editor/shell/main_window.h"
#include "editor/widgets/apply_theme.h"
#include "editor/widgets/preferences.h"
#include "project/journal/state_folder.h"
#include "render/service.h"
#include "trundle/options.h"
#include "trundle/problem.h"
#include "trundle/screenshot_runner.h"

namespace {

using trundle::endProcess, trundle::ignoreExits;

/// Prints Qt messages except those about features that the offscreen platform does not support.
void report(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (message.startsWith(QStringLiteral("This plugin does not support"))) return;
    const QString shown = qFormatLogMessage(type, context, trundle::forTerminal(message)); // it may contain a file name
    std::fprintf(stderr, "%s\n", shown.toLocal8Bit().constData());
}

/// Message handler while Qt opens the display. Without a display Qt would list its plugins and abort; this exits with a clear
/// message.
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
bool isTextOnly(int argc, char** argv) {
    constexpr std::string_view kWords[] = {"-h", "--help", "--help-all", "-v", "--version"};
    return std::any_of(argv + 1, argv + std::max(argc, 1),
                       [&](const char* word) { return std::ranges::find(kWords, word) != std::end(kWords); });
}

constexpr std::chrono::seconds kLastWait(5);

/// Handles SIGTERM and similar signals, for example at the end of a session. No dialogs are shown; unsaved texts are kept in the
/// journal for the next start. The result becomes true with the first request.
std::shared_ptr<const std::atomic<bool>> endOnRequest() {
    const auto requested = std::make_shared<std::atomic<bool>>(false);
    const auto end = [requested](int exitCode) {
        *requested = true;
        QMetaObject::invokeMethod(
            QCoreApplication::instance(), [exitCode] { QCoreApplication::exit(exitCode); }, Qt::QueuedConnection);
    };
    trundle::watchEndRequests(end, kLastWait);
    return requested;
}

/// Has a crash of this window reported in a folder of the user, and shows the reports of earlier ones. `shows` is false for a
/// picture, which must not contain them.
void reportCrashes(trundle::MainWindow& window, bool shows) {
    const std::string folder = trundle::userStateFolder() + "/crashes";
    if (shows) window.questions().showCrashReports(QString::fromStdString(folder));
    std::error_code failed; // then a crash is reported on standard error only
    std::filesystem::create_directories(folder, failed);
    trundle::keepCrashReport((folder + "/" + std::to_string(QCoreApplication::applicationPid()) + ".txt").c_str());
}

/// Ends the process after a timeout. The window has already saved what must be kept; the remaining destructors may wait minutes
/// for a picture, with no visible reason.
void endAfterTimeout(int code) {
    ignoreExits();
    std::thread([code] {
        std::this_thread::sleep_for(kLastWait);
        endProcess(code);
    }).detach();
}

/// Ends the program after its last event. Does not return if something must not be destroyed.
int leave(trundle::MainWindow& window, int code, bool endRequested) {
    if (endRequested) { // the journal has already been written
        trundle::BufferedFile::writeOutAll();
        endProcess(code);
    }
    if (window.session().endRuns()) {
        endAfterTimeout(code);
        return code;
    }
    // A controller call does not return. Objects that it uses must stay alive, so nothing is destroyed.
    window.putAway();
    endProcess(code);
}

} // namespace

int main(int argc, char** argv) {
    using namespace trundle;
    openStandardDescriptors(); // otherwise the display connection may get one of them and receive module output
    startOutputCleaner();
    std::signal(SIGXFSZ, SIG_IGN); // exceeding the file size limit fails the write instead of ending the program
    watchCrashes("trundle", "unsaved edits are offered at the next start");
    QCoreApplication::setApplicationName(QStringLiteral("Trundle"));
    QCoreApplication::setOrganizationName(QStringLiteral("Trundle"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TRUNDLE_VERSION));
    if (isTextOnly(argc, argv)) {
        const QCoreApplication application(argc, argv);
        (void)readOptions(application); // prints the text and exits
    }
    qInstallMessageHandler(reportStart);
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QApplication application(argc, argv);
    qInstallMessageHandler(report);

    const WindowOptions options = readOptions(application);
    cleanStandardOutput();            // of modules
    std::signal(SIGPIPE, [](int) {}); // fails the write if the cleaner was killed; child processes do not inherit a handler
    const Preferences preferences = loadPreferences();
    const ThemeKind system = themeOf(preferences.theme); // reads the desktop's theme before one is applied
    applyTheme(application, options.theme.value_or(system), preferences.fonts);
    QApplication::setWindowIcon(themedIcon(QStringLiteral("kind-robot")));

    const std::unique_ptr<Application> trundleApplication = makeApplication(findLocations(), Isolation::Module);
    const std::unique_ptr<RenderService> render = RenderService::startInBackground(true);
    MainWindow window(*trundleApplication, render.get(), findLocations(), options.given);
    if (options.screenshot.isEmpty()) window.rememberViews();
    else window.disableSettings(); // a screenshot must not depend on the user's settings
    if (options.size.isValid()) {
        window.setWindowState(Qt::WindowNoState); // the restored state may be maximised
        window.resize(options.size);
    }
    window.checkRobotsWith(programFolder() + "/trundle-cli");
    window.show();
    if (!options.quit) reportCrashes(window, options.screenshot.isEmpty()); // with --quit a script reads standard error
    ScreenshotRunner screenshots(window, options);                          // executes the options after the window is shown
    QObject::connect(&window.session(), &RunSession::stateChanged, &window, &watchExits);
    watchExits();
    const auto endRequested = endOnRequest();
    const int code = QApplication::exec();
    return leave(window, code, *endRequested);
}
