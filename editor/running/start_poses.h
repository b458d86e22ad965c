#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include <trundle/geometry.h>

#include "editor/document/document.h"

namespace trundle {

/// The values that make robots start at their current poses: Pos to a micrometre, HPR to a ten-thousandth of a degree.
struct StartPoses {
    std::vector<ValueEdit> values; ///< only of robots that moved
    QString leftOut;               ///< names of robots that are not in the run
    QString refusal;               ///< why the poses cannot be kept; empty if they can
};

/// `poseNow` returns nothing for a robot that is not in the run.
[[nodiscard]] StartPoses startPoses(const LoadedProject& loaded,
                                    const std::function<std::optional<Pose>(const std::string& robot)>& poseNow);

} // namespace trundle
