#pragma once
// What the render service is asked for.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/selection_outline.h"
#include "scene/nodes/masks.h"
#include "scene/overlay.h"
#include "scene/queries/camera_view.h"
#include "scene/queries/poses.h"
#include "scene/scene_marks.h"

namespace trundle {

inline constexpr std::uint32_t kMaxPixels = 4096; ///< along each side of an image

/// Scenes are numbered from 1; numbers are not reused.
enum class SceneId : std::uint64_t { None = 0 };

struct PictureRequest {
    SceneId scene = SceneId::None;
    std::optional<CameraView> view;           ///< nullopt: the default view of the scene
    std::uint32_t width = 1280, height = 720; ///< 1 .. kMaxPixels
    std::uint32_t mask = kMaskStill;
    /// Samples per pixel; 1: no antialiasing, and the fast look. A capture with 1 uses 4 in the rich look.
    int samples = 4;
    std::shared_ptr<const BodyPoses> poses; ///< null: start poses
    std::uint64_t stream = 0;               ///< not 0: a newer request of the same stream replaces one that is still queued
    bool capture = false;                   ///< a simulated camera waits for it: served before all views
    /// Set for a refinement of an image already shown: it is cancelled, with an Error without message, as soon as a request
    /// without this flag is queued.
    bool yields = false;
    bool wireframe = false; ///< robots and statics as lines
    bool floorLines = true; ///< grid lines on floors that have no texture
    double exposure = 1;    ///< factor on all light, before it is cut off at white
    SceneMarks marks;       ///< outlined objects; paths as in "robot0/chassis/hull"
    OutlineStyle outline;
    std::vector<std::string> hidden; ///< hidden objects, by the same paths
    SceneOverlay overlay;            ///< content of kMaskOverlay
};

struct PickRequest {
    SceneId scene = SceneId::None;
    CameraView view;
    std::uint32_t width = 1280, height = 720;
    double x = 0, y = 0; ///< pixels from the left and from the top
    std::uint32_t mask = kMaskRobots | kMaskStatics;
    std::shared_ptr<const BodyPoses> poses;
};

struct PickResult {
    std::string path; ///< "robot0/chassis/hull"; empty: no object
    Vec3 point = Vec3::Zero();
};

} // namespace trundle
