#pragma once
#include <array>

#include <QDialog>

#include <trundle/geometry.h>

class QPushButton;
class QSpinBox;

namespace trundle {

class AmountField;
class ResultLabel;

/// Asks how many members a Repeat has, and how far each is from the one before. Deletes itself when it is closed.
class RepeatDialog final : public QDialog {
    Q_OBJECT
public:
    /// `step`: the proposed one, m.
    RepeatDialog(const Vec3& step, QWidget* parent);

    [[nodiscard]] int count() const;
    [[nodiscard]] Vec3 step() const; ///< m, in the frame of the config

private:
    void check();

    QSpinBox* m_count;
    std::array<AmountField*, 3> m_step{};
    ResultLabel* m_words;
    QPushButton* m_repeat;
};

} // namespace trundle
