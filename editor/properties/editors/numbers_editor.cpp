#include "editor/properties/editors/numbers_editor.h"

#include <QGridLayout>

#include "editor/properties/editors/scrub.h"
#include "editor/properties/editors/scrub_label.h"
#include "editor/properties/editors/value_field.h"
#include "editor/widgets/theme.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

/// Labels for the numbers of a property.
QStringList axesOf(const Property& p) {
    const auto words = [](const char* text) { return QString::fromLatin1(text).split(QLatin1Char(' ')); };
    if (isColour(p)) return words("r g b");
    if (p.name == "HPR") return words("h p r");
    if (p.name == "Inertia") return words("xx yy zz xy xz yz");
    if (p.name == "Area") return words("x0 y0 x1 y1");
    if (p.maxCount == 3 || p.name == "Count" || p.name == "Spacing") return words("x y z");
    return words("1 2 3 4 5 6");
}

/// The other numbers of a list when its first one is typed.
std::string restOf(const Property& p, const std::string& typed) {
    const bool zero = p.minExclusive ? p.minimum < 0 : p.minimum <= 0;
    return zero && p.maximum >= 0 && p.name != "Inertia" ? "0" : typed;
}

/// An inertia with one of its three products, xy, xz or yz, where the text has none yet: the others are zero.
std::string withProduct(const FieldValue& inertia, std::size_t i, const std::string& typed) {
    std::string text = inertia.text;
    for (std::size_t k = 3; k < 6; ++k) text += inertia.separator + (k == i ? typed : "0");
    return text;
}

} // namespace

NumbersEditor::NumbersEditor(QWidget* parent) : RowEditor(parent), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(3);
    m_grid->setVerticalSpacing(3);
    connect(this, &RowEditor::scrubEnded, this, [this] { m_start.clear(); });
}

QWidget* NumbersEditor::focusField() const { return m_fields.empty() ? nullptr : m_fields.front(); }

bool NumbersEditor::canScrub() const {
    return m_fields.size() == 1 && Scrub::of(m_row.first().element(0), m_row.property()).has_value();
}

void NumbersEditor::addFields(std::size_t count) {
    const QStringList axes = axesOf(*m_row.property());
    while (m_fields.size() < count) {
        const std::size_t i = m_fields.size();
        auto* field = new ValueField(this);
        field->setObjectName(count == 1 ? QStringLiteral("field") : QStringLiteral("field%1").arg(i));
        field->setCompact(count > 1);
        m_fields.push_back(field);
        connect(field, &ValueField::entered, this, [this, i](const QString& typed) { enter(i, typed); });
        connect(field, &ValueField::refusedChanged, this, &RowEditor::refusedChanged);
        connect(field, &ValueField::stepped, this, [this, i](int steps) {
            scrubField(i, steps);
            Q_EMIT scrubEnded();
        });
        if (count == 1) continue;
        auto* label = new ScrubLabel(this);
        label->setText(axes.value(static_cast<int>(i)));
        label->setObjectName(QStringLiteral("axis%1").arg(i));
        label->setBuddy(field);
        label->setForegroundRole(QPalette::PlaceholderText); // a palette of its own would not follow the theme
        m_labels.push_back(label);
        connect(label, &ScrubLabel::dragged, this, [this, i](double steps) { scrubField(i, steps); });
        connect(label, &ScrubLabel::ended, this, &RowEditor::scrubEnded);
        connect(label, &ScrubLabel::clicked, field, [field] { field->setFocus(Qt::MouseFocusReason), field->selectAll(); });
        connect(label, &ScrubLabel::cancelled, this, [this] {
            Q_EMIT scrubCancelled();
            Q_EMIT scrubEnded();
        });
    }
    setFocusProxy(m_fields.front());
}

void NumbersEditor::arrange() {
    const bool formula = std::any_of(m_row.values.begin(), m_row.values.end(), [](const FieldValue& v) { return v.formula; });
    std::size_t columns = formula || m_fields.size() == 1 ? 1 : m_fields.size() == 2 || m_fields.size() == 4 ? 2 : 3;
    // Once the numbers do not fit they stay stacked until another object is shown, since the number of digits varies during a
    // drag.
    if (columns > 1 && m_start.empty() && m_stacked != m_row.first().path && !fit(columns)) m_stacked = m_row.first().path;
    if (m_stacked == m_row.first().path) columns = 1;
    if (columns == m_columns) return;
    m_columns = columns;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const int line = static_cast<int>(i / columns), column = static_cast<int>(i % columns) * 2;
        if (!m_labels.empty()) m_grid->addWidget(m_labels[i], line, column);
        m_grid->addWidget(m_fields[i], line, column + 1);
    }
    for (int c = 0; c < 6; ++c) m_grid->setColumnStretch(c, c % 2 && c / 2 < static_cast<int>(columns) ? 1 : 0);
}

