#include "devices/touch_sensor.h"

namespace trundle {

void TouchSensor::describe(Describe<TouchSensor>& d) {
    d.help("Detects contacts of geoms.");
    d.field("Geom", &TouchSensor::m_geomPaths, reference("Geom").required().counted(1, 1000),
            "The geoms whose contacts it detects, body.geom.");
    d.field("MinForce", &TouchSensor::m_minForceN, newtons().atLeast(0), "Weaker contacts are ignored.");
    TouchSensorSignals::describe(d);
}

void TouchSensor::setup(Mount& mount) {
    for (const std::string& path : m_geomPaths) m_geoms.push_back(mount.geom(path));
    m_contacts.reserve(8);
}

void TouchSensor::sense(Sensing& world) {
    double sumN = 0;
    std::size_t points = 0;
    for (const GeomId geom : m_geoms) {
        world.contacts(geom, m_contacts);
        points += m_contacts.size();
        for (const TrundleContact& contact : m_contacts) sumN += std::abs(contact.force);
    }
    pressed.set(points > 0 && sumN >= m_minForceN);
    force.set(sumN);
    count.set(static_cast<double>(points));
}

} // namespace trundle
