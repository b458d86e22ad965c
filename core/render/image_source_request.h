#pragma once
#include <functional>
#include <string>

#include "render/look_choice.h"

namespace trundle {

/// Appearance of a run's images, and the receiver of warnings about it.
struct ImageSourceRequest {
    LookChoice look = LookChoice::Automatic; ///< of views; does not apply to camera images
    std::function<void(const std::string&)> warn;
    bool belowWindow = false; ///< drawing leaves the processors to a window that is open beside the run
};

} // namespace trundle
