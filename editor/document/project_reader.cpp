#include "editor/document/project_reader.h"

#include <QTimer>

namespace trundle {

ProjectReader::ProjectReader(Application& application, QObject* parent) : QObject(parent), m_application(application) {
    m_pool.setMaxThreadCount(4); // one slow file does not block the next
}

void ProjectReader::open(const std::string& path, const OpenOptions& options, std::function<void(const Loaded& loaded)> done) {
    m_isOpening = true;
    m_pool.start([this, path, options, done = std::move(done), number = ++m_number] {
        const auto deliver = [this, done, number, loaded = m_application.open(path, options)] {
            if (number != m_number) return;
            const auto finish = [this, done, number, loaded] {
                if (number != m_number) return;
                m_isOpening = false;
                done(loaded);
            };
            if (!loaded) return finish();
            Q_EMIT aboutToOpen();
            QTimer::singleShot(1, this, finish); // not 0: a posted event would run before mouse and key events
        };
        QMetaObject::invokeMethod(this, deliver, Qt::QueuedConnection);
    });
}

void ProjectReader::cancel() {
    ++m_number;
    m_isOpening = false;
}

void ProjectReader::fillCaches(const std::string& path, OpenOptions options, std::function<void(bool isCurrent)> done) {
    m_pool.start([this, path, options = std::move(options), done = std::move(done), number = m_number] {
        (void)m_application.open(path, options);
        QMetaObject::invokeMethod(
            this, [this, done, number] { done(number == m_number); }, Qt::QueuedConnection);
    });
}

} // namespace trundle
