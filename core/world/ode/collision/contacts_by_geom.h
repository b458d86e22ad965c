#pragma once
// Which contacts each geom has. Made on demand, by one of several threads, since most worlds never need it.

#include <span>
#include <vector>

#include "base/on_demand.h"
#include "world/ode/objects/ode_records.h"

namespace trundle {

class ContactsByGeom {
public:
    /// Indices of the contacts of one geom, ascending. The contacts are those since the last `clear`.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t geom, std::size_t geoms, std::span<const OdeContact> contacts);
    void clear() { m_sorting.markDue(); }

private:
    void sort(std::size_t geoms, std::span<const OdeContact> contacts);

    std::vector<std::uint32_t> m_begin, m_contacts; ///< m_begin: by geom
    OnDemand m_sorting;
};

} // namespace trundle
