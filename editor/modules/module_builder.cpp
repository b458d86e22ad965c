#include "editor/modules/module_builder.h"

#include <utility>

#include "app/module_build.h"
#include "base/platform/process.h"

namespace trundle {
namespace {

constexpr std::uint64_t kMostOutput = 16u << 20;

/// Cuts a stream of bytes into lines.
class Lines {
public:
    QStringList take(std::string_view bytes) {
        QStringList lines;
        m_rest.append(bytes);
        for (std::size_t end = 0; (end = m_rest.find('\n')) != std::string::npos; m_rest.erase(0, end + 1))
            lines.append(QString::fromUtf8(m_rest.data(), static_cast<qsizetype>(end)));
        return lines;
    }

private:
    std::string m_rest;
};

/// Both outputs in one pipe, so that their lines keep their order; English messages, which are read afterwards.
ProcessRequest requestFor(const BuildStep& step, double limit, const std::stop_token& stop) {
    ProcessRequest request;
    request.program = "/bin/sh";
    request.arguments = {"-c", "exec \"$@\" 2>&1", "sh", "env", "LC_ALL=C.UTF-8", "cmake"};
    request.arguments.insert(request.arguments.end(), step.begin(), step.end());
    request.seconds = limit;
    request.outputBytes = kMostOutput;
    request.stop = stop;
    return request;
}

constexpr int kNotFound = 127; ///< exit code of env

} // namespace

ModuleBuilder::ModuleBuilder(Locations locations, QObject* parent) : QObject(parent), m_locations(std::move(locations)) {
    m_pool.setMaxThreadCount(1);
}

ModuleBuilder::~ModuleBuilder() {
    cancel();
    m_pool.waitForDone();
}

bool ModuleBuilder::build(std::vector<std::string> folders, const std::string& project) {
    if (std::exchange(m_runs, true)) return false;
    m_stop = std::stop_source();
    QStringList names;
    for (const std::string& folder : folders) names.append(QString::fromStdString(folder));
    Q_EMIT started(names);
    m_pool.start([this, job = Job{std::move(folders), project, m_limit, m_stop.get_token()}] {
        const BuildResult result = run(job);
        QMetaObject::invokeMethod(
            this, [this, result] { finish(result); }, Qt::QueuedConnection);
    });
    return true;
}

/// In the worker thread.
BuildResult ModuleBuilder::run(const Job& job) {
    BuildResult result;
    result.folders = job.folders;
    std::string output;
    for (const std::string& folder : job.folders)
        for (const BuildStep& step : buildSteps(folder, m_locations)) {
            ProcessRequest request = requestFor(step, job.limit, job.stop);
            request.received = [this, lines = Lines()](std::string_view bytes) mutable {
                const QStringList whole = lines.take(bytes);
                if (whole.isEmpty()) return;
                QMetaObject::invokeMethod(
                    this, [this, whole] { Q_EMIT printed(whole); }, Qt::QueuedConnection);
            };
            const Result<ProcessResult> ran = runProcess(request);
            result.cancelled = job.stop.stop_requested();
            if (!ran) result.failure = QString::fromStdString(ran.error().message);
            else {
                result.seconds += ran.value().seconds;
                output += ran.value().output;
                const bool found = ran.value().end != ProcessEnd::Exited || ran.value().exitCode != kNotFound;
                if (!found) result.failure = tr("cmake is not installed: a build needs cmake, make and a C++ compiler");
                else if (!ran.value().succeeded()) result.failure = QString::fromStdString("cmake " + describeEnd(request, ran.value()));
            }
            result.messages = readBuildOutput(output, folder + "/build", job.project,
                                              [&job](const std::string& file) { return file.starts_with(job.project + "/"); });
            if (!result.failure.isEmpty()) return result;
        }
    result.succeeded = true;
    return result;
}

void ModuleBuilder::finish(const BuildResult& result) {
    m_runs = false;
    Q_EMIT ended(result);
}

} // namespace trundle
