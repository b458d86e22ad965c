#pragma once
// Formats rapidly changing numbers so that their digits keep their positions.

#include <string>

namespace trundle {

/// Unit prefix and decimals of one quantity. They follow the largest magnitude so far, so they change rarely and never back.
class NumberScale {
public:
    enum class Kind { Real, Whole };
    /// `unit`: SI unit; "rad" is shown in degrees.
    explicit NumberScale(std::string unit = {}, Kind kind = Kind::Real);

    void note(double value);
    /// With about 4 significant digits of the largest magnitude; "not a number" for NaN, "infinite" for infinities.
    [[nodiscard]] std::string text(double value) const;
    [[nodiscard]] const std::string& unit() const { return m_shownUnit; } ///< with its prefix: "mA", "°"

private:
    void choose();

    std::string m_unit, m_shownUnit;
    Kind m_kind;
    double m_largest = 0, m_factor = 1;
    int m_decimals = 0;
};

} // namespace trundle
