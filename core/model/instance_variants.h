#pragma once
// One Robot or Static by itself, or a member of a Grid or Scatter, and its shapes with other values for the Params of its config: which Param makes a wall how long.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/resolver.h"
#include "schema/value_reader.h"

namespace trundle {

/// A geom of a config and the pose of its body in the config's frame (identity in a StaticConfig).
struct ConfigGeom {
    GeomSpec geom;
    Pose body;
};

class InstanceVariants {
public:
    using Params = std::vector<std::pair<std::string, GivenValue>>;

    /// `instance`: a Robot, Static, Grid or Scatter of the outline. Meshes come from `assets`; a geom whose mesh cannot be read has none.
    InstanceVariants(std::shared_ptr<const Outline> outline, AssetLookup assets, const Part& instance)
        : m_outline(std::move(outline)), m_assets(std::move(assets)), m_instance(&instance) {}

    /// The Params of its config with the values that they have in this instance, in text order; none whose value cannot be evaluated.
    [[nodiscard]] Params params() const;
    /// All geoms with these values in place of what the instance and its config give; the other Params keep theirs. Nothing where
    /// the config cannot be resolved at all; a geom for which a value does not fit is left out.
    [[nodiscard]] std::optional<std::vector<ConfigGeom>> geoms(const Params& changed) const;

private:
    std::shared_ptr<const Outline> m_outline;
    AssetLookup m_assets;
    const Part* m_instance; // of the outline
};

} // namespace trundle
