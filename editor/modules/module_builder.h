#pragma once
// Builds modules from their sources with CMake, while the window goes on.

#include <stop_token>
#include <string>
#include <vector>

#include <QObject>
#include <QStringList>
#include <QThreadPool>

#include "app/compiler_messages.h"
#include "app/locations.h"

namespace trundle {

/// How a build ended.
struct BuildResult {
    std::vector<std::string> folders; ///< of the modules
    bool succeeded = false, cancelled = false;
    double seconds = 0;
    QString failure;        ///< why it failed where no message of a compiler says it; else empty
    BuildMessages messages; ///< errors and warnings, also of a build that succeeded
};

/// Runs the commands of the folders' CMakeLists.txt, so call it only for trusted folders. One build at a time.
class ModuleBuilder final : public QObject {
    Q_OBJECT
public:
    explicit ModuleBuilder(Locations locations, QObject* parent = nullptr);
    ~ModuleBuilder() override; ///< cancels

    /// Builds modules one after the other, until one fails. `project`: messages about files below it have a place. False: one is running.
    bool build(std::vector<std::string> folders, const std::string& project);
    void cancel() { m_stop.request_stop(); }
    [[nodiscard]] bool isRunning() const { return m_runs; }
    /// Limit for one build, s.
    void setLimit(double seconds) { m_limit = seconds; }

Q_SIGNALS:
    void started(const QStringList& folders);
    void printed(const QStringList& lines);
    void ended(const trundle::BuildResult& result);

private:
    struct Job {
        std::vector<std::string> folders;
        std::string project;
        double limit;
        std::stop_token stop;
    };
    [[nodiscard]] BuildResult run(const Job& job);
    void finish(const BuildResult& result);

    Locations m_locations;
    double m_limit = 600;
    bool m_runs = false;
    std::stop_source m_stop;
    QThreadPool m_pool; ///< one thread; the last member: destroyed first, it waits for its thread
};

} // namespace trundle
