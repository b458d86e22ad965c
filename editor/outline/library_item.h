#pragma once
#include <string>
#include <vector>

#include <QString>

namespace trundle {

enum class LibrarySection { Robots, Arenas, Objects, RobotParts, Controllers, Shapes, Joints, Devices, World, Looks };
inline constexpr int kLibrarySections = 10;

/// Something to be put into the experiment.
struct LibraryItem {
    LibrarySection section = LibrarySection::Objects;
    QString title, help, icon;
    std::string kind;                 ///< of the block that is placed: "Robot", "Static", "Box"
    std::string text;                 ///< of the blocks; empty: the template of `kind`, made when it is wanted
    std::vector<std::string> imports; ///< directives that it needs: "robots/evbot.sim", "#loadModule controllers/linear_motion"
    std::string picture;              ///< an experiment that shows it; empty: the icon does
    std::string folder;               ///< from which that experiment's imports are looked for

    bool operator==(const LibraryItem&) const = default;
};

[[nodiscard]] QString sectionTitle(LibrarySection section);

} // namespace trundle
