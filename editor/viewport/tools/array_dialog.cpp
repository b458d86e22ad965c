#include "editor/viewport/tools/array_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace trundle {
namespace {

QDoubleSpinBox* spacingBox(const QString& axis, double metres) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QStringLiteral("spacing") + axis);
    box->setRange(-1000, 1000);
    box->setDecimals(3);
    box->setSingleStep(0.1);
    box->setSuffix(ArrayDialog::tr(" m"));
    box->setValue(metres);
    return box;
}

} // namespace

ArrayDialog::ArrayDialog(const Vec3& spacing, int originals, const QString& gridRefusal, bool gridIsTurned, QWidget* parent)
    : QDialog(parent), m_originals(originals), m_gridIsTurned(gridIsTurned) {
    setObjectName(QStringLiteral("arrayDialog"));
    setWindowTitle(tr("Array Copy"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(12);
    grid->addWidget(new QLabel(tr("Count")), 0, 1);
    grid->addWidget(new QLabel(tr("Spacing")), 0, 2);
    const char* names[] = {"X", "Y", "Z"};
    for (int k = 0; k < 3; ++k) {
        const QString name = QLatin1String(names[k]);
        m_count[std::size_t(k)] = new QSpinBox;
        m_count[std::size_t(k)]->setObjectName(QStringLiteral("count") + name);
        m_count[std::size_t(k)]->setRange(1, 200);
        m_count[std::size_t(k)]->setValue(k == 0 ? 3 : 1);
        m_spacing[std::size_t(k)] = spacingBox(name, spacing[k]);
        auto* label = new QLabel(name);
        label->setBuddy(m_count[std::size_t(k)]);
        grid->addWidget(label, k + 1, 0);
        grid->addWidget(m_count[std::size_t(k)], k + 1, 1);
        grid->addWidget(m_spacing[std::size_t(k)], k + 1, 2);
        connect(m_count[std::size_t(k)], &QSpinBox::valueChanged, this, &ArrayDialog::showStatus);
    }
    m_asGrid = new QCheckBox(tr("One Grid instead of single copies"));
    m_asGrid->setObjectName(QStringLiteral("asGrid"));
    m_asGrid->setEnabled(gridRefusal.isEmpty());
    m_asGrid->setToolTip(gridRefusal.isEmpty()
                             ? tr("A few words of text, and any number of members: count and spacing can be changed later.")
                             : gridRefusal);
    connect(m_asGrid, &QCheckBox::toggled, this, &ArrayDialog::showStatus);
    m_summary = new QLabel;
    m_summary->setObjectName(QStringLiteral("summary"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Copy"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* all = new QVBoxLayout(this);
    all->setSpacing(12);
    all->addLayout(grid);
    all->addWidget(m_asGrid);
    all->addWidget(m_summary);
    all->addWidget(buttons);
    m_count[0]->setFocus();
    m_count[0]->selectAll(); // so that a number that is typed replaces it
    showStatus();
}

ArrayCopy ArrayDialog::copy() const {
    ArrayCopy copy;
    for (std::size_t k = 0; k < 3; ++k) {
        copy.count[k] = m_count[k]->value();
        copy.spacing[Eigen::Index(k)] = m_spacing[k]->value();
    }
    copy.asGrid = m_asGrid->isChecked();
    if (copy.asGrid) copy.count[2] = 1;
    return copy;
}

void ArrayDialog::showStatus() {
    m_count[2]->setEnabled(!m_asGrid->isChecked());
    m_spacing[2]->setEnabled(!m_asGrid->isChecked());
    const ArrayCopy wanted = copy();
    const int total = wanted.count[0] * wanted.count[1] * wanted.count[2] * m_originals;
    const QString grid =
        m_gridIsTurned ? tr("A Grid of %1 × %2; its rows are turned with the original") : tr("A Grid of %1 × %2");
    m_summary->setText(wanted.asGrid      ? grid.arg(wanted.count[0]).arg(wanted.count[1])
                       : m_originals == 1 ? tr("%1 in all, with the original").arg(total)
                                          : tr("%1 in all, with the %2 originals").arg(total).arg(m_originals));
}

} // namespace trundle
