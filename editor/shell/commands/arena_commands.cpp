#include "editor/shell/commands/arena_commands.h"

#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "editor/document/document.h"
#include "editor/shell/dialogs/heights_dialog.h"
#include "editor/shell/dialogs/maze_dialog.h"
#include "editor/shell/dialogs/obstacles_dialog.h"
#include "editor/shell/dialogs/room_dialog.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/tools/scenery_target.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/strings.h"
#include "project/wizard/arena_text.h"
#include "project/wizard/heights_text.h"
#include "scene/queries/object_index.h"

namespace trundle {
namespace {

constexpr double kFlat = 0.01, kHighest = 0.4; // m; what is lower is a mark on the floor, what is higher is above the obstacles

/// The proposed field, with the robots and the scenery that is there. The middle is free if there is no robot.
ObstacleField fieldAmong(const ObjectIndex& objects) {
    ObstacleField field;
    const BodyPoses poses = startPoses(objects.experiment());
    const auto occupy = [&](const Bounds& bounds) {
        if (bounds.empty() || bounds.high.z() < kFlat || bounds.low.z() > kHighest) return;
        field.occupied.push_back({bounds.low.x(), bounds.low.y(), bounds.high.x(), bounds.high.y()});
    };
    for (const ObjectRef& object : objects.instances()) {
        if (const StaticSpec* fixed = objects.staticOf(object)) {
            for (std::uint32_t g = 0; fixed->geoms && g < fixed->geoms->size(); ++g)
                occupy(objects.boundsOf({ObjectKind::StaticGeom, object.instance, 0, g}, poses));
            continue;
        }
        occupy(objects.boundsOf(object, poses));
        field.free.clear();
    }
    return field;
}

} // namespace

ArenaCommands::ArenaCommands(QWidget& window, Actions& actions, Document& document, const ViewportScene& world,
                             Locations locations)
    : QObject(&window), m_window(window), m_document(document), m_world(world), m_locations(std::move(locations)) {
    connect(&actions.at("arena.room"), &QAction::triggered, this, &ArenaCommands::askRoom);
    connect(&actions.at("arena.maze"), &QAction::triggered, this, &ArenaCommands::askMaze);
    connect(&actions.at("arena.obstacles"), &QAction::triggered, this, &ArenaCommands::askObstacles);
    connect(&actions.at("arena.heights"), &QAction::triggered, this, &ArenaCommands::askHeights);
}

void ArenaCommands::askRoom() {
    if (!canHaveScenery(m_document)) return;
    auto* dialog = new RoomDialog(!hasFloor(m_world), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (dialog->plan()) insertRoom(tr("Insert Room"), "Room", *dialog->plan(), dialog->hasFloor());
    });
    dialog->open();
}

void ArenaCommands::askMaze() {
    if (!canHaveScenery(m_document)) return;
    auto* dialog = new MazeDialog(!hasFloor(m_world), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (dialog->plan()) insertRoom(tr("Insert Maze"), "Maze", *dialog->plan(), dialog->hasFloor());
    });
    dialog->open();
}

void ArenaCommands::askObstacles() {
    if (!canHaveScenery(m_document)) return;
    auto* dialog = new ObstaclesDialog(fieldAmong(*m_world.objects()), !hasFloor(m_world), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (!dialog->obstacles()) return;
        insert(tr("Insert Obstacle Field"), obstacleBlocksText("Obstacles", *dialog->obstacles(), dialog->hasFloor()),
               obstacleGeomsText(*dialog->obstacles(), dialog->hasFloor()));
    });
    dialog->open();
}

void ArenaCommands::insertRoom(const QString& title, const std::string& name, const RoomPlan& plan, bool hasFloor) {
    insert(title, roomBlocksText(name, plan, hasFloor), roomBoxesText(plan, hasFloor));
}

void ArenaCommands::insert(const QString& title, const std::string& blocks, const std::string& insideConfig) {
    insertScenery(m_document, sceneryTarget(m_document, m_world), title, blocks, insideConfig);
}

void ArenaCommands::askHeights() {
    if (!canHaveScenery(m_document)) return;
    if (m_document.isNew() || m_document.texts().isSample(m_document.path()))
        return Q_EMIT m_document.refused(tr("save the experiment first: the picture goes into its folder"));
    auto* dialog = new HeightsDialog(m_locations, toQString(m_document.loaded()->projectFolder), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { insertHeights(dialog->picture(), dialog->sizes()); });
    dialog->open();
}

/// A picture outside of the project is copied into its folder, under a free name.
void ArenaCommands::insertHeights(const QString& picture, const std::array<double, 3>& sizes) {
    const QDir folder(toQString(m_document.loaded()->projectFolder));
    QString name = folder.relativeFilePath(picture);
    if (name.startsWith(QLatin1String("..")) || QDir::isAbsolutePath(name)) {
        const QFileInfo from(picture);
        name = from.fileName();
        for (int i = 2; folder.exists(name); ++i)
            name = from.completeBaseName() + QString::number(i) + QLatin1Char('.') + from.suffix();
        if (!QFile::copy(picture, folder.filePath(name)))
            return Q_EMIT m_document.refused(tr("%1 cannot be copied to %2").arg(picture, folder.path()));
    }
    const Result<std::string> ground = heightsText(name.toStdString(), sizes);
    if (!ground) return Q_EMIT m_document.refused(toQString(ground.error().message));
    insert(tr("Insert Height Map"), "StaticConfig Hills {\n  " + ground.value() + "}\nStatic hills { Config=Hills }\n",
           ground.value());
}

} // namespace trundle
