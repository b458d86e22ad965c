#pragma once
// Where a block of a config is described: in the config itself, in what a Part uses, in one member of a Repeat. Private to core/model.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

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
    std::set<std::string, std::less<>> unfinished; ///< Repeats whose members are not all there: their values have errors

    /// What has that name: "wheel", "left.wheel", "chassis.bumper"; nullptr if there is nothing.
    [[nodiscard]] const Part* find(std::string_view name) const;
    /// Whether a name is that of something in a Repeat whose members are not all there.
    [[nodiscard]] bool isUnfinished(std::string_view name) const;
    /// The frame of the Part, or of the config that is resolved, that a member of a Repeat is in; else itself.
    [[nodiscard]] const PartFrame& holder() const;
    /// The frame in which a name written in it is found: itself, or one around a member of a Repeat.
    [[nodiscard]] const PartFrame& frameOf(std::string_view name) const;
    /// The blocks that may set values for what is in it, but for the instance, which is around them: a config after what it is a
    /// variant of, a Part after its PartConfig.
    [[nodiscard]] std::vector<const Part*> writers() const;
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

} // namespace trundle
