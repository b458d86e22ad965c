#pragma once
// The steps of the resolver, one file each. Private to core/model.

#include "model/resolve_context.h"

namespace trundle {

void resolveMaterials(ResolveContext& context);
void resolveSurfaces(ResolveContext& context);
[[nodiscard]] SettingsSpec resolveSettings(ResolveContext& context);

[[nodiscard]] inline const OverrideNode* below(const OverrideNode* overrides, const std::string& name) {
    if (!overrides) return nullptr;
    const auto it = overrides->children.find(name);
    return it == overrides->children.end() ? nullptr : &it->second;
}

/// Nothing when the geom cannot be (said).
[[nodiscard]] std::optional<GeomSpec> resolveGeom(ResolveContext& context, const Part& part, ParamScope& scope,
                                                  const OverrideNode* overrides, bool onBody);
[[nodiscard]] std::optional<BodySpec> resolveBody(ResolveContext& context, const Part& part, ParamScope& scope,
                                                  const OverrideNode* overrides);
/// Index of a body by name: those of the config that could be resolved.
using BodyPlaces = std::unordered_map<std::string, int>;
[[nodiscard]] std::optional<JointSpec> resolveJoint(ResolveContext& context, const Part& part, ParamScope& scope,
                                                    const OverrideNode* overrides, const Part& config,
                                                    const std::vector<BodySpec>& bodies, const BodyPlaces& places);
[[nodiscard]] std::shared_ptr<const RobotConfigSpec> resolveRobotConfig(ResolveContext& context, const Part& config,
                                                                        ParamScope& scope, const OverrideNode* overrides);
[[nodiscard]] std::shared_ptr<const std::vector<GeomSpec>> resolveStaticConfig(ResolveContext& context, const Part& config,
                                                                               ParamScope& scope, const OverrideNode* overrides);
/// Antenna patterns and the medium; after the settings.
void resolveRadio(ResolveContext& context);
/// Of a word that the language has and this program does not act on.
void sayIdle(ResolveContext& context, const std::string& key, SourceRange place);
void resolveLogs(ResolveContext& context);
/// The cameras and views that FrameLogs name; after robots and views.
void checkFrameLogs(ResolveContext& context);
/// Views and lights that cannot do what they say, told one after another.
class LookChecker {
public:
    explicit LookChecker(ResolveContext& context) : m_context(context) {}
    void check(const Record& record, const Part& part);

private:
    void checkView(const Record& record, const Part& part);
    void checkLight(const Record& record, const Part& part);

    ResolveContext& m_context;
    std::size_t m_suns = 0, m_lamps = 0;
};
/// Values of Transceivers that do not go together; after the robots.
void checkRadios(ResolveContext& context);
/// Robots, statics, grids and scatters, in text order.
void resolveInstances(ResolveContext& context);

/// Where the members of a layout stand. Empty after saying why (E317).
[[nodiscard]] std::vector<Pose> gridPoses(ResolveContext& context, const Part& part, const Record& record);
[[nodiscard]] std::vector<Pose> scatterPoses(ResolveContext& context, const Part& part, const Record& record,
                                             const RobotConfigSpec& config);

} // namespace trundle
