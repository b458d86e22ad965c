#include "editor/shell/dialogs/repeat_dialog.h"

#include <cmath>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "editor/properties/editors/amount_field.h"
#include "editor/shell/dialogs/plan_preview.h"
#include "editor/shell/dialogs/result_label.h"

namespace trundle {

RepeatDialog::RepeatDialog(const Vec3& step, QWidget* parent)
    : QDialog(parent), m_count(new QSpinBox), m_words(new ResultLabel("repeatWords")) {
    setObjectName(QStringLiteral("repeatDialog"));
    setWindowTitle(tr("Repeat"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_count->setObjectName(QStringLiteral("repeatCount"));
    m_count->setRange(1, 1000);
    m_count->setValue(4);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Members"), m_count);
    const char* const names[] = {"repeatStepX", "repeatStepY", "repeatStepZ"};
    for (std::size_t k = 0; k < 3; ++k) {
        const QString axis = QStringLiteral("XYZ").mid(int(k), 1);
        const double metres = std::round(step[Eigen::Index(k)] * 1000) / 1000;
        m_step[k] = makeLengthField(names[k], tr("The step along %1").arg(axis), -1000, 1000, metres);
        form->addRow(m_step[k]->makeLabel(tr("Step along &%1").arg(axis)), m_step[k]);
        connect(m_step[k], &AmountField::changed, this, &RepeatDialog::check);
    }
    m_words->setMinimumWidth(300);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_repeat = buttons->button(QDialogButtonBox::Ok);
    m_repeat->setText(tr("Repeat"));
    for (const AmountField* field : m_step) connect(field, &AmountField::submitted, m_repeat, &QPushButton::click);
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

int RepeatDialog::count() const { return m_count->value(); }

Vec3 RepeatDialog::step() const {
    return {m_step[0]->value().value_or(0), m_step[1]->value().value_or(0), m_step[2]->value().value_or(0)};
}

void RepeatDialog::check() {
    QString fault;
    for (const AmountField* field : m_step)
        if (fault.isEmpty() && !field->value()) fault = field->fault();
    m_repeat->setEnabled(fault.isEmpty());
    if (fault.isEmpty()) m_words->show(tr("One block is written, with a count. Its members follow every change of it."), false);
    else m_words->show(fault, true);
}

} // namespace trundle
