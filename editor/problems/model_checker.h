#pragma once
// Runs the model checks in a worker thread, so that typing is never delayed.

#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "base/diagnostic.h"
#include "editor/problems/robots_check.h"
#include "project/loading/project.h"

namespace trundle {

/// Runs one check at a time: of the model and the logs, then of what robots do on a plain floor, and of what only code of modules can
/// say. That code never runs in this process.
class ModelChecker final : public QObject {
    Q_OBJECT
public:
    explicit ModelChecker(QObject* parent = nullptr);
    ~ModelChecker() override;

    /// Checks this project after a short delay; a later call replaces the request and stops a running check. Null: nothing.
    void request(std::shared_ptr<const LoadedProject> loaded, RobotsCheck robots = {});

Q_SIGNALS:
    /// The diagnostics of the project requested last; a second time, with more of them, of its robots.
    void checked(const std::shared_ptr<const trundle::LoadedProject>& loaded, const std::vector<trundle::Diagnostic>& found);

private:
    void start();
    void finish(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<Diagnostic>& found);
    void report(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<Diagnostic>& found);

    std::shared_ptr<const LoadedProject> m_wanted;
    RobotsCheck m_robots;
    bool m_busy = false;
    std::size_t m_found = 0; ///< number of diagnostics of the model check
    std::stop_source m_stop; ///< of the running check
    QTimer m_delay{this};
    QThreadPool m_pool; ///< one thread; the last member: destroyed first, it waits for its thread
};

} // namespace trundle
