#include "editor/shell/dialogs/obstacles_dialog.h"

#include <utility>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/plan_preview.h"
#include "editor/shell/dialogs/result_label.h"
#include "editor/widgets/strings.h"

namespace trundle {

ObstaclesDialog::ObstaclesDialog(ObstacleField field, bool hasFloor, QWidget* parent)
    : QDialog(parent), m_field(std::move(field)),
      m_length(makeLengthField("fieldLength", tr("The length"), 1, 1000, m_field.length)),
      m_width(makeLengthField("fieldWidth", tr("The width"), 1, 1000, m_field.width)),
      m_least(makeLengthField("fieldLeast", tr("The smallest size"), 0.02, 100, m_field.least)),
      m_most(makeLengthField("fieldMost", tr("The largest size"), 0.02, 100, m_field.most)),
      m_apart(makeLengthField("fieldApart", tr("The least distance"), 0, 100, m_field.apart)), m_count(new QSpinBox),
      m_seed(new QSpinBox), m_floor(new QCheckBox(tr("With a &floor"))), m_preview(new PlanPreview("fieldPreview")),
      m_result(new ResultLabel("fieldResult")) {
    setObjectName(QStringLiteral("obstaclesDialog"));
    setWindowTitle(tr("Obstacle Field"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_count->setObjectName(QStringLiteral("fieldCount"));
    m_count->setRange(1, 2000);
    m_count->setValue(m_field.count);
    m_seed->setObjectName(QStringLiteral("fieldSeed"));
    m_seed->setRange(0, 1000000000);
    m_seed->setValue(static_cast<int>(m_field.seed));
    m_floor->setObjectName(QStringLiteral("fieldFloor"));
    m_floor->setChecked(hasFloor);
    makeLayout();
    for (AmountField* each : {m_length, m_width, m_least, m_most, m_apart}) {
        connect(each, &AmountField::changed, this, &ObstaclesDialog::check);
        connect(each, &AmountField::submitted, m_insert, [this] { m_insert->click(); });
    }
    for (QSpinBox* box : {m_count, m_seed}) connect(box, &QSpinBox::valueChanged, this, &ObstaclesDialog::check);
    m_count->setFocus();
    m_count->selectAll(); // so that a number that is typed replaces it
    check();
}

bool ObstaclesDialog::hasFloor() const { return m_floor->isChecked(); }

void ObstaclesDialog::makeLayout() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Number"), m_count);
    form->addRow(m_length->makeLabel(tr("&Length, along x")), m_length);
    form->addRow(m_width->makeLabel(tr("&Width, along y")), m_width);
    form->addRow(m_least->makeLabel(tr("S&mallest")), m_least);
    form->addRow(m_most->makeLabel(tr("Lar&gest")), m_most);
    form->addRow(m_apart->makeLabel(tr("&Apart, at least")), m_apart);
    form->addRow(tr("&Seed"), m_seed);
    form->addRow(QString(), m_floor);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(form, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_insert = buttons->addButton(tr("Insert"), QDialogButtonBox::AcceptRole);
    m_insert->setObjectName(QStringLiteral("fieldInsert"));
    m_insert->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->addLayout(middle, 1);
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// Why there are no obstacles.
QString ObstaclesDialog::place() {
    m_obstacles.reset();
    for (const AmountField* each : {m_length, m_width, m_least, m_most, m_apart})
        if (!each->value()) return each->fault();
    m_field.length = *m_length->value(), m_field.width = *m_width->value();
    m_field.least = *m_least->value(), m_field.most = *m_most->value(), m_field.apart = *m_apart->value();
    m_field.count = m_count->value();
    m_field.seed = static_cast<std::uint64_t>(m_seed->value());
    if (m_field.least > m_field.most) return tr("The smallest size is above the largest one.");
    Result<std::vector<FieldObstacle>> placed = obstacleField(m_field);
    if (!placed) return toQString(placed.error().message);
    m_obstacles = std::move(placed).value();
    return {};
}

void ObstaclesDialog::check() {
    const QString fault = place();
    m_insert->setEnabled(m_obstacles.has_value());
    if (!m_obstacles) return m_result->show(fault, true);
    m_preview->showObstacles(m_field, *m_obstacles);
    m_result->show(
        tr("Boxes and cylinders around the origin. The same seed gives the same field; what is there already stays free."),
        false);
}

} // namespace trundle
