#pragma once
// The torque and the current of a motor against the speed of its joint, drawn beside its rows.

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QWidget>

class QPainter;

namespace trundle {

struct LoadedProject;

/// At the joint, SI units; current is empty where the kind has none.
struct MotorCharacteristic {
    struct Sample {
        double speed = 0, effort = 0, current = 0;
    };
    /// At a part of the voltage.
    struct Part {
        double voltage = 0; ///< V
        std::vector<Sample> samples;
    };
    std::vector<Sample> samples; ///< from rest to the speed without load
    std::vector<Part> parts;     ///< at a quarter, a half and three quarters of the voltage, where it turns at all
    bool isLinear = false;       ///< m/s and N instead of rad/s and N m
    bool hasCurrent = false;
    double voltage = 0; ///< V, that it is for; 0: the kind has none
};

/// Of a RotaryMotor at MaxVoltage and at parts of it, with its friction, gear and current limit: i = (V - G w / kv) / R within the limit, joint effort =
/// efficiency * (G kt i - G M_dry - G^2 d w). Of a Servo and a LinearMotor the line from the largest effort to MaxSpeed. Nothing for other objects, and
/// without the values that it needs.
[[nodiscard]] std::optional<MotorCharacteristic> motorCharacteristic(const LoadedProject& loaded, const std::string& path);

class MotorCurve final : public QWidget {
    Q_OBJECT
public:
    explicit MotorCurve(QWidget* parent);
    void display(const MotorCharacteristic& motor);
    [[nodiscard]] QSize sizeHint() const override;
    /// What it shows in words: "Stall 0.42 Nm, 6 A; no load 20 rad/s".
    [[nodiscard]] QString summary() const;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    void paintFigures(QPainter& painter) const;

    MotorCharacteristic m_motor;
};

} // namespace trundle
