#pragma once
#include <optional>

#include <QWidget>

namespace trundle {

/// The charge of a battery as a share of its capacity.
class BatteryGauge final : public QWidget {
    Q_OBJECT
public:
    explicit BatteryGauge(QWidget* parent = nullptr);
    /// From 0 to 1.
    void setLevel(std::optional<double> level);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    std::optional<double> m_level;
};

} // namespace trundle
