#include "model/lighting_spec.h"

#include "model/kinds/world_fields.h"

namespace trundle {
namespace {

Triple tripleFrom(const ComponentSpec& spec, std::string_view key, const Triple& otherwise) {
    const ResolvedValue* value = spec.find(key);
    if (!value || value->value.numbers.size() != 3) return otherwise;
    const auto& n = value->value.numbers;
    return {n[0], n[1], n[2]};
}

Triple scaled(const Triple& light, double factor) { return {light[0] * factor, light[1] * factor, light[2] * factor}; }

/// Converts a display colour to linear light (gamma 2).
Triple lightFrom(const ComponentSpec& spec) {
    const Triple c = tripleFrom(spec, "ColorRGB", {1, 1, 1});
    return scaled({c[0] * c[0], c[1] * c[1], c[2] * c[2]}, spec.number("Intensity", 1));
}

Vec3 vectorOf(const Triple& t) { return {t[0], t[1], t[2]}; }

} // namespace

LightingSpec lightingSpecOf(const ExperimentSpec& experiment) {
    LightingSpec lighting;
    bool hasSun = false;
    for (const ComponentSpec& spec : experiment.looks) {
        if (spec.kind == "Sky") {
            lighting.zenith = tripleFrom(spec, "Zenith", lighting.zenith);
            lighting.horizon = tripleFrom(spec, "Horizon", lighting.horizon);
            const double ambient = spec.number("Ambient", 1);
            lighting.sky = scaled(lighting.sky, ambient);
            lighting.ground = scaled(lighting.ground, ambient);
        } else if (spec.kind == "Light" && spec.text("Mode") == "lamp") {
            if (lighting.lamps.size() < kMaxLamps)
                lighting.lamps.push_back(
                    {vectorOf(tripleFrom(spec, "Pos", {0, 0, 2})), lightFrom(spec), spec.number("Shadows", 1) != 0});
        } else if (spec.kind == "Light" && !hasSun) {
            hasSun = true;
            const Vec3 away = vectorOf(tripleFrom(spec, "Direction", {0, 0, 0}));
            if (away.norm() > 0) lighting.toSun = -away.normalized();
            lighting.sun = lightFrom(spec);
            lighting.sunShadows = spec.number("Shadows", 1) != 0;
        }
    }
    return lighting;
}

} // namespace trundle
