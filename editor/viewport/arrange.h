#pragma once
// Tools that put several selected objects in order. Each call is one edit of the document; what cannot be is said through
// Document::refused.

#include <array>

#include <QString>

#include <trundle/geometry.h>

namespace trundle {

struct ViewParts;

/// Lowers (or lifts) each object until it stands on what is below it, or on z = 0.
void dropToFloor(const ViewParts& parts);

enum class AlignTo { Low, Middle, High };
/// To the object selected last, along x, y or z.
void alignSelected(const ViewParts& parts, int axis, AlignTo to);
/// Middles at equal distances between the outermost two, along x, y or z.
void distributeSelected(const ViewParts& parts, int axis);

struct ArrayCopy {
    std::array<int, 3> count{3, 1, 1}; ///< with the original
    Vec3 spacing{1, 1, 1};             ///< m
    bool asGrid = false;               ///< a single robot becomes a Grid of count x and y
};
void copyInRows(const ViewParts& parts, const ArrayCopy& copy);
/// Why a Grid cannot be made of what is selected; empty where it can.
[[nodiscard]] QString gridRefusal(const ViewParts& parts);
/// Whether the rows of that Grid are turned, as its one HPR is that of the rows and of each robot. Single copies stand along x and y.
[[nodiscard]] bool gridIsTurned(const ViewParts& parts);

} // namespace trundle
