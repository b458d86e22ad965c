#pragma once
#include <QWidget>

#include "editor/running/active_run.h"

namespace trundle {

class CameraFeed;
class CameraTiles;
class RenderService;

/// The image of one camera of a run.
class SensorImage final : public QWidget {
    Q_OBJECT
public:
    /// `camera`: "robot0/eye". `render` is null without OpenGL.
    SensorImage(RenderService* render, std::string camera, QWidget* parent = nullptr);
    void display(const RunResults& run, bool running);
    [[nodiscard]] bool isSettled() const;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    std::string m_camera;
    CameraTiles* m_tiles;
    CameraFeed* m_feed;
};

} // namespace trundle
