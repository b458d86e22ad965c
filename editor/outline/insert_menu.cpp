#include "editor/outline/insert_menu.h"

#include <algorithm>
#include <map>

#include <QMenu>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/insertion_place.h"
#include "editor/outline/kind_icons.h"
#include "editor/outline/object_edits.h"
#include "editor/widgets/theme.h"
#include "model/dotted_path.h"
#include "project/edits/insert_positions.h"
#include "project/edits/plans.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxBeside = 3; ///< entries of one role in the common menu; more go into a submenu

QString roleTitle(Role role) {
    switch (role) {
    case Role::Body: return InsertMenu::tr("Bodies");
    case Role::Geom: return InsertMenu::tr("Shapes");
    case Role::Joint: return InsertMenu::tr("Joints");
    case Role::Device: return InsertMenu::tr("Sensors and Actuators");
    case Role::Controller: return InsertMenu::tr("Controllers");
    case Role::Log: return InsertMenu::tr("Logs");
    case Role::Instance: return InsertMenu::tr("Robots and Scenery");
    case Role::Layout: return InsertMenu::tr("Many Robots");
    case Role::Repeat: return InsertMenu::tr("Repetition");
    case Role::Config: return InsertMenu::tr("Configs");
    case Role::Material: return InsertMenu::tr("Materials");
    case Role::Surface: return InsertMenu::tr("Surfaces");
    case Role::Look: return InsertMenu::tr("Light and Views");
    case Role::Pattern: return InsertMenu::tr("Antennas");
    case Role::Medium: return InsertMenu::tr("Radio");
    case Role::Region: return InsertMenu::tr("Regions");
    case Role::Settings: break;
    }
    return {};
}

/// In the order in which a robot is usually built.
constexpr Role kRoles[] = {Role::Body,    Role::Geom,   Role::Joint,  Role::Device,   Role::Controller, Role::Instance,
                           Role::Repeat,  Role::Layout, Role::Config, Role::Material, Role::Surface,    Role::Look,
                           Role::Pattern, Role::Medium, Role::Region, Role::Log};

} // namespace

struct InsertMenu::Entries {
    std::map<Role, std::vector<const Kind*>> byRole;
};

InsertMenu::InsertMenu(Document& document, Selection& selection, ObjectEdits& edits, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_edits(edits) {}

void InsertMenu::attach(QMenu& menu) {
    menu.setToolTipsVisible(true);
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu, kept = menu.actions()] {
        for (QAction* action : menu.actions())
            if (!kept.contains(action)) {
                menu.removeAction(action);
                QMenu* under = action->menu(); // deleting the submenu deletes its action
                (under ? static_cast<QObject*>(under) : action)->deleteLater();
            }
        if (!kept.isEmpty()) menu.addSeparator();
        fill(menu);
    });
    fill(menu);
}

void InsertMenu::fill(QMenu& menu) {
    menu.setToolTipsVisible(true);
    if (!m_document.isOpen()) {
        menu.addAction(tr("Open or create an experiment first"))->setEnabled(false);
        return;
    }
    const LoadedProject& loaded = *m_document.loaded();
    const std::string at = m_document.editedModel().insertionPlace(m_selection);
    std::map<std::string, Entries> places;
    for (const Kind* kind : loaded.registry->all()) {
        if (kind->role == Role::Settings) continue;
        if (const auto place = insertionPlaceFor(loaded, at, *kind)) places[*place].byRole[kind->role].push_back(kind);
    }
    for (const std::string& place : placesAround(loaded, at))
        if (const auto entries = places.find(place); entries != places.end())
            addPlace(menu, place, entries->second, place.empty() && places.size() > 1);
}

/// `isFarther`: there are nearer places; what is seldom inserted does not lengthen the menu then.
void InsertMenu::addPlace(QMenu& menu, const std::string& place, const Entries& entries, bool isFarther) {
    const std::string name(lastWord(place));
    QAction* title = menu.addAction(place.empty() ? tr("In the experiment") : tr("In %1").arg(QString::fromStdString(name)));
    title->setEnabled(false);
    title->setObjectName(QStringLiteral("insertPlace.") + QString::fromStdString(place));
    QMenu* more = nullptr;
    for (const Role role : kRoles) {
        const auto kinds = entries.byRole.find(role);
        if (kinds == entries.byRole.end()) continue;
        QMenu* into = &menu;
        if (isFarther && role != Role::Instance) into = more = more ? more : namedMenu(menu, tr("More"), QStringLiteral("insertMore"));
        if (entries.byRole.size() > 1 && kinds->second.size() > kMaxBeside) {
            QMenu* ofRole = namedMenu(*into, roleTitle(role), QStringLiteral("insertRole.") + QLatin1String(roleName(role)));
            ofRole->setIcon(themedIcon(roleIcon(role)));
            into->addMenu(ofRole);
            into = ofRole;
        }
        for (const Kind* kind : kinds->second) {
            if (kind->name == "Part") addParts(*into, place, *kind);
            else addKind(*into, *kind);
        }
        if (role == Role::Instance && place.empty()) addObjects(menu);
    }
    if (more) menu.addMenu(more);
    menu.addSeparator();
}

