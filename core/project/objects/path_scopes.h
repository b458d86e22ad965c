#pragma once
// The instances that a path leads through, and the Params in scope at its end. Private to core/project.

#include <deque>
#include <optional>

#include "model/override_order.h"
#include "model/params.h"
#include "project/objects/object_location.h"

namespace trundle {

class PathScopes {
public:
    PathScopes(const LoadedProject& loaded, const ObjectLocation& place);
    PathScopes(const PathScopes&) = delete;
    PathScopes& operator=(const PathScopes&) = delete;

    /// A Robot, Static, Grid, Scatter, Part or variant that sets values of what is inside it.
    struct Layer {
        const Part* instance = nullptr;
        const Part* config = nullptr; ///< of the instance
        ParamScope* scope = nullptr;  ///< for the values in its block
        std::size_t first = 0;        ///< the word of the path to the object that its keys begin with
    };
    /// The Params at the values in the object's own block.
    [[nodiscard]] ParamScope& scope() { return *m_scope; }
    /// The Params of the config that an object at the end of the path uses, with the values that are set for them; those of the
    /// object's scope if it is no instance.
    [[nodiscard]] ParamScope& configScope();

    /// What an instance on the path sets for a property or Param of the object; nothing if it is not overridden. A property that an
    /// instance has itself is no override.
    struct Override {
        const SourceAssignment* assignment = nullptr;
        const Layer* layer = nullptr;
    };
    [[nodiscard]] std::optional<Override> overrideOf(std::string_view key, bool isParam = false) const;
    /// All that are set; the first one holds.
    [[nodiscard]] std::vector<Override> overridesOf(std::string_view key, bool isParam = false) const;
    [[nodiscard]] Evaluator& evaluator() { return m_evaluator; }

private:
    ParamScope* inside(ParamScope* outer, const std::vector<SourceParam>& params);
    ParamScope* enter(const Part& config);
    ParamScope* enterMember(const Part& repeat, std::size_t member);
    void descend(const Part& part, const ObjectLocation& place);

    const Part* m_object = nullptr;
    Diagnostics m_silent;
    Evaluator m_evaluator;
    std::deque<ParamScope> m_scopes; // a deque: the scopes point to each other
    std::vector<Layer> m_layers;     ///< outermost first
    std::vector<OverrideWord> m_path; ///< the words to the object, without those of a config at its beginning
    ParamScope *m_globals = nullptr, *m_scope = nullptr, *m_configScope = nullptr;
};

} // namespace trundle
