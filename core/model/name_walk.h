#pragma once
#include <cstddef>
#include <string>

#include "model/part.h"

namespace trundle {

/// Visits what can be named in a config, for lists of names: its blocks, those of its Parts, "left.wheel", and of the first
/// members of its Repeats, "roller_0.axle", and the geoms of bodies, "chassis.bumper". Parts can multiply to very many blocks, so
/// of those only the first `most` are visited.
class NameWalk {
public:
    explicit NameWalk(std::size_t most) : m_left(most) {}

    /// Calls `visit(part, prefix)` for each block inside, in the order of the text; its name there is prefix + part.name. Enters
    /// a Part, Repeat or body for which that is true.
    template <class Visit> void inside(const Part& holder, const std::string& prefix, const Visit& visit) {
        walk(holder, prefix, false, visit);
    }

private:
    template <class Visit> void walk(const Part& holder, const std::string& prefix, bool inPart, const Visit& visit) {
        if (holder.config) walk(*holder.config, prefix, inPart, visit);
        for (const Part& part : holder.parts) {
            if (inPart && m_left == 0) return;
            if (inPart) --m_left;
            if (!visit(part, prefix)) continue;
            if (part.isRepeat()) walk(part, prefix + part.name + "_0.", inPart, visit);
            else if (part.config || part.is(Role::Body)) walk(part, prefix + part.name + ".", inPart || part.config, visit);
        }
    }

    std::size_t m_left; ///< blocks in Parts that are still visited
};

} // namespace trundle