QMenu* InsertMenu::namedMenu(QMenu& menu, const QString& title, const QString& name) {
    auto* made = new QMenu(title, &menu);
    made->setObjectName(name);
    made->setToolTipsVisible(true);
    return made;
}

/// Movable objects: robots without joints, devices and controller, each with the config that defines it.
void InsertMenu::addObjects(QMenu& menu) {
    QMenu* objects = namedMenu(menu, tr("Object"), QStringLiteral("insertObjects"));
    objects->setIcon(themedIcon(QStringLiteral("kind-object")));
    menu.addMenu(objects);
    for (const char* shape : {"Box", "Sphere", "Cylinder", "Capsule"}) {
        const Kind* geom = m_document.loaded()->registry->find(shape);
        if (!geom) continue;
        const QString name = geom->name == "Sphere" ? tr("Ball") : QString::fromStdString(geom->name);
        QAction* action = objects->addAction(themedIcon(kindIcon(geom)), name);
        action->setObjectName(QStringLiteral("insertObject.") + QLatin1String(shape));
        action->setToolTip(tr("A movable object: a Robot without joints, devices and controller, and its config"));
        action->setStatusTip(action->toolTip());
        connect(action, &QAction::triggered, this, [this, shape] {
            const Kind* kind = m_document.isOpen() ? m_document.loaded()->registry->find(shape) : nullptr;
            if (kind) (void)m_edits.insertObject(*kind);
        });
    }
}

/// The PartConfigs that there are, each for one Part more, and a new one. Without any, a Part comes with a new one.
void InsertMenu::addParts(QMenu& menu, const std::string& place, const Kind& part) {
    const LoadedProject& loaded = *m_document.loaded();
    const std::string at = m_document.editedModel().insertionPlace(m_selection);
    std::vector<std::pair<std::string, std::string>> parts; // name of the config, and text
    for (const Part* config : loaded.outline->configs.all())
        if (std::string text = partTextFor(loaded, place, *config); !text.empty())
            parts.emplace_back(config->name, std::move(text));
    if (parts.empty()) return addNewPart(menu, part, QString::fromStdString(part.name), place);
    QMenu* into = namedMenu(menu, QString::fromStdString(part.name), QStringLiteral("insertParts"));
    into->setIcon(themedIcon(kindIcon(&part)));
    menu.addMenu(into);
    for (const auto& [name, text] : parts) {
        const QString shown = QString::fromStdString(name);
        QAction* action = into->addAction(themedIcon(kindIcon(&part)), QString(shown).replace(u"&"_qs, u"&&"_qs));
        action->setObjectName(QStringLiteral("insertPart.") + shown);
        action->setStatusTip(tr("One Part more that uses %1").arg(shown));
        connect(action, &QAction::triggered, this, [this, at, shown, text = text] {
            if (const Result<Blocks> blocks = blocksFrom(text))
                (void)m_edits.insertAtPoint(blocks.value(), at, tr("Add Part %1").arg(shown));
        });
    }
    into->addSeparator();
    addNewPart(*into, part, tr("New Part"), place);
}

/// With a PartConfig of its own, to be built.
void InsertMenu::addNewPart(QMenu& menu, const Kind& part, const QString& title, const std::string& place) {
    QAction* action = menu.addAction(themedIcon(kindIcon(&part)), title);
    action->setObjectName(QStringLiteral("insert.") + QString::fromStdString(part.name));
    action->setToolTip(QString::fromStdString(part.help));
    action->setStatusTip(action->toolTip());
    connect(action, &QAction::triggered, this, [this, place] { insertNewPart(place); });
}

void InsertMenu::insertNewPart(const std::string& place) {
    const LoadedProject& loaded = *m_document.loaded();
    const std::string config = templateOf(loaded, *loaded.registry->find("PartConfig"), place);
    const Result<Blocks> needed = blocksFrom(config);
    if (!needed || needed.value().names.empty()) return;
    const std::string& name = needed.value().names.back();
    Result<Blocks> blocks = blocksFrom("Part part { Config=" + name + " }");
    if (!blocks) return;
    blocks.value().needs.push_back({"PartConfig." + name, config});
    (void)m_edits.insertAtPoint(blocks.value(), m_document.editedModel().insertionPlace(m_selection), tr("Add Part"));
}

QAction* InsertMenu::addKind(QMenu& menu, const Kind& kind) {
    QAction* action = menu.addAction(themedIcon(kindIcon(&kind)), QString::fromStdString(kind.name));
    action->setObjectName(QStringLiteral("insert.") + QString::fromStdString(kind.name));
    action->setToolTip(QString::fromStdString(kind.help));
    action->setStatusTip(QString::fromStdString(kind.help));
    const auto& world = m_document.loaded()->outline->world.all();
    const bool medium = kind.role == Role::Medium;
    if (medium && std::any_of(world.begin(), world.end(), [](const Part* part) { return part->is(Role::Medium); })) {
        action->setEnabled(false);
        action->setToolTip(tr("There is one already: all radios share one medium"));
    }
    connect(action, &QAction::triggered, this, [this, name = kind.name] {
        const Kind* kind = m_document.isOpen() ? m_document.loaded()->registry->find(name) : nullptr;
        if (kind) (void)m_edits.insertKind(*kind, m_document.editedModel().insertionPlace(m_selection));
    });
    return action;
}

} // namespace trundle
