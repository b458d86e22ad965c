#include "editor/shell/dialogs/new_robot_dialog.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QButtonGroup>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/module_template.h"
#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/result_label.h"
#include "editor/shell/dialogs/robot_plan.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

QString nameOf(BaseShape base) {
    switch (base) {
    case BaseShape::Differential: return NewRobotDialog::tr("&Differential");
    case BaseShape::SkidSteer: return NewRobotDialog::tr("S&kid-steer");
    case BaseShape::Omni: return NewRobotDialog::tr("Three &omni wheels");
    case BaseShape::Mecanum: return NewRobotDialog::tr("Me&canum");
    case BaseShape::Ackermann: break;
    }
    return NewRobotDialog::tr("&Ackermann");
}

QString describedAs(BaseShape base) {
    switch (base) {
    case BaseShape::Differential: return NewRobotDialog::tr("Two driven wheels and a slider. Turns on the spot.");
    case BaseShape::SkidSteer: return NewRobotDialog::tr("Four driven wheels that do not steer: in a turn they skid.");
    case BaseShape::Omni: return NewRobotDialog::tr("Three omni wheels on a circle. Moves in any direction.");
    case BaseShape::Mecanum: return NewRobotDialog::tr("Four wheels with oblique rollers. Moves in any direction.");
    case BaseShape::Ackermann: break;
    }
    return NewRobotDialog::tr("Driven at the back and steered in front, as a car.");
}

QString labelOf(double RobotDesign::*number) {
    const std::pair<double RobotDesign::*, QString> labels[] = {
        {&RobotDesign::length, NewRobotDialog::tr("&Length")},
        {&RobotDesign::width, NewRobotDialog::tr("&Width")},
        {&RobotDesign::height, NewRobotDialog::tr("&Height")},
        {&RobotDesign::wheelRadius, NewRobotDialog::tr("Wheel &radius")},
        {&RobotDesign::wheelSeparation, NewRobotDialog::tr("Wheel &separation")},
        {&RobotDesign::wheelBase, NewRobotDialog::tr("Wheel&base")},
        {&RobotDesign::mass, NewRobotDialog::tr("&Mass")},
        {&RobotDesign::topSpeed, NewRobotDialog::tr("&Top speed")},
    };
    return std::ranges::find(labels, number, &std::pair<double RobotDesign::*, QString>::first)->second;
}

QString helpOf(double RobotDesign::*number) {
    if (number == &RobotDesign::width) return NewRobotDialog::tr("Of the hull; with omni wheels, its diameter.");
    if (number == &RobotDesign::length || number == &RobotDesign::height) return NewRobotDialog::tr("Of the hull.");
    if (number == &RobotDesign::wheelSeparation)
        return NewRobotDialog::tr("From left to right; with omni wheels, the diameter of their circle.");
    if (number == &RobotDesign::wheelBase) return NewRobotDialog::tr("Between the axles.");
    if (number == &RobotDesign::mass) return NewRobotDialog::tr("Of the whole robot.");
    if (number == &RobotDesign::topSpeed) return NewRobotDialog::tr("To be reached with a reserve of 20 %.");
    return NewRobotDialog::tr("Of all wheels.");
}

/// Object names: "robotLength".
QString keyOf(double RobotDesign::*number) {
    QString key = QStringLiteral("robot ") + labelOf(number).remove(QLatin1Char('&')).toLower();
    for (qsizetype at = key.indexOf(QLatin1Char(' ')); at >= 0; at = key.indexOf(QLatin1Char(' ')))
        key.remove(at, 1), key[at] = key[at].toUpper();
    return key;
}

Property propertyOf(const DesignNumber& number) {
    Property property;
    property.name = number.name;
    property.unit = number.unit;
    property.minimum = number.least;
    property.maximum = number.most;
    return property;
}

/// Not taken in the folder: Rover, Rover2, Rover3.
QString freeRobotName(const QString& folder) {
    QString name = QStringLiteral("Rover");
    for (int n = 2; QFileInfo::exists(folder + QLatin1Char('/') + toQString(moduleNameFor(name.toStdString()))); ++n)
        name = QStringLiteral("Rover%1").arg(n);
    return name;
}

} // namespace

