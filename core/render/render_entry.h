#pragma once
// Entry points of the render library, which programs load on first use so that a run without images starts fast. Caller and
// library must come from the same build, because pointers to C++ types cross the border.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "render/image_source_request.h"

namespace trundle {

struct ExperimentSpec;
class ImageSource;
class SignalLayout;
class SignalBlock;

struct RenderJob {
    std::uint32_t structSize = sizeof(RenderJob);
    const ExperimentSpec* experiment = nullptr;
    const SignalLayout* layout = nullptr; ///< with `block`: poses from signals; otherwise start poses
    const SignalBlock* block = nullptr;
    bool hasView = false; ///< false: the whole scene from a raised three-quarter view
    double eye[3] = {0, 0, 0}, target[3] = {0, 0, 0}, up[3] = {0, 0, 1}; ///< m, world
    double fieldOfView = 0;                                              ///< rad, horizontal; 0: the default
    std::uint32_t width = 1280, height = 720;                            ///< up to 4096
    const char* view = nullptr;              ///< name of a View block; overrides the view fields above
    const char* camera = nullptr;            ///< "robot0/eye": the image of that camera in its own size; overrides the view
    LookChoice look = LookChoice::Automatic; ///< does not apply to camera images
    const char* outputPath = nullptr;        ///< .png, .jpg or .jpeg
    bool onlyCheck = false;                  ///< draws nothing; checks the camera, the view and the extension
    char* error = nullptr;                   ///< receives one line, NUL-terminated; may be null
    std::size_t errorSize = 0;
    const std::function<void(const std::string&)>* warn = nullptr; ///< called with a one-line warning for the user
};

} // namespace trundle

#define TRUNDLE_RENDER_LIBRARY "libtrundle_render.so"

#define TRUNDLE_RENDER_EXPORT __attribute__((visibility("default")))

extern "C" {
/// Writes one image file. Returns 0, or the number of the diagnostic code (510: no OpenGL, 511: rendering failed) with its
/// message in `error`. Does not throw.
TRUNDLE_RENDER_EXPORT int trundle_render_experiment(const trundle::RenderJob* job);
/// Source of an experiment's camera images; experiment and layout must outlive it. The caller deletes it before closing the
/// library. Returns nullptr if `build` is not sizeof(RenderJob), as for a caller of another build.
TRUNDLE_RENDER_EXPORT trundle::ImageSource* trundle_frame_source(const trundle::ExperimentSpec* experiment,
                                                                 const trundle::SignalLayout* layout,
                                                                 const trundle::ImageSourceRequest* imageRequest,
                                                                 std::size_t build);
}
