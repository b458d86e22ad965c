#pragma once
// The light of Leds on what is around them: a few small lamps without shadows.

#include <span>
#include <vector>

#include <osg/MatrixTransform>
#include <osg/StateSet>

#include "scene/queries/led_model.h"

namespace trundle {

class LedLights {
public:
    /// At most so many light a picture.
    static constexpr std::size_t kMost = 4;

    /// `leds` are those of the experiment, `bodies` in the order of BodyPoses.
    void make(const ExperimentSpec& experiment, const std::vector<LedModel>& leds,
              std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies);
    /// Ignored unless there is one colour for each Led.
    void set(std::span<const LedColour> colours);
    /// Sets the uniforms of the scene for a picture from `eye` (world frame, m): those Leds that are brightest from there, of equal ones the
    /// first. While none shines, the scene is drawn without any of this, and it returns false.
    bool apply(const Vec3& eye, osg::StateSet& root) const;

private:
    struct Source {
        osg::ref_ptr<osg::MatrixTransform> body; ///< null: it lights nothing
        osg::Vec3d place, axis;                  ///< in its body
        double candela = 0, narrowness = 0;      ///< narrowness: exponent of the cosine to its axis; 0: it shines all around
        LedColour shown{};
    };
    std::vector<Source> m_sources; ///< in the order of ledsOf()
};

} // namespace trundle