NewRobotDialog::NewRobotDialog(const QString& folder, QWidget* parent)
    : QDialog(parent), m_bases(new QButtonGroup(this)), m_plan(new RobotPlan), m_name(new QLineEdit(freeRobotName(folder))),
      m_folder(new QLineEdit(folder)), m_motor(new ResultLabel("robotMotor")), m_result(new ResultLabel("robotResult")) {
    setObjectName(QStringLiteral("newRobot"));
    setWindowTitle(tr("New Robot from Dimensions"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_name->setObjectName(QStringLiteral("robotName"));
    m_folder->setObjectName(QStringLiteral("robotFolder"));
    makeLayout();
    useBase(BaseShape::Differential);
    for (QLineEdit* field : {m_name, m_folder}) connect(field, &QLineEdit::textChanged, this, &NewRobotDialog::check);
    m_bases->button(0)->setFocus();
    resizeToFont(*this, {760, 470});
}

void NewRobotDialog::makeLayout() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_create = buttons->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    m_create->setObjectName(QStringLiteral("robotCreate"));
    m_create->setDefault(true);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addWidget(makeBases());
    middle->addWidget(makeNumbers());
    middle->addWidget(m_plan, 1);
    auto* all = new QVBoxLayout(this);
    all->setSpacing(8);
    all->addLayout(middle, 1);
    all->addWidget(m_motor);
    all->addWidget(makePlace());
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// One is chosen.
QWidget* NewRobotDialog::makeBases() {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (const BaseShape base : kBaseShapes) {
        auto* button = new QToolButton;
        button->setObjectName(QStringLiteral("base%1").arg(int(base)));
        button->setText(nameOf(base));
        button->setToolTip(describedAs(base));
        button->setCheckable(true);
        button->setIcon(baseIcon(base));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        button->setFocusPolicy(Qt::StrongFocus);
        showTextBesideIcon(*button, 40);
        m_bases->addButton(button, int(base));
        layout->addWidget(button);
    }
    m_bases->button(0)->setChecked(true);
    connect(m_bases, &QButtonGroup::idClicked, this, [this](int id) { useBase(static_cast<BaseShape>(id)); });
    return column;
}

QWidget* NewRobotDialog::makeNumbers() {
    auto* column = new QWidget;
    auto* form = new QFormLayout(column);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(4);
    for (std::size_t i = 0; i < designNumbers().size(); ++i) {
        const DesignNumber& number = designNumbers()[i];
        auto* field = new AmountField(propertyOf(number));
        field->setObjectName(keyOf(number.value));
        field->setToolTip(helpOf(number.value));
        field->setFixedWidth(scaledToFont(110));
        QLabel* label = field->makeLabel(labelOf(number.value));
        label->setToolTip(helpOf(number.value));
        form->addRow(label, field);
        m_fields[i] = field;
        m_labels[i] = label;
        connect(field, &AmountField::changed, this, [this, i] { change(i); });
        connect(field, &AmountField::submitted, m_create, [this] { m_create->click(); });
        connect(field, &AmountField::focused, this, [this, number] { m_plan->highlight(number.value); });
    }
    return column;
}

QWidget* NewRobotDialog::makePlace() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* browse = new QToolButton;
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tr("Choose the folder"));
    connect(browse, &QToolButton::clicked, this, &NewRobotDialog::chooseFolder);
    for (const auto& [text, field, stretch] : {std::tuple(tr("&Name"), m_name, 1), {tr("&Folder"), m_folder, 3}}) {
        auto* label = new QLabel(text);
        label->setBuddy(field);
        layout->addWidget(label);
        layout->addWidget(field, stretch);
    }
    layout->addWidget(browse);
    return row;
}

/// Its usual dimensions: those of another base rarely fit.
void NewRobotDialog::useBase(BaseShape base) {
    m_design = usualDesign(base);
    m_chosen.clear();
    m_isFilling = true;
    for (const auto& [i, field] : m_fields) {
        const auto number = designNumbers()[i].value;
        field->setValue(m_design.*number);
        const bool counts = (number != &RobotDesign::wheelBase || hasWheelBase(base)) &&
                            (number != &RobotDesign::length || base != BaseShape::Omni);
        field->setEnabled(counts);
        m_labels[i]->setEnabled(counts);
    }
    m_isFilling = false;
    check();
}

