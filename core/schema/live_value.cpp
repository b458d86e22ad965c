#include "schema/live_value.h"

#include <algorithm>
#include <cmath>

#include "base/platform/module_text.h"

namespace trundle {
namespace {

constexpr double kRounding = 1e-9; // in units of the text; the exact check was made when the text was read

/// `number` is in SI units, the limits are in the text's unit.
bool inRange(const TrundleField& field, double number) {
    if (field.type == TRUNDLE_BOOLEAN) return true;
    const double value = number / field.scale, slack = kRounding * std::max(1.0, std::abs(value));
    const bool above = field.flags & TRUNDLE_MIN_EXCLUSIVE ? value > field.minimum : value >= field.minimum - slack;
    const bool below = field.flags & TRUNDLE_MAX_EXCLUSIVE ? value < field.maximum : value <= field.maximum + slack;
    return above && below;
}

} // namespace

Status setLive(const TrundleKind& kind, void* instance, const std::string& who, const std::string& property,
               const PropertyValue& value) {
    std::uint32_t index = 0;
    while (index < kind.fieldCount && property != kind.fields[index].name) ++index;
    if (index == kind.fieldCount || !kind.set || !instance) return Error{Code::UnknownKey, who + " has no property " + property};
    const TrundleField& field = kind.fields[index];
    if (!(field.flags & TRUNDLE_LIVE)) return Error{Code::WrongPlace, property + " of " + who + " does not change during a run"};

    const bool numeric = field.type == TRUNDLE_NUMBER || field.type == TRUNDLE_INTEGER || field.type == TRUNDLE_BOOLEAN;
    std::vector<const char*> texts;
    for (const std::string& text : value.texts) texts.push_back(text.c_str());
    const std::size_t count = numeric ? value.numbers.size() : texts.size();
    if (count < field.minCount || count > field.maxCount)
        return Error{Code::WrongCount, property + " of " + who + " does not take that many values"};
    for (const double number : value.numbers) {
        if (!std::isfinite(number)) return Error{Code::OutOfRange, property + " of " + who + " must be finite"};
        if (!inRange(field, number)) // possible if the loaded module version differs from the one used for checking the text
            return Error{Code::OutOfRange, property + " of " + who + " is out of the range that the running code describes"};
    }
    const TrundleValue crossing{value.numbers.data(), texts.data(), static_cast<std::uint32_t>(count)};
    if (kind.set(instance, index, &crossing) == 0) return {};
    const std::string why = kind.lastError ? moduleMessage(kind.lastError(instance)) : std::string();
    return Error{Code::OutOfRange, who + " refuses its " + property + (why.empty() ? "" : ": ") + why};
}

} // namespace trundle
