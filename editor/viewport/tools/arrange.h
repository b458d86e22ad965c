#pragma once
// Commands that arrange several selected objects. Each call is one edit of the document; failures are reported through
// Document::refused.

#include <array>

#include <QString>

#include <trundle/geometry.h>

namespace trundle {

struct ViewContext;

/// Moves each object up or down until it rests on the surface below it, or on z = 0.
void dropToFloor(const ViewContext& context);

enum class AlignTo { Low, Middle, High };
/// Aligns the selected objects to the one selected last, along x, y or z.
void alignSelected(const ViewContext& context, int axis, AlignTo to);
/// Spaces the centres equally between the outermost two, along x, y or z.
void distributeSelected(const ViewContext& context, int axis);

struct ArrayCopy {
    std::array<int, 3> count{3, 1, 1}; ///< including the original
    Vec3 spacing{1, 1, 1};             ///< m
    bool asGrid = false;               ///< replaces a single Robot or Static by a Grid with the counts of x and y
};
void copyInRows(const ViewContext& context, const ArrayCopy& copy);
/// The reason why the selection cannot become a Grid; empty if it can.
[[nodiscard]] QString gridRefusal(const ViewContext& context);
/// True if that Grid's rows would be rotated, since its HPR applies to the rows as well as to each member. Single copies are
/// placed along the world's x and y.
[[nodiscard]] bool gridIsTurned(const ViewContext& context);

} // namespace trundle
