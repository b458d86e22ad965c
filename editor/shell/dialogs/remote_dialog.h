#pragma once
#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QSpinBox;
class QToolButton;

namespace trundle {

class RemoteAccess;

/// Switches the access of other programs to the run on and off, and shows how they connect. Stays open beside the window.
class RemoteDialog final : public QDialog {
    Q_OBJECT
public:
    RemoteDialog(RemoteAccess& access, const QString& pythonFolder, QWidget* parent = nullptr);

private:
    void copy();
    void setOn(bool on);
    void refresh();

    RemoteAccess& m_access;
    QString m_pythonFolder; ///< of the package trundle
    QCheckBox* m_on;
    QSpinBox* m_port;
    QLineEdit* m_code;
    QToolButton* m_copy;
    QLabel* m_state;
};

} // namespace trundle
