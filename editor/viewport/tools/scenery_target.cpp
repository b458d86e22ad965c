#include "editor/viewport/tools/scenery_target.h"

#include <QCoreApplication>

#include "editor/document/document.h"
#include "editor/viewport/context/viewport_scene.h"

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

} // namespace trundle
