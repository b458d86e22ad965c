#include "editor/properties/row_menu.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

#include "editor/properties/origin_text.h"
#include "editor/properties/rows.h"
#include "editor/widgets/theme.h"
#include "project/edits/plans.h"

namespace trundle {
namespace {

QAction* add(QMenu& menu, const char* name, const QString& title, const std::function<void()>& handler) {
    QAction* action = menu.addAction(title);
    action->setObjectName(QString::fromLatin1(name));
    QObject::connect(action, &QAction::triggered, &menu, handler);
    return action;
}

void addValueActions(QMenu& menu, const Row& row, Document& document, const RowActions& actions) {
    const std::string path = row.first().path;
    if (row.given()) {
        QAction* reset = add(menu, "rowReset", QObject::tr("Reset"),
                             [row, actions] { actions.failed(row.set([](const FieldValue&) { return std::string(); }, {})); });
        reset->setEnabled(canReset(row));
        reset->setIcon(themedIcon(QStringLiteral("reset")));
    }
    if (row.values.size() != 1) return;
    if (row.first().origin == ValueOrigin::Override && row.first().setForAll.empty())
        add(menu, "rowPush", QObject::tr("Push into the config"),
            [path, &document, actions] { actions.failed(pushOverride(document, path)); });
    if (row.first().origin == ValueOrigin::Config)
        add(menu, "rowPull", QObject::tr("Override here"),
            [path, &document, actions] { actions.failed(pullOverride(document, path)); });
}

} // namespace

void fillRowMenu(QMenu& menu, const Row& row, Document& document, const RowActions& actions) {
    const FieldValue& v = row.first();
    const QString place = placeWords(*row.loaded, v.place);
    if (!place.isEmpty())
        add(menu, "rowJump", v.given() ? QObject::tr("Go to %1").arg(place) : QObject::tr("Go to its block, %1").arg(place),
            [actions, range = v.place] { actions.jump(range); });
    addValueActions(menu, row, document, actions);
    menu.addSeparator();
    QAction* asText = add(menu, "rowAsText", QObject::tr("Edit as text or formula"), actions.editAsText);
    asText->setCheckable(true);
    asText->setChecked(actions.asText);
    add(menu, "rowCopyPath", QObject::tr("Copy path"),
        [v] { QGuiApplication::clipboard()->setText(QString::fromStdString(v.path)); });
    if (!v.text.empty())
        add(menu, "rowCopyValue", QObject::tr("Copy value"),
            [v] { QGuiApplication::clipboard()->setText(QString::fromStdString(v.text)); });
}

} // namespace trundle
