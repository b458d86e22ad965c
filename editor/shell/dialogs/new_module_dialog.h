#pragma once
#include <functional>
#include <string>

#include <QDialog>

#include "app/module_template.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;

namespace trundle {

class ResultLabel;

/// Asks for the name, the language and the folder of a new controller or component. Deletes itself when it is closed.
class NewModuleDialog final : public QDialog {
    Q_OBJECT
public:
    struct Options {
        bool isController = true;
        QString project;    ///< the folder that must contain the module's
        /// Of a controller, what it can be used for: "robot0, in place of Wander", "3 robots"; empty: nothing is selected.
        QString user;
        /// Why a kind cannot have a name; empty if it can.
        std::function<QString(ModuleTemplate what, const std::string& kind)> fault;
    };
    NewModuleDialog(Options options, QWidget* parent);

    [[nodiscard]] ModuleTemplate what() const;
    [[nodiscard]] std::string kind() const;
    [[nodiscard]] std::string folder() const; ///< in which the module's own folder is made
    [[nodiscard]] bool isUsed() const;        ///< it is to be used at once

private:
    void makeLayout();
    void choose();
    void check();
    [[nodiscard]] QString fault() const;

    Options m_options;
    QLineEdit *m_name, *m_folder;
    QRadioButton *m_cpp, *m_python;
    QCheckBox* m_use;
    ResultLabel* m_result;
    QPushButton* m_create = nullptr;
};

} // namespace trundle
