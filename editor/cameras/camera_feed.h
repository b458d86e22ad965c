#pragma once
// Keeps the camera images of visible tiles up to date: with the images that the run made for its controllers and logs where there
// are any, else with images of the same cameras and poses from the render service.

#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "editor/cameras/camera_tiles.h"
#include "signals/camera_image.h"

namespace trundle {

/// The state whose images are to be shown.
struct CameraState {
    std::shared_ptr<const ExperimentSpec> experiment;
    ImageTime moment;
    RunImages images;     ///< made by the run
    bool running = false; ///< while it runs, its recent images are shown; otherwise each image is of exactly this state
};

/// Images are rendered in a worker thread, only for visible tiles, and rarely enough to leave most of the machine to the run and
/// the viewports.
class CameraFeed final : public QObject {
    Q_OBJECT
public:
    /// Without a render service nothing is shown. Both must outlive this object.
    CameraFeed(RenderService* render, CameraTiles& tiles, QObject* parent = nullptr);

    void show(CameraState state);
    [[nodiscard]] const CameraState& state() const { return m_state; }
    [[nodiscard]] const std::vector<CameraModel>& cameras() const { return m_cameras; } ///< of the experiment
    /// None: each camera's own mode.
    void setMode(std::optional<CameraMode> mode);
    /// Requests the images that visible tiles lack.
    void update();
    /// Writes an image file of the experiment; saved() follows.
    void save(std::shared_ptr<const ExperimentSpec> experiment, const CameraPicture& picture, const QString& path);

    [[nodiscard]] bool canDraw() const { return m_painter != nullptr; }
    /// All visible images are up to date. For tests.
    [[nodiscard]] bool isSettled() const;
    /// Number of images rendered so far. For tests.
    [[nodiscard]] int drawnCount() const { return m_drawn; }

Q_SIGNALS:
    void shown();                                            ///< tiles have new images
    void saved(const QString& path, const QString& failure); ///< empty on success

private:
    void invalidate();
    void take(const std::vector<CameraPicture>& pictures, double seconds);
    [[nodiscard]] std::shared_ptr<const CameraImage> runImage(const std::string& camera) const;
    [[nodiscard]] bool isOutdated(const CameraTiles::Tile& tile) const;
    [[nodiscard]] std::vector<CameraShot> outdated() const;

    CameraTiles& m_tiles;
    CameraPainter* m_painter = nullptr;
    CameraState m_state;
    std::vector<CameraModel> m_cameras;
    std::optional<CameraMode> m_mode;
    std::uint64_t m_number = 1, m_asked = 0; ///< of the current state (poses, experiment, modes); of the one requested
    int m_drawn = 0;
    QTimer m_next;
    QElapsedTimer m_sinceAsked;
    double m_pauseMs = 0; ///< minimum interval until the next request
};

} // namespace trundle
