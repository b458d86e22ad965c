#pragma once
#include <optional>

#include <QDialog>

#include "project/wizard/room_plan.h"

class QCheckBox;
class QPushButton;
class QSpinBox;

namespace trundle {

class AmountField;
class PlanPreview;
class ResultLabel;

/// Asks for the dimensions and the seed of a maze and shows it. Deletes itself when it is closed.
class MazeDialog final : public QDialog {
    Q_OBJECT
public:
    /// `hasFloor`: proposed.
    MazeDialog(bool hasFloor, QWidget* parent);

    [[nodiscard]] const std::optional<RoomPlan>& plan() const { return m_plan; } ///< empty: a number is wrong
    [[nodiscard]] bool hasFloor() const;

private:
    void makeLayout();
    void check();
    [[nodiscard]] QString makePlan();

    std::optional<RoomPlan> m_plan;
    QSpinBox *m_rows, *m_columns, *m_seed;
    AmountField *m_cell, *m_height, *m_thickness;
    QCheckBox* m_floor;
    PlanPreview* m_preview;
    ResultLabel* m_result;
    QPushButton* m_insert = nullptr;
};

} // namespace trundle
