#include "editor/properties/editors/amount_field.h"

#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>

#include "editor/properties/editors/scrub.h"
#include "editor/properties/editors/scrub_label.h"
#include "editor/properties/editors/value_field.h"
#include "editor/widgets/strings.h"
#include "project/objects/typed_number.h"
#include "project/objects/value_text.h"

namespace trundle {
AmountField::AmountField(Property property, QWidget* parent)
    : QWidget(parent), m_property(std::move(property)), m_field(new ValueField(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_field);
    setFocusProxy(m_field);
    m_field->setObjectName(QStringLiteral("field"));
    m_field->installEventFilter(this);
    connect(m_field, &ValueField::textChanged, this, &AmountField::read);
    connect(m_field, &ValueField::entered, this, [this](const QString& typed) {
        if (m_value) m_field->setValue(typed);
        else m_field->setError(m_fault);
    });
    connect(m_field, &ValueField::stepped, this, [this](int steps) { step(m_field->text(), steps); });
}

void AmountField::setValue(double si) { m_field->setValue(toQString(numberOf(m_property, si))); }

void AmountField::selectAll() { m_field->selectAll(); }

QLabel* AmountField::makeLabel(const QString& text) {
    auto* label = new ScrubLabel;
    label->setText(text);
    label->setBuddy(m_field);
    label->setScrubbing(true);
    m_field->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    connect(label, &ScrubLabel::dragged, this, [this](double steps) {
        if (m_before.isEmpty()) m_before = m_field->text();
        step(m_before, steps);
    });
    connect(label, &ScrubLabel::ended, this, [this] { m_before.clear(); });
    connect(label, &ScrubLabel::cancelled, this, [this] { m_field->setValue(std::exchange(m_before, {})); });
    connect(label, &ScrubLabel::clicked, this, [this] { m_field->setFocus(Qt::MouseFocusReason), m_field->selectAll(); });
    return label;
}

void AmountField::step(const QString& from, double steps) {
    if (const auto scrub = Scrub::of(from.toStdString(), &m_property)) {
        m_field->setModified(false); // so that the new value replaces what was typed
        m_field->setValue(toQString(scrub->after(steps)));
    }
}

void AmountField::read() {
    const std::string text = tidied(m_field->text().toStdString());
    const Result<double> read = typedNumber(text, m_property);
    m_value = read ? std::optional(read.value()) : std::nullopt;
    m_fault = read ? QString() : toQString(read.error().message) + QLatin1Char('.');
    const bool isPlain = !text.empty() && (std::isdigit(static_cast<unsigned char>(text.back())) != 0 || text.back() == '.');
    m_field->setSuffix(isPlain ? toQString(m_property.unit) : QString());
    Q_EMIT changed();
}

bool AmountField::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) Q_EMIT focused();
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            Q_EMIT submitted();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace trundle
