#pragma once
#include <memory>
#include <string>

#include "model/experiment_spec.h"
#include "render/render_entry.h"
#include "signals/camera_image.h"
#include "signals/layout.h"

namespace trundle {

/// Loads the render library from the modules folder. `experiment` and `layout` must outlive the returned source.
[[nodiscard]] Result<std::unique_ptr<ImageSource>> openImageSource(const std::string& folder, const ExperimentSpec& experiment,
                                                                   const SignalLayout& layout,
                                                                   const ImageSourceRequest& pictureOptions = {});

} // namespace trundle
