#pragma once
// Looks up the objects that a plan changes. Private to core/project.

#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/objects/object_location.h"

namespace trundle {

/// The location of an object whose block can be changed. Fails for the experiment itself, a missing object, and a member of a
/// Grid or Scatter, which has no text.
[[nodiscard]] Result<ObjectLocation> requireChangeable(const LoadedProject& loaded, const std::string& path);

/// One of the selected objects, with its requested path.
struct Chosen {
    ObjectLocation place;
    std::string path;
};
/// In text order, each block once, without blocks that are inside another one.
[[nodiscard]] Result<std::vector<Chosen>> chosen(const LoadedProject& loaded, const std::vector<std::string>& paths);

/// The ranges of their blocks.
[[nodiscard]] std::vector<SourceRange> rangesOf(const std::vector<Chosen>& chosen);

/// Whether a range is inside another or equal to it.
[[nodiscard]] bool isWithin(const SourceRange& inner, const SourceRange& outer);
/// Whether a kind of block is allowed in `parent` (nullptr: at the top level).
[[nodiscard]] bool isAllowedIn(const Kind& kind, const Part* parent);

/// What blocks hold, by themselves or through their Parts.
class HeldBlocks {
public:
    void add(const Kind& kind);
    void add(const Part& block);
    /// Blocks given as text; `others` are those given with it.
    void add(const LoadedProject& loaded, const BlockItem& block, const std::vector<const BlockItem*>& others);
    /// Fails if a config cannot get them too: geoms without a Body are in scenery only, in it and in the configs that use it, and
    /// PartConfigs do not contain each other in a circle. `title` is that of the new block, for messages.
    [[nodiscard]] Status fitsIn(const LoadedProject& loaded, const Part& config, const std::string& title) const;
    /// Whether one has geoms without a Body, and the other bodies, joints or devices.
    [[nodiscard]] bool mixesWith(const HeldBlocks& other) const;
    /// Whether they can be in a Body, as a block of `kind` that holds them: geoms and Repeats of geoms can.
    [[nodiscard]] bool fitInBody(const Kind& kind) const;

private:
    void visit(const Part& holder);

    bool m_scenery = false, m_robot = false; ///< geoms without a Body; bodies, joints and devices
    bool m_isRobot = false;                  ///< a RobotConfig is among them
    bool m_hasPart = false;                  ///< a Part
    std::set<const Part*> m_reached;
};

/// For messages: "a Box is in a Body or a StaticConfig".
[[nodiscard]] std::string allowedPlaces(const Kind& kind);

} // namespace trundle
