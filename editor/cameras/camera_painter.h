#pragma once
// What simulated cameras see, drawn beside the window and beside the run: neither waits for it.

#include <memory>
#include <string>
#include <vector>

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include "render/frame_drawer.h"

namespace trundle {

struct CameraShot {
    std::string camera;             ///< "robot0/eye"
    std::optional<CameraMode> mode; ///< none: the camera's own
};

struct CameraPicture {
    CameraShot shot;
    std::shared_ptr<const Frame> frame; ///< null where it failed
    QImage image;
    QString failure;
};

class CameraPainter final : public QObject {
    Q_OBJECT
public:
    explicit CameraPainter(RenderService& render, QObject* parent = nullptr);
    /// Waits for the picture in work.
    ~CameraPainter() override;

    /// Draws them one after the other; drawn() follows once, with all of them. One call at a time.
    void draw(std::shared_ptr<const ExperimentSpec> experiment, FrameMoment moment, std::vector<CameraShot> shots);
    [[nodiscard]] bool isBusy() const { return m_busy; }
    /// Writes a picture file, .png or .jpg by its ending, that says where and when it was taken. saved() follows.
    void save(std::shared_ptr<const ExperimentSpec> experiment, const CameraPicture& picture, const QString& path);

Q_SIGNALS:
    void drawn(const std::vector<trundle::CameraPicture>& pictures, double seconds); ///< that it took
    void saved(const QString& path, const QString& failure);                         ///< empty: it is written

private:
    FrameDrawer& drawerOf(const std::shared_ptr<const ExperimentSpec>& experiment);
    [[nodiscard]] CameraPicture picture(FrameDrawer& drawer, const FrameMoment& moment, const CameraShot& shot);

    RenderService& m_render;
    bool m_busy = false;
    // For the pool's thread alone.
    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::unique_ptr<FrameDrawer> m_drawer;
    QThreadPool m_pool; // one after the other; the last member, so that it ends first
};

} // namespace trundle
