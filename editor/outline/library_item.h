#pragma once
#include <string>
#include <vector>

#include <QString>

namespace trundle {

enum class LibrarySection { Robots, Arenas, Objects, RobotParts, Controllers, Shapes, Joints, Devices, World, Looks };
inline constexpr int kLibrarySections = 10;

/// Something that can be inserted into the experiment.
struct LibraryItem {
    LibrarySection section = LibrarySection::Objects;
    QString title, help, icon;
    std::string kind;                 ///< of the block that is inserted: "Robot", "Static", "Box"
    std::string text;                 ///< of the blocks; empty: the template of `kind`, made on insertion
    std::vector<std::string> imports; ///< directives that it needs: "robots/evbot.sim", "#loadModule controllers/linear_motion"
    std::string picture;              ///< text of an experiment that shows the item; empty: the icon is used
    std::string folder;               ///< search folder for the imports of that experiment

    bool operator==(const LibraryItem&) const = default;
};

[[nodiscard]] QString sectionTitle(LibrarySection section);

} // namespace trundle
