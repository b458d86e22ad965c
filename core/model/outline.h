#pragma once
// The named blocks of an experiment as declared in the text, before any value is evaluated. Used to look up references,
// overrides, provenance and edit targets.

#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "model/part.h"
#include "schema/registry.h"

namespace trundle {

/// Points into the trees of its TextSet and the kinds of its registry, and keeps both alive.
class Outline {
public:
    /// Reports unknown, misplaced, unnamed and duplicate blocks. Returns an empty outline with E312 if there are too many blocks.
    [[nodiscard]] static std::shared_ptr<Outline> build(std::shared_ptr<const TextSet> texts,
                                                        std::shared_ptr<const Registry> registry, Diagnostics& diagnostics);

    AssignmentList settings;
    std::vector<SourceParam> params;
    std::vector<std::unique_ptr<Part>> parts; ///< all top-level parts, in order
    NameSpace materials, surfaces, patterns, configs, world;
    std::unordered_set<std::string> unknown; ///< names of blocks without a name space: references to them get no further errors

    [[nodiscard]] const TextSet& texts() const { return *m_texts; }
    [[nodiscard]] const Registry& registry() const { return *m_registry; }
    /// The name space of a kind, the first word of `Surface.rubber`; nullptr for kinds without one.
    [[nodiscard]] const NameSpace* spaceOf(const Kind& kind) const;
    /// Leads every Part to its PartConfig, except where PartConfigs would contain each other, and adds the Params to PartConfigs that
    /// their references imply. Called by build(), and again where values were set.
    void linkParts();
    /// PartConfigs that contain each other.
    struct PartCircle {
        const Part* use = nullptr; ///< the Part that closes the circle; it has no config
        std::string chain;         ///< "A > B > A"
    };
    [[nodiscard]] const std::vector<PartCircle>& partCircles() const { return m_circles; }
    [[nodiscard]] bool isInCircle(const Part& config) const;
    /// Whether it is a Part whose config may be another one in each instance: it is computed, or a block around it may exchange it.
    [[nodiscard]] bool hasVaryingConfig(const Part& part) const;

private:
    void linkPart(Part& part, const Part* owner, bool isMisplaced);
    std::vector<PartCircle> m_circles;
    std::shared_ptr<const TextSet> m_texts;
    std::shared_ptr<const Registry> m_registry;
    std::unordered_set<std::string> m_exchanged; ///< names of Parts
};

/// Calls `visit(part, path)` for each block of the world; of a Repeat also, behind it, for those in it: "row.cart".
template <class Visit> void eachInWorld(const Part& part, const std::string& path, const Visit& visit) {
    visit(part, path);
    if (!part.isRepeat()) return;
    for (const Part& inner : part.parts)
        if (inner.usable && inner.kind) eachInWorld(inner, path + "." + inner.name, visit);
}
template <class Visit> void eachInWorld(const Outline& outline, const Visit& visit) {
    for (const Part* part : outline.world.all()) eachInWorld(*part, part->name, visit);
}

/// Everything in the world with its name, of a Grid, Scatter or Repeat that of the first member: "swarm_0", "row_0.cart".
[[nodiscard]] std::vector<std::pair<const Part*, std::string>> firstMembers(const Outline& outline);

/// The Grid or Scatter of a member: `swarm` for "swarm_12".
[[nodiscard]] const Part* layoutOfMember(const Outline& outline, std::string_view name);

} // namespace trundle
