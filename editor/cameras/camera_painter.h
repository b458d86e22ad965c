#pragma once
// Renders the images of simulated cameras in a worker thread, blocking neither the GUI nor the run.

#include <memory>
#include <string>
#include <vector>

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include "render/camera_image_renderer.h"

namespace trundle {

struct CameraShot {
    std::string camera;                      ///< "robot0/eye"
    std::optional<CameraMode> mode;          ///< none: the camera's own mode
    std::shared_ptr<const CameraImage> made; ///< the image that the run made; null: it has to be rendered
};

struct CameraPicture {
    CameraShot shot;
    std::shared_ptr<const CameraImage> frame; ///< null on failure
    QImage image;
    QString failure;
};

class CameraPainter final : public QObject {
    Q_OBJECT
public:
    explicit CameraPainter(RenderService& render, QObject* parent = nullptr);
    /// Waits for the image being rendered.
    ~CameraPainter() override;

    /// Renders the images that the run has not made, one after the other; drawn() is emitted once, with all. One call at a time.
    void draw(std::shared_ptr<const ExperimentSpec> experiment, ImageTime moment, std::vector<CameraShot> shots);
    [[nodiscard]] bool isBusy() const { return m_busy; }
    /// Writes an image file, .png or .jpg by its extension, with the camera and time of the image in it. saved() follows.
    void save(std::shared_ptr<const ExperimentSpec> experiment, const CameraPicture& picture, const QString& path);

Q_SIGNALS:
    void drawn(const std::vector<trundle::CameraPicture>& pictures, double seconds); ///< wall-clock s that it took
    void saved(const QString& path, const QString& failure);                         ///< empty on success

private:
    CameraImageRenderer& drawerOf(const std::shared_ptr<const ExperimentSpec>& experiment);
    [[nodiscard]] CameraPicture picture(CameraImageRenderer& drawer, const ImageTime& moment, const CameraShot& shot);

    RenderService& m_render;
    bool m_busy = false;
    // Used by the worker thread only.
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::unique_ptr<CameraImageRenderer> m_drawer;
    QThreadPool m_pool; // one thread; the last member: destroyed first, it waits for its thread
};

} // namespace trundle
