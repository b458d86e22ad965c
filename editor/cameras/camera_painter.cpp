#include "editor/cameras/camera_painter.h"

#include <atomic>
#include <chrono>

#include "base/platform/atomic_file.h"

namespace trundle {

CameraPainter::CameraPainter(RenderService& render, QObject* parent) : QObject(parent), m_render(render) {
    m_pool.setMaxThreadCount(1);
    m_pool.setThreadPriority(QThread::LowPriority);
}

CameraPainter::~CameraPainter() {
    m_pool.clear();
    m_pool.waitForDone();
}

CameraImageRenderer& CameraPainter::drawerOf(const std::shared_ptr<const ExperimentSpec>& experiment) {
    if (!m_drawer || experiment != m_experiment) {
        m_drawer = std::make_unique<CameraImageRenderer>(experiment, m_render);
        m_experiment = experiment;
    }
    return *m_drawer;
}

CameraPicture CameraPainter::picture(CameraImageRenderer& drawer, const ImageTime& moment, const CameraShot& shot) {
    CameraPicture made;
    made.shot = shot;
    made.frame = shot.made;
    if (!made.frame) {
        Result<CameraImage> frame = drawer.capture(shot.camera, moment, shot.mode);
        if (!frame) {
            made.failure = QString::fromStdString(frame.error().message);
            return made;
        }
        made.frame = std::make_shared<const CameraImage>(std::move(frame).value());
    }
    made.image = QImage(made.frame->pixels.data(), int(made.frame->width), int(made.frame->height), int(made.frame->width) * 3,
                        QImage::Format_RGB888)
                     .convertToFormat(QImage::Format_RGB32);
    return made;
}

void CameraPainter::draw(std::shared_ptr<const ExperimentSpec> experiment, ImageTime moment, std::vector<CameraShot> shots) {
    m_busy = true;
    m_pool.start([this, experiment = std::move(experiment), moment = std::move(moment), shots = std::move(shots)] {
        const auto start = std::chrono::steady_clock::now();
        CameraImageRenderer& drawer = drawerOf(experiment);
        std::vector<CameraPicture> pictures;
        for (const CameraShot& shot : shots) pictures.push_back(picture(drawer, moment, shot));
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        QMetaObject::invokeMethod(
            this,
            [this, pictures = std::move(pictures), seconds] {
                m_busy = false;
                Q_EMIT drawn(pictures, seconds);
            },
            Qt::QueuedConnection);
    });
}

void CameraPainter::save(std::shared_ptr<const ExperimentSpec> experiment, const CameraPicture& picture, const QString& path) {
    m_pool.start([this, experiment = std::move(experiment), picture, path] {
        const std::string name = path.toStdString();
        const Result<std::string> bytes = drawerOf(experiment).encode(*picture.frame, picture.shot.camera, name);
        const Status written = bytes ? writeFileAtomically(name, bytes.value()) : Status(bytes.error());
        const QString failure = written ? QString() : QString::fromStdString(written.error().message);
        QMetaObject::invokeMethod(
            this, [this, path, failure] { Q_EMIT saved(path, failure); }, Qt::QueuedConnection);
    });
}

} // namespace trundle
