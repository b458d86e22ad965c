#pragma once
#include <QDialog>

#include "editor/viewport/tools/arrange.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace trundle {

/// Dialog for the number and spacing of copies.
class ArrayDialog final : public QDialog {
    Q_OBJECT
public:
    /// `originals`: number of objects to copy. `gridRefusal`: the reason why a Grid cannot be made; empty: the dialog offers it.
    /// `gridIsTurned`: its rows follow the axes of the robot instead of the world's.
    ArrayDialog(const Vec3& spacing, int originals, const QString& gridRefusal, bool gridIsTurned = false,
                QWidget* parent = nullptr);

    [[nodiscard]] ArrayCopy copy() const;

private:
    void showStatus();

    const int m_originals;
    const bool m_gridIsTurned;
    std::array<QSpinBox*, 3> m_count{};
    std::array<QDoubleSpinBox*, 3> m_spacing{};
    QCheckBox* m_asGrid = nullptr;
    QLabel* m_summary = nullptr;
};

} // namespace trundle
