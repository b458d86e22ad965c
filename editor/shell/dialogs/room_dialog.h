#pragma once
#include <optional>

#include <QDialog>

#include "project/wizard/room_plan.h"

class QCheckBox;
class QComboBox;
class QPushButton;

namespace trundle {

class AmountField;
class PlanPreview;
class ResultLabel;

/// Asks for the dimensions of a room and shows it. Deletes itself when it is closed.
class RoomDialog final : public QDialog {
    Q_OBJECT
public:
    /// `hasFloor`: proposed.
    RoomDialog(bool hasFloor, QWidget* parent);

    [[nodiscard]] const std::optional<RoomPlan>& plan() const { return m_plan; } ///< empty: a number is wrong
    [[nodiscard]] bool hasFloor() const;

private:
    void makeLayout();
    void check();
    [[nodiscard]] QString makePlan();

    std::optional<RoomPlan> m_plan;
    AmountField *m_length, *m_width, *m_height, *m_thickness, *m_doorWidth;
    QComboBox* m_side;
    QCheckBox* m_floor;
    PlanPreview* m_preview;
    ResultLabel* m_result;
    QPushButton* m_insert = nullptr;
};

} // namespace trundle
