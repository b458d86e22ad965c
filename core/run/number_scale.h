#pragma once
// Numbers that change many times a second, written so that their digits stay where they are.

#include <string>

namespace trundle {

/// Unit prefix and decimals of one quantity. They follow the largest magnitude noted so far, and so change seldom and never back.
class NumberScale {
public:
    enum class Kind { Real, Whole };
    /// `unit`: SI; "rad" is shown as degrees.
    explicit NumberScale(std::string unit = {}, Kind kind = Kind::Real);

    void note(double value);
    /// At most about 4 significant digits of the largest; "not a number" for NaN, "infinite" for infinities.
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
