#pragma once
// A number changed by dragging: which step, which text.

#include <optional>
#include <string>

#include "schema/kind.h"

namespace trundle {

/// An element that is a plain number, with or without a unit: what dragging makes of it.
class Scrub {
public:
    /// Nothing where the text is no single number: a formula, say. `property` may be missing (a Param).
    [[nodiscard]] static std::optional<Scrub> of(const std::string& element, const Property* property);

    /// The text after so many steps, in the unit that was there, kept within the property's range.
    [[nodiscard]] std::string after(double steps) const;
    [[nodiscard]] double step() const { return m_step; }

private:
    double m_number = 0, m_step = 0.01;
    double m_low = 0, m_high = 0; ///< in the unit of the text
    int m_decimals = 2;
    std::string m_behind; ///< blank and unit
};

} // namespace trundle
