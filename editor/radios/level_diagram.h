#pragma once
#include <optional>

#include <QWidget>

#include "radio/radio_nodes.h"

namespace trundle {

/// Shows how each term of a link budget changes the power from sender to receiver, above the reference levels.
class LevelDiagram final : public QWidget {
public:
    explicit LevelDiagram(QWidget* parent = nullptr);
    struct Levels {
        LinkReport report;
        double sensitivity = 0, noiseFloor = 0; ///< dBm
    };
    void setLevels(const std::optional<Levels>& levels);
    [[nodiscard]] QSize sizeHint() const override { return {360, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 90}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    struct Scale;
    void drawReferences(QPainter& painter, const Scale& scale) const;
    void drawStairs(QPainter& painter, const Scale& scale) const;

    std::optional<Levels> m_levels;
};

} // namespace trundle
