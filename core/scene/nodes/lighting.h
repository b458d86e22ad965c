#pragma once
// Lighting of an experiment: the sun, sky and lamps of its text, or defaults.

#include <vector>

#include <osg/StateSet>
#include <osg/Vec3>

#include "model/experiment_spec.h"

namespace trundle {

struct Lamp {
    osg::Vec3 place;
    osg::Vec3 light; ///< linear RGB at a distance of 1 m
    bool shadows = true;
};

/// Light is linear RGB; the colours of the sky are display colours.
struct Lighting {
    osg::Vec3 sun; ///< unit vector towards the sun, in world coordinates
    osg::Vec3 sunLight{0.98f, 0.94f, 0.86f}, skyLight{0.36f, 0.395f, 0.45f}, groundLight{0.19f, 0.185f, 0.18f};
    osg::Vec3 horizon{0.815f, 0.865f, 0.905f}, zenith{0.265f, 0.480f, 0.765f};
    bool shadows = true; ///< cast by the sun
    std::vector<Lamp> lamps;

    Lighting();
    /// Irradiance of an unobstructed surface with this normal from sun and sky; sunShare() is the sun's fraction of it.
    [[nodiscard]] osg::Vec3 on(const osg::Vec3& normal) const;
    [[nodiscard]] float sunShare(const osg::Vec3& normal) const;
    /// Sets the uniforms of the GLSL programs.
    void applyTo(osg::StateSet& root) const;
};

[[nodiscard]] Lighting lightingOf(const ExperimentSpec& experiment);

} // namespace trundle
