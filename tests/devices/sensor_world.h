#pragma once
// Sensors in worlds that are given as text, built and run as the programs do.

#include <filesystem>
#include <fstream>
#include <functional>
#include <span>

#include <QTemporaryDir>
#include <QtTest>

#include "app/application.h"
#include "run/runner.h"

namespace trundle::test {

/// An experiment from a text, and its world. `prepare` writes files beside the text.
class SensorWorld {
public:
    explicit SensorWorld(const std::string& text, const std::vector<std::string>& sets = {},
                         const std::function<void(const QTemporaryDir&)>& prepare = {}) {
        if (prepare) prepare(m_folder);
        const std::string path = (std::filesystem::path(m_folder.path().toStdString()) / "main.sim").string();
        std::ofstream(path, std::ios::binary) << text;
        OpenOptions options;
        options.sets = sets;
        m_loaded = m_application->open(path, options).value();
        for (const Diagnostic& d : m_loaded->diagnostics.all())
            if (d.severity == Severity::Error) m_failure += d.message + "\n";
        if (!m_failure.empty()) return;
        Diagnostics built;
        m_runner = m_application->makeRunner(*m_loaded, {}, built);
        for (const Diagnostic& d : built.all()) m_failure += d.message + "\n";
    }

    [[nodiscard]] bool ok() const { return m_runner != nullptr; }
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    [[nodiscard]] World& world() { return m_runner->world(); }
    /// False after a fault.
    bool run(int ticks = 1) {
        for (int i = 0; i < ticks; ++i)
            if (!m_runner->tick()) return false;
        return true;
    }
    [[nodiscard]] double time() { return world().time(); }
    [[nodiscard]] std::span<const double> values(const std::string& path) {
        const auto entry = world().layout().find(path);
        return entry ? world().block().slots().subspan(entry->offset, entry->count) : std::span<const double>();
    }
    [[nodiscard]] double value(const std::string& path, std::size_t element = 0) {
        const auto all = values(path);
        return element < all.size() ? all[element] : std::nan("");
    }
    [[nodiscard]] Vec3 vector(const std::string& path) { return {value(path, 0), value(path, 1), value(path, 2)}; }
    [[nodiscard]] Pose pose(const std::string& path) {
        const auto p = values(path + "/pose");
        return {Vec3(p[0], p[1], p[2]), Quat(p[3], p[4], p[5], p[6])};
    }

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Application> m_application = makeApplication();
    std::shared_ptr<const LoadedProject> m_loaded;
    std::unique_ptr<Runner> m_runner;
    std::string m_failure;
};

/// Mean and standard deviation.
struct Moments {
    double mean = 0, deviation = 0;
};
inline Moments momentsOf(std::span<const double> samples) {
    Moments m;
    for (const double s : samples) m.mean += s / static_cast<double>(samples.size());
    for (const double s : samples) m.deviation += (s - m.mean) * (s - m.mean) / static_cast<double>(samples.size() - 1);
    m.deviation = std::sqrt(m.deviation);
    return m;
}
/// Correlation of each sample with the one `lag` later.
inline double correlationOf(std::span<const double> samples, std::size_t lag) {
    const Moments m = momentsOf(samples);
    double sum = 0;
    for (std::size_t i = 0; i + lag < samples.size(); ++i) sum += (samples[i] - m.mean) * (samples[i + lag] - m.mean);
    return sum / static_cast<double>(samples.size() - lag) / (m.deviation * m.deviation);
}

} // namespace trundle::test
