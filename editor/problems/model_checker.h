#pragma once
// Runs the model checks in a worker thread, so that typing is never delayed.

#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "base/diagnostic.h"
#include "project/loading/project.h"

namespace trundle {

/// Runs one check at a time, of the model and the logs only: no module code runs and no port is bound.
class ModelChecker final : public QObject {
    Q_OBJECT
public:
    explicit ModelChecker(QObject* parent = nullptr);
    ~ModelChecker() override;

    /// Checks this project after a short delay; a later call replaces the request and stops a running check. Null: nothing.
    void request(std::shared_ptr<const LoadedProject> loaded);

Q_SIGNALS:
    /// The diagnostics of the project requested last.
    void checked(const std::shared_ptr<const trundle::LoadedProject>& loaded, const std::vector<trundle::Diagnostic>& found);

private:
    void start();
    void finish(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<Diagnostic>& found);

    std::shared_ptr<const LoadedProject> m_wanted;
    bool m_busy = false;
    std::stop_source m_stop; ///< of the running check
    QTimer m_delay{this};
    QThreadPool m_pool; ///< one thread; the last member: destroyed first, it waits for its thread
};

} // namespace trundle
