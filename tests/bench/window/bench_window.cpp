#include "bench/window/bench_window.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <QEventLoop>
#include <QKeyEvent>
#include <QMetaEnum>
#include <QMouseEvent>
#include <QTimer>
#include <QTreeView>

#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/view/view.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/apply_theme.h"

namespace trundle {
namespace {

constexpr double kTimeoutMs = 60000;

double readMs(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

/// Processor time of the calling thread, ms.
double computedMs() { return readMs(CLOCK_THREAD_CPUTIME_ID); }

double fromStatus(const char* key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key)) return std::atof(line.c_str() + std::string_view(key).size() + 1) / 1024;
    return 0;
}

} // namespace

double nowMs() { return readMs(CLOCK_MONOTONIC); }
double computedByAllMs() { return readMs(CLOCK_PROCESS_CPUTIME_ID); }

double residentMb() { return fromStatus("VmRSS"); }
double peakMb() { return fromStatus("VmHWM"); }

QJsonObject summary(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto share = [&](double part) {
        return values.empty() ? 0.0 : values[std::min(values.size() - 1, std::size_t(part * double(values.size())))];
    };
    return {{QStringLiteral("median"), share(0.5)},
            {QStringLiteral("p95"), share(0.95)},
            {QStringLiteral("worst"), share(1)},
            {QStringLiteral("count"), qint64(values.size())}};
}

// ---- events of the window's thread ----

bool BenchApplication::notify(QObject* receiver, QEvent* event) {
    const QEvent::Type type = event->type();
    const char* const name = receiver->metaObject()->className(); // the event may delete the receiver
    const double begin = nowMs(), computed = m_depth == 0 ? computedMs() : 0;
    ++m_depth;
    const bool done = QApplication::notify(receiver, event);
    --m_depth;
    const double end = nowMs();
    if (type == QEvent::Paint) m_paintedAt[receiver] = end;
    if (m_depth > 0) return done;
    if (const double busy = computedMs() - computed; busy > m_longest.busyMs) {
        const char* const word = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
        m_longest = {end - begin, busy,
                     QStringLiteral("%1 in %2").arg(QLatin1String(word ? word : "event"), QLatin1String(name))};
    }
    return done;
}

struct EventGaps::Shared {
    std::atomic<bool> over = false, waiting = false;
    double postedMs = 0, longestMs = 0; // owned by the posting thread while no event is pending, otherwise by the window's
};

EventGaps::EventGaps() : m_shared(std::make_shared<Shared>()) {
    m_thread = std::thread([this, shared = m_shared] {
        while (!shared->over) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            shared->postedMs = nowMs();
            shared->waiting = true;
            QCoreApplication::postEvent(this, new QEvent(QEvent::User), Qt::LowEventPriority);
            shared->waiting.wait(true);
        }
    });
}

EventGaps::~EventGaps() {
    m_shared->over = true;
    m_shared->waiting = false;
    m_shared->waiting.notify_one();
    m_thread.join();
}

bool EventGaps::event(QEvent* event) {
    if (event->type() != QEvent::User) return QObject::event(event);
    m_shared->longestMs = std::max(m_shared->longestMs, nowMs() - m_shared->postedMs);
    m_shared->waiting = false;
    m_shared->waiting.notify_one();
    return true;
}

double EventGaps::takeLongest() { return std::exchange(m_shared->longestMs, 0); }

// ---- the window ----

BenchWindow::BenchWindow() {
    applyTheme(*qApp, ThemeKind::Light);
    window = std::make_unique<MainWindow>(*application, render.get(), findLocations());
    window->resize(1600, 1000);
    window->show();
}

BenchWindow::~BenchWindow() { window.reset(); }

void BenchWindow::until(const char* what, const std::function<bool()>& holds) {
    // The events of EventGaps wake the loop every millisecond.
    for (const double begin = nowMs(); !holds();) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        if (nowMs() - begin < kTimeoutMs) continue;
        std::fprintf(stderr, "window_bench: not within a minute: %s\n", what);
        std::exit(1);
    }
}

void BenchWindow::wait(double ms) {
    const double end = nowMs() + ms;
    until("a moment", [&] { return nowMs() >= end; });
}

void BenchWindow::untilSettled() {
    until("the window settles", [this] { return window->isSettled(); });
}

void BenchWindow::act(const std::function<void()>& what) {
    bool done = false;
    QMetaObject::invokeMethod(
        window.get(),
        [&] {
            what();
            done = true;
        },
        Qt::QueuedConnection);
    until("it is done", [&] { return done; });
}

void BenchWindow::trigger(const char* action) {
    act([&] { window->actions().at(action).trigger(); });
}

void BenchWindow::open(const QString& file) {
    act([&] { window->open(file); });
    until("the file is open", [this] { return window->document().isOpen() && !window->document().opening().isOpening(); });
    untilSettled();
    if (window->document().loaded()->diagnostics.hasErrors()) {
        std::fprintf(stderr, "window_bench: %s has errors\n", qPrintable(file));
        std::exit(1);
    }
}

View& BenchWindow::view() { return window->viewport().views().current(); }
CodeEdit& BenchWindow::text() { return window->text().page()->edit(); }
QTreeView& BenchWindow::tree() { return *window->findChild<QTreeView*>(QStringLiteral("outlineTree")); }

void BenchWindow::key(QWidget& to, int key, const QString& text) {
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease})
        QCoreApplication::postEvent(&to, new QKeyEvent(type, key, Qt::NoModifier, text));
}

void BenchWindow::mouse(QEvent::Type type, const QPointF& at) {
    const bool moves = type == QEvent::MouseMove, released = type == QEvent::MouseButtonRelease;
    QCoreApplication::postEvent(&view(), new QMouseEvent(type, at, view().mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                                                         released ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier));
}

void BenchWindow::sizeView(int width, int height) {
    window->viewport().resize(width, height);
    for (int tries = 0; tries < 4 && view().size() != QSize(width, height); ++tries) {
        window->resize(window->width() + width - view().width(), window->height() + height - view().height());
        wait(50);
    }
    untilSettled();
}

} // namespace trundle
