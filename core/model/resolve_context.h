#pragma once
// What the files of the resolver share. Private to core/model.

#include <functional>
#include <map>

#include "model/params.h"
#include "model/record.h"
#include "model/resolver.h"

namespace trundle {

class ResolveContext {
public:
    ResolveContext(const Outline& outline, const AssetLookup& assets, Diagnostics& diagnostics, ExperimentSpec& out)
        : outline(outline), texts(outline.texts()), registry(outline.registry()), assets(assets), diagnostics(diagnostics),
          out(out), evaluator(texts, diagnostics) {
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

    /// Takes care of keys that are no property (true: done); `words` are such keys, for suggestions.
    struct ExtraKeys {
        std::function<bool(const PlacedAssignment&)> take;
        std::vector<std::string> words;
    };
    /// The values of a part.
    [[nodiscard]] Record read(const Part& part, ParamScope& scope, const OverrideNode* overrides, Origin origin,
                              const ExtraKeys& extra = {});
    [[nodiscard]] Record readSettings();

    /// Index of a material or surface by name; says E208 for one that nobody defined and E315 for one defined later.
    [[nodiscard]] std::uint32_t materialIndex(const Record& record, const Part& user);
    [[nodiscard]] std::uint32_t surfaceIndex(const Record& record, const Part& user);
    /// The config an instance names, or nullptr after saying why not.
    [[nodiscard]] const Part* configOf(const Record& record, const Part& user, std::string_view kind);
    /// Checks the references of a component of `config` against its parts.
    [[nodiscard]] bool checkReferences(const Record& record, const Part& config);
    /// One name against the parts of a config; `property` says what fits.
    [[nodiscard]] bool checkReference(const Property& property, const std::string& name, SourceRange range, bool literal,
                                      const Part& config);
    void unknownReference(const std::string& property, const std::string& what, const std::string& name, SourceRange range,
                          bool literal, const std::vector<std::string>& candidates);
    /// The fix that adds `text` to a block.
    void fixAdd(Diagnostic& d, const Part& part, const std::string& key, const std::string& value);

    std::map<std::string, std::uint32_t> materialPlaces, surfacePlaces;
    /// Geoms that name no Material or no Surface, in the order they were met.
    std::vector<std::pair<const Part*, std::string>> defaulted;
    std::unordered_set<const Part*> defaultedParts;

private:
    void fill(Record& record, const AssignmentList& assignments, const Part* part, ParamScope& scope,
              const OverrideNode* overrides, Origin origin, const ExtraKeys& extra);
    [[nodiscard]] std::optional<ResolvedValue> readGiven(const Property& property, const GivenValue& given, Origin origin);
    /// Of each choice between properties exactly one must stand there; `tried`: parallel to the properties, those that do.
    void checkAlternatives(Record& record, const Part& part, const std::vector<bool>& tried,
                           const std::vector<std::string>& meant);
    void missesAll(const Record& record, const Part& part, const Alternatives& choice);
    void hasSeveral(const Part& part, const std::vector<std::string>& there);
    void unknownKey(const Kind& kind, const PlacedAssignment& a, const std::string& title, const std::vector<std::string>& more,
                    std::vector<std::string>& meant);
    [[nodiscard]] std::uint32_t lookUp(const Record& record, const Part& user, const char* key, const NameSpace& space,
                                       const std::map<std::string, std::uint32_t>& places);
    void hintLater(const Part& found, const Part& user, SourceRange range);

    std::map<std::string, int> m_unknownSaid;
    std::map<std::string, bool> m_laterSaid;
};

[[nodiscard]] inline Vec3 vec3(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
[[nodiscard]] inline Pose poseOf(const std::array<double, 3>& pos, const std::array<double, 3>& hpr) {
    return {vec3(pos), rotationFromHpr(vec3(hpr))};
}
[[nodiscard]] ComponentSpec componentFrom(const Record& record, const Part& part);

} // namespace trundle
