#pragma once
#include <memory>
#include <vector>

#include <QPixmap>
#include <QWidget>

#include "run/live/live_state.h"
#include "scene/queries/range_model.h"

namespace trundle {

/// What a sensor with beams measures, seen from above in its own frame: x upwards, y to the left, a ring at round distances.
class PolarPlot final : public QWidget {
    Q_OBJECT
public:
    explicit PolarPlot(QWidget* parent = nullptr);
    void setFan(std::shared_ptr<const RangeModel> fan);
    /// Distances in m, one for each beam; empty: no reading.
    void setDistances(std::span<const double> distances);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QPixmap drawnRings() const;
    void paintArea(QPainter& painter) const;
    [[nodiscard]] QPointF middle() const { return {0.5 * width(), 0.5 * height()}; }
    [[nodiscard]] double radius() const;

    std::shared_ptr<const RangeModel> m_fan;
    std::vector<double> m_distances;
    QPixmap m_rings; ///< disc, rings and their labels: they change with the widget's size, screen and colours only
};

} // namespace trundle