/// The places of the wheels follow the hull until they are chosen.
void NewRobotDialog::change(std::size_t number) {
    if (m_isFilling || m_fields.size() < designNumbers().size()) return;
    m_chosen.insert(number);
    if (const auto value = m_fields[number]->value()) m_design.*designNumbers()[number].value = *value;
    const auto isFree = [this](double RobotDesign::*value) {
        const auto at = std::ranges::find(designNumbers(), value, &DesignNumber::value) - designNumbers().begin();
        return !m_chosen.contains(static_cast<std::size_t>(at));
    };
    RobotDesign placed = m_design;
    placeWheels(placed, isFree(&RobotDesign::wheelSeparation), isFree(&RobotDesign::wheelBase));
    m_isFilling = true;
    for (const auto& [i, field] : m_fields)
        if (const auto value = designNumbers()[i].value; placed.*value != m_design.*value) field->setValue(placed.*value);
    m_isFilling = false;
    check();
}

void NewRobotDialog::chooseFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the Robot"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(folder);
}

std::string NewRobotDialog::folder() const { return QDir::cleanPath(m_folder->text().trimmed()).toStdString(); }

QString NewRobotDialog::numberFault() const {
    for (const auto& [i, field] : m_fields)
        if (field->isEnabled() && !field->value()) return field->fault();
    return {};
}

QString NewRobotDialog::placeFault() const {
    const std::string name = m_name->text().trimmed().toStdString();
    if (const std::string fault = robotNameFault(name); !fault.empty()) return toQString(fault);
    const QFileInfo folder(toQString(this->folder()));
    if (!folder.isDir()) return tr("There is no folder %1.").arg(folder.filePath());
    if (!folder.isWritable()) return tr("The folder %1 is not writable.").arg(folder.filePath());
    const QString made = folder.filePath() + QLatin1Char('/') + toQString(moduleNameFor(name));
    return QFileInfo::exists(made) ? tr("%1 exists already.").arg(made) : QString();
}

/// Shows the robot and what it reaches, and says what will be written, or why nothing can be.
void NewRobotDialog::check() {
    if (m_fields.size() < designNumbers().size()) return; // in the making
    for (const auto& [i, field] : m_fields)
        if (field->value()) m_design.*designNumbers()[i].value = *field->value();
    m_design.base = static_cast<BaseShape>(m_bases->checkedId());
    m_design.name = m_name->text().trimmed().toStdString();
    m_plan->show(m_design);
    QString fault = numberFault();
    QString reached;
    if (fault.isEmpty()) {
        if (const Result<MotorChoice> choice = chooseMotor(m_design); choice) {
            const auto& [motor, speed, slope] = choice.value();
            reached = tr("%1 × %2: up to %3 m/s with a reserve of 20 %, slopes of up to %4°, %5 N·m at stall.")
                          .arg(QString::number(drivenWheels(m_design.base)), toQString(std::string(motor.name)),
                               QString::number(speed, 'g', 2), QString::number(std::floor(slope * 180 / std::numbers::pi)),
                               QString::number(motor.stallTorque, 'g', 2));
        } else {
            fault = toQString(choice.error().message);
        }
    }
    m_motor->show(reached, false);
    if (fault.isEmpty()) fault = placeFault();
    m_create->setEnabled(fault.isEmpty());
    if (!fault.isEmpty()) return m_result->show(fault, true);
    const QString name = toQString(moduleNameFor(m_design.name));
    m_result->show(tr("Writes %1/%1.sim, the experiment %1_square.sim and its controller %1_square.py. The folder %1 becomes "
                      "trusted: what is in it may run, with your rights.")
                       .arg(name),
                   false);
}

void NewRobotDialog::accept() {
    Result<NewRobot> made = makeRobot(m_design, folder());
    if (!made) return m_result->show(toQString(made.error().message), true);
    m_made = std::move(made).value();
    QDialog::accept();
}

} // namespace trundle
