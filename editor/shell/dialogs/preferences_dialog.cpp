#include "editor/shell/dialogs/preferences_dialog.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

#include "editor/viewport/tools/navigation_style.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

const QString kTrusted = QStringLiteral("trustedFolders");

QString menuOf(const ActionRow& row) {
    return QString(QLatin1String(row.menu)).remove(QLatin1Char('|')).remove(QLatin1Char('&'));
}

/// The table's text, since the action's current one may be longer ("Undo Move robot0"); with its submenu, since "Robot" alone is
/// ambiguous.
QString nameOf(const ActionRow& row) {
    const QString menu = menuOf(row), name = PreferencesDialog::tr(row.text).remove(QLatin1Char('&')).remove(QStringLiteral("…"));
    const qsizetype under = menu.indexOf(QLatin1Char('/'));
    return under < 0 ? name : menu.mid(under + 1) + QStringLiteral(": ") + name;
}

} // namespace

PreferencesDialog::PreferencesDialog(Actions& actions, QWidget* parent) : QDialog(parent), m_actions(actions) {
    setObjectName(QStringLiteral("preferences"));
    setWindowTitle(tr("Preferences"));
    resizeToFont(*this, {620, 520});
    auto* tabs = new QTabWidget;
    tabs->addTab(makeGeneral(), tr("General"));
    tabs->addTab(makeShortcuts(), tr("Shortcuts"));
    tabs->addTab(makeTrust(), tr("Trusted folders"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(tabs);
    layout->addWidget(buttons);
    for (QPushButton* button : findChildren<QPushButton*>()) button->setAutoDefault(false); // not for Enter in a field
}

QWidget* PreferencesDialog::makeGeneral() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    const auto choice = [this, form](const char* name, const QString& label, const QStringList& words, int now) {
        auto* box = new QComboBox;
        box->setObjectName(QLatin1String(name));
        box->addItems(words);
        box->setCurrentIndex(now);
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::take);
        form->addRow(label, box);
        return box;
    };
    const auto size = [this, form](const char* name, const QString& label, int largest, int now) {
        auto* box = new QSpinBox;
        box->setObjectName(QLatin1String(name));
        box->setRange(kSmallestFont, largest);
        box->setSuffix(tr(" px"));
        box->setValue(now);
        connect(box, &QSpinBox::valueChanged, this, &PreferencesDialog::take);
        form->addRow(label, box);
        return box;
    };
    const Preferences& p = m_preferences;
    m_theme = choice("themeChoice", tr("&Theme"), {tr("As the system"), tr("Light"), tr("Dark")}, int(p.theme));
    m_interfaceFont = size("interfaceFont", tr("Font size of the &window"), kLargestInterfaceFont, p.fonts.interface);
    m_textFont = size("textFont", tr("Font size of te&xts"), kLargestTextFont, p.fonts.text);
    m_wrap = choice("wrapChoice", tr("Wrap &long lines"), {tr("In narrow panes"), tr("Always"), tr("Never")}, int(p.wrapLines));
    m_navigation = choice("navigationChoice", tr("3D &navigation"), {tr("Trundle"), tr("Blender"), tr("CAD")}, int(p.navigation));
    m_buttons = new QLabel;
    m_buttons->setObjectName(QStringLiteral("navigationButtons"));
    m_buttons->setWordWrap(true);
    form->addRow(QString(), m_buttons);
    m_buttons->setText(navigationWords(p.navigation));
    return page;
}

void PreferencesDialog::take() {
    if (!m_theme || !m_textFont || !m_wrap || !m_navigation) return; // the dialog is still being built
    const Preferences before = m_preferences;
    m_preferences.theme = static_cast<ThemeChoice>(m_theme->currentIndex());
    m_preferences.fonts = {m_interfaceFont->value(), m_textFont->value()};
    m_preferences.wrapLines = static_cast<WrapLines>(m_wrap->currentIndex());
    m_preferences.navigation = static_cast<NavigationStyle>(m_navigation->currentIndex());
    if (m_preferences == before) return;
    m_buttons->setText(navigationWords(m_preferences.navigation));
    savePreferences(m_preferences);
    Q_EMIT changed(before, m_preferences);
}

