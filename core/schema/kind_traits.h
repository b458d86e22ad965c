#pragma once
// What the table of a kind says of itself, whatever interface its module was built for.

#include <cstddef>

#include <trundle/abi.h>

namespace trundle {

/// Its calls use nothing that robots share, so that they may come at the same time as those of other robots.
[[nodiscard]] inline bool isIndependent(const TrundleKind& kind) {
    return kind.size >= offsetof(TrundleKind, traits) + sizeof kind.traits && (kind.traits & TRUNDLE_INDEPENDENT) != 0;
}

} // namespace trundle
