#include "editor/shell/commands/arena_commands.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/shell/dialogs/heights_dialog.h"
#include "editor/shell/dialogs/maze_dialog.h"
#include "editor/shell/dialogs/room_dialog.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/tools/scenery_target.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/strings.h"
#include "project/edits/plans.h"
#include "project/wizard/arena_text.h"
#include "project/wizard/heights_text.h"

namespace trundle {

ArenaCommands::ArenaCommands(QWidget& window, Actions& actions, Document& document, const ViewportScene& world,
                             Locations locations)
    : QObject(&window), m_window(window), m_document(document), m_world(world), m_locations(std::move(locations)) {
    connect(&actions.at("arena.room"), &QAction::triggered, this, &ArenaCommands::askRoom);
    connect(&actions.at("arena.maze"), &QAction::triggered, this, &ArenaCommands::askMaze);
    connect(&actions.at("arena.heights"), &QAction::triggered, this, &ArenaCommands::askHeights);
}

bool ArenaCommands::needsFloor() const {
    return std::ranges::none_of(m_world.objects()->experiment().statics, [](const StaticSpec& fixed) {
        return fixed.geoms && std::ranges::any_of(*fixed.geoms, [](const GeomSpec& geom) {
                   return geom.shape == GeomShape::Plane || geom.shape == GeomShape::Heightfield;
               });
    });
}

void ArenaCommands::askRoom() {
    if (!canHaveScenery(m_document)) return;
    auto* dialog = new RoomDialog(needsFloor(), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (dialog->plan()) insertRoom(tr("Insert Room"), "Room", *dialog->plan(), dialog->hasFloor());
    });
    dialog->open();
}

void ArenaCommands::askMaze() {
    if (!canHaveScenery(m_document)) return;
    auto* dialog = new MazeDialog(needsFloor(), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (dialog->plan()) insertRoom(tr("Insert Maze"), "Maze", *dialog->plan(), dialog->hasFloor());
    });
    dialog->open();
}

void ArenaCommands::insertRoom(const QString& title, const std::string& name, const RoomPlan& plan, bool hasFloor) {
    insert(title, roomBlocksText(name, plan, hasFloor), roomBoxesText(plan, hasFloor));
}

void ArenaCommands::insert(const QString& title, const std::string& blocks, const std::string& insideConfig) {
    const SceneryTarget target = sceneryTarget(m_document, m_world);
    const auto plan = [path = target.path, text = target.path.empty() ? blocks : insideConfig](
                          const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) -> Result<EditPlan> {
        Result<EditPlan> plan = planInsert(loaded, renamed(path), text, {"common/materials.sim", "common/surfaces.sim"});
        if (plan && path.empty()) { // the Static alone, not its config
            std::vector<std::string>& selects = plan.value().selects;
            selects.erase(selects.begin(), selects.end() - 1);
        }
        return plan;
    };
    (void)m_document.structure().apply(title, {target.path}, plan);
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
