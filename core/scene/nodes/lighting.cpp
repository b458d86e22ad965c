#include "scene/nodes/lighting.h"

#include "model/kinds/world_fields.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {
namespace {

osg::Vec3 tripleFrom(const ComponentSpec& spec, std::string_view key, const osg::Vec3& otherwise) {
    const ResolvedValue* value = spec.find(key);
    if (!value || value->value.numbers.size() != 3) return otherwise;
    const auto& n = value->value.numbers;
    return {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])};
}

/// Converts a display colour to linear light (gamma 2).
osg::Vec3 squared(const osg::Vec3& c) { return {c.x() * c.x(), c.y() * c.y(), c.z() * c.z()}; }

osg::Vec3 lightFrom(const ComponentSpec& spec) {
    return squared(tripleFrom(spec, "ColorRGB", {1, 1, 1})) * static_cast<float>(spec.number("Intensity", 1));
}

} // namespace

osg::Vec3 sunDirection() {
    osg::Vec3 sun(-0.52f, -0.30f, 0.80f);
    sun.normalize();
    return sun;
}

Lighting::Lighting() : sun(sunDirection()) {}

osg::Vec3 Lighting::on(const osg::Vec3& normal) const {
    const float up = 0.5f + 0.5f * normal.z();
    return groundLight * (1 - up) + skyLight * up + sunLight * std::max(0.f, normal * sun);
}

float Lighting::sunShare(const osg::Vec3& normal) const {
    const osg::Vec3 own = sunLight * std::max(0.f, normal * sun), all = on(normal);
    const float whole = all.x() + all.y() + all.z();
    return whole > 0 ? (own.x() + own.y() + own.z()) / whole : 0;
}

void Lighting::applyTo(osg::StateSet& root) const {
    // The glow fades with a dim sun or sky, but never exceeds the default.
    const auto share = [](const osg::Vec3& of, const osg::Vec3& whole) {
        return std::min(1.f, (of.x() + of.y() + of.z()) / (whole.x() + whole.y() + whole.z()));
    };
    const Lighting usual;
    root.addUniform(new osg::Uniform("sunGlow", osg::Vec3(0.10f, 0.085f, 0.06f) * share(sunLight, usual.sunLight)));
    root.addUniform(new osg::Uniform("skyBelow", osg::Vec3(0.47f, 0.49f, 0.51f) * share(horizon, usual.horizon)));
    for (const auto& [name, value] : {std::pair{"sunWay", sun},
                                      {"sunLight", sunLight},
                                      {"skyLight", skyLight},
                                      {"groundLight", groundLight},
                                      {"horizonColour", horizon},
                                      {"zenithColour", zenith}})
        root.addUniform(new osg::Uniform(name, value));
    root.removeDefine("LAMPS");
    if (lamps.empty()) return;
    const auto count = static_cast<int>(lamps.size());
    root.setDefine("LAMPS", std::to_string(count));
    osg::ref_ptr<osg::Uniform> places = new osg::Uniform(osg::Uniform::FLOAT_VEC3, "lampPlace", count);
    osg::ref_ptr<osg::Uniform> lights = new osg::Uniform(osg::Uniform::FLOAT_VEC3, "lampLight", count);
    for (unsigned i = 0; i < lamps.size(); ++i) {
        places->setElement(i, lamps[i].place);
        lights->setElement(i, lamps[i].light);
    }
    root.addUniform(places);
    root.addUniform(lights);
}

Lighting lightingOf(const ExperimentSpec& experiment) {
    Lighting lighting;
    bool hasSun = false;
    for (const ComponentSpec& spec : experiment.looks) {
        if (spec.kind == "Sky") {
            lighting.zenith = tripleFrom(spec, "Zenith", lighting.zenith);
            lighting.horizon = tripleFrom(spec, "Horizon", lighting.horizon);
            const auto ambient = static_cast<float>(spec.number("Ambient", 1));
            lighting.skyLight *= ambient;
            lighting.groundLight *= ambient;
        } else if (spec.kind == "Light" && spec.text("Mode") == "lamp") {
            if (lighting.lamps.size() < kMaxLamps)
                lighting.lamps.push_back({tripleFrom(spec, "Pos", {0, 0, 2}), lightFrom(spec), spec.number("Shadows", 1) != 0});
        } else if (spec.kind == "Light" && !hasSun) {
            hasSun = true;
            osg::Vec3 away = tripleFrom(spec, "Direction", -lighting.sun);
            if (away.normalize() > 0) lighting.sun = -away;
            lighting.sunLight = lightFrom(spec);
            lighting.shadows = spec.number("Shadows", 1) != 0;
        }
    }
    return lighting;
}

} // namespace trundle
