#include "devices/touch_sensor.h"

namespace trundle {

void TouchSensor::describe(Describe<TouchSensor>& d) {
    d.help("Detects contacts of geoms.").independent();
    d.field("Geom", &TouchSensor::m_geomPaths, reference("Geom").required().counted(1, 1000),
            "The geoms whose contacts it detects, body.geom.");
    d.field("MinForce", &TouchSensor::m_minForceN, newtons().atLeast(0), "Weaker contacts are ignored.");
    d.field("ReleaseForce", &TouchSensor::m_releaseForceN, newtons().atLeast(0),
            "Once pressed, it stays so until the force falls below this; not given: MinForce.");
    TouchSensorSignals::describe(d);
}

void TouchSensor::setup(Mount& mount) {
    if (m_releaseForceN && *m_releaseForceN > m_minForceN)
        mount.fail("ReleaseForce is above MinForce: it would not stay pressed");
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
    m_isPressed = points > 0 && sumN >= (m_isPressed ? m_releaseForceN.value_or(m_minForceN) : m_minForceN);
    pressed.set(m_isPressed);
    force.set(sumN);
    count.set(static_cast<double>(points));
}

} // namespace trundle
