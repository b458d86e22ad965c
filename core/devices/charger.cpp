#include "devices/charger.h"

namespace trundle {

void Charger::describe(Describe<Charger>& d) {
    d.help("Charges the batteries of robots whose Contact touches it.");
    d.field("Geom", &Charger::m_geomPaths, reference("Geom").required().counted(1, 1000), "Its contacts, body.geom.");
    d.field("Voltage", &Charger::m_voltage, volts().above(0).atMost(1e6).required().live(),
            "At which it stops to raise the voltage of a battery, and its current falls: 4.2 V for each LiIon cell.");
    d.field("MaxCurrent", &Charger::m_maxCurrent, amperes().within(0, 1e6).required().live(),
            "With which it charges until then; all batteries at it share it.");
    ChargerSignals::describe(d);
}

void Charger::setup(Mount& mount) {
    for (const std::string& path : m_geomPaths) m_geoms.push_back(mount.geom(path));
    voltage.set(m_voltage);
}

void Charger::act(Actuation& world) {
    const double most = world.supply().powered() ? m_maxCurrent : 0;
    for (const GeomId geom : m_geoms) world.offerPower(geom, m_voltage, most);
}

void Charger::sense(Sensing& world) {
    const TrundleTaken taken = world.taken();
    connected.set(taken.takers > 0);
    current.set(taken.amperes);
    voltage.set(taken.amperes > 0 ? taken.watts / taken.amperes : m_voltage);
    energy.set(energy.get() + taken.watts * world.tick());
}

} // namespace trundle
