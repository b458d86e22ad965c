#include "editor/properties/editors/reference_editor.h"

#include <QCompleter>
#include <QEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QStringListModel>
#include <QToolButton>

#include "editor/properties/editors/value_field.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

constexpr int kMaxListed = 200; ///< in the menu; completion finds more

/// The names in a value, without quotes.
QStringList origin(const FieldValue& v) {
    QStringList names;
    for (std::size_t i = 0; i < v.elements.size(); ++i) names << QString::fromStdString(plainText(v.element(i)));
    return names;
}

} // namespace

ReferenceEditor::ReferenceEditor(QWidget* parent)
    : FieldEditor(parent), m_button(addButton(QStringLiteral("pick"), tr("Choose from matching names"))), m_menu(new QMenu(this)),
      m_names(new QStringListModel(this)) {
    m_button->setFixedWidth(22);
    m_button->setFocusPolicy(Qt::NoFocus); // Alt+Down in the field opens the same list
    m_button->setMenu(m_menu);
    m_button->setPopupMode(QToolButton::InstantPopup);
    auto* completer = new QCompleter(m_names, this);
    completer->setFilterMode(Qt::MatchContains);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    m_field->setCompleter(completer);
    m_field->installEventFilter(this);
    connect(completer, qOverload<const QString&>(&QCompleter::activated), this, [this](const QString& name) {
        if (m_row.fieldCount() == 1) pick(name);
    });
    connect(m_menu, &QMenu::aboutToShow, this, &ReferenceEditor::fillMenu);
}

QStringList ReferenceEditor::names() const {
    QStringList names;
    if (!m_row.candidates) return names;
    for (const std::string& name : m_row.candidates()) names << QString::fromStdString(name);
    return names;
}

void ReferenceEditor::refresh() {
    FieldEditor::refresh();
    if (m_field->hasFocus()) m_names->setStringList(names());
}

bool ReferenceEditor::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field && event->type() == QEvent::FocusIn) m_names->setStringList(names());
    if (watched == m_field && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Down && key->modifiers() == Qt::AltModifier) {
            m_button->showMenu();
            return true;
        }
    }
    return RowEditor::eventFilter(watched, event);
}

bool ReferenceEditor::isOfPairs() const { return m_row.fieldCount() > 2 && m_row.property()->minCount == 2; }

QStringList ReferenceEditor::typedNames() const {
    QStringList names = m_field->text().split(QLatin1Char(','));
    for (QString& name : names) name = name.trimmed();
    names.removeAll(QString());
    return names;
}

void ReferenceEditor::fillMenu() {
    m_menu->clear();
    if (isOfPairs())
        if (const QStringList typed = typedNames(); typed.size() % 2 == 1)
            m_menu->addAction(tr("%1 and").arg(typed.last()))->setEnabled(false);
    const QStringList fitting = names(), here = m_row.mixed() ? QStringList() : origin(m_row.first());
    for (const QString& name : fitting.mid(0, kMaxListed)) {
        QAction* action = m_menu->addAction(name);
        action->setCheckable(!isOfPairs());
        action->setChecked(!isOfPairs() && here.contains(name));
        connect(action, &QAction::triggered, this, [this, name] { pick(name); });
    }
    if (fitting.size() > kMaxListed)
        m_menu->addAction(tr("%1 more: type to filter").arg(fitting.size() - kMaxListed))->setEnabled(false);
    if (fitting.isEmpty()) m_menu->addAction(tr("No matching names"))->setEnabled(false);
}

/// After the first name of a pair the list opens again for the second one.
void ReferenceEditor::pickForPair(const QString& name) {
    const QStringList all = typedNames() << name;
    const bool isWhole = all.size() % 2 == 0;
    m_field->setFocus();
    m_field->setText(all.join(QStringLiteral(", ")) + (isWhole ? QString() : QStringLiteral(", ")));
    m_field->setModified(true);
    if (isWhole) return m_field->enter();
    const QPoint below = m_button->mapToGlobal(QPoint(0, m_button->height()));
    QMetaObject::invokeMethod(
        m_menu, [this, below] { m_menu->popup(below); }, Qt::QueuedConnection);
}

void ReferenceEditor::pick(const QString& name) {
    if (isOfPairs()) return pickForPair(name);
    const bool list = m_row.fieldCount() > 1;
    const std::string word = name.toStdString();
    m_field->setModified(false);
    commit(m_field, [list, word, name](const FieldValue& v) -> ParsedValue {
        const ParsedValue picked = wordOrQuoted(word, v.given() && v.text.starts_with('"'));
        if (!list || v.formula || v.text.empty()) return picked;
        const auto at = origin(v).indexOf(name);
        if (at < 0) return v.with(v.elements.size(), picked.text());
        std::vector<std::string> rest;
        for (std::size_t i = 0; i < v.elements.size(); ++i)
            if (i != static_cast<std::size_t>(at)) rest.push_back(v.element(i));
        return rest.empty() ? v.text : joined(rest, v.separator);
    });
}

} // namespace trundle
