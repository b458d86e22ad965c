#include "devices/touch_sensor.h"

namespace trundle {

void TouchSensor::describe(Describe<TouchSensor>& d) {
    d.help("Detects contacts of geoms.");
    d.field("Geom", &TouchSensor::m_geomPaths, reference("Geom").required().counted(1, 1000),
            "The geoms whose contacts it detects, body.geom.");
    d.field("MinForce", &TouchSensor::m_minForceN, newtons().atLeast(0), "Weaker contacts are ignored.");
    d.output("pressed", "", "Something touches.", 1, TRUNDLE_BOOLEAN_SIGNAL);
    d.output("force", "N", "Sum of the contacts' normal forces.");
    d.output("count", "", "Contact points.", 1, TRUNDLE_INTEGER_SIGNAL);
}

void TouchSensor::setup(Mount& mount) {
    for (const std::string& path : m_geomPaths) m_geoms.push_back(mount.geom(path));
    m_pressed = mount.signal("pressed");
    m_force = mount.signal("force");
    m_count = mount.signal("count");
    m_contacts.reserve(8);
}

void TouchSensor::sense(Sensing& world) {
    double force = 0;
    std::size_t count = 0;
    for (const GeomId geom : m_geoms) {
        world.contacts(geom, m_contacts);
        count += m_contacts.size();
        for (const TrundleContact& contact : m_contacts) force += std::abs(contact.force);
    }
    m_pressed.set(count > 0 && force >= m_minForceN);
    m_force.set(force);
    m_count.set(static_cast<double>(count));
}

} // namespace trundle
