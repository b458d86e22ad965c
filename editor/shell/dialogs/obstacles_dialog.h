#pragma once
#include <optional>

#include <QDialog>

#include "project/wizard/obstacle_field.h"

class QCheckBox;
class QPushButton;
class QSpinBox;

namespace trundle {

class AmountField;
class PlanPreview;
class ResultLabel;

/// Asks for the dimensions and the seed of a field of obstacles and shows it. Deletes itself when it is closed.
class ObstaclesDialog final : public QDialog {
    Q_OBJECT
public:
    /// `field`: proposed, and what is free and occupied. `hasFloor`: proposed.
    ObstaclesDialog(ObstacleField field, bool hasFloor, QWidget* parent);

    /// Empty: a number is wrong, or they have no room.
    [[nodiscard]] const std::optional<std::vector<FieldObstacle>>& obstacles() const { return m_obstacles; }
    [[nodiscard]] bool hasFloor() const;

private:
    void makeLayout();
    void check();
    [[nodiscard]] QString place();

    ObstacleField m_field;
    std::optional<std::vector<FieldObstacle>> m_obstacles;
    AmountField *m_length, *m_width, *m_least, *m_most, *m_apart;
    QSpinBox *m_count, *m_seed;
    QCheckBox* m_floor;
    PlanPreview* m_preview;
    ResultLabel* m_result;
    QPushButton* m_insert = nullptr;
};

} // namespace trundle
