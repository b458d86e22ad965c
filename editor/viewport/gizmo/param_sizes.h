#pragma once
// Determines which Param of a config sets the size of a Robot or Static along each axis, by evaluating the config with varied
// values.

#include <array>
#include <optional>
#include <string>

#include "editor/viewport/gizmo/gizmo.h"
#include "project/objects/instance_shapes.h"
#include "scene/shapes/bounds.h"

namespace trundle {

class ParamSizes {
public:
    /// nullopt unless `path` is a Robot, Static, Grid or Scatter with a config that has shapes. One member represents the whole
    /// Grid.
    [[nodiscard]] static std::optional<ParamSizes> of(const LoadedProject& loaded, const std::string& path);

    /// Bounding box of its shapes, in the config's frame.
    [[nodiscard]] const Bounds& box() const { return m_box; }
    /// True if exactly one Param sets the extent along that axis.
    [[nodiscard]] bool canSize(int axis) const { return m_axes[std::size_t(axis)].param >= 0; }
    [[nodiscard]] bool canSizeAny() const { return canSize(0) || canSize(1) || canSize(2); }
    [[nodiscard]] SizeName sizeName(int axis) const;
    /// Why some axis cannot be scaled, naming the Params involved; empty if all can.
    [[nodiscard]] QString refusal() const;
    /// Path of the only shape of a config whose size does not depend on Params; otherwise empty.
    [[nodiscard]] const std::string& onlyShape() const { return m_onlyShape; }

    /// A new value of a Param, and the bounding box that it results in.
    struct Change {
        std::string param, text, before; ///< before: as written in the instance, or a plain number of the config; else empty
        Bounds box;
    };
    /// The value that gives a scalable axis the extent (m), rounded so that the extent is accurate to `fineness` (m).
    [[nodiscard]] Change resized(int axis, double extent, double fineness) const;

private:
    struct Param {
        std::string name, text; ///< text: its value as written in the instance or the config
        GivenValue value;       ///< a single number
        double metres = 1;      ///< metres per unit of the value
        bool written = false;   ///< the text is a number with or without a unit, not a formula
    };
    struct Axis {
        int param = -1;   ///< index of the Param that sets it; -1: none
        double slope = 0; ///< m of extent per unit of the Param
        Sides sides = Sides::Both;
        std::vector<std::string> several; ///< Params that affect it, where it is ambiguous
    };
    ParamSizes(std::string path, InstanceVariants variants) : m_path(std::move(path)), m_variants(std::move(variants)) {}

    struct Effect {                                   ///< of a Param on the sides of the box
        Vec3 low = Vec3::Zero(), high = Vec3::Zero(); ///< m per unit of the Param
        [[nodiscard]] Vec3 slope() const { return high - low; }
    };

    [[nodiscard]] std::optional<Bounds> boxWith(const InstanceVariants::Params& changed) const;
    [[nodiscard]] InstanceVariants::Params with(const Param& param, double number) const;
    void findAxes(const InstanceVariants::Params& all);
    [[nodiscard]] Effect effectOf(const Param& param, const InstanceVariants::Params& all) const;
    [[nodiscard]] Axis axisFrom(int axis, const std::vector<Effect>& effects) const;

    std::string m_path, m_config;
    InstanceVariants m_variants;
    std::vector<Param> m_params; // numeric ones only
    std::array<Axis, 3> m_axes;
    Bounds m_box;
    std::size_t m_shapes = 0;
    std::string m_onlyShape;
};

} // namespace trundle
