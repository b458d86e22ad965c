// Saves pictures of the window with the Radio dock in front: draw_radios FILE OUT.png light|dark SECONDS [LATE] [SIZE=WxH]
// [SELECT=PATH,PATH] [BUDGET] [ROW=N]. LATE: another dock is in front while it runs.
#include <cstdio>

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QTableView>

#include "editor/radios/packets_page.h"
#include "editor/radios/radios_panel.h"
#include "editor/shell/main_window.h"
#include "editor/widgets/theme.h"
#include "parts/parts.h"
#include "render/service.h"

using namespace trundle;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (argc < 5)
        return std::fprintf(
                   stderr, "draw_radios FILE OUT.png light|dark SECONDS [LATE] [SIZE=WxH] [SELECT=PATH,PATH] [BUDGET] [ROW=N]\n"),
               2;
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
        while (time.elapsed() < 30000 && (time.elapsed() < 400 || !window.isSettled() || !done()));
    };
    window.setLayout(Layout::Run);
    if (!window.document().open(argv[1]).ok()) return std::fprintf(stderr, "no %s\n", argv[1]), 1;
    window.showText(false);
    QStringList words;
    for (int i = 5; i < argc; ++i) words.append(QString::fromLocal8Bit(argv[i]));
    for (const QString& word : words)
        if (word.startsWith(QStringLiteral("SIZE=")))
            window.resize(word.mid(5).section(u'x', 0, 0).toInt(), word.section(u'x', 1).toInt());
    auto* dock = window.findChild<QDockWidget*>(QStringLiteral("dock.radios"));
    if (!words.contains(QStringLiteral("LATE"))) dock->raise();
    auto* panel = window.findChild<RadiosPanel*>();
    settle([] { return true; });
    if (const double seconds = std::atof(argv[4]); seconds > 0) {
        window.session().setSpeed(0);
        window.session().runFor(seconds);
        settle([&] { return window.session().state() == RunState::Paused && window.session().time() > seconds - 1e-9; });
    }
    dock->raise();
    settle([] { return true; });
    for (const QString& word : words) {
        if (word.startsWith(QStringLiteral("SELECT="))) {
            std::vector<std::string> paths;
            for (const QString& path : word.mid(7).split(u',')) paths.push_back(path.toStdString());
            window.selection().set(paths);
        } else if (word == QStringLiteral("BUDGET")) panel->showPage(RadiosPanel::Budget);
        else if (word.startsWith(QStringLiteral("ROW=")))
            panel->findChild<QTableView*>()->setCurrentIndex(panel->packets().model().index(word.mid(4).toInt(), 0));
        settle([] { return true; });
    }
    return window.grab().save(QString::fromLocal8Bit(argv[2])) ? 0 : 1;
}
