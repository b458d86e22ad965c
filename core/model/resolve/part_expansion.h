#pragma once
// The blocks of a config with those of its Parts, in text order: what a Part uses is as if its PartConfig were written in its place,
// with the name of the Part in front. Private to core/model.

#include <deque>
#include <set>

#include "model/resolve/part_frame.h"

namespace trundle {

class PartExpansion {
public:
    /// `scope` has the Params of the config; it and `overrides` must outlive this.
    PartExpansion(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides);
    /// The blocks of the world.
    explicit PartExpansion(ResolveContext& context);

    [[nodiscard]] const std::vector<ExpandedPart>& parts() const { return m_parts; }
    [[nodiscard]] const PartFrame& root() const { return m_frames.front(); } ///< of the config, or of the world
    [[nodiscard]] bool hasTooMany() const { return m_isFull; } ///< objects; it is reported
    /// Calls `resolve` for every usable block of a role; what is reported meanwhile names the Parts that it is used by.
    template <class Resolve> void each(Role role, const Resolve& resolve) { each(role, role, resolve); }
    /// The same for two roles.
    template <class Resolve> void each(Role role, Role other, const Resolve& resolve) {
        for (const ExpandedPart& part : m_parts) {
            const bool isRepeated = part.frame->isRepeated();
            if (!part.part->usable || !(part.part->is(role) || part.part->is(other)) ||
                (isRepeated && m_faulty.contains(part.part)))
                continue;
            const std::size_t first = m_context.diagnostics.all().size(), errors = m_context.diagnostics.errorCount();
            resolve(part);
            nameUses(first, *part.frame);
            if (!isRepeated || m_context.diagnostics.errorCount() == errors) continue;
            m_faulty.insert(part.part);
            m_context.failedRobots.insert(part.part);
        }
    }

private:
    void expand(PartFrame& frame) { expand(frame, *frame.config); }
    void expand(PartFrame& frame, const Part& holder);
    void add(PartFrame& frame, const Part& part);
    [[nodiscard]] const OverrideNode* withVariants(const Part& config, ParamScope& scope, const OverrideNode* outside);
    void addVariant(const Part& config, ParamScope& scope, OverrideNode& overrides);
    [[nodiscard]] bool clashes(const Part& part, const Part& holder);
    void expandUse(const Part& use, PartFrame& outer);
    void expandRepeat(const Part& repeat, PartFrame& outer);
    [[nodiscard]] bool expandMember(const Part& repeat, PartFrame& outer, std::size_t member, const std::vector<double>& counts);
    void checkMembers(const Part& repeat, const PartFrame& outer, std::size_t count);
    [[nodiscard]] bool isFull();
    [[nodiscard]] bool takeParams(PartFrame& frame, const OverrideNode* outside, ParamScope& scope);
    void placeLater(PartFrame& frame, const Record& record);
    void placeFrames();
    [[nodiscard]] static bool takeIn(ResolveContext& context, PartFrame& frame, const Record& record);
    [[nodiscard]] bool isCircle(const PartFrame& frame, SourceRange place);
    void checkContent(const Part& part, const PartFrame& frame);
    void nameUses(std::size_t first, const PartFrame& frame);

    ResolveContext& m_context;
    bool m_isScenery, m_isFull = false;
    std::deque<PartFrame> m_frames; // deques, since pointers to their elements are kept
    std::deque<ParamScope> m_scopes;
    std::deque<OverrideNode> m_overrides;
    std::vector<ExpandedPart> m_parts;
    std::vector<std::pair<PartFrame*, Record>> m_toPlace; ///< that have an In
    std::set<const SourceAssignment*> m_astray;           ///< overrides that lead nowhere in a config that may vary; reported
    std::set<const Part*> m_faulty; ///< blocks of Repeats with errors: the other members would repeat them
};

/// The properties of a config itself, those that it does not set from the config that it is a variant of.
[[nodiscard]] Record readConfig(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides);

} // namespace trundle
