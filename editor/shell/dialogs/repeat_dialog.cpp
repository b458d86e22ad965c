#include "editor/shell/dialogs/repeat_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace trundle {

RepeatDialog::RepeatDialog(const Vec3& step, QWidget* parent) : QDialog(parent), m_count(new QSpinBox) {
    setObjectName(QStringLiteral("repeatDialog"));
    setWindowTitle(tr("Repeat"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_count->setObjectName(QStringLiteral("repeatCount"));
    m_count->setRange(1, 1000);
    m_count->setValue(4);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Members"), m_count);
    for (std::size_t k = 0; k < 3; ++k) {
        const QString axis = QStringList{QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")}.at(int(k));
        auto* box = m_step[k] = new QDoubleSpinBox;
        box->setObjectName(QStringLiteral("repeatStep") + axis);
        box->setRange(-1000, 1000);
        box->setDecimals(3);
        box->setSingleStep(0.01);
        box->setSuffix(tr(" m"));
        box->setValue(step[Eigen::Index(k)]);
        form->addRow(tr("Step along &%1").arg(axis), box);
    }
    auto* words = new QLabel(tr("One block is written, with a count. Its members follow every change of it."));
    words->setWordWrap(true);
    words->setMinimumWidth(300);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Repeat"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* all = new QVBoxLayout(this);
    all->setSpacing(12);
    all->addLayout(form);
    all->addWidget(words);
    all->addWidget(buttons);
}

int RepeatDialog::count() const { return m_count->value(); }

Vec3 RepeatDialog::step() const { return {m_step[0]->value(), m_step[1]->value(), m_step[2]->value()}; }

} // namespace trundle
