#include "editor/viewport/tools/scenery_target.h"

#include <algorithm>

#include <QCoreApplication>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/viewport_scene.h"
#include "project/edits/plans.h"

namespace trundle {

SceneryTarget sceneryTarget(const Document& document, const ViewportScene& world) {
    for (const StaticSpec& fixed : world.objects()->experiment().statics) {
        if (!fixed.name.starts_with("StaticConfig.")) continue; // scenery of an experiment has the name of its Static
        const auto place = placeOf(*document.loaded(), fixed.name);
        if (place && place->part) return {fixed.name, fixed.pose};
    }
    return {};
}

bool canHaveScenery(Document& document) {
    if (!document.isOpen()) {
        Q_EMIT document.refused(QCoreApplication::translate("SceneryTarget", "open or create an experiment first"));
        return false;
    }
    if (!document.editedModel().path().starts_with("RobotConfig.")) return true;
    Q_EMIT document.refused(
        QCoreApplication::translate("SceneryTarget", "scenery is not part of a robot: leave the model editor first"));
    return false;
}

bool hasFloor(const ViewportScene& world) {
    return std::ranges::any_of(world.objects()->experiment().statics, [](const StaticSpec& fixed) {
        return fixed.geoms && std::ranges::any_of(*fixed.geoms, [](const GeomSpec& geom) {
                   return geom.shape == GeomShape::Plane || geom.shape == GeomShape::Heightfield;
               });
    });
}

void insertScenery(Document& document, const SceneryTarget& target, const QString& title, const std::string& blocks,
                   const std::string& insideConfig) {
    const auto plan = [path = target.path, text = target.path.empty() ? blocks : insideConfig](
                          const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) -> Result<EditPlan> {
        Result<EditPlan> plan = planInsert(loaded, renamed(path), text, {"common/materials.sim", "common/surfaces.sim"});
        if (plan && path.empty()) { // the Static alone, not its config
            std::vector<std::string>& selects = plan.value().selects;
            selects.erase(selects.begin(), selects.end() - 1);
        }
        return plan;
    };
    (void)document.structure().apply(title, {target.path}, plan);
}

} // namespace trundle
