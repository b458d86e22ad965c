#pragma once
// A mesh of a file with a simple shape or several hulls for its collisions, as text.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace trundle {

/// The shape that collides. Where it is and how large, in m, in the frame of the config or body.
struct CollisionShape {
    enum class Kind { Box, Cylinder, Sphere, Capsule, Hull, Hulls };
    Kind kind = Kind::Hull; ///< Hull: of the mesh itself, without numbers; Hulls: in files of their own
    std::array<double, 3> centre{};
    int axis = 2; ///< of a cylinder or capsule: 0 along x, 1 along y, 2 along z
    std::array<double, 3> size{};
    double radius = 0, length = 0;
    std::vector<std::string> files; ///< of Hulls, as written
    std::vector<double> volumes;    ///< m^3, of Hulls
};

struct MeshPart {
    std::string name; ///< see meshName()
    std::string file; ///< as written
    double scale = 1;
    bool isYUp = false;             ///< of the file: turned so that z is up
    std::array<double, 3> origin{}; ///< of the file, m
    bool hasOwnLook = false;        ///< colours of its own file
    std::string surface = "wall";
    std::optional<double> mass; ///< kg; of a body
    CollisionShape shape;
};

/// A name for the blocks of a file: "Coffee cup (2).stl" becomes coffeeCup2.
[[nodiscard]] std::string meshName(const std::string& file);

/// Geoms for a StaticConfig or a Body.
[[nodiscard]] std::string meshGeomsText(const MeshPart& part);
/// A StaticConfig of them and a Static, for an experiment.
[[nodiscard]] std::string meshSceneryText(const MeshPart& part);

} // namespace trundle
