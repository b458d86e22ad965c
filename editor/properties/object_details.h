#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QWidget>

class QGridLayout;

namespace trundle {

class MotorCurve;
class RunSession;
class Section;
struct LoadedProject;

/// What follows from the rows of one object, below them: the curve of a motor; mass, centre, inertia and balance of a body or robot.
class ObjectDetails final : public QWidget {
    Q_OBJECT
public:
    explicit ObjectDetails(QWidget* parent);

    /// Hidden for an object of which nothing is shown, and without `path`. `session` may be null.
    void display(const std::string& path, const std::shared_ptr<const LoadedProject>& loaded, const RunSession* session);

    /// Whether it is above the rows: a curve is read while they are changed, and a motor has many.
    [[nodiscard]] bool leadsRows() const { return m_isMotor; }

private:
    using Lines = std::vector<std::pair<QString, QString>>;
    [[nodiscard]] static Lines massLines(const std::string& path, const LoadedProject& loaded, const RunSession* session);
    void showMass(const Lines& lines);

    Section *m_motor, *m_mass;
    MotorCurve* m_curve;
    bool m_isMotor = false;
    QWidget* m_lines;
    QGridLayout* m_grid;
};

} // namespace trundle
