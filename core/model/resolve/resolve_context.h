#pragma once
// State and helper functions shared by the resolver's files. Private to core/model.

#include <functional>
#include <map>

#include "model/asset_lookup.h"
#include "model/experiment_spec.h"
#include "model/outline.h"
#include "model/params.h"
#include "model/resolve/record.h"

namespace trundle {

struct PartFrame;

class ResolveContext {
public:
    ResolveContext(const Outline& outline, const AssetLookup& assets, Diagnostics& diagnostics, ExperimentSpec& out)
        : outline(outline), texts(outline.texts()), registry(outline.registry()), assets(assets), diagnostics(diagnostics),
          out(out), evaluator(texts, diagnostics, &registry) {
        globals.declare(outline.params);
    }

    const Outline& outline;
    const TextSet& texts;
    const Registry& registry;
    const AssetLookup& assets;
    Diagnostics& diagnostics;
    ExperimentSpec& out;
    Evaluator evaluator;
    ParamScope globals;

    [[nodiscard]] bool brokenText(const SourceRange& range) { return evaluator.broken(range); }

    /// Handles keys that are not properties of the kind: `take` returns true if it handled the key; `words` are valid keys, for
    /// suggestions.
    struct ExtraKeys {
        std::function<bool(const SourceAssignment&)> take;
        std::vector<std::string> words;
    };
    /// Evaluates the values of a part.
    [[nodiscard]] Record read(const Part& part, ParamScope& scope, const OverrideNode* overrides, Origin origin,
                              const ExtraKeys& extra = {});
    [[nodiscard]] Record readSettings();

    /// Index of a material or surface by name; reports E208 for an unknown name and E315 for one defined later.
    [[nodiscard]] std::uint32_t materialIndex(const Record& record, const Part& user);
    [[nodiscard]] std::uint32_t surfaceIndex(const Record& record, const Part& user);
    /// The config that an instance names; nullptr, with a diagnostic, on failure.
    [[nodiscard]] const Part* configOf(const Record& record, const Part& user, std::string_view kind);
    /// The surface of a mirrored geom: the friction that points to the left points to the right.
    [[nodiscard]] std::uint32_t mirroredSurface(std::uint32_t surface);
    void unknownReference(const std::string& property, const std::string& what, const std::string& name, SourceRange range,
                          bool literal, const std::vector<std::string>& candidates);
    /// Adds a fix that writes `key=value` into a block.
    void fixAdd(Diagnostic& d, const Part& part, const std::string& key, const std::string& value);

    std::map<std::string, std::uint32_t> materialPlaces, surfacePlaces;
    /// Geoms without a Material or Surface, in order of discovery.
    std::vector<std::pair<const Part*, std::string>> defaulted;
    std::unordered_set<const Part*> defaultedParts;
    std::size_t reads = 0; ///< blocks read so far
    std::unordered_set<const Part*> failedRobots; ///< blocks of robots not all of which are in `out`: they have errors of their own
    /// Whether an unknown name has an error of its own, or may have been defined in an import that is not there.
    [[nodiscard]] bool isReported(const std::string& name) const { return texts.openImports || outline.unknown.contains(name); }
    /// Whether a path begins with the name of such a robot, or of a member of it.
    [[nodiscard]] bool isFailedRobot(std::string_view path) const;

private:
    struct UnknownKeys {
        std::vector<std::string> meant;      ///< properties meant by misspelt keys: not reported as missing
        std::optional<std::size_t> stranger; ///< index of the diagnostic of the first key that is near to none
        std::vector<std::string> missing;    ///< required properties that it is most likely for
    };
    void fill(Record& record, const AssignmentList& assignments, const Part* part, ParamScope& scope,
              const OverrideNode* overrides, Origin origin, const ExtraKeys& extra);
    [[nodiscard]] std::optional<ResolvedValue> readGiven(const Property& property, const GivenValue& given, Origin origin);
    /// Checks that exactly one property of each alternative is given; `validated` is parallel to the properties and marks the
    /// given ones.
    void checkAlternatives(Record& record, const Part& part, const std::vector<bool>& validated,
                           const std::vector<std::string>& meant);
    void hasNone(const Record& record, const Part& part, const Alternatives& choice);
    void hasSeveral(const Part& part, const std::vector<std::string>& there);
    void reportMissing(const Part& part, const Property& property, UnknownKeys& unknown);
    void unknownKey(const Kind& kind, const SourceAssignment& a, const std::string& title, const std::vector<std::string>& more,
                    UnknownKeys& unknown);
    [[nodiscard]] std::uint32_t lookUp(const Record& record, const Part& user, const char* key, const NameSpace& space,
                                       const std::map<std::string, std::uint32_t>& places);
    void hintLater(const Part& found, const Part& user, SourceRange range);

    std::map<std::uint32_t, std::uint32_t> m_mirrored; ///< surfaces
    struct UnknownName {
        int reports = 0;
        std::size_t last = 0; ///< index of its last diagnostic + 1; 0: none was kept
    };
    std::map<std::string, UnknownName> m_unknownNames;
    std::map<std::string, bool> m_reportedLater;
};

[[nodiscard]] inline Vec3 vec3(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
[[nodiscard]] inline Pose poseOf(const std::array<double, 3>& pos, const std::array<double, 3>& hpr) {
    return {vec3(pos), rotationFromHpr(vec3(hpr))};
}
/// What `In` names in the config that is resolved, checked; empty: it is not given, or is the world. Nothing, with a diagnostic, if
/// it is wrong.
[[nodiscard]] std::optional<std::string> bodyOfIn(ResolveContext& context, const Record& record, const PartFrame& frame,
                                                  const std::string& self);
[[nodiscard]] ComponentSpec componentFrom(const Record& record, const Part& part);

} // namespace trundle
