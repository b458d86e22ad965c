#pragma once
#include <string>
#include <vector>

namespace trundle {

/// Objects to outline, as paths of robots, bodies, geoms and statics: "robot0/chassis/hull".
struct SceneMarks {
    std::vector<std::string> selected, hovered;
    [[nodiscard]] bool empty() const { return selected.empty() && hovered.empty(); }
    bool operator==(const SceneMarks&) const = default;
};

} // namespace trundle
