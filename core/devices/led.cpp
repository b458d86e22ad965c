#include "devices/led.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kCandela = 1e-3; // light of 1 is 1000 lx at 1 m, as LightSensor says

/// Rec. 709 luminance of a display colour, whose light is its square.
double luminanceOf(double red, double green, double blue) {
    return 0.2126 * red * red + 0.7152 * green * green + 0.0722 * blue * blue;
}

} // namespace

void Led::describe(Describe<Led>& d) {
    d.help("Shines: cameras see its lens, light sensors its light.");
    d.field("Body", &Led::m_bodyName, reference("Body").required(), "The body it is fixed to.");
    d.field("Pos", &Led::m_position, metres().within(-1e5, 1e5), "Position of its lens in the body.");
    d.field("HPR", &Led::m_hpr, degrees().within(-1e6, 1e6), "Heading, pitch and roll in the body; its axis is along x.");
    d.field("ColorRGB", &Led::m_color, number().within(0, 1), "At the start; the command color changes it.");
    d.field("Intensity", &Led::m_intensity, unitOf("cd").within(0, 1e9).live(),
            "Along its axis if it is white; other colours have the share of it that the eye sees of them.");
    d.field("HalfAngle", &Led::m_halfAngle, degrees().within(1, 89),
            "Off its axis at which it is half as bright; not given: it shines all around.");
    d.field("Diameter", &Led::m_diameter, metres().within(0, 100), "Of its lens, as cameras see it; 0: none.");
    d.field("On", &Led::m_on, flag(), "At the start; the command on changes it.");
    d.field("Power", &Led::m_power, unitOf("W").within(0, 1e6), "That it draws from the robot's Battery while it shines.");
    LedSignals::describe(d);
}

/// Intensity by the cosine of the angle to a power, after Moreno and Sun, "Modeling the radiation pattern of LEDs", Optics Express 16
/// (2008), eq. 1: m = -ln 2 / ln cos(half angle).
void Led::setup(Mount& mount) {
    m_body = mount.body(m_bodyName);
    const Vec3 axis = rotationFromHpr(Vec3(m_hpr.data())) * Vec3::UnitX();
    m_beam = {
        {axis.x(), axis.y(), axis.z()}, m_halfAngle ? -std::log(2.0) / std::log(std::cos(*m_halfAngle)) : 0, m_diameter / 2};
    on.set(m_on);
    for (std::uint32_t i = 0; i < 3; ++i) color.set(i, m_color[i]);
}

void Led::act(Actuation& world) {
    m_shines = on.read(world) != 0 && world.supply().powered();
    const auto share = [this](std::uint32_t i) { return std::isfinite(color.get(i)) ? std::clamp(color.get(i), 0.0, 1.0) : 0.0; };
    const double light = m_shines ? kCandela * m_intensity * luminanceOf(share(0), share(1), share(2)) : 0;
    world.emitLight(m_body, Vec3(m_position.data()), light, m_beam);
}

void Led::sense(Sensing& world) {
    lit.set(m_shines);
    if (m_shines && m_power > 0) world.draw(m_power);
}

} // namespace trundle
