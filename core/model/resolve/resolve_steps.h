#pragma once
// The steps of the resolver, one file per step. Private to core/model.

#include "model/resolve/footprint.h"
#include "model/resolve/part_expansion.h"

namespace trundle {

void resolveMaterials(ResolveContext& context);
void resolveSurfaces(ResolveContext& context);
[[nodiscard]] SettingsSpec resolveSettings(ResolveContext& context);

/// Nothing, with a diagnostic, if the geom is invalid.
[[nodiscard]] std::optional<GeomSpec> resolveGeom(ResolveContext& context, const Part& part, ParamScope& scope,
                                                  const OverrideNode* overrides, bool onBody);
/// As it is described. `in` becomes the name of the body that its pose counts from, empty for none; `place` where that is written.
[[nodiscard]] std::optional<BodySpec> resolveBody(ResolveContext& context, const ExpandedPart& expanded, std::string& in,
                                                  SourceRange& place);
/// Index by name of the bodies that could be resolved.
using BodyIndices = std::unordered_map<std::string, int>;
[[nodiscard]] std::optional<JointSpec> resolveJoint(ResolveContext& context, const ExpandedPart& expanded,
                                                    const std::vector<BodySpec>& bodies, const BodyIndices& places);
[[nodiscard]] std::optional<SpringSpec> resolveSpring(ResolveContext& context, const ExpandedPart& expanded,
                                                      const std::vector<BodySpec>& bodies, const BodyIndices& places);
/// A joint's own values, without its bodies; nothing, with a diagnostic, if they are wrong.
[[nodiscard]] std::optional<JointSpec> readJoint(ResolveContext& context, const Part& part, const Record& record);
/// What the other end of a joint or spring names, which Child or Parent cannot mean; empty for other properties.
[[nodiscard]] std::string otherEnd(const Record& record, std::string_view property);
/// A second joint between the same bodies.
void warnAboutTwoJoints(ResolveContext& context, const Part& second, const std::string& oneName, const std::string& otherName);
/// Reports two values of a block that do not go together, at the one that came from farthest outside, by an override or a Param; else at
/// the second.
void reportTwo(ResolveContext& context, const Record& record, const Part& part, const char* first, const char* second,
               const std::string& message);
/// Requires all joints of the config.
[[nodiscard]] std::optional<GearSpec> resolveGear(ResolveContext& context, const ExpandedPart& expanded,
                                                  const std::vector<JointSpec>& joints);
[[nodiscard]] std::shared_ptr<const RobotConfigSpec> resolveRobotConfig(ResolveContext& context, const Part& config,
                                                                        ParamScope& scope, const OverrideNode* overrides);
/// A StaticConfig with one set of Param values and overrides applied.
struct StaticConfigSpec {
    std::vector<GeomSpec> geoms;
    std::shared_ptr<const RobotConfigSpec>
        moving; ///< its bodies, joints and devices, after one that is fixed; null: there are none
};
[[nodiscard]] std::shared_ptr<const StaticConfigSpec> resolveStaticConfig(ResolveContext& context, const Part& config,
                                                                          ParamScope& scope, const OverrideNode* overrides);
/// Checks a PartConfig by itself; what is outside of it is not known.
void checkPartConfig(ResolveContext& context, const Part& config);
/// Antenna patterns and the medium; requires the settings.
void resolveRadio(ResolveContext& context);
/// The name of the mirror image of an antenna pattern or antenna model; the same name if it has none of its own.
[[nodiscard]] std::string mirroredAntenna(ResolveContext& context, const std::string& name);
void resolveLogs(ResolveContext& context, PartExpansion& world);
/// Joints and springs at the top level, regions, and robots that do not touch each other; requires the robots.
void resolveLinks(ResolveContext& context, PartExpansion& world);
/// Checks the robots that a property names; in a list, the name of a Grid or Scatter is replaced by those of its members.
[[nodiscard]] bool checkRobots(ResolveContext& context, const Property& property, ResolvedValue& value);
/// What a name in a member of a Repeat of the world means: a block of that member, "row_3.cart" for "cart", or what is around it.
[[nodiscard]] std::string nameMeant(const std::string& name, const PartFrame& frame);
/// The pairs of a list of names; nothing, with a diagnostic, if one name is left over.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> namePairs(ResolveContext& context, const Record& record,
                                                                         SourceRange otherwise);
/// Checks the cameras and views that FrameLogs name; requires robots and views.
void checkFrameLogs(ResolveContext& context);
/// Checks views and lights for invalid combinations of values, one after another.
class AppearanceChecker {
public:
    explicit AppearanceChecker(ResolveContext& context) : m_context(context) {}
    void check(const Record& record, const Part& part);

private:
    void checkView(const Record& record, const Part& part);
    void checkLight(const Record& record, const Part& part);

    ResolveContext& m_context;
    std::size_t m_suns = 0, m_lamps = 0;
};
/// Checks Transceivers for inconsistent values; requires the robots.
void checkRadios(ResolveContext& context);
/// Robots, statics, grids and scatters, in text order.
void resolveInstances(ResolveContext& context, PartExpansion& world);

/// The poses of a Grid's members, in the world or in the member of a Repeat that it is in.
[[nodiscard]] std::vector<Pose> gridPoses(ResolveContext& context, const Part& part, const Record& record);

} // namespace trundle
