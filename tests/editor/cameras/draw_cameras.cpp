// Saves pictures of the window with the Cameras dock in front: draw_cameras FILE OUT.png light|dark SECONDS [ACTION|SELECT=PATH|MODE=N]...
// An action that opens a dialog makes a second picture, of that: OUT.png.dialog.png.
#include <cstdio>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>

#include "editor/shell/main_window.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"

using namespace trundle;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (argc < 5) return std::fprintf(stderr, "draw_cameras FILE OUT.png light|dark SECONDS [ACTION|SELECT=PATH|MODE=N]...\n"), 2;
    applyTheme(application, argv[3] == std::string("dark") ? ThemeKind::Dark : ThemeKind::Light);
    const auto parts = makeParts();
    const auto render = RenderService::startInBackground();
    MainWindow window(*parts, render.get(), findLocations());
    window.resize(1600, 1000);
    window.show();
    const auto settle = [&window](auto done) {
        QElapsedTimer time;
        time.start();
        do QApplication::processEvents(QEventLoop::AllEvents, 20);
        while (time.elapsed() < 20000 && (time.elapsed() < 400 || !window.isSettled() || !done()));
    };
    window.setLayout(Layout::Run);
    if (!window.document().open(argv[1]).ok()) return std::fprintf(stderr, "no %s\n", argv[1]), 1;
    window.showText(false);
    for (auto* dock : window.findChildren<QDockWidget*>())
        if (dock->objectName() == QStringLiteral("dock.cameras")) dock->raise();
    settle([] { return true; });
    if (const double seconds = std::atof(argv[4]); seconds > 0) {
        window.session().setSpeed(0);
        window.session().runFor(seconds);
        settle([&] { return window.session().state() == RunState::Paused && window.session().time() > seconds - 1e-9; });
    }
    for (int i = 5; i < argc; ++i) {
        const QString word = QString::fromLocal8Bit(argv[i]);
        if (word.startsWith(QStringLiteral("SELECT="))) window.selection().select(word.mid(7).toStdString());
        else if (word.startsWith(QStringLiteral("MODE=")))
            window.findChild<QComboBox*>(QStringLiteral("cameraMode"))->setCurrentIndex(word.mid(5).toInt());
        else window.actions().at(argv[i]).trigger();
        settle([] { return true; });
    }
    const QString out = QString::fromLocal8Bit(argv[2]);
    for (auto* dialog : window.findChildren<QDialog*>())
        if (dialog->isVisible()) dialog->grab().save(out + QStringLiteral(".dialog.png"));
    return window.grab().save(out) ? 0 : 1;
}
