#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <QObject>
#include <QThreadPool>

#include "app/application.h"

namespace trundle {

/// Reads projects in worker threads. All functions are called in the thread of this object, and results arrive there.
class ProjectReader final : public QObject {
    Q_OBJECT
public:
    using Loaded = Result<std::shared_ptr<const LoadedProject>>;

    explicit ProjectReader(Application& application, QObject* parent = nullptr);

    /// Reads a file and calls `done`, unless open() or cancel() was called meanwhile.
    void open(const std::string& path, const OpenOptions& options, std::function<void(const Loaded& loaded)> done);
    void cancel();
    [[nodiscard]] bool isOpening() const { return m_isOpening; } ///< until `done` is called
    /// Reads a file for its side effect, which is to fill the mesh cache. `isCurrent`: open() and cancel() were not called meanwhile.
    void fillCaches(const std::string& path, OpenOptions options, std::function<void(bool isCurrent)> done);

Q_SIGNALS:
    void aboutToOpen(); ///< the file is read; `done` is called in a separate event, so that neither handler delays the other

private:
    Application& m_application;
    std::uint64_t m_number = 0; ///< of the newest request
    bool m_isOpening = false;
    QThreadPool m_pool; ///< the last member: destroyed first, it waits for its threads
};

} // namespace trundle
