#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include <trundle/geometry.h>

#include "editor/document/document.h"

namespace trundle {

/// The values that make robots start where they stand now: Pos to a micrometre, HPR to a ten-thousandth of a degree.
struct KeptPoses {
    std::vector<ValueEdit> values; ///< only of robots that moved
    QString leftOut;               ///< names of robots that do not run
    QString refusal;               ///< why they cannot be kept; empty where they can
};

/// `poseNow` gives nothing for a robot that does not run.
[[nodiscard]] KeptPoses keptPoses(const Loaded& loaded,
                                  const std::function<std::optional<Pose>(const std::string& robot)>& poseNow);

} // namespace trundle
