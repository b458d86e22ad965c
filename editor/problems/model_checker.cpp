#include "editor/problems/model_checker.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "check/model_check.h"
#include "project/loading/modules.h"
#include "run/logs/log_kinds.h"

namespace trundle {

namespace {

constexpr int kDelayMs = 300;                          // after the last edit
constexpr std::chrono::milliseconds kRobotsDelay(700); // after that, since it takes longer and may start a process

/// False if a stop was requested meanwhile.
bool waitUnlessStopped(const std::stop_token& stop) {
    std::mutex lock;
    std::condition_variable_any wake;
    std::unique_lock guard(lock);
    return !wake.wait_for(guard, stop, kRobotsDelay, [&stop] { return stop.stop_requested(); });
}

} // namespace

ModelChecker::ModelChecker(QObject* parent) : QObject(parent) {
    m_pool.setMaxThreadCount(1);
    m_delay.setSingleShot(true);
    m_delay.setInterval(kDelayMs);
    connect(&m_delay, &QTimer::timeout, this, &ModelChecker::start);
}

ModelChecker::~ModelChecker() {
    m_stop.request_stop();
    m_pool.waitForDone();
}

void ModelChecker::request(std::shared_ptr<const LoadedProject> loaded, RobotsCheck robots) {
    m_stop.request_stop();
    m_wanted = std::move(loaded);
    m_robots = std::move(robots);
    m_delay.start();
}

void ModelChecker::start() {
    if (m_busy) return; // finish() starts the next check
    if (!m_wanted) return Q_EMIT checked(nullptr, {});
    m_busy = true;
    m_stop = std::stop_source();
    m_pool.start([this, loaded = m_wanted, robots = m_robots, stop = m_stop.get_token()]() mutable {
        Diagnostics found;
        const bool isWhole = !loaded->diagnostics.hasErrors() && !loaded->pending;
        if (isWhole) checkLogs(*loaded->experiment, *loaded->registry, hasAllModules(loaded->diagnostics), found);
        checkModel(*loaded, found, stop);
        QMetaObject::invokeMethod(
            this, [this, loaded, all = found.all()] { finish(loaded, all); }, Qt::QueuedConnection);
        if (isWhole && !found.hasErrors() && waitUnlessStopped(stop)) {
            tryRobots(*loaded, found, stop);
            if (hasAllModules(loaded->diagnostics) && !robots.program.empty()) found.append(checkRobots(robots, *loaded, stop));
        }
        // The project is moved along: if this is its last reference, it is destroyed in this object's thread.
        QMetaObject::invokeMethod(
            this, [this, loaded = std::move(loaded), all = found.all()] { report(loaded, all); }, Qt::QueuedConnection);
    });
}

void ModelChecker::finish(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<Diagnostic>& found) {
    m_busy = false;
    m_found = found.size();
    if (loaded == m_wanted && !m_stop.stop_requested()) Q_EMIT checked(loaded, found);
    else if (!m_delay.isActive()) m_delay.start();
}

void ModelChecker::report(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<Diagnostic>& found) {
    if (loaded == m_wanted && found.size() > m_found) Q_EMIT checked(loaded, found);
}

} // namespace trundle
