// Saves an image of the panel: draw_viewport FILE OUT.png [light|dark] [SELECT] [TOOL] [VIEWS] [OVERLAYS,...]
#include <cstdio>

#include <QApplication>
#include <QElapsedTimer>

#include "editor/viewport/view_window.h"
#include "editor/widgets/apply_theme.h"

using namespace trundle;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (argc < 3) return std::fprintf(stderr, "draw_viewport FILE OUT.png [light|dark] [SELECT] [TOOL] [VIEWS] [OVERLAYS]\n"), 2;
    const auto argument = [&](int i) { return i < argc ? QString::fromLocal8Bit(argv[i]) : QString(); };
    applyTheme(application, argument(3) == QStringLiteral("dark") ? ThemeKind::Dark : ThemeKind::Light);
    auto render = RenderService::startInBackground();
    ViewWindow window(render.get());
    window.panel->resize(1280, 760);
    if (!window.document.opening().open(argv[1]).ok()) return std::fprintf(stderr, "no %s\n", argv[1]), 1;
    if (!argument(4).isEmpty()) {
        std::vector<std::string> paths;
        for (const QString& path : argument(4).split(QLatin1Char(','))) paths.push_back(path.toStdString());
        window.selection.set(paths);
    }
    if (!argument(5).isEmpty()) window.trigger(("tool." + argument(5).toLatin1()).constData());
    if (argument(6) == QStringLiteral("2")) window.trigger("view.two");
    if (argument(6) == QStringLiteral("4")) window.trigger("view.four");
    if (!argument(7).isEmpty())
        for (const QString& name : argument(7).split(QLatin1Char(','))) window.trigger(("view." + name.toLatin1()).constData());
    QElapsedTimer time;
    time.start();
    while (time.elapsed() < 2500 || !window.panel->isSettled()) QApplication::processEvents(QEventLoop::AllEvents, 20);
    std::printf("%d redraws, %d refinements\n", window.view().image().redraws(), window.view().image().refinements());
    return window.panel->grab().save(QString::fromLocal8Bit(argv[2])) ? 0 : 1;
}
