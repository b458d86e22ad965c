#pragma once
#include <functional>
#include <string_view>

#include "model/part.h"

namespace trundle {

/// The property whose value a Param of a config is where it stands for a name: Parent for `Hinge axle { Parent=$carrier ... }`, also if a Part
/// in the config passes it on, `carrier=$carrier`. The first one in the text; nullptr: it stands for no name.
[[nodiscard]] const Property* propertyNamedBy(const Part& config, std::string_view param);

/// Whether a value in a config uses a Param of that name, by itself or in $( ), that is declared nowhere in it.
[[nodiscard]] bool usesParam(const Part& config, std::string_view param);

/// The Params whose value, a word or a list, an expression may have: `$(name)`, `$(if(a > b, name, other))`,
/// `$(element(name, 0))`.
void eachNameGiven(const Expression& expression, const std::function<void(const std::string&)>& take);

} // namespace trundle
