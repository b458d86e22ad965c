#pragma once
// What is in an engine, as others refer to it.

#include <cstdint>

namespace trundle {

/// An object of the engine by its index. Nothing is removed, so a valid handle stays valid.
template <class Tag> struct Handle {
    std::uint32_t index = 0xffffffffu;
    [[nodiscard]] bool valid() const { return index != 0xffffffffu; }
    bool operator==(const Handle&) const = default;
};
using ActorHandle = Handle<struct ActorTag>;
using BodyHandle = Handle<struct BodyTag>;
using JointHandle = Handle<struct JointTag>;
using GeomHandle = Handle<struct GeomTag>;
using CouplingHandle = Handle<struct CouplingTag>;

inline constexpr std::uint32_t kNoActor = 0xffffffffu; ///< partner of a contact with a static

} // namespace trundle
