#include "editor/viewport/view/joint_panel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/selection.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/widgets/theme.h"
#include "model/dotted_path.h"
#include "scene/queries/joint_motion.h"

namespace trundle {
namespace {

constexpr double kPerUnit = 10; // steps of a slider in a degree or a millimetre
constexpr int kPanelWidth = 250;

double shownUnits(const JointCoordinate& c) { return c.isAngle ? 180 / std::numbers::pi : 1000; } ///< in rad or m

QString coordinateTitle(const JointSpec& joint, const JointCoordinate& c) {
    const QString name = QString::fromStdString(joint.name);
    switch (joint.type) {
    case JointType::Universal: return c.part == 0 ? name : JointPanel::tr("%1, Axis2").arg(name);
    case JointType::Suspension: return c.part == 0 ? JointPanel::tr("%1, travel").arg(name) : name;
    case JointType::Ball: return JointPanel::tr("%1, about %2").arg(name, QString(QLatin1Char("xyz"[c.part])));
    default: return name;
    }
}

/// Its keys are its own: End is also the shortcut of a command.
class JointSlider final : public QSlider {
public:
    JointSlider() : QSlider(Qt::Horizontal) {}

protected:
    bool event(QEvent* event) override {
        constexpr int kKeys[] = {Qt::Key_Home, Qt::Key_End,   Qt::Key_PageUp, Qt::Key_PageDown,
                                 Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down};
        if (event->type() == QEvent::ShortcutOverride &&
            std::ranges::find(kKeys, static_cast<QKeyEvent*>(event)->key()) != std::end(kKeys))
            event->accept();
        return QSlider::event(event);
    }
};

} // namespace

JointPanel::JointPanel(const ViewContext& context, QWidget* parent)
    : QFrame(parent), m_context(context), m_robot(new QLabel), m_hint(new QLabel), m_reset(new QPushButton(tr("Reset"))),
      m_holder(new QWidget) {
    setObjectName(QStringLiteral("jointPanel"));
    setFixedWidth(scaledToFont(kPanelWidth));
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 6, 4, 6);
    auto* top = new QHBoxLayout;
    auto* title = new QLabel(tr("Joint Positions"));
    useFont(*title, [] {
        QFont bold = interfaceFont();
        bold.setWeight(QFont::DemiBold);
        return bold;
    });
    m_reset->setObjectName(QStringLiteral("jointsReset"));
    m_reset->setToolTip(tr("Back to the start; the text never changes here"));
    auto* close = new QToolButton;
    close->setObjectName(QStringLiteral("jointsClose"));
    close->setIcon(themedIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close"));
    top->addWidget(title, 1);
    top->addWidget(m_reset);
    top->addWidget(close);
    column->addLayout(top);
    m_robot->setForegroundRole(QPalette::PlaceholderText);
    m_hint->setWordWrap(true);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(m_robot);
    column->addWidget(m_hint);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* holder = new QVBoxLayout(m_holder);
    holder->setContentsMargins({});
    scroll->setWidget(m_holder);
    column->addWidget(scroll, 1);
    connect(close, &QToolButton::clicked, this, &JointPanel::closeRequested);
    connect(m_reset, &QPushButton::clicked, this, [this] { jointPositions(m_context.world).reset(); });
    connect(&m_context.world, &ViewportScene::replaced, this, &JointPanel::refresh);
    connect(&m_context.world, &ViewportScene::posed, this, &JointPanel::showValues);
    connect(&m_context.selection, &Selection::changed, this, &JointPanel::refresh);
}

void JointPanel::showEvent(QShowEvent*) { refresh(); }

/// That of the selection; otherwise the first one with joints that move.
const RobotSpec* JointPanel::robot() const {
    const ObjectIndex& objects = *m_context.world.objects();
    const auto moves = [](const RobotSpec& robot) { return robot.config && !jointCoordinates(*robot.config).empty(); };
    for (const std::string& path : m_context.selection.paths()) {
        for (const RobotSpec& robot : objects.experiment().robots)
            if (moves(robot) && startsWithPath(path, robot.name)) return &robot;
        for (const ObjectRef& object : m_context.world.objectsOf(path))
            if (const RobotSpec* robot = objects.robotOf(object); robot && moves(*robot)) return robot;
    }
    const auto first = std::ranges::find_if(objects.experiment().robots, moves);
    return first == objects.experiment().robots.end() ? nullptr : &*first;
}

std::vector<std::string> JointPanel::signature(const RobotSpec* robot) const {
    std::vector<std::string> all;
    if (!robot) return all;
    all.push_back(robot->name);
    for (const JointCoordinate& c : jointCoordinates(*robot->config))
        all.push_back(robot->config->joints[c.joint].name + " " + std::to_string(c.part) + " " + std::to_string(c.isAngle) + " " +
                      std::to_string(c.low) + " " + std::to_string(c.high));
    return all;
}

void JointPanel::refresh() {
    if (!isVisible()) return;
    const RobotSpec* robot = this->robot();
    if (std::vector<std::string> now = signature(robot); now != m_signature || !m_body) {
        m_signature = std::move(now);
        rebuild(robot);
    }
    showValues();
}

void JointPanel::rebuild(const RobotSpec* robot) {
    m_rows.clear();
    if (m_body) m_body->deleteLater();
    m_body = new QWidget(m_holder);
    auto* grid = new QGridLayout(m_body);
    grid->setContentsMargins(0, 4, 6, 4);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    m_robot->setText(robot ? QString::fromStdString(robot->name) : QString());
    m_robot->setVisible(robot != nullptr);
    const std::size_t count = robot ? jointCoordinates(*robot->config).size() : 0;
    for (std::size_t i = 0; i < count; ++i) addRow(*robot, i, *grid);
    grid->setRowStretch(int(3 * count), 1);
    auto* layout = static_cast<QVBoxLayout*>(m_holder->layout());
    layout->addWidget(m_body);
    m_body->show();
}

void JointPanel::addRow(const RobotSpec& robot, std::size_t coordinate, QGridLayout& grid) {
    const JointCoordinate c = jointCoordinates(*robot.config)[coordinate];
    const JointSpec& joint = robot.config->joints[c.joint];
    const double units = shownUnits(c);
    auto* label = new QLabel(coordinateTitle(joint, c));
    auto* slider = new JointSlider;
    auto* number = new QDoubleSpinBox;
    const QString unit = c.isAngle ? QStringLiteral("°") : tr(" mm");
    slider->setObjectName(QStringLiteral("joint.%1.%2").arg(QString::fromStdString(joint.name), QString::number(c.part)));
    number->setObjectName(slider->objectName() + QStringLiteral(".number"));
    slider->setRange(int(std::lround(kPerUnit * units * c.low)), int(std::lround(kPerUnit * units * c.high)));
    slider->setPageStep(int(kPerUnit * 10));
    slider->setSingleStep(int(kPerUnit));
    number->setDecimals(1);
    number->setRange(units * c.low, units * c.high);
    number->setSuffix(unit);
    number->setKeyboardTracking(false);
    number->setAlignment(Qt::AlignRight);
    const auto end = [&](double value, bool isStop) {
        const QString shown = QString::number(units * value, 'f', c.isAngle ? 0 : 1) + unit;
        return isStop ? shown : QStringLiteral("(%1)").arg(shown);
    };
    label->setToolTip(tr("From %1 to %2; in brackets: there is no stop").arg(end(c.low, c.hasLow), end(c.high, c.hasHigh)));
    slider->setToolTip(label->toolTip());
    slider->setAccessibleName(label->text());
    number->setAccessibleName(label->text());
    connect(slider, &QSlider::valueChanged, this, [this, coordinate](int value) { set(coordinate, value / kPerUnit); });
    connect(number, &QDoubleSpinBox::valueChanged, this, [this, coordinate](double value) { set(coordinate, value); });
    const int at = int(3 * coordinate);
    grid.addWidget(label, at, 0);
    grid.addWidget(number, at, 1);
    grid.addWidget(slider, at + 1, 0, 1, 2);
    m_rows.push_back({slider, number});
}

void JointPanel::set(std::size_t coordinate, double shown) {
    const RobotSpec* robot = this->robot();
    if (!robot) return;
    const auto all = jointCoordinates(*robot->config);
    if (coordinate < all.size()) jointPositions(m_context.world).set(*robot, coordinate, shown / shownUnits(all[coordinate]));
}

void JointPanel::showValues() {
    if (!isVisible() || !m_body) return;
    const RobotSpec* robot = this->robot();
    const bool runs = m_context.world.isRunning();
    m_hint->setText(runs ? tr("The run moves the joints; reset it to move them here.")
                         : tr("No robot here has joints that move."));
    m_hint->setVisible(runs || !robot);
    m_body->setEnabled(!runs);
    m_reset->setEnabled(!runs && !jointPositions(m_context.world).empty());
    const auto all = robot ? jointCoordinates(*robot->config) : std::vector<JointCoordinate>();
    for (std::size_t i = 0; i < std::min(all.size(), m_rows.size()); ++i) {
        const double shown = shownUnits(all[i]) * jointPositions(m_context.world).at(*robot, i);
        const QSignalBlocker quietSlider(m_rows[i].slider), quietNumber(m_rows[i].number);
        m_rows[i].slider->setValue(int(std::lround(kPerUnit * shown)));
        m_rows[i].number->setValue(shown);
    }
}

} // namespace trundle
