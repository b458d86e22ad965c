#pragma once
// The contacts of a tick as an engine reports them: those of units with each other and the scenery, and of all units with the ground.
// Made on demand, of one of several threads.

#include <span>
#include <vector>

#include "base/on_demand.h"
#include "world/wheeled/unit_contacts.h"

namespace trundle {

class ContactList {
public:
    ContactList(const WheeledObjects& objects, const UnitContacts& contacts) : m_objects(objects), m_contacts(contacts) {}

    /// After a tick of h seconds.
    void clear(double h) {
        for (OnDemand* each : {&m_making, &m_filing, &m_linking}) each->markDue();
        m_h = h;
    }
    [[nodiscard]] const std::vector<EngineContact>& all() const;
    /// By an index of of().
    [[nodiscard]] EngineContact at(std::uint32_t index) const;
    /// Indices of the contacts of a geom, ascending. Those of a geom that the ground does not touch are found without the list of all. Valid until
    /// the thread asks again, and until the next tick.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t geom) const;

private:
    static constexpr std::uint32_t kAmongUnits = 0x80000000u; ///< and more: a point of a contact among units
    static constexpr std::uint32_t kMostPoints = 4, kNone = 0xffffffffu;
    /// Of the list of a geom's contacts among units; in this round.
    struct Head {
        std::uint64_t round = 0;
        std::uint32_t contact = kNone;
    };
    struct Next {
        std::uint32_t ofA = kNone, ofB = kNone;
    };

    /// What is only near carries nothing, and is no contact for others.
    [[nodiscard]] static bool carries(const UnitContactPoint& point) { return point.gap <= 0 || point.normal > 0; }
    [[nodiscard]] EngineContact contactOf(const UnitContact& contact, const UnitContactPoint& point) const;
    [[nodiscard]] std::span<const std::uint32_t> amongUnits(std::uint32_t unit, std::uint32_t geom) const;
    void make() const;
    void link() const;
    void file() const;
    void addUnit(const UnitContact& contact, std::vector<EngineContact>& to) const;
    void addGround(std::uint32_t unit) const;
    void addSupports(std::uint32_t unit) const;

    const WheeledObjects& m_objects;
    const UnitContacts& m_contacts;
    double m_h = 1;
    mutable OnDemand m_making{false}, m_filing, m_linking; ///< nothing touches before the first tick
    mutable std::vector<EngineContact> m_all;
    mutable std::vector<Head> m_heads; ///< by geom
    mutable std::vector<Next> m_next;  ///< by contact of m_contacts
    mutable std::uint64_t m_round = 0;
    mutable std::vector<std::uint32_t> m_begin, m_byGeom; ///< m_begin: by geom
};

} // namespace trundle
