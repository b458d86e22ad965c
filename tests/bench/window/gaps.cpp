// Measures how long events wait for the window's thread under load, and the memory of the window.

#include <QJsonArray>

#include "bench/window/bench_window.h"
#include "editor/text/code/code_edit.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/view/view.h"

namespace trundle {
namespace {

constexpr int kDrags = 5, kSteps = 40, kStepMs = 16;

class Phases {
public:
    explicit Phases(BenchWindow& w) : m_w(w) {}
    void add(const char* name, const std::function<void()>& work) {
        (void)m_w.gaps.takeLongest();
        (void)application().takeLongest();
        const double begin = nowMs();
        work();
        const BenchApplication::Longest longest = application().takeLongest();
        m_all.append(QJsonObject{{QStringLiteral("phase"), QLatin1String(name)},
                                 {QStringLiteral("gap_ms"), m_w.gaps.takeLongest()},
                                 {QStringLiteral("event_ms"), longest.ms},
                                 {QStringLiteral("busy_ms"), longest.busyMs},
                                 {QStringLiteral("event"), longest.what},
                                 {QStringLiteral("took_ms"), nowMs() - begin}});
    }
    [[nodiscard]] const QJsonArray& all() const { return m_all; }

private:
    static BenchApplication& application() { return *static_cast<BenchApplication*>(qApp); }
    BenchWindow& m_w;
    QJsonArray m_all;
};

/// Drags the gizmo's x arrow back and forth at the event rate of a mouse.
void drag(BenchWindow& w) {
    const auto spot = w.view().tools().gizmo().spot({GizmoHandle::Kind::Axis, 0});
    if (!spot) qFatal("there is no handle to drag");
    w.mouse(QEvent::MouseMove, *spot);
    w.mouse(QEvent::MouseButtonPress, *spot);
    for (int i = 1; i <= kSteps; ++i) {
        w.mouse(QEvent::MouseMove, *spot + QPointF(3 * i, i % 5));
        w.wait(kStepMs);
    }
    w.mouse(QEvent::MouseButtonRelease, *spot + QPointF(3 * kSteps, 0));
    w.wait(2 * kStepMs);
}

} // namespace

QJsonObject measureGaps(const QString& file) {
    BenchWindow w;
    RunSession& session = w.window->session();
    Document& document = w.window->document();
    w.wait(500);
    w.untilSettled();
    const double empty = residentMb();
    Phases phases(w);
    phases.add("open, until drawn", [&] { w.open(file); });
    const double opened = residentMb();
    const auto select = [&] {
        w.act([&] { w.window->selection().select("middle"); });
        for (const char* action : {"view.frame", "tool.move"}) w.trigger(action);
        w.untilSettled();
    };
    phases.add("select a robot", select);
    phases.add("drag it by the gizmo", [&] {
        for (int i = 0; i < kDrags; ++i) drag(w);
        w.untilSettled();
    });
    if (document.edits().history().position() != kDrags)
        qFatal("%d drags made %d entries", kDrags, int(document.edits().history().position()));
    phases.add("undo and redo", [&] {
        for (const char* action : {"edit.undo", "edit.redo", "edit.undo"})
            for (int i = 0; i < kDrags; ++i) {
                w.trigger(action);
                w.wait(100);
            }
        w.trigger("edit.redo");
        w.untilSettled();
    });
    phases.add("type in the text", [&] {
        w.text().setFocus();
        for (int i = 0; i < 20; ++i) {
            if (i % 2 == 0) w.key(w.text(), Qt::Key_Space, QStringLiteral(" "));
            else w.key(w.text(), Qt::Key_Backspace, {});
            w.wait(60);
        }
        w.wait(500);
        w.untilSettled();
    });
    phases.add("save", [&] {
        w.trigger("file.save");
        w.wait(700);
        w.untilSettled();
    });
    if (document.texts().isModified()) qFatal("it was not saved");
    phases.add("run, from F5 on", [&] {
        w.trigger("sim.run");
        w.until("it runs", [&] { return session.results().time() > 0; });
        w.wait(3000);
    });
    phases.add("pause", [&] {
        w.trigger("sim.pause");
        w.until("it is paused", [&] { return session.state() == RunState::Paused; });
        w.untilSettled();
    });
    phases.add("drag it in the paused world", [&] {
        select();
        drag(w);
        w.untilSettled();
    });
    phases.add("reset", [&] {
        w.trigger("sim.reset");
        w.wait(100);
        w.untilSettled();
    });
    const double worked = residentMb();
    phases.add("close", [&] {
        w.act([&] { document.opening().close(); });
        w.wait(300);
    });
    return {{QStringLiteral("phases"), phases.all()},
            {QStringLiteral("empty_mb"), empty},
            {QStringLiteral("opened_mb"), opened},
            {QStringLiteral("worked_mb"), worked},
            {QStringLiteral("peak_mb"), peakMb()}};
}

QJsonObject measureStart(const QString& file, double startedMs) {
    BenchWindow w;
    BenchApplication& application = *static_cast<BenchApplication*>(qApp);
    double drawn = 0;
    QObject::connect(&w.view().image(), &ViewImage::shown, [&] {
        if (drawn == 0) drawn = nowMs();
    });
    if (!file.isEmpty()) w.window->open(file);
    w.until("the window is painted", [&] { return application.paintedAt(*w.window) > 0; });
    const double window = application.paintedAt(*w.window);
    if (!file.isEmpty())
        w.until("the first picture is painted", [&] { return drawn > 0 && application.paintedAt(w.view()) > drawn; });
    return {{QStringLiteral("window_ms"), window - startedMs},
            {QStringLiteral("picture_ms"), file.isEmpty() ? 0 : application.paintedAt(w.view()) - startedMs}};
}

} // namespace trundle
