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
        m_ready = m_filed = m_amongReady = false;
        m_h = h;
    }
    [[nodiscard]] const std::vector<EngineContact>& all() const;
    /// By an index of of().
    [[nodiscard]] const EngineContact& at(std::uint32_t index) const {
        return index < kAmongUnits ? all()[index] : m_among[index - kAmongUnits];
    }
    /// Indices of the contacts of a geom, ascending. Those of a geom that the ground does not touch are found without the list of all.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t geom) const;

private:
    static constexpr std::uint32_t kAmongUnits = 0x80000000u; ///< added to the indices of m_among

    [[nodiscard]] std::span<const std::uint32_t> amongUnits(std::uint32_t unit, std::uint32_t geom) const;
    void make() const;
    void makeAmong() const;
    void file() const;
    void addUnit(const UnitContact& contact, std::vector<EngineContact>& to) const;
    void addGround(std::uint32_t unit) const;
    void addSupports(std::uint32_t unit) const;

    const WheeledObjects& m_objects;
    const UnitContacts& m_contacts;
    double m_h = 1;
    mutable bool m_ready = false, m_filed = false, m_amongReady = false;
    mutable std::vector<EngineContact> m_all, m_among; ///< m_among: without those with the ground
    mutable std::vector<IndexPair> m_amongOf;          ///< sorted: unit, index in m_among
    mutable std::vector<std::uint32_t> m_found;
    mutable std::vector<std::uint32_t> m_begin, m_byGeom; ///< m_begin: by geom
};

} // namespace trundle
