#pragma once
// A grid of camera images, as large as the available area allows.

#include <functional>
#include <string>
#include <vector>

#include <QWidget>

#include "editor/cameras/camera_painter.h"

namespace trundle {

class CameraTiles final : public QWidget {
    Q_OBJECT
public:
    explicit CameraTiles(QWidget* parent = nullptr);

    struct Tile {
        std::string camera;
        double aspect = 4.0 / 3; ///< width over height
        CameraPicture picture;
        std::uint64_t state = 0; ///< the caller's number of the state shown; 0: nothing yet
        QRect place;
    };
    /// Cameras that were shown before keep their images.
    void setCameras(const std::vector<std::pair<std::string, double>>& cameras);
    void setPicture(const CameraPicture& picture, std::uint64_t state);
    [[nodiscard]] const std::vector<Tile>& tiles() const { return m_tiles; }
    /// Tiles that are at least partly visible; none while the widget is hidden.
    [[nodiscard]] std::vector<const Tile*> visibleTiles() const;
    /// The tile that keys and buttons apply to; null if there is none.
    [[nodiscard]] const Tile* current() const;
    void setCurrent(const std::string& camera);
    /// Returns the text for a pixel of a measuring camera's image: "1.24 m", "yard/ball"; called for the pixel under the mouse.
    using PixelText = std::function<QString(const Tile& tile, std::uint32_t x, std::uint32_t y)>;
    void setPixelText(PixelText pixelText) { m_reading = std::move(pixelText); }

    /// Lays out the tiles for the parent's size.
    void fit();

Q_SIGNALS:
    void currentChanged();
    void menuRequested(const std::string& camera, const QPoint& globally);
    void uncovered(); ///< other tiles may be visible now

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void moveEvent(QMoveEvent*) override;
    void showEvent(QShowEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;

private:
    struct Plan {
        int columns = 1, tileWidth = 0, tileHeight = 0;
    };
    [[nodiscard]] Plan planFor(int width, int height) const;
    void paintTile(QPainter& painter, const Tile& tile) const;
    [[nodiscard]] QRect pictureIn(const Tile& tile) const;
    [[nodiscard]] int captionHeight() const;
    [[nodiscard]] const Tile* tileAt(const QPoint& at) const;

    std::vector<Tile> m_tiles;
    std::string m_current;
    PixelText m_reading;
    QPoint m_mouse{-1, -1};
};

} // namespace trundle
