#include "editor/shell/commands/mesh_commands.h"

#include <utility>

#include "app/mesh_files.h"
#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/shell/dialogs/mesh_dialog.h"
#include "editor/viewport/tools/scenery_target.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/strings.h"
#include "project/edits/plan_sensor_ring.h"
#include "project/edits/plans.h"

namespace trundle {

MeshCommands::MeshCommands(QWidget& window, Actions& actions, Document& document, Selection& selection,
                           const ViewportScene& world, Locations locations)
    : QObject(&window), m_window(window), m_document(document), m_selection(selection), m_world(world),
      m_locations(std::move(locations)) {
    connect(&actions.at("mesh.import"), &QAction::triggered, this, &MeshCommands::ask);
}

void MeshCommands::ask() {
    if (!m_document.isOpen()) return Q_EMIT m_document.refused(tr("open or create an experiment first"));
    if (m_document.isNew() || m_document.texts().isSample(m_document.path()))
        return Q_EMIT m_document.refused(tr("save the experiment first: the mesh goes into its folder"));
    std::string body;
    if (const std::string& model = m_document.editedModel().path(); model.starts_with("RobotConfig.")) {
        const Result<std::string> found =
            bodyForSensors(*m_document.loaded(), m_document.editedModel().insertionPlace(m_selection));
        if (!found) return Q_EMIT m_document.refused(toQString(found.error().message));
        body = found.value();
    }
    auto* dialog = new MeshDialog(m_locations, toQString(m_document.loaded()->projectFolder), !body.empty(), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog, body] { insert(*dialog, body); });
    dialog->open();
}

void MeshCommands::insert(const MeshDialog& dialog, const std::string& body) {
    const Result<std::string> written = bringMesh(dialog.file().toStdString(), m_document.loaded()->projectFolder);
    if (!written) return Q_EMIT m_document.refused(toQString(written.error().message));
    MeshPart part = dialog.part(written.value());
    if (const ConvexParts* several = dialog.hulls()) {
        auto files = writeHulls(several->hulls, written.value(), m_document.loaded()->projectFolder);
        if (!files) return Q_EMIT m_document.refused(toQString(files.error().message));
        part.shape.files = std::move(files).value();
    }
    const std::string parent = body.empty() ? sceneryTarget(m_document, m_world).path : body;
    const std::string text = parent.empty() ? meshSceneryText(part) : meshGeomsText(part);
    const auto plan = [parent, text](const LoadedProject& loaded,
                                     const StructureEdits::PathMapping& renamed) -> Result<EditPlan> {
        Result<EditPlan> plan = planInsert(loaded, renamed(parent), text, {"common/materials.sim", "common/surfaces.sim"});
        if (plan && parent.empty()) { // the Static alone, not its config
            std::vector<std::string>& selects = plan.value().selects;
            selects.erase(selects.begin(), selects.end() - 1);
        }
        return plan;
    };
    (void)m_document.structure().apply(tr("Insert Mesh %1").arg(toQString(part.name)), {parent}, plan);
}

} // namespace trundle
