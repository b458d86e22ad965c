#pragma once
// The real window, offscreen, for measurements: sends it events and reports when their effect was painted.

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

[[nodiscard]] double nowMs();           ///< monotonic clock
[[nodiscard]] double computedByAllMs(); ///< processor time of all threads so far

/// Records when widgets were painted and which event occupied the window's thread longest.
class BenchApplication final : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;

    /// Time of a widget's last paint event; 0: not painted since the first query.
    [[nodiscard]] double paintedAt(const QObject& widget) { return m_paintedAt[&widget]; }
    struct Longest {
        double ms = 0;     ///< wall time
        double busyMs = 0; ///< processor time of the thread, independent of other programs
        QString what;      ///< "MouseMove in trundle::View"
    };
    /// The event with the most processor time since the last call.
    [[nodiscard]] Longest takeLongest() { return std::exchange(m_longest, {}); }

private:
    std::map<const QObject*, double> m_paintedAt;
    int m_depth = 0;
    Longest m_longest;
};

/// Measures how long events wait for the window's thread. A separate thread posts an event, and the next one 1 ms after it was handled.
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

    /// Processes events until a condition holds; ends the program with a message if it does not within a minute.
    void until(const char* what, const std::function<bool()>& holds);
    void wait(double ms);
    void open(const QString& file);
    /// Waits until the view is drawn at full quality and nothing is pending.
    void untilSettled();
    /// Runs a function as a separate event.
    void act(const std::function<void()>& what);
    void trigger(const char* action);

    [[nodiscard]] View& view();
    [[nodiscard]] CodeEdit& text();
    [[nodiscard]] QTreeView& tree();
    /// Sends a key press and its release as the window system does.
    void key(QWidget& to, int key, const QString& text);
    void mouse(QEvent::Type type, const QPointF& at);
    /// Sets the size of the view; the window is resized to fit.
    void sizeView(int width, int height);

    std::unique_ptr<Application> application = makeApplication();
    std::unique_ptr<RenderService> render = RenderService::startInBackground();
    std::unique_ptr<MainWindow> window;
    EventGaps gaps;
};

/// Resident memory of this process, MB: current and peak.
[[nodiscard]] double residentMb();
[[nodiscard]] double peakMb();

/// {"median": , "p95": , "worst": , "count": }
[[nodiscard]] QJsonObject summary(std::vector<double> values);

// The measurements.
[[nodiscard]] QJsonObject measureTyping(const QString& file, int keys);
[[nodiscard]] QJsonObject measureFilter(const QString& file, int rounds);
[[nodiscard]] QJsonObject measureGaps(const QString& file);
[[nodiscard]] QJsonObject measureFrames(const QString& file, double seconds);
[[nodiscard]] QJsonObject measureSensors(const QString& file, double seconds);
[[nodiscard]] QJsonObject measureStart(const QString& file, double startedMs);

} // namespace trundle
