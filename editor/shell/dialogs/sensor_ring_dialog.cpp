#include "editor/shell/dialogs/sensor_ring_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace trundle {
namespace {

QDoubleSpinBox* metresBox(const char* name, double least, double most, double value) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(least, most);
    box->setDecimals(3);
    box->setSingleStep(0.01);
    box->setSuffix(SensorRingDialog::tr(" m"));
    box->setValue(value);
    return box;
}

} // namespace

SensorRingDialog::SensorRingDialog(const QString& body, const SensorRing& proposed, QWidget* parent)
    : QDialog(parent), m_count(new QSpinBox), m_radius(metresBox("ringRadius", 0.001, 100, proposed.radius)),
      m_height(metresBox("ringHeight", -100, 100, proposed.height)),
      m_range(metresBox("ringRange", 0.01, 1000, proposed.maxRange)), m_type(new QComboBox) {
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
    form->addRow(tr("&Radius"), m_radius);
    form->addRow(tr("&Height"), m_height);
    form->addRow(tr("&Maximum range"), m_range);
    auto* words = new QLabel(tr("Around the origin of %1, each facing outwards, the first one along its x axis.").arg(body));
    words->setWordWrap(true);
    words->setMinimumWidth(300);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Insert"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* all = new QVBoxLayout(this);
    all->setSpacing(12);
    all->addLayout(form);
    all->addWidget(words);
    all->addWidget(buttons);
}

SensorRing SensorRingDialog::ring() const {
    return {m_count->value(), m_radius->value(), m_height->value(), m_range->value(),
            m_type->currentData().toString().toStdString()};
}

} // namespace trundle
