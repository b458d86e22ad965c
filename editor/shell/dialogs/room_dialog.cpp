#include "editor/shell/dialogs/room_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/plan_preview.h"
#include "editor/shell/dialogs/result_label.h"
#include "editor/widgets/strings.h"

namespace trundle {

RoomDialog::RoomDialog(bool hasFloor, QWidget* parent)
    : QDialog(parent), m_length(makeLengthField("roomLength", tr("The length"), 0.2, 1000, 4)),
      m_width(makeLengthField("roomWidth", tr("The width"), 0.2, 1000, 3)),
      m_height(makeLengthField("roomHeight", tr("The height of the walls"), 0.01, 100, 0.5)),
      m_thickness(makeLengthField("roomThickness", tr("The thickness of the walls"), 0.005, 10, 0.1)),
      m_doorWidth(makeLengthField("roomDoorWidth", tr("The width of the door"), 0.05, 1000, 0.8)), m_side(new QComboBox),
      m_floor(new QCheckBox(tr("With a &floor"))), m_preview(new PlanPreview("roomPreview")),
      m_result(new ResultLabel("roomResult")) {
    setObjectName(QStringLiteral("roomDialog"));
    setWindowTitle(tr("Room"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_side->setObjectName(QStringLiteral("roomDoor"));
    m_side->addItems({tr("None"), tr("North"), tr("East"), tr("South"), tr("West")});
    m_floor->setObjectName(QStringLiteral("roomFloor"));
    m_floor->setChecked(hasFloor);
    makeLayout();
    for (AmountField* field : {m_length, m_width, m_height, m_thickness, m_doorWidth}) {
        connect(field, &AmountField::changed, this, &RoomDialog::check);
        connect(field, &AmountField::submitted, m_insert, [this] { m_insert->click(); });
    }
    connect(m_side, &QComboBox::currentIndexChanged, this, &RoomDialog::check);
    m_length->setFocus();
    m_length->selectAll(); // so that a number that is typed replaces it
    check();
}

bool RoomDialog::hasFloor() const { return m_floor->isChecked(); }

void RoomDialog::makeLayout() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(m_length->makeLabel(tr("&Length, along x")), m_length);
    form->addRow(m_width->makeLabel(tr("&Width, along y")), m_width);
    form->addRow(m_height->makeLabel(tr("Wall &height")), m_height);
    form->addRow(m_thickness->makeLabel(tr("Wall &thickness")), m_thickness);
    form->addRow(tr("&Door in the"), m_side);
    form->addRow(m_doorWidth->makeLabel(tr("D&oor width")), m_doorWidth);
    form->addRow(QString(), m_floor);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(form, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_insert = buttons->addButton(tr("Insert"), QDialogButtonBox::AcceptRole);
    m_insert->setObjectName(QStringLiteral("roomInsert"));
    m_insert->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->addLayout(middle, 1);
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// Why there is no plan.
QString RoomDialog::makePlan() {
    m_plan.reset();
    RoomOptions options;
    options.doorSide = static_cast<RoomSide>(m_side->currentIndex());
    m_doorWidth->setEnabled(options.doorSide != RoomSide::None);
    for (const AmountField* field : {m_length, m_width, m_height, m_thickness, m_doorWidth})
        if (!field->value() && field->isEnabled()) return field->fault();
    options.length = *m_length->value(), options.width = *m_width->value();
    options.height = *m_height->value(), options.thickness = *m_thickness->value();
    options.doorWidth = m_doorWidth->value().value_or(options.doorWidth);
    Result<RoomPlan> plan = roomPlan(options);
    if (!plan) return toQString(plan.error().message);
    m_plan = std::move(plan).value();
    return {};
}

void RoomDialog::check() {
    const QString fault = makePlan();
    m_insert->setEnabled(m_plan.has_value());
    if (!m_plan) return m_result->show(fault, true);
    m_preview->showWalls(*m_plan);
    m_result->show(tr("%1 walls around the origin, %2 m × %3 m outside. North is up, along y.")
                       .arg(QString::number(m_plan->walls.size()), QString::number(m_plan->length, 'g', 6),
                            QString::number(m_plan->width, 'g', 6)),
                   false);
}

} // namespace trundle
