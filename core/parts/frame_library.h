#pragma once
#include <memory>
#include <string>

#include "model/experiment_spec.h"
#include "render/render_entry.h"
#include "signals/frame.h"
#include "signals/layout.h"

namespace trundle {

/// Opens the library of pictures in the folder of modules. Experiment and layout outlive what it gives.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> openFrameSource(const std::string& folder, const ExperimentSpec& experiment,
                                                                   const SignalLayout& layout, const FrameSourceWish& wish = {});

} // namespace trundle
