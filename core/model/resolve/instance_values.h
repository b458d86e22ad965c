#pragma once
// The values that an instance sets in its config: of a Robot, Static, Grid or Scatter, and of a Part. Private to core/model.

#include <set>

#include "model/resolve/resolve_context.h"

namespace trundle {

struct InstanceValues {
    std::vector<std::pair<std::string, GivenValue>> params;
    OverrideNode overrides;
    std::string key; ///< identifies the values: equal keys for equal values

    void addParam(const std::string& name, GivenValue value);
};

/// Reports overrides from outside that lead nowhere in the config of a Part, which is known with the values of an instance only;
/// each once, since they are in all members of a Repeat. `writers`: the blocks around the Part that may set values in it, innermost
/// first, without the instance. What one inside of the block that names the config sets is for another config, and is not reported.
void checkOverrides(ResolveContext& context, const Part& use, const Part& config, const OverrideNode& outside,
                    const std::vector<const Part*>& writers, std::set<const SourceAssignment*>& reported);

/// Reads the values of an instance's own block, sorted into properties of its kind, Params of its config and overrides by path.
/// `outer` overrides its own properties; null: nothing does. `config` becomes the config that it names, nullptr with a diagnostic
/// if no config of the kind has that name. Of a Grid or Scatter these are the values of one member, which has numbers in the scope then.
[[nodiscard]] Record readInstance(ResolveContext& context, const Part& part, ParamScope& scope, InstanceValues& given,
                                  const Part*& config, std::string_view kind, const OverrideNode* outer = nullptr,
                                  std::size_t member = 0);

/// Moves the diagnostics from index `first` on to the values of the instance that caused them; one that they did not cause gets a
/// note with the instance. nullptr: it has no values, but the variant that it names may have.
void nameInstance(ResolveContext& context, std::size_t first, const InstanceValues& given, const Part* instance,
                  const std::string& note);

} // namespace trundle
