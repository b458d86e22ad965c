#pragma once
// Pictures side by side, as large as there is room for.

#include <functional>
#include <string>
#include <vector>

#include <QWidget>

#include "editor/cameras/camera_painter.h"

namespace trundle {

class CameraWall final : public QWidget {
    Q_OBJECT
public:
    explicit CameraWall(QWidget* parent = nullptr);

    struct Tile {
        std::string camera;
        double aspect = 4.0 / 3; ///< width over height
        CameraPicture picture;
        std::uint64_t state = 0; ///< what it shows, as the caller counts; 0: nothing yet
        QRect place;
    };
    /// Tiles of cameras that stay keep their pictures.
    void setCameras(const std::vector<std::pair<std::string, double>>& cameras);
    void setPicture(const CameraPicture& picture, std::uint64_t state);
    [[nodiscard]] const std::vector<Tile>& tiles() const { return m_tiles; }
    /// Those of which something is to be seen; none while the wall is hidden.
    [[nodiscard]] std::vector<const Tile*> visibleTiles() const;
    /// The one that is meant by keys and buttons; null where there is none.
    [[nodiscard]] const Tile* current() const;
    void setCurrent(const std::string& camera);
    /// What a pixel of a measured picture tells: "1.24 m", "yard/ball"; asked with the tile and the pixel under the mouse.
    using Reading = std::function<QString(const Tile& tile, std::uint32_t x, std::uint32_t y)>;
    void setReading(Reading reading) { m_reading = std::move(reading); }

    /// Lays the tiles out anew for the room that the parent has.
    void fit();

Q_SIGNALS:
    void currentChanged();
    void menuWanted(const std::string& camera, const QPoint& globally);
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
    Reading m_reading;
    QPoint m_mouse{-1, -1};
};

} // namespace trundle
