#pragma once
// Private to core/model/resolve.

#include <map>

#include "model/resolve/resolve_context.h"

namespace trundle {

/// Counts the objects of configs with those of their Parts, without expanding them.
class ConfigSizes {
public:
    explicit ConfigSizes(ResolveContext& context) : m_context(context), m_evaluator(context.texts, m_silent) {}

    /// With the config's own values of its Params.
    [[nodiscard]] double of(const Part& config);
    /// The Repeat with most objects of the configs that were counted; nullptr: they have none.
    [[nodiscard]] const Part* largestRepeat() const { return m_largest; }

private:
    [[nodiscard]] double count(const Part& part, ParamScope& scope);

    ResolveContext& m_context;
    Diagnostics m_silent;
    Evaluator m_evaluator;
    std::map<const Part*, double> m_known;
    const Part* m_largest = nullptr;
    double m_most = 0; ///< objects in it
};

/// Adds the Count of a Repeat, which may be null, to a message about too many objects.
void noteCount(Diagnostic& diagnostic, const Part* repeat);

} // namespace trundle
