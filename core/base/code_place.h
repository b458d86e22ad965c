#pragma once
#include <string>

namespace trundle {

/// A line in the source of a module: where a controller or a device of an author has a fault.
struct CodePlace {
    std::string file; ///< absolute; empty: unknown
    int line = 0;     ///< from 1

    [[nodiscard]] bool isKnown() const { return !file.empty(); }
    bool operator==(const CodePlace&) const = default;
};

} // namespace trundle
