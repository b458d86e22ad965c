#include "scene/nodes/lighting.h"

#include "model/lighting_spec.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {
namespace {

osg::Vec3 vectorOf(const std::array<double, 3>& t) {
    return {static_cast<float>(t[0]), static_cast<float>(t[1]), static_cast<float>(t[2])};
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
    // What bodies reflect of the sky low down fades with the light of the sky, which may be less than its colour says.
    osg::Vec3 horizonShine = osg::componentMultiply(horizon, horizon) * share(skyLight, usual.skyLight);
    for (const auto& [name, value] : {std::pair{"sunWay", sun},
                                      {"horizonShine", horizonShine},
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
    const LightingSpec spec = lightingSpecOf(experiment);
    Lighting lighting;
    lighting.sun =
        osg::Vec3(static_cast<float>(spec.toSun.x()), static_cast<float>(spec.toSun.y()), static_cast<float>(spec.toSun.z()));
    lighting.sunLight = vectorOf(spec.sun);
    lighting.skyLight = vectorOf(spec.sky);
    lighting.groundLight = vectorOf(spec.ground);
    lighting.horizon = vectorOf(spec.horizon);
    lighting.zenith = vectorOf(spec.zenith);
    lighting.shadows = spec.sunShadows;
    for (const LampSpec& lamp : spec.lamps)
        lighting.lamps.push_back({osg::Vec3(static_cast<float>(lamp.position.x()), static_cast<float>(lamp.position.y()),
                                            static_cast<float>(lamp.position.z())),
                                  vectorOf(lamp.light), lamp.shadows});
    return lighting;
}

} // namespace trundle
