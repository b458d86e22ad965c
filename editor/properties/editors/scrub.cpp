#include "editor/properties/editors/scrub.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

/// A step that changes the second or third digit.
double stepFor(double number, double low, double high) {
    const bool share = std::isfinite(low) && std::isfinite(high) && high - low <= 1;
    if (share) return 0.01;
    if (number == 0) return high > 0 && high < 1 ? high / 100 : 0.01;
    return std::pow(10.0, std::clamp(std::floor(std::log10(std::abs(number))) - 1, -9.0, 9.0));
}

/// Number of decimals; keeps those already written.
int decimalsOf(double number) {
    const std::string text = plainNumber(number);
    const std::size_t point = text.find('.');
    return point == std::string::npos ? 0 : std::min(12, static_cast<int>(text.size() - point - 1));
}

} // namespace

std::optional<Scrub> Scrub::of(const std::string& element, const Property* property) {
    const ParsedValue value(element);
    const std::vector<Element>& elements = value.value().elements;
    if (elements.size() != 1 || elements[0].kind != Element::Kind::Number) return std::nullopt;
    const Element& e = elements[0];
    Scrub scrub;
    scrub.m_number = e.number;
    scrub.m_low = -HUGE_VAL;
    scrub.m_high = HUGE_VAL;
    if (!e.unit.empty()) {
        const std::size_t digits = element.find_last_not_of(" \t", e.unitRange.begin - 1);
        scrub.m_behind = element.substr(digits + 1);
    }
    const bool whole = property && property->type == PropertyType::Integer;
    if (property) {
        const auto inUnit = [&](double limit) {
            return e.unit.empty() ? limit : convertUnit(limit, property->unit, e.unit).value_or(limit);
        };
        scrub.m_low = inUnit(property->minimum);
        scrub.m_high = inUnit(property->maximum);
    }
    const bool degrees = e.unit == "deg" || (e.unit.empty() && property && property->unit == "deg");
    scrub.m_step = whole || degrees ? 1 : stepFor(e.number, scrub.m_low, scrub.m_high);
    scrub.m_decimals = std::clamp(static_cast<int>(-std::floor(std::log10(scrub.m_step) + 1e-9)), decimalsOf(e.number), 12);
    if (!property) return scrub;
    if (property->minExclusive) scrub.m_low += scrub.m_step;
    if (property->maxExclusive) scrub.m_high -= scrub.m_step;
    return scrub;
}

std::string Scrub::after(double steps) const {
    const double scale = std::pow(10.0, m_decimals);
    const double raw = m_number + std::round(steps) * m_step;
    const double round = std::abs(raw) * scale < 1e15 ? std::round(raw * scale) / scale : raw;
    return plainNumber(std::clamp(round, std::min(m_low, m_number), std::max(m_high, m_number))) + m_behind;
}

} // namespace trundle
