// Computes the poses of the members of a Grid.
#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

std::vector<Pose> gridPoses(ResolveContext& context, const Part& part, const Record& record) {
    const GridFields f = fieldsFrom<GridFields>(record);
    const Pose pattern = poseOf(f.pos, f.hpr);
    const auto nx = static_cast<std::size_t>(f.count[0]),
               ny = f.count.size() > 1 ? static_cast<std::size_t>(f.count[1]) : std::size_t{1};
    const double sx = f.spacing[0], sy = f.spacing.size() > 1 ? f.spacing[1] : sx;
    if ((nx > 1 && sx == 0) || (ny > 1 && sy == 0)) {
        const bool all = (nx == 1 || sx == 0) && (ny == 1 || sy == 0);
        context.diagnostics.warning(Code::OutOfRange, record.rangeOf("Spacing", part.nameRange()),
                                    (all ? "all members of " : "members of ") + part.title() + " are in one place: Spacing is 0");
    }
    std::vector<Pose> poses;
    poses.reserve(nx * ny);
    for (std::size_t iy = 0; iy < ny; ++iy) {
        for (std::size_t ix = 0; ix < nx; ++ix) {
            const Vec3 at((static_cast<double>(ix) - static_cast<double>(nx - 1) / 2) * sx,
                          (static_cast<double>(iy) - static_cast<double>(ny - 1) / 2) * sy, 0);
            poses.push_back({pattern * at, pattern.rotation});
        }
    }
    return poses;
}

} // namespace trundle
