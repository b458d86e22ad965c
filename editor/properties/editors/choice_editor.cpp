#include "editor/properties/editors/choice_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include "editor/properties/editors/wheel_filter.h"
#include "editor/widgets/theme.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

/// Creates its list view on first opening: most are never opened, and Qt caches the style of each view.
class Choices final : public QComboBox {
public:
    using QComboBox::QComboBox;
    void showPopup() override {
        // The combo box's own delegate would draw the list in the box's faint colour.
        if (!std::exchange(m_hasList, true)) setItemDelegate(new QStyledItemDelegate(this));
        QComboBox::showPopup();
    }

private:
    bool m_hasList = false;
};

} // namespace

ChoiceEditor::ChoiceEditor(QWidget* parent) : RowEditor(parent), m_box(new Choices(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_box);
    m_box->setObjectName(QStringLiteral("field"));
    m_box->setMinimumWidth(60);
    setFocusProxy(m_box);
    ignoreWheel(*m_box);
    connect(m_box, &QComboBox::activated, this, [this](int index) {
        const std::string word = m_box->itemText(index).toStdString();
        commit([word](const FieldValue& v) {
            const bool quoted = v.given() && v.text.starts_with('"');
            return quoted ? wordOrQuoted(word, true) : ParsedValue(word);
        });
    });
}

QWidget* ChoiceEditor::focusField() const { return m_box; }

void ChoiceEditor::refresh() {
    const QSignalBlocker quiet(m_box);
    QStringList words;
    for (const std::string& word : m_row.choices()) words << QString::fromStdString(word);
    QStringList there;
    for (int i = 0; i < m_box->count(); ++i) there << m_box->itemText(i);
    if (there != words) {
        m_box->clear();
        m_box->addItems(words);
    }
    const QString word = QString::fromStdString(plainText(m_row.first().text));
    m_box->setPlaceholderText(m_row.mixed() ? tr("mixed") : word.isEmpty() ? tr("not set") : word);
    m_box->setCurrentIndex(m_row.mixed() ? -1 : m_box->findText(word));
    const QString sheet = QStringLiteral("QComboBox { color: %1; }").arg(ink(m_row.given() ? Ink::Text : Ink::Faint).name());
    if (m_box->styleSheet() != sheet) m_box->setStyleSheet(sheet);
}

FlagEditor::FlagEditor(QWidget* parent) : RowEditor(parent), m_box(new QCheckBox(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 2, 0, 2);
    layout->addWidget(m_box);
    layout->addStretch(1);
    m_box->setObjectName(QStringLiteral("field"));
    setFocusProxy(m_box);
    connect(m_box, &QCheckBox::clicked, this, [this] {
        const bool on = m_row.mixed() || m_row.first().text != "true";
        const char* word = on ? "true" : "false";
        commit([word](const FieldValue&) { return std::string(word); });
    });
}

QWidget* FlagEditor::focusField() const { return m_box; }

void FlagEditor::refresh() {
    const bool open = m_row.mixed() || m_row.first().text.empty();
    m_box->setTristate(open);
    m_box->setCheckState(open ? Qt::PartiallyChecked : m_row.first().text == "true" ? Qt::Checked : Qt::Unchecked);
    m_box->setText(m_row.mixed()                ? tr("mixed")
                   : m_row.first().text.empty() ? tr("not set")
                                                : QString::fromStdString(m_row.first().text));
    const QString sheet = QStringLiteral("QCheckBox { color: %1; }").arg(ink(m_row.given() ? Ink::Text : Ink::Faint).name());
    if (m_box->styleSheet() != sheet) m_box->setStyleSheet(sheet);
}

} // namespace trundle
