#include "devices/belt.h"

#include <algorithm>
#include <cmath>

namespace trundle {

double RunningSurface::next(Actuation& world, double commanded) {
    const Supply supply = world.supply();
    const double most = m_maxSpeed * (supply.present ? supply.voltage / supply.nominal : 1);
    const double wanted = std::clamp(commanded, -most, most);
    const double step = m_maxAcceleration > 0 ? m_maxAcceleration * world.tick() : HUGE_VAL;
    m_rate += std::clamp(wanted - m_rate, -step, step);
    return m_rate;
}

double RunningSurface::travelled(Sensing& world) {
    m_travel += m_rate * (world.time() > 0 ? double(world.tick()) : 0);
    if (m_power > 0) world.draw(m_power * std::abs(m_rate) / m_maxSpeed);
    return m_travel;
}

void Belt::describe(Describe<Belt>& d) {
    d.help("A conveyor belt: a geom whose surface carries along what lies on it.");
    d.field("Geom", &Belt::m_geomName, reference("Geom").required(), "The geom whose surface runs, along its own x axis.");
    d.field("Heading", &Belt::m_heading, degrees().within(-360, 360),
            "From the geom's x axis, about its z axis, to where it runs.");
    describeRunning(d);
    BeltSignals::describe(d);
}

void Belt::setup(Mount& mount) { m_geom = mount.geom(m_geomName); }

void Belt::act(Actuation& world) {
    const double now = next(world, speed.read(world));
    world.surfaceVelocity(m_geom, now * Vec3(std::cos(m_heading), std::sin(m_heading), 0));
}

void Belt::sense(Sensing& world) {
    travel.set(travelled(world));
    rate.set(runs());
}

void Track::describe(Describe<Track>& d) {
    d.help("The track of a tracked vehicle: geoms on the ground whose surface runs and drives the vehicle.");
    d.field("Geom", &Track::m_geomNames, reference("Geom").required().counted(1, 100),
            "The geoms that are on the ground, each with its x axis forwards and its z axis up.");
    describeRunning(d);
    TrackSignals::describe(d);
}

void Track::setup(Mount& mount) {
    for (const std::string& name : m_geomNames) m_geoms.push_back(mount.geom(name));
}

/// What is below runs backwards while the vehicle goes forwards.
void Track::act(Actuation& world) {
    const double now = next(world, speed.read(world));
    for (const GeomId geom : m_geoms) world.surfaceVelocity(geom, Vec3(-now, 0, 0));
}

void Track::sense(Sensing& world) {
    travel.set(travelled(world));
    rate.set(runs());
}

} // namespace trundle
