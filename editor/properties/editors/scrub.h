#pragma once
// Changing a number by dragging: step size and formatting.

#include <optional>
#include <string>

#include "schema/kind.h"

namespace trundle {

/// Drag state of a value that is a plain number, with or without a unit.
class Scrub {
public:
    /// Nothing if the text is not a single number, for example a formula. `property` may be null (a Param).
    [[nodiscard]] static std::optional<Scrub> of(const std::string& element, const Property* property);

    /// The text after this many steps, in the same unit, clamped to the property's range.
    [[nodiscard]] std::string after(double steps) const;
    [[nodiscard]] double step() const { return m_step; }

private:
    double m_number = 0, m_step = 0.01;
    double m_low = 0, m_high = 0; ///< in the unit of the text
    int m_decimals = 2;
    std::string m_behind; ///< blank and unit
};

} // namespace trundle
