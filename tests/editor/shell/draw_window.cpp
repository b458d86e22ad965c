// Saves an image of the window with one dock in front, after a run: draw_window FILE OUT.png light|dark SECONDS DOCK [WORD]...
// WORD: an action's name, select=PATH,PATH, size=WxH, or NAME=N, the Nth row, choice or tab of the widget with that name. An open
// dialog is saved as a second image, OUT.png.dialog.png. For visual review and for the guide; golden_test.cpp tests images.
#include <cstdio>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QTabBar>

#include "app/application.h"
#include "editor/shell/main_window.h"
#include "editor/shell/work_area.h"
#include "editor/widgets/apply_theme.h"
#include "render/service.h"

using namespace trundle;

namespace {

constexpr int kLeastMs = 400, kMaxMs = 30'000;

bool choose(MainWindow& window, const QString& name, int index) {
    if (auto* choice = window.findChild<QComboBox*>(name)) choice->setCurrentIndex(index);
    else if (auto* tabs = window.findChild<QTabBar*>(name)) tabs->setCurrentIndex(index);
    else if (auto* rows = window.findChild<QAbstractItemView*>(name)) rows->setCurrentIndex(rows->model()->index(index, 0));
    else return false;
    return true;
}

bool apply(MainWindow& window, const QString& word) {
    const QString name = word.section(u'=', 0, 0), value = word.section(u'=', 1);
    if (name == QStringLiteral("select")) {
        std::vector<std::string> paths;
        for (const QString& path : value.split(u',')) paths.push_back(path.toStdString());
        window.selection().set(paths);
    } else if (name == QStringLiteral("size")) {
        window.resize(value.section(u'x', 0, 0).toInt(), value.section(u'x', 1).toInt());
    } else if (word.contains(u'=')) {
        return choose(window, name, value.toInt());
    } else {
        window.actions().at(name.toLatin1().constData()).trigger();
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    if (argc < 6) return std::fprintf(stderr, "draw_window FILE OUT.png light|dark SECONDS DOCK [WORD]...\n"), 2;
    applyTheme(application, argv[3] == std::string("dark") ? ThemeKind::Dark : ThemeKind::Light);
    const auto trundleApplication = makeApplication();
    const auto render = RenderService::startInBackground();
    MainWindow window(*trundleApplication, render.get(), findLocations());
    window.resize(1600, 1000);
    window.show();
    const auto settle = [&window](auto done) {
        QElapsedTimer time;
        time.start();
        do QApplication::processEvents(QEventLoop::AllEvents, 20);
        while (time.elapsed() < kMaxMs && (time.elapsed() < kLeastMs || !window.isSettled() || !done()));
    };
    window.setLayout(Layout::Run);
    if (!window.document().opening().open(argv[1]).ok()) return std::fprintf(stderr, "no %s\n", argv[1]), 1;
    window.work().showText(false);
    auto* dock = window.findChild<QDockWidget*>(QStringLiteral("dock.") + QString::fromLocal8Bit(argv[5]));
    if (!dock) return std::fprintf(stderr, "no dock %s\n", argv[5]), 2;
    dock->raise();
    settle([] { return true; });
    if (const double seconds = std::atof(argv[4]); seconds > 0) {
        window.session().setSpeed(0);
        window.session().runFor(seconds);
        settle(
            [&] { return window.session().state() == RunState::Paused && window.session().results().time() > seconds - 1e-9; });
    }
    for (int i = 6; i < argc; ++i) {
        if (!apply(window, QString::fromLocal8Bit(argv[i]))) return std::fprintf(stderr, "what is %s?\n", argv[i]), 2;
        settle([] { return true; });
    }
    const QString out = QString::fromLocal8Bit(argv[2]);
    for (auto* dialog : window.findChildren<QDialog*>())
        if (dialog->isVisible()) dialog->grab().save(out + QStringLiteral(".dialog.png"));
    return window.grab().save(out) ? 0 : 1;
}