QWidget* PreferencesDialog::makeShortcuts() {
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    m_filter->setObjectName(QStringLiteral("shortcutFilter"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setClearButtonEnabled(true);
    m_shortcuts->setObjectName(QStringLiteral("shortcuts"));
    m_shortcuts->setHeaderLabels({tr("Command"), tr("Menu"), tr("Shortcut")});
    m_shortcuts->setRootIsDecorated(false);
    m_shortcuts->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    auto* keys = new QKeySequenceEdit;
    keys->setObjectName(QStringLiteral("keys"));
    keys->setMinimumHeight(scaledToFont(26));
    auto* set = new QPushButton(tr("Set"));
    set->setObjectName(QStringLiteral("setKeys"));
    auto* reset = new QPushButton(tr("Default"));
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Keys of the chosen command:")));
    row->addWidget(keys, 1);
    row->addWidget(set);
    row->addWidget(reset);
    layout->addWidget(m_filter);
    layout->addWidget(m_shortcuts, 1);
    layout->addLayout(row);
    fillShortcuts();
    const auto chosen = [this]() -> const ActionRow* {
        const QTreeWidgetItem* item = m_shortcuts->currentItem();
        return item ? &m_actions.table()[item->data(0, Qt::UserRole).toULongLong()] : nullptr;
    };
    connect(m_filter, &QLineEdit::textChanged, this, &PreferencesDialog::narrow);
    const auto showKeys = [this, keys, set, reset, chosen] {
        const ActionRow* row = chosen();
        keys->setKeySequence(row ? m_actions.at(row->id).shortcut() : QKeySequence());
        for (QWidget* widget : {static_cast<QWidget*>(keys), static_cast<QWidget*>(set), static_cast<QWidget*>(reset)})
            widget->setEnabled(row);
    };
    connect(m_shortcuts, &QTreeWidget::currentItemChanged, this, showKeys);
    showKeys();
    connect(set, &QPushButton::clicked, this, [this, keys, chosen] {
        if (const ActionRow* row = chosen()) setKeys(row->id, keys->keySequence());
    });
    connect(reset, &QPushButton::clicked, this, [this, chosen] {
        const ActionRow* row = chosen();
        if (!row || !areFree(row->id, QKeySequence(QLatin1String(row->shortcut), QKeySequence::PortableText))) return;
        m_actions.resetShortcut(row->id);
        fillShortcuts();
    });
    return page;
}

QString PreferencesDialog::ownerOf(const Actions& actions, const QKeySequence& keys, const char* id) {
    if (keys.isEmpty()) return {};
    for (const ActionRow& row : actions.table())
        if (std::string_view(row.id) != id && actions.at(row.id).shortcut() == keys) return QLatin1String(row.id);
    return {};
}

bool PreferencesDialog::areFree(const char* id, const QKeySequence& keys) {
    for (QByteArray other; !(other = ownerOf(m_actions, keys, id).toLatin1()).isEmpty();) {
        const auto row = std::ranges::find_if(m_actions.table(), [&](const ActionRow& r) { return other == r.id; });
        const auto answer = QMessageBox::question(
            this, tr("Keys in use"),
            tr("%1 is the shortcut of “%2”. Reassign it?").arg(keys.toString(QKeySequence::NativeText), nameOf(*row)),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
        if (answer != QMessageBox::Yes) return false;
        m_actions.setShortcut(other.constData(), {});
    }
    return true;
}

void PreferencesDialog::setKeys(const char* id, const QKeySequence& keys) {
    if (!areFree(id, keys)) return;
    m_actions.setShortcut(id, keys);
    fillShortcuts();
}

void PreferencesDialog::fillShortcuts() {
    const int current = m_shortcuts->indexOfTopLevelItem(m_shortcuts->currentItem());
    {
        const QSignalBlocker quiet(m_shortcuts); // keeps the focus on the button that was pressed
        m_shortcuts->clear();
    }
    for (std::size_t i = 0; i < m_actions.table().size(); ++i) {
        const ActionRow& row = m_actions.table()[i];
        const QString keys = m_actions.at(row.id).shortcut().toString(QKeySequence::NativeText);
        auto* item = new QTreeWidgetItem(m_shortcuts, {nameOf(row), menuOf(row), keys});
        item->setData(0, Qt::UserRole, qulonglong(i));
        item->setToolTip(0, tr(row.help));
    }
    m_shortcuts->setCurrentItem(m_shortcuts->topLevelItem(std::max(0, current)));
    narrow();
}

void PreferencesDialog::narrow() {
    const QString words = m_filter->text();
    QTreeWidgetItem* first = nullptr;
    for (int i = 0; i < m_shortcuts->topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = m_shortcuts->topLevelItem(i);
        const bool fits = std::ranges::any_of(std::array{0, 1, 2}, [&](int column) { // also by shortcut: which one has Ctrl+D?
            return item->text(column).contains(words, Qt::CaseInsensitive);
        });
        item->setHidden(!fits);
        if (fits && !first) first = item;
    }
    // Select a visible row, since shortcuts apply to the current one.
    if (const QTreeWidgetItem* current = m_shortcuts->currentItem(); !current || current->isHidden())
        m_shortcuts->setCurrentItem(first);
}

QWidget* PreferencesDialog::makeTrust() {
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    auto* why = new QLabel(
        tr("Modules are programs. Those in these folders, and those that come with Trundle, are loaded without asking."));
    why->setWordWrap(true);
    m_folders->setObjectName(QStringLiteral("trustedFolders"));
    m_folders->addItems(QSettings().value(kTrusted).toStringList());
    auto* remove = new QPushButton(tr("Stop trusting"));
    connect(remove, &QPushButton::clicked, this, [this] {
        delete m_folders->currentItem();
        QStringList left;
        for (int i = 0; i < m_folders->count(); ++i) left << m_folders->item(i)->text();
        QSettings().setValue(kTrusted, left);
    });
    layout->addWidget(why);
    layout->addWidget(m_folders, 1);
    layout->addWidget(remove, 0, Qt::AlignLeft);
    return page;
}

} // namespace trundle
