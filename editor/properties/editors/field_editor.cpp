#include "editor/properties/editors/field_editor.h"

#include <QHBoxLayout>
#include <QLocale>

#include "editor/properties/editors/value_field.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

bool isWords(const Property* p) {
    return p && (p->type == PropertyType::Text || p->type == PropertyType::File || p->type == PropertyType::Reference);
}

/// Whether the row is a Param whose value is a number or a formula that evaluates to one.
bool isNumber(const Row& row) {
    if (row.property()) return isNumeric(*row.property());
    const FieldValue& v = row.first();
    const ParsedValue value(v.formula ? v.shown : v.text);
    return value.status() && value.value().elements.front().kind == Element::Kind::Number;
}

bool isQuoted(const FieldValue& v) { return v.given() && v.text.starts_with('"'); }

/// The text on one line, with line breaks replaced by blanks.
QString flat(const std::string& text) { return QString::fromStdString(text).simplified(); }

QString suffixOf(const Row& row) {
    const FieldValue& v = row.first();
    if (row.mixed()) return {};
    const QString unit = row.property() ? QString::fromStdString(row.property()->unit) : QString();
    if (v.formula && !v.shown.empty()) {
        const QString shown = QStringLiteral("= ") + QString::fromStdString(v.shown);
        return unit.isEmpty() ? shown : shown + QLatin1Char(' ') + unit;
    }
    return {};
}

QString lineText(const Row& row) {
    const FieldValue& v = row.first();
    if (row.mixed()) return {};
    if (!isWords(row.property()) || row.property()->maxCount > 1 || v.formula || v.elements.size() != 1) return flat(v.text);
    const std::string plain = plainText(v.text);
    return plain.find_first_of("\r\n\t") == std::string::npos ? QString::fromStdString(plain) : flat(v.text);
}

ParsedValue typedValue(const Row& row, const QString& typed) {
    const std::string text = typed.toStdString();
    if (!isWords(row.property())) return withArithmetic(tidied(text), isNumber(row));
    if (row.property()->maxCount > 1) return listOfWords(tidied(text));
    const bool quoted = isQuoted(row.first());
    const bool asText = row.property()->type == PropertyType::Text;
    return wordOrQuoted(asText ? text : tidied(text), quoted);
}

void showLine(ValueField& field, const Row& row) {
    field.setMixed(row.mixed());
    field.setFaint(!row.given());
    field.setSuffix(suffixOf(row));
    field.setValue(lineText(row));
    field.setReadOnly(row.isLong());
    const SourceRange& place = row.first().place;
    if (row.isLong())
        field.setPlaceholderText(
            QObject::tr("%1 long; edit it in the text").arg(QLocale().formattedDataSize(place.range.end - place.range.begin)));
    else if (!row.mixed() && row.first().text.empty()) field.setPlaceholderText(QObject::tr("not set"));
}

} // namespace

FieldEditor::FieldEditor(QWidget* parent) : RowEditor(parent), m_field(new ValueField(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_field, 1);
    m_field->setObjectName(QStringLiteral("field"));
    setFocusProxy(m_field);
    connect(m_field, &ValueField::refusedChanged, this, &RowEditor::refusedChanged);
    connect(m_field, &ValueField::entered, this, [this](const QString& typed) {
        const ParsedValue value = typed.isEmpty() ? ParsedValue() : typedValue(m_row, typed);
        commit(m_field, [value](const FieldValue&) { return value; });
    });
}

QToolButton* FieldEditor::addButton(const QString& name, const QString& tip) {
    auto* button = new QToolButton(this);
    layout()->addWidget(button);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setFixedHeight(m_field->sizeHint().height());
    return button;
}

QWidget* FieldEditor::focusField() const { return m_field; }

void FieldEditor::refresh() { showLine(*m_field, m_row); }

} // namespace trundle
