#pragma once
#include <QDialog>

#include "editor/viewport/arrange.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace trundle {

/// Asks how many copies and how far apart.
class ArrayDialog final : public QDialog {
    Q_OBJECT
public:
    /// `originals`: how many objects are copied. `gridRefusal`: why a Grid cannot be made; empty: it is offered.
    /// `gridIsTurned`: its rows go along the axes of the robot, which are not those of the world.
    ArrayDialog(const Vec3& spacing, int originals, const QString& gridRefusal, bool gridIsTurned = false,
                QWidget* parent = nullptr);

    [[nodiscard]] ArrayCopy copy() const;

private:
    void say();

    const int m_originals;
    const bool m_gridIsTurned;
    std::array<QSpinBox*, 3> m_count{};
    std::array<QDoubleSpinBox*, 3> m_spacing{};
    QCheckBox* m_asGrid = nullptr;
    QLabel* m_summary = nullptr;
};

} // namespace trundle
