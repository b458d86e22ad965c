#pragma once
// The contacts of a tick as an engine reports them: those of units with each other and the scenery, and of all units with the ground.
// Made on demand.

#include <span>
#include <vector>

#include "world/wheeled/unit_contacts.h"

namespace trundle {

class ContactList {
public:
    ContactList(const WheeledObjects& objects, const UnitContacts& contacts) : m_objects(objects), m_contacts(contacts) {}

    /// After a tick of h seconds.
    void clear(double h) {
        m_ready = m_filed = false;
        m_h = h;
    }
    [[nodiscard]] const std::vector<EngineContact>& all() const;
    /// Indices of the contacts of a geom, ascending.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t geom) const;

private:
    [[nodiscard]] bool touchesNothing(std::uint32_t geom) const;
    void make() const;
    void file() const;
    void addUnit(const UnitContact& contact) const;
    void addGround(std::uint32_t unit) const;
    void addSupports(std::uint32_t unit) const;

    const WheeledObjects& m_objects;
    const UnitContacts& m_contacts;
    double m_h = 1;
    mutable bool m_ready = false, m_filed = false;
    mutable std::vector<EngineContact> m_all;
    mutable std::vector<std::uint32_t> m_begin, m_byGeom; ///< m_begin: by geom
};

} // namespace trundle
