#pragma once
// Which Param of its config makes a Robot or Static how large along each of its axes, found by evaluating the config with other values.

#include <array>
#include <optional>
#include <string>

#include "editor/viewport/gizmo.h"
#include "project/instance_shapes.h"
#include "scene/bounds.h"

namespace trundle {

class ParamSizes {
public:
    /// Nothing for what is no Robot, Static, Grid or Scatter with a config that has shapes. A member stands for all of a Grid.
    [[nodiscard]] static std::optional<ParamSizes> of(const Loaded& loaded, const std::string& path);

    /// Around its shapes, in the config's frame.
    [[nodiscard]] const Bounds& box() const { return m_box; }
    /// An axis that exactly one Param sets the extent along can be sized.
    [[nodiscard]] bool canSize(int axis) const { return m_axes[std::size_t(axis)].param >= 0; }
    [[nodiscard]] bool canSizeAny() const { return canSize(0) || canSize(1) || canSize(2); }
    [[nodiscard]] SizeName sizeName(int axis) const;
    /// Why some axis cannot be sized, naming the Params there are; empty where each can.
    [[nodiscard]] QString refusal() const;
    /// The only shape of a config whose size no Param changes; empty where it is otherwise.
    [[nodiscard]] const std::string& onlyShape() const { return m_onlyShape; }

    /// A new value of a Param, and the box that it gives.
    struct Change {
        std::string param, text;
        Bounds box;
    };
    /// The value that gives an axis that can be sized this extent (m), to steps of `fineness` (m) of the extent.
    [[nodiscard]] Change resized(int axis, double extent, double fineness) const;

private:
    struct Param {
        std::string name, text; ///< text: its value as written, in the instance or the config
        GivenValue value;       ///< one number
        double metres = 1;      ///< of one of its unit
        bool written = false;   ///< the text is a number with or without a unit, not a formula
    };
    struct Axis {
        int param = -1;   ///< the one that sets it; -1: none
        double slope = 0; ///< m of extent per unit of the Param's number
        Sides sides = Sides::Both;
        std::vector<std::string> several; ///< more than one that could be meant
    };
    ParamSizes(std::string path, InstanceVariants variants) : m_path(std::move(path)), m_variants(std::move(variants)) {}

    [[nodiscard]] std::optional<Bounds> boxWith(const InstanceVariants::Params& changed) const;
    [[nodiscard]] InstanceVariants::Params with(const Param& param, double number) const;
    void findAxes(const InstanceVariants::Params& all);

    std::string m_path, m_config;
    InstanceVariants m_variants;
    std::vector<Param> m_params; // those that are one number
    std::array<Axis, 3> m_axes;
    Bounds m_box;
    std::size_t m_shapes = 0;
    std::string m_onlyShape;
};

} // namespace trundle
