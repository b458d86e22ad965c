#pragma once
// The real window, offscreen, for measurements: it is sent events, and says when it has shown what came of them.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include <QApplication>
#include <QJsonObject>

#include "app/application.h"
#include "editor/shell/main_window.h"
#include "render/service.h"

class QTreeView;

namespace trundle {

class CodeEdit;
class View;

[[nodiscard]] double nowMs();           ///< of the clock that never goes back
[[nodiscard]] double computedByAllMs(); ///< processor time of all threads so far

/// Notes when widgets were painted, and which event kept the window's thread longest.
class BenchApplication final : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;

    /// When the last painting of a widget was done; 0: never since it was first asked for.
    [[nodiscard]] double paintedAt(const QObject& widget) { return m_paintedAt[&widget]; }
    struct Longest {
        double ms = 0;     ///< by the clock
        double busyMs = 0; ///< that the thread computed: what no other program adds to
        QString what;      ///< "MouseMove in trundle::View"
    };
    /// The longest event, by what the thread computed, since the last call.
    [[nodiscard]] Longest takeLongest() { return std::exchange(m_longest, {}); }

private:
    std::map<const QObject*, double> m_paintedAt;
    int m_depth = 0;
    Longest m_longest;
};

/// How long events wait for the window's thread. A thread of its own posts one, and the next 1 ms after it was answered.
class EventGaps final : public QObject {
public:
    EventGaps();
    ~EventGaps() override;
    /// The longest since the last call, ms.
    [[nodiscard]] double takeLongest();

protected:
    bool event(QEvent* event) override;

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared;
    std::thread m_thread;
};

struct BenchWindow {
    BenchWindow();
    ~BenchWindow();

    /// Lets the window work until something holds; ends the program with a message where it does not within a minute.
    void until(const char* what, const std::function<bool()>& holds);
    void wait(double ms);
    void open(const QString& file);
    /// Drawn as finely as it will be, nothing under way.
    void untilSettled();
    /// Does something as an event of its own.
    void act(const std::function<void()>& what);
    void trigger(const char* action);

    [[nodiscard]] View& view();
    [[nodiscard]] CodeEdit& text();
    [[nodiscard]] QTreeView& tree();
    /// A key press and its release, as the window system would hand them over.
    void key(QWidget& to, int key, const QString& text);
    void mouse(QEvent::Type type, const QPointF& at);
    /// Of the view; its window is made to fit.
    void sizeView(int width, int height);

    std::unique_ptr<Application> application = makeApplication();
    std::unique_ptr<RenderService> render = RenderService::startInBackground();
    std::unique_ptr<MainWindow> window;
    EventGaps gaps;
};

/// Of this process, MB: now and at most so far.
[[nodiscard]] double residentMb();
[[nodiscard]] double peakMb();

/// {"median": , "p95": , "worst": , "count": }
[[nodiscard]] QJsonObject summary(std::vector<double> values);

// What the program can measure.
[[nodiscard]] QJsonObject measureTyping(const QString& file, int keys);
[[nodiscard]] QJsonObject measureFilter(const QString& file, int rounds);
[[nodiscard]] QJsonObject measureGaps(const QString& file);
[[nodiscard]] QJsonObject measureFrames(const QString& file, double seconds);
[[nodiscard]] QJsonObject measureStart(const QString& file, double startedMs);

} // namespace trundle
