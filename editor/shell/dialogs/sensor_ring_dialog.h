#pragma once
#include <QDialog>

#include "project/edits/plan_sensor_ring.h"

class QComboBox;
class QPushButton;
class QSpinBox;

namespace trundle {

class AmountField;
class ResultLabel;

/// Asks for the number, place and type of distance sensors around a body. Deletes itself when it is closed.
class SensorRingDialog final : public QDialog {
    Q_OBJECT
public:
    SensorRingDialog(const QString& body, const SensorRing& proposed, QWidget* parent);

    [[nodiscard]] SensorRing ring() const;

private:
    void check();

    QSpinBox* m_count;
    AmountField *m_radius, *m_height, *m_range;
    QComboBox* m_type;
    QString m_body;
    ResultLabel* m_words;
    QPushButton* m_insert;
};

} // namespace trundle
