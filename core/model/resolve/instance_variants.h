#pragma once
// Resolves one Robot, Static or layout member alone, with other values of its config's Params: shows how each Param affects its
// shapes.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/resolver.h"
#include "schema/value_reader.h"

namespace trundle {

/// A geom of a config, and the pose of its body in the config frame (identity in a StaticConfig).
struct ConfigGeom {
    GeomSpec geom;
    Pose body;
};

class InstanceVariants {
public:
    using Params = std::vector<std::pair<std::string, GivenValue>>;

    /// `instance`: a Robot, Static, Grid or Scatter of the outline. Meshes come from `assets`; a geom with an unreadable mesh has
    /// none.
    InstanceVariants(std::shared_ptr<const Outline> outline, AssetLookup assets, const Part& instance)
        : m_outline(std::move(outline)), m_assets(std::move(assets)), m_instance(&instance) {}

    /// The Params of its config and their values in this instance, in text order; Params that cannot be evaluated are left out.
    [[nodiscard]] Params params() const;
    /// All geoms with these values instead of those of the instance and its config; the other Params are unchanged. Nothing if
    /// the config cannot be resolved; geoms for which a value is invalid are left out.
    [[nodiscard]] std::optional<std::vector<ConfigGeom>> geoms(const Params& changed) const;

private:
    std::shared_ptr<const Outline> m_outline;
    AssetLookup m_assets;
    const Part* m_instance; // of the outline
};

} // namespace trundle
