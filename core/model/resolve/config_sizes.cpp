#include "model/resolve/config_sizes.h"

#include "model/repeat.h"

namespace trundle {

double ConfigSizes::of(const Part& config) {
    const auto [it, isNew] = m_known.try_emplace(&config, 1); // of a circle, what is known so far
    if (!isNew) return it->second;
    ParamScope scope(&m_context.globals);
    scope.declare(config.params);
    const double size = count(config, scope);
    return m_known[&config] = size;
}

double ConfigSizes::count(const Part& part, ParamScope& scope) {
    double size = part.config && part.is(Role::Config) ? count(*part.config, scope) : 1;
    for (const Part& inner : part.parts) {
        if (!inner.isRepeat()) {
            size += inner.config ? 1 + of(*inner.config) : count(inner, scope);
            continue;
        }
        ParamScope own(&scope);
        own.declare(inner.params);
        const std::vector<double> counts = countsOf(inner, m_evaluator, own, nullptr, m_silent);
        setIndex(own, 0, counts);
        const double all =
            static_cast<double>(memberCount(counts)) * (count(inner, own) - 1); // of the Repeat itself nothing is left
        size += all;
        if (all > m_most) {
            m_most = all;
            m_largest = &inner;
        }
    }
    return size;
}

void noteCount(Diagnostic& diagnostic, const Part* repeat) {
    const SourceAssignment* count = repeat ? repeat->assignments.find("Count") : nullptr;
    if (count) diagnostic.notes.emplace_back("most are in " + repeat->title(), count->valueRange());
}

} // namespace trundle
