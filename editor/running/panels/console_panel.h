#pragma once
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace trundle {

class ConsoleModel;
class RunSession;

/// Messages of controllers, devices and the run itself. Scrolls to the newest line unless the user has scrolled up.
class ConsolePanel final : public QWidget {
    Q_OBJECT
public:
    explicit ConsolePanel(RunSession& session, QWidget* parent = nullptr);

    [[nodiscard]] ConsoleModel& model() { return *m_model; }
    void copySelected();
    void clear();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeTools();
    void makeView();
    void showRobots();
    void applyFilter();
    void showCounts();
    void follow();

    ConsoleModel* m_model;
    QTableView* m_view = nullptr;
    QComboBox* m_robot = nullptr;
    QLineEdit* m_search = nullptr;
    QLabel* m_counts = nullptr;
    bool m_follows = true;
};

} // namespace trundle
