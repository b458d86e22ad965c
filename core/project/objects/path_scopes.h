#pragma once
// The instances that a path leads through, and the Params in scope at its end. Private to core/project.

#include <deque>
#include <optional>

#include "model/params.h"
#include "project/objects/object_location.h"

namespace trundle {

class PathScopes {
public:
    PathScopes(const LoadedProject& loaded, const ObjectLocation& place);
    PathScopes(const PathScopes&) = delete;
    PathScopes& operator=(const PathScopes&) = delete;

    /// A Robot, Static, Grid, Scatter or Part that sets values of what is inside it. The outermost one holds.
    struct Layer {
        const Part* instance = nullptr;
        const Part* config = nullptr; ///< of the instance
        ParamScope* scope = nullptr;  ///< for the values in its block
        std::string inside;           ///< path from it to the object: "left.wheel"; empty: it is the object
        std::string insideAll;        ///< the same with the names of Repeats instead of those of their members
    };
    [[nodiscard]] const std::vector<Layer>& layers() const { return m_layers; }
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
    std::vector<Layer> m_layers;
    ParamScope *m_globals = nullptr, *m_scope = nullptr, *m_configScope = nullptr;
};

} // namespace trundle
