#include "model/kinds/model_kinds.h"

#include "base/assert.h"
#include "model/kinds/config_fields.h"
#include "model/kinds/radio_fields.h"
#include "model/kinds/world_fields.h"

namespace trundle {

namespace {

class KindBuilder {
public:
    explicit KindBuilder(Registry& registry) : m_registry(registry) {}
    template <class T> void add(const char* name, Role role, std::vector<std::string> parents, bool nameOptional = false) {
        const Status status = m_registry.add(kindOf<T>(name, role, std::move(parents), nameOptional));
        TRUNDLE_ASSERT(status.ok());
    }

private:
    Registry& m_registry;
};

} // namespace

void addModelKinds(Registry& registry) {
    KindBuilder kinds(registry);
    kinds.add<SettingsFields>("settings", Role::Settings, {});
    kinds.add<MaterialFields>("Material", Role::Material, {""});
    kinds.add<SurfaceFields>("Surface", Role::Surface, {""});
    kinds.add<AntennaPatternFields>("AntennaPattern", Role::Pattern, {""});
    kinds.add<RadioMediumFields>("RadioMedium", Role::Medium, {""}, true);
    kinds.add<RobotConfigFields>("RobotConfig", Role::Config, {""});
    kinds.add<StaticConfigFields>("StaticConfig", Role::Config, {""});
    kinds.add<PartConfigFields>("PartConfig", Role::Config, {""});
    const std::vector<std::string> anyConfig{"RobotConfig", "StaticConfig", "PartConfig", "Repeat", "Ring"};
    kinds.add<PartFields>("Part", Role::Instance, anyConfig);
    std::vector<std::string> anywhere = anyConfig;
    anywhere.emplace_back();
    std::vector<std::string> aroundBlocks = anywhere; // in a Body around geoms
    aroundBlocks.emplace_back("Body");
    kinds.add<RepeatFields>("Repeat", Role::Repeat, aroundBlocks);
    kinds.add<RingFields>("Ring", Role::Repeat, aroundBlocks);
    const std::vector<std::string> inWorld{"", "Repeat", "Ring"};
    kinds.add<RobotFields>("Robot", Role::Instance, inWorld);
    kinds.add<StaticFields>("Static", Role::Instance, inWorld);
    kinds.add<GridFields>("Grid", Role::Layout, inWorld);
    kinds.add<ScatterFields>("Scatter", Role::Layout, inWorld);
    kinds.add<LightFields>("Light", Role::Look, inWorld, true);
    kinds.add<SkyFields>("Sky", Role::Look, {""}, true);
    kinds.add<ViewFields>("View", Role::Look, inWorld, true);
    kinds.add<RegionFields>("Region", Role::Region, inWorld);
    kinds.add<BodyFields>("Body", Role::Body, anyConfig);
    const std::vector<std::string> ground{"StaticConfig", "PartConfig", "Repeat", "Ring"};
    std::vector<std::string> solid{"Body"};
    solid.insert(solid.end(), ground.begin(), ground.end());
    kinds.add<BoxFields>("Box", Role::Geom, solid, true);
    kinds.add<SphereFields>("Sphere", Role::Geom, solid, true);
    kinds.add<CylinderFields>("Cylinder", Role::Geom, solid, true);
    kinds.add<CapsuleFields>("Capsule", Role::Geom, solid, true);
    kinds.add<ConvexFields>("Convex", Role::Geom, solid, true);
    kinds.add<MeshFields>("Mesh", Role::Geom, solid, true);
    kinds.add<PlaneFields>("Plane", Role::Geom, ground, true);
    kinds.add<HeightfieldFields>("Heightfield", Role::Geom, ground, true);
    const std::vector<std::string>& anyJointed = anywhere; // at the top level between robots
    kinds.add<HingeFields>("Hinge", Role::Joint, anyJointed);
    kinds.add<SliderFields>("Slider", Role::Joint, anyJointed);
    kinds.add<BallFields>("Ball", Role::Joint, anyJointed);
    kinds.add<UniversalFields>("Universal", Role::Joint, anyJointed);
    kinds.add<FixedFields>("Fixed", Role::Joint, anyJointed);
    kinds.add<SuspensionFields>("Suspension", Role::Joint, anyJointed);
    kinds.add<SpringFields>("Spring", Role::Joint, anyJointed);
    kinds.add<GearFields>("Gear", Role::Joint, anyConfig);
}

Kind withControllerProperties(Kind kind) {
    if (kind.role != Role::Controller) return kind;
    static const Kind common = kindOf<ControllerFields>("", Role::Controller, {});
    for (const Property& p : common.properties) {
        if (!kind.find(p.name)) kind.properties.push_back(p);
    }
    return kind;
}

Registry withControllerProperties(const Registry& registry) {
    Registry completed;
    for (const Kind* kind : registry.all()) {
        const Status status = completed.add(withControllerProperties(*kind));
        TRUNDLE_ASSERT(status.ok()); // names were unique before
    }
    return completed;
}

} // namespace trundle
