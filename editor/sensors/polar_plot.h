#pragma once
#include <memory>
#include <vector>

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

private:
    std::shared_ptr<const RangeModel> m_fan;
    std::vector<double> m_distances;
};

} // namespace trundle
