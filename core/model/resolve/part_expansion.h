#pragma once
// The blocks of a config with those of its Parts, in text order: what a Part uses is as if its PartConfig were written in its place,
// with the name of the Part in front. Private to core/model.

#include <deque>
#include <set>

#include "model/resolve/instance_values.h"
#include "model/resolve/mirror.h"

namespace trundle {

/// The blocks of one config: the config that is resolved, what one Part in it uses, or one member of a Repeat. Names are looked up in
/// it, and those that a member of a Repeat does not have around it.
struct PartFrame {
    const Part* config = nullptr; ///< of a member of a Repeat the Repeat itself; nullptr: it is the world
    const Part* use = nullptr;    ///< the Part or Repeat; nullptr: it is the config that is resolved
    PartFrame* outer = nullptr;   ///< of the config that holds the Part
    std::string prefix;           ///< of its names: "left."
    ParamScope* scope = nullptr;  ///< the Params of the config
    const OverrideNode* overrides = nullptr;
    bool isOpen = false; ///< a PartConfig by itself: what is outside is not known
    PartPlacement placement;
    std::string in; ///< the body that the placement counts from, in the config that is resolved; empty: the frame of `outer`
    SourceRange inRange;
    InstanceValues given;              ///< by the Part
    std::optional<std::size_t> member; ///< of a Repeat
    std::map<std::string, const PartFrame*, std::less<>> inner;

    /// What has that name: "wheel", "left.wheel", "chassis.bumper"; nullptr if there is nothing.
    [[nodiscard]] const Part* find(std::string_view name) const;
    /// The frame of the Part, or of the config that is resolved, that a member of a Repeat is in; else itself.
    [[nodiscard]] const PartFrame& holder() const;
    /// The frame in which a name written in it is found: itself, or one around a member of a Repeat.
    [[nodiscard]] const PartFrame& frameOf(std::string_view name) const;
    [[nodiscard]] bool isRepeated() const { return member || (outer && outer->isRepeated()); }
};

/// A block that is resolved, and the frame that it is described in.
struct ExpandedPart {
    const Part* part = nullptr;
    PartFrame* frame = nullptr;

    [[nodiscard]] const OverrideNode* overrides() const { return below(frame->overrides, part->name); }
    [[nodiscard]] std::string name() const { return frame->prefix + part->name; }
    /// Whether it is a mirror image of what is described, not only turned.
    [[nodiscard]] bool isMirrored() const {
        bool is = false;
        for (const PartFrame* at = frame; at->use; at = at->outer) is ^= at->placement.isMirrored();
        return is;
    }
    /// Puts a pose described in the innermost frame into the config that is resolved, or into the world.
    [[nodiscard]] Pose placed(Pose pose) const {
        for (const PartFrame* at = frame; at->use; at = at->outer) pose = at->placement.pose(pose);
        return pose;
    }
    /// The same for a device: on a body of the part or on one from outside.
    void place(ComponentSpec& device) const {
        const std::string body = device.text("Body");
        for (const PartFrame* at = frame; at->use; at = at->outer)
            at->placement.place(device, body.empty() || body.starts_with(at->prefix));
    }
    /// Puts something described in the innermost frame into the config that is resolved.
    template <class Spec, class... Context> bool place(Spec& spec, Context&... context) const {
        bool good = true;
        for (const PartFrame* at = frame; at->use; at = at->outer) {
            if constexpr (sizeof...(Context) > 0) good = at->placement.place(context..., spec) && good;
            else at->placement.place(spec);
        }
        return good;
    }
};

/// Notes in which member of a Repeat, Grid or Scatter something is wrong; not for the first one, unless it is its number.
void nameMember(const ResolveContext& context, Diagnostic& d, const Part& of, std::size_t member);

class PartExpansion {
public:
    /// `scope` has the Params of the config; it and `overrides` must outlive this.
    PartExpansion(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides);
    /// The blocks of the world.
    explicit PartExpansion(ResolveContext& context);

    [[nodiscard]] const std::vector<ExpandedPart>& parts() const { return m_parts; }
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
    std::set<const Part*> m_faulty; ///< blocks of Repeats with errors: the other members would repeat them
};

/// The properties of a config itself, those that it does not set from the config that it is a variant of.
[[nodiscard]] Record readConfig(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides);

/// Reports PartConfigs that contain each other (E302).
void reportPartCircles(ResolveContext& context);

} // namespace trundle
