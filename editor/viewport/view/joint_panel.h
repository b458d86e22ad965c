#pragma once
// Sliders beside the views that move the joints of one robot before a run. The text does not change.

#include <string>
#include <vector>

#include <QFrame>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace trundle {

struct RobotSpec;
struct ViewContext;

class JointPanel final : public QFrame {
    Q_OBJECT
public:
    /// `context` must outlive this widget.
    explicit JointPanel(const ViewContext& context, QWidget* parent = nullptr);

Q_SIGNALS:
    void closeRequested();

protected:
    void showEvent(QShowEvent*) override;

private:
    /// A coordinate of a joint: its name, slider and number.
    struct JointRow {
        QSlider* slider = nullptr;
        QDoubleSpinBox* number = nullptr;
    };
    [[nodiscard]] const RobotSpec* robot() const;
    [[nodiscard]] std::vector<std::string> signature(const RobotSpec* robot) const;
    void refresh();
    void rebuild(const RobotSpec* robot);
    void addRow(const RobotSpec& robot, std::size_t coordinate, QGridLayout& grid);
    void set(std::size_t coordinate, double shown);
    void showValues();

    const ViewContext& m_context;
    QLabel *m_robot, *m_hint;
    QPushButton* m_reset;
    QWidget* m_holder;         ///< of m_body
    QWidget* m_body = nullptr; ///< parent of the rows
    std::vector<JointRow> m_rows;
    std::vector<std::string> m_signature; ///< what the rows are for
};

} // namespace trundle
