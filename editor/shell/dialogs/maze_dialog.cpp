#include "editor/shell/dialogs/maze_dialog.h"

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
namespace {

QSpinBox* makeCount(const char* name, int least, int most, int value) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(least, most);
    box->setValue(value);
    return box;
}

} // namespace

MazeDialog::MazeDialog(bool hasFloor, QWidget* parent)
    : QDialog(parent), m_rows(makeCount("mazeRows", 1, 100, 6)), m_columns(makeCount("mazeColumns", 1, 100, 8)),
      m_seed(makeCount("mazeSeed", 0, 1000000000, 1)),
      m_cell(makeLengthField("mazeCell", tr("The size of a cell"), 0.05, 100, 0.6)),
      m_height(makeLengthField("mazeHeight", tr("The height of the walls"), 0.01, 100, 0.3)),
      m_thickness(makeLengthField("mazeThickness", tr("The thickness of the walls"), 0.002, 10, 0.05)),
      m_floor(new QCheckBox(tr("With a &floor"))), m_preview(new PlanPreview("mazePreview")),
      m_result(new ResultLabel("mazeResult")) {
    setObjectName(QStringLiteral("mazeDialog"));
    setWindowTitle(tr("Maze"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_floor->setObjectName(QStringLiteral("mazeFloor"));
    m_floor->setChecked(hasFloor);
    makeLayout();
    for (AmountField* field : {m_cell, m_height, m_thickness}) {
        connect(field, &AmountField::changed, this, &MazeDialog::check);
        connect(field, &AmountField::submitted, m_insert, [this] { m_insert->click(); });
    }
    for (QSpinBox* box : {m_rows, m_columns, m_seed}) connect(box, &QSpinBox::valueChanged, this, &MazeDialog::check);
    m_rows->setFocus();
    m_rows->selectAll(); // so that a number that is typed replaces it
    check();
}

bool MazeDialog::hasFloor() const { return m_floor->isChecked(); }

void MazeDialog::makeLayout() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Rows"), m_rows);
    form->addRow(tr("&Columns"), m_columns);
    form->addRow(m_cell->makeLabel(tr("C&ell size")), m_cell);
    form->addRow(m_height->makeLabel(tr("Wall &height")), m_height);
    form->addRow(m_thickness->makeLabel(tr("Wall &thickness")), m_thickness);
    form->addRow(tr("&Seed"), m_seed);
    form->addRow(QString(), m_floor);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addLayout(form, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_insert = buttons->addButton(tr("Insert"), QDialogButtonBox::AcceptRole);
    m_insert->setObjectName(QStringLiteral("mazeInsert"));
    m_insert->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->addLayout(middle, 1);
    all->addWidget(m_result);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

/// Why there is no plan.
QString MazeDialog::makePlan() {
    m_plan.reset();
    for (const AmountField* field : {m_cell, m_height, m_thickness})
        if (!field->value()) return field->fault();
    MazeOptions options;
    options.rows = m_rows->value(), options.columns = m_columns->value();
    options.cell = *m_cell->value(), options.height = *m_height->value(), options.thickness = *m_thickness->value();
    options.seed = static_cast<std::uint64_t>(m_seed->value());
    Result<RoomPlan> plan = mazePlan(options);
    if (!plan) return toQString(plan.error().message);
    m_plan = std::move(plan).value();
    return {};
}

void MazeDialog::check() {
    const QString fault = makePlan();
    m_insert->setEnabled(m_plan.has_value());
    if (!m_plan) return m_result->show(fault, true);
    m_preview->showWalls(*m_plan);
    m_result->show(tr("%1 walls around the origin, %2 m × %3 m. One way, and only one, leads from each cell to each other.")
                       .arg(QString::number(m_plan->walls.size()), QString::number(m_plan->length, 'g', 6),
                            QString::number(m_plan->width, 'g', 6)),
                   false);
}

} // namespace trundle
