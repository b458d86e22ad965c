// The context menu of the Scene tree.

#include <algorithm>

#include <QMenu>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/insert_menu.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_panel.h"
#include "editor/outline/outline_view.h"
#include "editor/widgets/theme.h"
#include "project/edits/plans.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

/// Adds an entry that shows a shortcut without registering it: the window's action has it.
template <class Slot>
QAction* add(QMenu& menu, const char* name, const QString& icon, const QString& text, Slot verb, const QString& keys = {}) {
    QAction* action = menu.addAction(themedIcon(icon), keys.isEmpty() ? text : text + QLatin1Char('\t') + keys);
    action->setObjectName(QLatin1String(name));
    QObject::connect(action, &QAction::triggered, &menu, verb);
    return action;
}

} // namespace

QMenu* OutlinePanel::contextMenu() {
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("outlineMenu"));
    menu->setToolTipsVisible(true);
    const std::string path = m_selection.current();
    const bool one = m_document.isOpen() && !path.empty();
    if (one) addObjectActions(*menu, path);
    add(
        *menu, "outline.paste", QStringLiteral("paste"), tr("&Paste"), [this] { m_edits.pasteAtSelected(); },
        QStringLiteral("Ctrl+V"))
        ->setEnabled(m_edits.canPaste());
    QMenu* insert = menu->addMenu(themedIcon(QStringLiteral("insert")), tr("&Insert"));
    insert->setObjectName(QStringLiteral("outline.insert"));
    m_insert->fill(*insert);
    menu->addSeparator();
    if (one) menu->addActions(m_more);
    addMarkActions(*menu);
    menu->addSeparator();
    add(*menu, "outline.foldAll", {}, tr("Fold Everything"), [this] { m_tree->collapseAll(); });
    return menu;
}

void OutlinePanel::addObjectActions(QMenu& menu, const std::string& path) {
    const auto place = placeOf(*m_document.loaded(), path);
    add(
        menu, "outline.jump", QStringLiteral("view-text"), tr("Go to &Text"), [this, path] { jumpFrom(m_model->indexOf(path)); },
        tr("Return"));
    if (place && place->instance && configOf(*m_document.loaded(), *place->instance))
        add(menu, "outline.config", QStringLiteral("kind-robotconfig"), tr("&Edit Its Config"),
            [this, path] { editConfig(path); });
    if (canReplaceBySingles(*m_document.loaded(), path))
        add(menu, "outline.singles", QStringLiteral("array"), tr("Replace by &Single Instances"),
            [this, path] { (void)m_edits.replaceBySingles(path); });
    if (place && place->part && place->part->kind && place->part->kind->name == "Camera")
        add(menu, "outline.through", QStringLiteral("kind-camera"), tr("&Look Through It"),
            [this, path] { Q_EMIT lookThroughRequested(path); });
    menu.addSeparator();
    add(
        menu, "outline.rename", QStringLiteral("rename"), tr("&Rename"), [this] { renameSelected(); }, QStringLiteral("F2"))
        ->setEnabled(m_edits.canRename(path));
    add(
        menu, "outline.duplicate", QStringLiteral("duplicate"), tr("D&uplicate"), [this] { m_edits.duplicateSelected(); },
        QStringLiteral("Ctrl+D"));
    add(
        menu, "outline.delete", QStringLiteral("delete"), tr("&Delete"), [this] { m_edits.removeSelected(); },
        QStringLiteral("Del"));
    menu.addSeparator();
    add(
        menu, "outline.cut", QStringLiteral("cut"), tr("Cu&t"), [this] { m_edits.cutSelected(); }, QStringLiteral("Ctrl+X"));
    add(
        menu, "outline.copy", QStringLiteral("copy"), tr("&Copy"), [this] { m_edits.copySelected(); }, QStringLiteral("Ctrl+C"));
}

void OutlinePanel::addMarkActions(QMenu& menu) {
    const std::vector<std::string> paths = markable();
    if (!paths.empty()) {
        const bool hide =
            std::any_of(paths.begin(), paths.end(), [this](const auto& p) { return !m_marks.hidden().contains(p); });
        const bool lock =
            std::any_of(paths.begin(), paths.end(), [this](const auto& p) { return !m_marks.locked().contains(p); });
        add(menu, "outline.hide", hide ? QStringLiteral("eye-off") : QStringLiteral("eye"), hide ? tr("&Hide") : tr("S&how"),
            [this, paths, hide] { m_marks.setHidden(paths, hide); });
        add(menu, "outline.lock", lock ? QStringLiteral("lock") : QStringLiteral("unlock"), lock ? tr("&Lock") : tr("Un&lock"),
            [this, paths, lock] { m_marks.setLocked(paths, lock); });
    }
    if (!m_marks.hidden().empty())
        add(menu, "outline.showAll", QStringLiteral("eye"), tr("Show Everything"), [this] { m_marks.showAll(); });
}

void OutlinePanel::editConfig(const std::string& path) {
    const auto place = placeOf(*m_document.loaded(), path);
    const Part* config = place && place->instance ? configOf(*m_document.loaded(), *place->instance) : nullptr;
    if (!config) return;
    const std::string at = pathOf(*m_document.loaded(), {config});
    m_selection.select(at);
    jumpFrom(m_model->indexOf(at));
}

} // namespace trundle
