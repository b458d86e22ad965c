#include "scene/led_lights.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include <osg/Uniform>

namespace trundle {
namespace {

constexpr double kLightOfCandela = 1e-3; // light of 1 is 1000 lx at 1 m, as of a Lamp
constexpr float kFaint = 1e-5f;          // light at 1 m that is not seen on a surface 5 cm away

/// How bright a Led is, and how narrow its beam.
struct LedBeam {
    double candela = 1, narrowness = 0;
};

/// In the order of ledsOf(), by the names that the kind Led declares.
std::vector<LedBeam> beamsOf(const ExperimentSpec& experiment) {
    std::vector<LedBeam> beams;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Led") continue;
            LedBeam& beam = beams.emplace_back();
            beam.candela = device.number("Intensity", beam.candela);
            if (const double half = device.number("HalfAngle"); half > 0)
                beam.narrowness = -std::log(2.0) / std::log(std::cos(half));
        }
    }
    return beams;
}

struct ChosenLed {
    double seen = 0; ///< from the eye
    osg::Vec3 place, light;
    osg::Vec4 beam;
};

osg::Uniform* arrayOf(osg::StateSet& root, const char* name, osg::Uniform::Type type) {
    return root.getOrCreateUniform(name, type, static_cast<unsigned>(LedLights::kMost));
}

} // namespace

void LedLights::make(const ExperimentSpec& experiment, const std::vector<LedModel>& leds,
                     std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies) {
    const std::vector<LedBeam> beams = beamsOf(experiment);
    for (std::size_t i = 0; i < leds.size(); ++i) {
        const LedModel& led = leds[i];
        Source& source = m_sources.emplace_back();
        source.shown = led.atStart;
        if (led.body >= bodies.size() || !led.mounting.position.allFinite()) continue;
        source.body = bodies[led.body];
        const Vec3 axis = led.mounting.rotation * Vec3::UnitX();
        source.place.set(led.mounting.position.x(), led.mounting.position.y(), led.mounting.position.z());
        source.axis.set(axis.x(), axis.y(), axis.z());
        source.candela = beams[i].candela;
        source.narrowness = beams[i].narrowness;
    }
}

void LedLights::set(std::span<const LedColour> colours) {
    if (colours.size() != m_sources.size()) return;
    for (std::size_t i = 0; i < colours.size(); ++i) m_sources[i].shown = colours[i];
}

bool LedLights::apply(const Vec3& eye, osg::StateSet& root) const {
    std::vector<ChosenLed> chosen;
    for (const Source& source : m_sources) {
        const auto most = *std::ranges::max_element(source.shown);
        if (!source.body || !(kLightOfCandela * source.candela * most * most > kFaint)) continue;
        const osg::Matrix& body = source.body->getMatrix();
        const osg::Vec3d place = source.place * body, axis = osg::Matrix::transform3x3(source.axis, body);
        ChosenLed& led = chosen.emplace_back();
        for (unsigned k = 0; k < 3; ++k)
            led.light[k] = static_cast<float>(kLightOfCandela * source.candela) * source.shown[k] * source.shown[k];
        led.place = place;
        led.beam = osg::Vec4(osg::Vec3(axis), static_cast<float>(source.narrowness));
        led.seen = source.candela * most / (0.01 + (place - osg::Vec3d(eye.x(), eye.y(), eye.z())).length2());
    }
    root.removeDefine("LED_BEAMS");
    root.removeDefine("LEDS");
    if (chosen.empty()) return false;
    std::ranges::stable_sort(chosen, std::greater(), &ChosenLed::seen);
    // A program is compiled for each number of them, so there are few of these.
    const std::size_t count = std::bit_ceil(std::min(chosen.size(), kMost));
    chosen.resize(count);
    root.setDefine("LEDS", std::to_string(count));
    if (std::ranges::any_of(chosen, [](const ChosenLed& led) { return led.beam.w() > 0; }))
        root.setDefine("LED_BEAMS"); // apart, since powers take most of the time
    osg::Uniform *places = arrayOf(root, "ledPlace", osg::Uniform::FLOAT_VEC3),
                 *lights = arrayOf(root, "ledLight", osg::Uniform::FLOAT_VEC3),
                 *beams = arrayOf(root, "ledBeam", osg::Uniform::FLOAT_VEC4);
    for (unsigned i = 0; i < count; ++i) {
        places->setElement(i, chosen[i].place);
        lights->setElement(i, chosen[i].light);
        beams->setElement(i, chosen[i].beam);
    }
    return true;
}

} // namespace trundle
