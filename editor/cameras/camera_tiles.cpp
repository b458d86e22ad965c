#include "editor/cameras/camera_tiles.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QPainter>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kGap = 8, kLeastWidth = 110; // pixels

} // namespace

CameraTiles::CameraTiles(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("cameraWall"));
    setAccessibleName(tr("Pictures of cameras"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
}

void CameraTiles::setCameras(const std::vector<std::pair<std::string, double>>& cameras) {
    std::vector<Tile> tiles;
    for (const auto& [camera, aspect] : cameras) {
        Tile tile;
        for (Tile& before : m_tiles)
            if (before.camera == camera) tile = std::move(before);
        tile.camera = camera;
        tile.aspect = aspect;
        tiles.push_back(std::move(tile));
    }
    m_tiles = std::move(tiles);
    if (!current()) m_current = m_tiles.empty() ? std::string() : m_tiles.front().camera;
    fit();
    Q_EMIT currentChanged();
}

void CameraTiles::setPicture(const CameraPicture& picture, std::uint64_t state) {
    for (Tile& tile : m_tiles) {
        if (tile.camera != picture.shot.camera) continue;
        tile.picture = picture;
        tile.state = state;
        update(tile.place);
        if (tile.camera == m_current) Q_EMIT currentChanged();
    }
}

std::vector<const CameraTiles::Tile*> CameraTiles::visibleTiles() const {
    std::vector<const Tile*> seen;
    if (!isVisible()) return seen;
    const QRegion shown = visibleRegion();
    for (const Tile& tile : m_tiles)
        if (shown.intersects(tile.place)) seen.push_back(&tile);
    return seen;
}

const CameraTiles::Tile* CameraTiles::current() const {
    for (const Tile& tile : m_tiles)
        if (tile.camera == m_current) return &tile;
    return nullptr;
}

void CameraTiles::setCurrent(const std::string& camera) {
    if (camera == m_current) return;
    m_current = camera;
    update();
    Q_EMIT currentChanged();
}

int CameraTiles::captionHeight() const { return fontMetrics().height() + 6; }

/// The number of columns that gives the largest images while all fit; if not even small ones fit, as many columns as the width
/// allows.
CameraTiles::Plan CameraTiles::planFor(int width, int height) const {
    const int count = int(m_tiles.size());
    double aspect = 1e9; // of the tallest image
    for (const Tile& tile : m_tiles) aspect = std::min(aspect, tile.aspect);
    const auto heightOf = [&](int tileWidth) { return int(std::lround(tileWidth / aspect)) + captionHeight(); };
    Plan best;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const int room = (width - kGap * (columns + 1)) / columns;
        const int high = (height - kGap * (rows + 1)) / rows - captionHeight();
        const int tileWidth = std::min(room, int(std::max(0, high) * aspect));
        if (tileWidth > best.tileWidth) best = {columns, tileWidth, heightOf(tileWidth)};
    }
    if (best.tileWidth >= kLeastWidth) return best;
    best.columns = std::max(1, (width - kGap) / (kLeastWidth + kGap));
    best.columns = std::min(best.columns, std::max(1, count));
    best.tileWidth = std::max(40, (width - kGap * (best.columns + 1)) / best.columns);
    if (best.columns == count) best.tileWidth = std::min(best.tileWidth, kLeastWidth);
    best.tileHeight = heightOf(best.tileWidth);
    return best;
}

void CameraTiles::fit() {
    if (m_tiles.empty()) return setMinimumHeight(0);
    const QSize room = parentWidget() ? parentWidget()->size() : size();
    const Plan plan = planFor(room.width(), room.height());
    const int rows = (int(m_tiles.size()) + plan.columns - 1) / plan.columns;
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        const int column = int(i) % plan.columns, row = int(i) / plan.columns;
        m_tiles[i].place = QRect(kGap + column * (plan.tileWidth + kGap), kGap + row * (plan.tileHeight + kGap), plan.tileWidth,
                                 plan.tileHeight);
    }
    setMinimumHeight(kGap + rows * (plan.tileHeight + kGap));
    update();
    Q_EMIT uncovered();
}

QRect CameraTiles::pictureIn(const Tile& tile) const {
    const QRect room = tile.place.adjusted(0, 0, 0, -captionHeight());
    QSize size = tile.picture.image.isNull() ? QSize(int(1000 * tile.aspect), 1000) : tile.picture.image.size();
    size.scale(room.size(), Qt::KeepAspectRatio);
    return {room.topLeft() + QPoint((room.width() - size.width()) / 2, (room.height() - size.height()) / 2), size};
}

