// Resolves settings, materials and surfaces.
#include "base/missing_asset.h"
#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

namespace {

/// Adds a spec; one named `default` replaces the built-in one.
template <class Spec>
Spec& placeFor(std::vector<Spec>& all, std::map<std::string, std::uint32_t>& places, const std::string& name) {
    if (name == "default") {
        places[name] = 0;
        return all[0];
    }
    places[name] = static_cast<std::uint32_t>(all.size());
    return all.emplace_back();
}

void readTexture(ResolveContext& context, MaterialSpec& material, SourceRange place) {
    if (!context.assets.texture) return;
    const auto stand = [&](const Error& error) {
        context.diagnostics.warning(error.code, place, error.message);
        material.picture = missingAssetPicture();
    };
    const Result<std::string> found = context.assets.texture(material.texture, place.file);
    if (!found) return stand(found.error());
    material.texturePath = found.value();
    if (!context.assets.picture) return;
    const Result<std::shared_ptr<const Raster>> picture = context.assets.picture(material.texturePath);
    if (!picture) return stand(picture.error());
    material.picture = picture.value();
}

} // namespace

SettingsSpec resolveSettings(ResolveContext& context) {
    const Record record = context.readSettings();
    const SettingsFields f = fieldsFrom<SettingsFields>(record);
    SettingsSpec s;
    s.tick = f.tick;
    s.duration = f.duration;
    s.seed = static_cast<std::uint64_t>(f.seed);
    s.gravity = vec3(f.gravity);
    s.solver = f.solver == "exact" ? SolverChoice::Exact : f.solver == "quick" ? SolverChoice::Quick : SolverChoice::Auto;
    s.solverRange = record.rangeOf("Solver", {});
    for (const EngineChoice engine : {EngineChoice::General, EngineChoice::Wheeled, EngineChoice::Planar, EngineChoice::Auto})
        if (f.engine == nameOf(engine)) s.engine = engine;
    s.engineRange = record.rangeOf("Engine", {});
    s.iterations = f.iterations;
    s.threads = f.threads;
    s.errorReduction = f.errorReduction;
    s.isolation = f.isolation.value_or("");
    s.title = f.title;
    s.description = f.description;
    return s;
}

void resolveMaterials(ResolveContext& context) {
    context.out.materials = {MaterialSpec{}};
    context.out.materials[0].name = "default";
    for (const Part* part : context.outline.materials.all()) {
        ParamScope scope(&context.globals);
        scope.declare(part->params);
        const Record record = context.read(*part, scope, nullptr, Origin::Config);
        const MaterialFields f = fieldsFrom<MaterialFields>(record);
        MaterialSpec& m = placeFor(context.out.materials, context.materialPlaces, part->name);
        m.name = part->name;
        m.colour = f.colour;
        m.emission = f.emission;
        m.texture = f.texture.value_or("");
        m.textureMap = f.textureMap;
        m.textureScale = f.textureScale;
        m.shininess = f.shininess;
        m.opacity = f.opacity;
        m.range = part->range;
        if (!m.texture.empty()) readTexture(context, m, record.rangeOf("Texture", part->nameRange()));
    }
    context.materialPlaces.try_emplace("default", 0);
}

void resolveSurfaces(ResolveContext& context) {
    context.out.surfaces = {SurfaceSpec{}};
    context.out.surfaces[0].name = "default";
    for (const Part* part : context.outline.surfaces.all()) {
        ParamScope scope(&context.globals);
        scope.declare(part->params);
        const Record record = context.read(*part, scope, nullptr, Origin::Config);
        const SurfaceFields f = fieldsFrom<SurfaceFields>(record);
        if (f.frictionHeading != 0 && !f.friction2 && record.complete)
            context.diagnostics.warning(Code::MissingRequired, record.rangeOf("FrictionHeading", part->nameRange()),
                                        part->title() +
                                            " has a FrictionHeading but no Friction2: its friction is the same in all "
                                            "directions");
        SurfaceSpec& s = placeFor(context.out.surfaces, context.surfacePlaces, part->name);
        s = {part->name,  f.friction,        f.restitution, f.rollingFriction, f.softness,
             part->range, part->nameRange(), f.friction2,   f.frictionHeading};
    }
    context.surfacePlaces.try_emplace("default", 0);
}

} // namespace trundle
