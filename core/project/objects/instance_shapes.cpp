#include "project/objects/instance_shapes.h"

#include <functional>

namespace trundle {

namespace {

void forEachGeom(const ExperimentSpec& experiment, const std::function<void(const GeomSpec&)>& take) {
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies)
            for (const GeomSpec& geom : body.geoms) take(geom);
    }
    for (const StaticSpec& fixed : experiment.statics)
        if (fixed.geoms)
            for (const GeomSpec& geom : *fixed.geoms) take(geom);
}

} // namespace

std::optional<InstanceVariants> variantsOf(const LoadedProject& loaded, const ObjectLocation& place) {
    const Part* part = place.part;
    if (!part || part != place.instance || !isPlaced(*part)) return std::nullopt;
    AssetLookup assets;
    assets.shapes = loaded.shapes;
    const auto pathOf = [named = loaded.named](const std::string& written, FileId file) {
        const auto found = named.find({file, written});
        return found == named.end() ? std::string() : found->second.path;
    };
    // Keeps only the shapes, not the contents of the files.
    assets.mesh = [pathOf, experiment = loaded.experiment,
                   shapes = loaded.shapes](const std::string& written, FileId file) -> Result<FoundAsset<TriangleMesh>> {
        FoundAsset<TriangleMesh> found{pathOf(written, file), nullptr};
        forEachGeom(*experiment, [&](const GeomSpec& geom) {
            if (!found.content && geom.mesh && geom.file == found.path) found.content = shapes->originalOf(geom.mesh);
        });
        if (!found.content) return Error{Code::MeshUnreadable, "the mesh " + written + " is not read"};
        return found;
    };
    assets.heightMap = [pathOf, experiment = loaded.experiment](const std::string& written,
                                                                FileId file) -> Result<FoundAsset<HeightMap>> {
        FoundAsset<HeightMap> found{pathOf(written, file), nullptr};
        forEachGeom(*experiment, [&](const GeomSpec& geom) {
            if (!found.content && geom.heightMap && geom.file == found.path) found.content = geom.heightMap;
        });
        if (!found.content) return Error{Code::MeshUnreadable, "the height map " + written + " is not read"};
        return found;
    };
    return InstanceVariants(loaded.outline, std::move(assets), *part);
}

} // namespace trundle
