#include "editor/shell/dialogs/sensor_ring_dialog.h"

#include <cmath>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/plan_preview.h"
#include "editor/shell/dialogs/result_label.h"

namespace trundle {
namespace {

/// To whole millimetres.
double readable(double metres) { return std::round(metres * 1000) / 1000; }

} // namespace

SensorRingDialog::SensorRingDialog(const QString& body, const SensorRing& proposed, QWidget* parent)
    : QDialog(parent), m_count(new QSpinBox),
      m_radius(makeLengthField("ringRadius", tr("The radius"), 0.001, 100, readable(proposed.radius))),
      m_height(makeLengthField("ringHeight", tr("The height"), -100, 100, readable(proposed.height))),
      m_range(makeLengthField("ringRange", tr("The maximum range"), 0.01, 1000, readable(proposed.maxRange))),
      m_type(new QComboBox), m_body(body), m_words(new ResultLabel("ringWords")) {
    setObjectName(QStringLiteral("sensorRingDialog"));
    setWindowTitle(tr("Ring of Sensors"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_count->setObjectName(QStringLiteral("ringCount"));
    m_count->setRange(1, 360);
    m_count->setValue(proposed.count);
    m_type->setObjectName(QStringLiteral("ringType"));
    m_type->addItem(tr("Infrared"), QStringLiteral("infrared"));
    m_type->addItem(tr("Ultrasonic"), QStringLiteral("ultrasonic"));
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Sensors"), m_count);
    form->addRow(tr("&Type"), m_type);
    form->addRow(m_radius->makeLabel(tr("&Radius")), m_radius);
    form->addRow(m_height->makeLabel(tr("&Height")), m_height);
    form->addRow(m_range->makeLabel(tr("&Maximum range")), m_range);
    m_words->setMinimumWidth(300);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_insert = buttons->button(QDialogButtonBox::Ok);
    m_insert->setText(tr("Insert"));
    for (const AmountField* field : {m_radius, m_height, m_range}) {
        connect(field, &AmountField::changed, this, &SensorRingDialog::check);
        connect(field, &AmountField::submitted, m_insert, &QPushButton::click);
    }
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* all = new QVBoxLayout(this);
    all->setSpacing(12);
    all->addLayout(form);
    all->addWidget(m_words);
    all->addWidget(buttons);
    m_count->setFocus();
    m_count->selectAll(); // so that a number that is typed replaces it
    check();
}

void SensorRingDialog::check() {
    QString fault;
    for (const AmountField* field : {m_radius, m_height, m_range})
        if (fault.isEmpty() && !field->value()) fault = field->fault();
    m_insert->setEnabled(fault.isEmpty());
    const QString place = tr("Around the origin of %1, each facing outwards, the first one along its x axis.").arg(m_body);
    m_words->show(fault.isEmpty() ? place : fault, !fault.isEmpty());
}

SensorRing SensorRingDialog::ring() const {
    SensorRing ring; // read only while all lengths have values
    ring.count = m_count->value();
    ring.radius = m_radius->value().value_or(ring.radius);
    ring.height = m_height->value().value_or(ring.height);
    ring.maxRange = m_range->value().value_or(ring.maxRange);
    ring.type = m_type->currentData().toString().toStdString();
    return ring;
}

} // namespace trundle
