// The window: builds the parts, joins them, goes.

#include <cstdlib>

#include <QApplication>
#include <QSettings>

#include "editor/shell/main_window.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"
#include "trundle/options.h"
#include "trundle/picture_taker.h"

namespace {

QtMessageHandler g_report = nullptr; // Qt's own

/// Without a screen Qt says with each window what it cannot do there; whoever takes pictures so has nothing of that.
void report(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (!message.startsWith(QStringLiteral("This plugin does not support"))) g_report(type, context, message);
}

} // namespace

int main(int argc, char** argv) {
    using namespace trundle;
    g_report = qInstallMessageHandler(report);
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Trundle"));
    QApplication::setOrganizationName(QStringLiteral("Trundle"));
    QApplication::setApplicationVersion(QStringLiteral(TRUNDLE_VERSION));

    const WindowOptions options = readOptions(application);
    const bool dark =
        options.theme.value_or(QSettings().value(QStringLiteral("darkTheme")).toBool() ? ThemeKind::Dark : ThemeKind::Light) ==
        ThemeKind::Dark;
    applyTheme(application, dark ? ThemeKind::Dark : ThemeKind::Light);
    QApplication::setWindowIcon(themedIcon(QStringLiteral("kind-robot")));

    const std::unique_ptr<Parts> parts = makeParts();
    const std::unique_ptr<RenderService> render = RenderService::startInBackground();
    MainWindow window(*parts, render.get(), findLocations());
    if (options.screenshot.isEmpty()) window.rememberViews();
    else window.leaveNoTrace(); // and a picture is the same whoever takes it
    if (options.size.isValid()) window.resize(options.size);
    window.show();
    PictureTaker taker(window, options); // does what the options ask for, once the window stands
    const int code = QApplication::exec();
    if (window.session().endRuns()) return code;
    // Code of a controller does not come back. What it uses must stay as long as it is there, so nothing is taken down.
    window.putAway();
    std::_Exit(code);
}
