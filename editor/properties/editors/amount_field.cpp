#include "editor/properties/editors/amount_field.h"

#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>

#include "editor/properties/editors/scrub.h"
#include "editor/properties/editors/scrub_label.h"
#include "editor/properties/editors/value_field.h"
#include "editor/widgets/strings.h"
#include "model/params.h"
#include "project/objects/value_text.h"
#include "schema/value_reader.h"

namespace trundle {
namespace {

/// The number that a text is, or the first problem in `diagnostics`.
std::optional<double> numberIn(const std::string& text, const Property& property, Diagnostics& diagnostics) {
    TextSet texts;
    texts.trees = {parse(std::make_shared<const SourceText>("value", "v = " + text + "\n"), 0)};
    const Tree& tree = *texts.trees[0];
    const auto* assignment = tree.items().size() == 1 ? tree.items()[0].as<AssignmentItem>() : nullptr;
    if (!tree.diagnostics().empty() || !assignment || assignment->value.elements.size() != 1) return std::nullopt;
    ParamScope scope;
    const auto given = Evaluator(texts, diagnostics).evaluate(assignment->value, 0, scope);
    const auto value = given ? readValue(property, *given, diagnostics) : std::nullopt;
    return value ? std::optional(value->numbers.front()) : std::nullopt;
}

} // namespace

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
    const std::string text = withArithmetic(tidied(m_field->text().toStdString()), true).text();
    Diagnostics diagnostics;
    m_value = numberIn(text, m_property, diagnostics);
    m_fault.clear();
    if (!m_value)
        m_fault = diagnostics.all().empty()
                      ? tr("%1 is a number in %2.").arg(toQString(m_property.name), toQString(m_property.unit))
                      : toQString(diagnostics.all().front().message) + QLatin1Char('.');
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
