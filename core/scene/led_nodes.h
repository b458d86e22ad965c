#pragma once
// The lenses of Leds in a scene: spheres on their bodies, which shine in their colour or are dark.

#include <span>
#include <vector>

#include <osg/Geometry>
#include <osg/MatrixTransform>

#include "scene/queries/led_model.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {

class LedNodes {
public:
    /// Adds a lens to its body for each Led that has one.
    void make(const std::vector<LedModel>& leds, std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies,
              const SceneShading& look);
    /// Ignored unless there is one colour for each Led.
    void set(std::span<const LedColour> colours);

private:
    struct Lens {
        osg::ref_ptr<osg::Geometry> shape; ///< null: not seen
        LedColour own{}, shown{};
    };
    static void paint(const Lens& lens);
    std::vector<Lens> m_lenses; ///< in the order of ledsOf()
};

} // namespace trundle