bool NumbersEditor::fit(std::size_t columns) const {
    if (!m_sized) return true; // widths are not known before the first layout
    int labels = 0, widest = 0;
    for (const ScrubLabel* label : m_labels) labels = std::max(labels, label->sizeHint().width());
    for (const ValueField* field : m_fields) widest = std::max({widest, field->wholeWidth(), field->minimumSizeHint().width()});
    const int count = static_cast<int>(columns), gaps = (2 * count - 1) * m_grid->horizontalSpacing();
    return count * (labels + widest) + gaps <= width() - m_grid->contentsMargins().left();
}

/// Below each other, which is what becomes of the numbers in a narrow panel: side by side they would hold it wide.
QSize NumbersEditor::minimumSizeHint() const {
    int labels = 0, fields = 0;
    for (const ScrubLabel* label : m_labels) labels = std::max(labels, label->sizeHint().width() + m_grid->horizontalSpacing());
    for (const ValueField* field : m_fields) fields = std::max(fields, field->minimumSizeHint().width());
    return {m_grid->contentsMargins().left() + labels + fields, RowEditor::minimumSizeHint().height()};
}

void NumbersEditor::refresh() {
    if (m_fields.empty()) addFields(m_row.fieldCount());
    if (m_stacked != m_row.first().path) m_stacked.clear();
    for (std::size_t i = 0; i < m_fields.size(); ++i) showField(i);
    arrange();
}

void NumbersEditor::resizeEvent(QResizeEvent* event) {
    RowEditor::resizeEvent(event);
    if (m_fields.empty() || (m_sized && event->oldSize().width() == width())) return;
    m_sized = true;
    m_stacked.clear();
    arrange();
}

void NumbersEditor::showField(std::size_t i) {
    ValueField& field = *m_fields[i];
    const FieldValue& v = m_row.first();
    const bool mixed = m_row.mixedElement(i), one = m_fields.size() == 1;
    const QString text = mixed ? QString() : QString::fromStdString(v.element(i));
    const QString unit = QString::fromStdString(m_row.property()->unit);
    const bool plain = !text.isEmpty() && (text.back().isDigit() || text.back() == QLatin1Char('.'));
    QString suffix = one && (plain || text.isEmpty()) ? unit : QString();
    if (!mixed && text.startsWith(QLatin1Char('$')) && i < v.parts.size())
        suffix =
            QStringLiteral("= ") + QString::fromStdString(v.parts[i]) + (unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    field.setMixed(mixed);
    field.setFaint(!m_row.given());
    field.setSuffix(suffix);
    field.setValue(text);
    if (!mixed && text.isEmpty()) field.setPlaceholderText(one ? tr("not set") : QStringLiteral("–"));
    if (m_labels.empty()) return;
    m_labels[i]->setScrubbing(Scrub::of(v.element(i), m_row.property()).has_value());
}

void NumbersEditor::enter(std::size_t i, const QString& typed) {
    const ParsedValue value = withArithmetic(tidied(typed.toStdString()), true);
    const std::string& text = value.text();
    ValueField* field = m_fields[i];
    if (text.empty()) {
        const bool last = i + 1 >= m_row.first().elements.size();
        if (i > 0 && (i < m_row.property()->minCount || !last)) return field->setError(tr("A number is missing"));
        if (i == 0 && m_fields.size() > 1 && m_row.first().elements.size() > 1) return field->setError(tr("A number is missing"));
        commit(field, [i](const FieldValue& v) { return v.before(i); });
        return;
    }
    if (!value.status()) return field->setError(QString::fromStdString(value.status().error().message));
    const std::size_t count = value.value().elements.size();
    if (count != 1 && m_fields.size() > 1)
        return field->setError(tr("%1 numbers here, one belongs into each field; a decimal point is written as .").arg(count));
    const bool one = m_fields.size() == 1;
    const Property& p = *m_row.property();
    const std::string others = restOf(p, text);
    const std::size_t least = p.minCount;
    const bool product = p.name == "Inertia" && i >= 3;
    commit(field, [i, value, one, others, least, product](const FieldValue& v) -> ParsedValue {
        if (one) return value;
        const std::string& text = value.text();
        if (product && v.elements.size() == 3) return withProduct(v, i, text);
        if (!v.elements.empty()) return v.with(i, text);
        std::vector<std::string> all(std::max(least, i + 1), others);
        all[i] = text;
        return joined(all, v.separator);
    });
}

void NumbersEditor::scrubField(std::size_t i, double steps) {
    if (m_start.empty() && !Scrub::of(m_row.first().element(i), m_row.property())) return;
    if (m_start.empty())
        for (const FieldValue& v : m_row.values) m_start.emplace(v.path, v);
    const auto start = m_start;
    const Property property = *m_row.property();
    commit(
        m_fields[i],
        [start, steps, i, property](const FieldValue& v) {
            const auto it = start.find(v.path);
            if (it == start.end()) return v.text;
            const auto scrub = Scrub::of(it->second.element(i), &property);
            return scrub ? it->second.with(i, scrub->after(steps)) : v.text;
        },
        "scrub " + m_row.first().path);
}

} // namespace trundle
