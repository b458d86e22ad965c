#pragma once
#include "model/part.h"

namespace trundle {

/// Calls `visit` for the blocks of a config, of a Part for those of its config; of a variant first those of what it is a variant of.
template <class Visit> void eachBlock(const Part& part, const Visit& visit) {
    if (part.config) eachBlock(*part.config, visit);
    for (const Part& inner : part.parts) visit(inner);
}

/// Whether a key of a config is most likely Config, misspelt: it is reported.
[[nodiscard]] bool hasMisspeltConfig(const Part& config);

/// Whether a config is a variant of one that is unknown, or of itself in a circle, so that what it has is not known; it is reported.
[[nodiscard]] inline bool isBaseMissing(const Part& config) {
    const Part* base = &config;
    while (base->config) base = base->config;
    return base->is(Role::Config) && (base->assignments.find("Config") || hasMisspeltConfig(*base));
}

/// Whether the Config of a Part is computed: which one it is, and what it has, depends on values that an instance gives.
[[nodiscard]] bool isConfigComputed(const Part& part);

/// Whether it is a config made from another one.
[[nodiscard]] inline bool isVariant(const Part& part) { return part.config && part.is(Role::Config); }

} // namespace trundle
