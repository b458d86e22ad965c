#pragma once
#include <map>
#include <optional>
#include <set>

#include <QDialog>

#include "app/robot_files.h"

class QButtonGroup;
class QLabel;
class QLineEdit;
class QPushButton;

namespace trundle {

class AmountField;
class ResultLabel;
class RobotPlan;

/// Asks for the base, the dimensions, the mass and the top speed of a new robot, shows which motors it gets and what it reaches with
/// them, and writes its files. Deletes itself when it is closed.
class NewRobotDialog final : public QDialog {
    Q_OBJECT
public:
    /// `folder`: proposed for the robot's own folder to be made in.
    NewRobotDialog(const QString& folder, QWidget* parent);

    /// The robot whose files are written, once the dialog was accepted.
    [[nodiscard]] const NewRobot& made() const { return *m_made; }

public Q_SLOTS:
    void accept() override; ///< stays open and says why if the files cannot be written

private:
    void makeLayout();
    [[nodiscard]] QWidget* makeBases();
    [[nodiscard]] QWidget* makeNumbers();
    [[nodiscard]] QWidget* makePlace();
    void useBase(BaseShape base);
    void chooseFolder();
    void change(std::size_t number);
    void check();
    [[nodiscard]] QString numberFault() const;
    [[nodiscard]] QString placeFault() const;
    [[nodiscard]] std::string folder() const;

    RobotDesign m_design; ///< as typed; of a number that cannot be read, the last one
    std::optional<NewRobot> m_made;
    QButtonGroup* m_bases;
    std::map<std::size_t, AmountField*> m_fields; ///< by place in designNumbers()
    std::map<std::size_t, QLabel*> m_labels;
    std::set<std::size_t> m_chosen; ///< numbers that the person has changed; the other ones follow them
    bool m_isFilling = false;       ///< fields, not by the person
    RobotPlan* m_plan;
    QLineEdit *m_name, *m_folder;
    ResultLabel *m_motor, *m_result;
    QPushButton* m_create = nullptr;
};

} // namespace trundle