void CameraTiles::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    painter.fillRect(event->rect(), palette().window());
    for (const Tile& tile : m_tiles)
        if (tile.place.adjusted(-2, -2, 2, 2).intersects(event->rect())) paintTile(painter, tile);
}

void CameraTiles::paintTile(QPainter& painter, const Tile& tile) const {
    const QRect at = pictureIn(tile);
    if (tile.picture.image.isNull()) {
        painter.fillRect(at, palette().color(QPalette::AlternateBase));
        painter.setPen(ink(Ink::Faint));
        painter.drawText(at.adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap, tile.picture.failure);
    } else {
        // No smoothing when enlarged, so that single pixels are visible.
        painter.setRenderHint(QPainter::SmoothPixmapTransform, at.width() * devicePixelRatioF() < tile.picture.image.width());
        painter.drawImage(at, tile.picture.image);
    }
    const bool isCurrent = tile.camera == m_current && m_tiles.size() > 1;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(isCurrent ? QPen(ink(Ink::Accent), 2) : QPen(ink(Ink::Line), 1));
    painter.drawRect(isCurrent ? at.adjusted(-1, -1, 1, 1) : at.adjusted(0, 0, -1, -1));

    QRect line(at.left(), at.bottom() + 3, at.width(), captionHeight() - 3);
    QString pixelText;
    if (m_reading && at.contains(m_mouse) && tile.picture.frame) {
        const auto x = std::uint32_t((m_mouse.x() - at.x()) * int(tile.picture.frame->width) / at.width());
        const auto y = std::uint32_t((m_mouse.y() - at.y()) * int(tile.picture.frame->height) / at.height());
        pixelText = m_reading(tile, x, y);
    }
    if (!pixelText.isEmpty()) {
        painter.setPen(ink(Ink::Faint));
        pixelText =
            fontMetrics().elidedText(pixelText, Qt::ElideMiddle, line.width()); // the pixel text has priority over the name
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, pixelText);
        line.setRight(line.right() - fontMetrics().horizontalAdvance(pixelText) - 8);
    }
    if (line.width() < fontMetrics().averageCharWidth() * 4) return;
    painter.setPen(ink(Ink::Text));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(QString::fromStdString(tile.camera), Qt::ElideMiddle, line.width()));
}

const CameraTiles::Tile* CameraTiles::tileAt(const QPoint& at) const {
    for (const Tile& tile : m_tiles)
        if (tile.place.contains(at)) return &tile;
    return nullptr;
}

void CameraTiles::resizeEvent(QResizeEvent*) { fit(); }
void CameraTiles::moveEvent(QMoveEvent*) { Q_EMIT uncovered(); }
void CameraTiles::showEvent(QShowEvent*) { Q_EMIT uncovered(); }

void CameraTiles::mousePressEvent(QMouseEvent* event) {
    if (const Tile* tile = tileAt(event->position().toPoint())) setCurrent(tile->camera);
}

void CameraTiles::mouseMoveEvent(QMouseEvent* event) {
    const Tile* before = tileAt(m_mouse);
    m_mouse = event->position().toPoint();
    for (const Tile* tile : {before, tileAt(m_mouse)})
        if (tile) update(tile->place);
}

void CameraTiles::leaveEvent(QEvent*) {
    m_mouse = {-1, -1};
    update();
}

void CameraTiles::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    if (step == 0) return QWidget::keyPressEvent(event);
    for (std::size_t i = 0; i < m_tiles.size(); ++i) {
        if (m_tiles[i].camera != m_current) continue;
        const auto next = std::clamp<std::ptrdiff_t>(std::ptrdiff_t(i) + step, 0, std::ptrdiff_t(m_tiles.size()) - 1);
        return setCurrent(m_tiles[std::size_t(next)].camera);
    }
}

void CameraTiles::contextMenuEvent(QContextMenuEvent* event) {
    const Tile* tile = event->reason() == QContextMenuEvent::Mouse ? tileAt(event->pos()) : current();
    if (!tile) return;
    setCurrent(tile->camera);
    Q_EMIT menuRequested(tile->camera, event->globalPos());
}

} // namespace trundle
