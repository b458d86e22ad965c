#pragma once
#include <optional>

#include <QWidget>

namespace trundle {

/// A heading as a needle on a dial, seen from above: x of the world (0°) to the right, counter-clockwise.
class HeadingDial final : public QWidget {
    Q_OBJECT
public:
    explicit HeadingDial(QWidget* parent = nullptr);
    /// Radians; the true heading is a second needle.
    void setHeading(std::optional<double> heading, std::optional<double> trueHeading);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    std::optional<double> m_heading, m_trueHeading;
};

} // namespace trundle
