// Measures what many lidars cost the window: the fans over the 3D picture and the cards of the Sensors dock.

#include "bench/window/bench_window.h"
#include "editor/document/selection.h"
#include "editor/sensors/sensor_card.h"
#include "editor/sensors/sensors_panel.h"
#include "editor/shell/work_area.h"
#include "editor/viewport/view/view.h"

namespace trundle {
namespace {

constexpr int kRounds = 50;

/// Processor times of some rounds, ms.
QJsonObject timesOf(const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < kRounds; ++i) {
        const double before = computedByAllMs();
        work();
        times.push_back(computedByAllMs() - before);
    }
    return summary(times);
}

} // namespace

QJsonObject measureSensors(const QString& file, double seconds) {
    BenchWindow w;
    w.open(file);
    w.act([&] { w.window->work().showText(false); });
    w.sizeView(1280, 500);
    auto* panel = w.window->findChild<SensorsPanel*>();
    w.window->findChild<QAction*>(QStringLiteral("show.sensors"))->trigger();
    w.act([&] { w.window->session().runFor(seconds); });
    w.until("it has run", [&] { return w.window->session().state() == RunState::Paused; });
    w.untilSettled();
    const QJsonObject bare = timesOf([&] { w.view().repaint(); });
    std::vector<std::string> lidars;
    for (const RobotSpec& robot : w.window->session().results().experiment->robots) lidars.push_back(robot.name + ".scan");
    w.act([&] { w.window->selection().set(lidars); });
    w.until("the cards are there", [&] { return panel->cards().size() == lidars.size(); });
    w.untilSettled();
    const QJsonObject fans = timesOf([&] { w.view().repaint(); });
    const RunResults& run = w.window->session().results();
    // Cards take turns; also those that are scrolled out of sight.
    const std::vector<SensorCard*>& all = panel->cards();
    const std::size_t turns = (all.size() + SensorsPanel::kCardsAtOnce - 1) / SensorsPanel::kCardsAtOnce;
    std::size_t turn = 0;
    const auto eachOfATurn = [&](const auto& work) {
        for (std::size_t i = turn++ % turns; i < all.size(); i += turns) work(*all[i]);
    };
    const QJsonObject values = timesOf([&] { eachOfATurn([&](SensorCard& card) { card.display(run, true); }); });
    const QJsonObject cards = timesOf([&] { eachOfATurn([](SensorCard& card) { (void)card.grab(); }); });
    return {{QStringLiteral("lidars"), qint64(lidars.size())},
            {QStringLiteral("view"), bare},
            {QStringLiteral("view_with_fans"), fans},
            {QStringLiteral("values"), values},
            {QStringLiteral("cards"), cards}};
}

} // namespace trundle
