#pragma once
// The door of the render library, which programs open on first use so that a run without pictures starts fast. Caller and
// library are of one build: pointers to our own types cross it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "render/look_choice.h"

namespace trundle {

struct ExperimentSpec;
class FrameSource;
class SignalLayout;
class SignalBlock;

struct RenderJob {
    std::uint32_t structSize = sizeof(RenderJob);
    const ExperimentSpec* experiment = nullptr;
    const SignalLayout* layout = nullptr; ///< with `block`: poses from signals; without: start poses
    const SignalBlock* block = nullptr;
    bool hasView = false; ///< false: the whole scene from a raised three-quarter view
    double eye[3] = {0, 0, 0}, target[3] = {0, 0, 0}, up[3] = {0, 0, 1}; ///< m, world
    double fieldOfView = 0;                                              ///< rad, horizontal; 0: the default
    std::uint32_t width = 1280, height = 720;                            ///< up to 4096
    const char* view = nullptr;   ///< a View of the text; what the other fields say of the view does not matter then
    const char* camera = nullptr; ///< "robot0/eye": what that camera gives, in its own size; the view does not matter then
    LookChoice look = LookChoice::Automatic; ///< not of what a camera gives
    const char* outputPath = nullptr;        ///< .png, .jpg or .jpeg
    bool onlyCheck = false; ///< draws nothing: says whether camera and view are there and the ending is one of those
    char* error = nullptr;  ///< one line, ends with NUL; may be null
    std::size_t errorSize = 0;
    const std::function<void(const std::string&)>* warn = nullptr; ///< told, in a line, what a person should know of the picture
};

/// How pictures of a run look, and who is told where that cannot be.
struct FrameSourceWish {
    LookChoice look = LookChoice::Automatic; ///< of views; not of what cameras see
    std::function<void(const std::string&)> warn;
};

} // namespace trundle

#define TRUNDLE_RENDER_LIBRARY "libtrundle_render.so"

#define TRUNDLE_RENDER_EXPORT __attribute__((visibility("default")))

extern "C" {
/// Writes one picture. 0, or the number of the diagnostic code (510: no OpenGL to be had, 511: the picture failed) with its
/// words in `error`. Throws nothing.
TRUNDLE_RENDER_EXPORT int trundle_render_experiment(const trundle::RenderJob* job);
/// What the cameras of an experiment see; experiment and layout outlive it. To be deleted by the caller, before the library is
/// closed. nullptr where `build` is not sizeof(RenderJob), as another build's may be.
TRUNDLE_RENDER_EXPORT trundle::FrameSource* trundle_frame_source(const trundle::ExperimentSpec* experiment,
                                                                 const trundle::SignalLayout* layout,
                                                                 const trundle::FrameSourceWish* wish, std::size_t build);
}
