#pragma once
#include <QIcon>
#include <QWidget>

#include "project/wizard/robot_design.h"

namespace trundle {

/// A drawing of a robot in the making: from above and from the left side, with its dimensions.
class RobotPlan final : public QWidget {
    Q_OBJECT
public:
    explicit RobotPlan(QWidget* parent = nullptr);

    void show(const RobotDesign& design);
    /// Draws the dimension of this number in the accent colour; null: of none.
    void highlight(double RobotDesign::*number);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    RobotDesign m_design;
    double RobotDesign::*m_highlighted = nullptr;
};

/// The base of usualDesign() from above.
[[nodiscard]] QIcon baseIcon(BaseShape base);

} // namespace trundle
