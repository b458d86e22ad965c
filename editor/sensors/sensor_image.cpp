#include "editor/sensors/sensor_image.h"

#include <algorithm>

#include "editor/cameras/camera_feed.h"
#include "editor/cameras/camera_tiles.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kImageHeight = 190;

} // namespace

SensorImage::SensorImage(RenderService* render, std::string camera, QWidget* parent)
    : QWidget(parent), m_camera(std::move(camera)), m_tiles(new CameraTiles(this)),
      m_feed(new CameraFeed(render, *m_tiles, this)) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QSize SensorImage::sizeHint() const { return {200, scaledToFont(kImageHeight)}; }

void SensorImage::display(const RunResults& run, bool running) {
    const bool another = run.experiment != m_feed->state().experiment;
    m_feed->show({run.experiment, {run.poses, run.snapshot->tick, run.snapshot->time}, run.snapshot->images, running});
    if (!another) return;
    const auto& cameras = m_feed->cameras();
    const auto model = std::ranges::find(cameras, m_camera, &CameraModel::path);
    if (model == cameras.end()) return;
    m_tiles->setCameras({{m_camera, double(model->width) / std::max(1u, model->height)}});
    m_feed->update();
}

bool SensorImage::isSettled() const { return m_feed->isSettled(); }

void SensorImage::resizeEvent(QResizeEvent*) {
    m_tiles->setGeometry(rect());
    m_tiles->fit();
}

} // namespace trundle
