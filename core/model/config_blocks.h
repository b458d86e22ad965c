#pragma once
#include "model/part.h"

namespace trundle {

/// Calls `visit` for the blocks of a config, of a Part for those of its config; of a variant first those of what it is a variant of.
template <class Visit> void eachBlock(const Part& part, const Visit& visit) {
    if (part.config) eachBlock(*part.config, visit);
    for (const Part& inner : part.parts) visit(inner);
}

/// Whether it is a config made from another one.
[[nodiscard]] inline bool isVariant(const Part& part) { return part.config && part.is(Role::Config); }

} // namespace trundle
