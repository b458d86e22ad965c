#include "editor/cameras/camera_feed.h"

#include <algorithm>
#include <cmath>

namespace trundle {
namespace {

constexpr double kLeastPauseMs = 66; // about 15 updates a second
constexpr double kShare = 1.0 / 3;   // largest share of one processor's time for these images

} // namespace

CameraFeed::CameraFeed(RenderService* render, CameraTiles& tiles, QObject* parent) : QObject(parent), m_tiles(tiles) {
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &CameraFeed::update);
    connect(&m_tiles, &CameraTiles::uncovered, this, &CameraFeed::update);
    if (!render) return;
    m_painter = new CameraPainter(*render, this);
    connect(m_painter, &CameraPainter::drawn, this, &CameraFeed::take);
    connect(m_painter, &CameraPainter::saved, this, &CameraFeed::saved);
}

void CameraFeed::show(CameraState state) {
    const bool another = state.experiment != m_state.experiment;
    const bool moved = state.moment.poses != m_state.moment.poses || state.moment.tick != m_state.moment.tick;
    if (another) m_cameras = state.experiment ? camerasOf(*state.experiment) : std::vector<CameraModel>();
    m_state = std::move(state);
    if (another || moved) invalidate();
    else update();
}

void CameraFeed::setMode(std::optional<CameraMode> mode) {
    m_mode = mode;
    invalidate();
}

void CameraFeed::invalidate() {
    ++m_number;
    update();
}

/// The run's image of this state; while it runs, the newest one until the next is overdue.
std::shared_ptr<const CameraImage> CameraFeed::runImage(const std::string& camera) const {
    const auto made = m_state.images.find(camera);
    if (made == m_state.images.end()) return nullptr;
    const std::uint64_t now = m_state.moment.tick;
    if (m_state.running ? !made->second.isRecentAt(now) : made->second.image->tick != now) return nullptr;
    const auto isCamera = [&](const CameraModel& model) { return model.path == camera; };
    const auto model = std::ranges::find_if(m_cameras, isCamera);
    const bool sameMode = !m_mode || (model != m_cameras.end() && model->mode == *m_mode);
    return sameMode ? made->second.image : nullptr;
}

bool CameraFeed::isOutdated(const CameraTiles::Tile& tile) const {
    const bool stopped = !m_state.running && tile.picture.frame && tile.picture.frame->tick != m_state.moment.tick;
    return tile.state != m_number || stopped;
}

std::vector<CameraShot> CameraFeed::outdated() const {
    std::vector<CameraShot> shots;
    if (!m_painter || !m_state.moment.poses) return shots;
    for (const CameraTiles::Tile* tile : m_tiles.visibleTiles())
        if (isOutdated(*tile)) shots.push_back({tile->camera, m_mode, runImage(tile->camera)});
    return shots;
}

/// Requests one batch at a time, always of the newest state, with a pause proportional to the duration of the last batch.
void CameraFeed::update() {
    if (!m_painter || m_painter->isBusy() || m_next.isActive()) return;
    std::vector<CameraShot> shots = outdated();
    if (shots.empty()) return;
    const double since = m_sinceAsked.isValid() ? double(m_sinceAsked.elapsed()) : 1e9;
    if (since < m_pauseMs) return m_next.start(int(std::ceil(m_pauseMs - since)));
    m_sinceAsked.start();
    m_asked = m_number;
    m_painter->draw(m_state.experiment, m_state.moment, std::move(shots));
}

void CameraFeed::take(const std::vector<CameraPicture>& pictures, double seconds) {
    m_pauseMs = std::max(kLeastPauseMs, 1000 * seconds / kShare);
    for (const CameraPicture& picture : pictures) {
        if (!picture.shot.made) ++m_drawn;
        m_tiles.setPicture(picture, m_asked);
    }
    update();
    Q_EMIT shown();
}

void CameraFeed::save(std::shared_ptr<const ExperimentSpec> experiment, const CameraPicture& picture, const QString& path) {
    if (m_painter) m_painter->save(std::move(experiment), picture, path);
}

bool CameraFeed::isSettled() const { return !m_painter || (!m_painter->isBusy() && outdated().empty()); }

} // namespace trundle
