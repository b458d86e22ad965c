#pragma once
// The render service: one off-screen context on a thread of its own. Callers post requests and receive pixels; OSG and OpenGL are
// not visible to them.

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "model/experiment_spec.h"
#include "render/data_image.h"
#include "render/image.h"
#include "render/look_choice.h"
#include "render/selection_outline.h"
#include "scene/camera_view.h"
#include "scene/masks.h"
#include "scene/overlay.h"
#include "scene/poses.h"
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

/// Thread-safe. Requests are served in order, captures before views; a request that cannot be served gives an Error. A `done`
/// callback is called exactly once, on the service's thread or, if the request is rejected, on any thread: it must not block, nor
/// call the service's destructor.
class RenderService {
public:
    using ImageDone = std::function<void(Result<Image>)>;
    using PickDone = std::function<void(Result<std::vector<PickResult>>)>;

    /// Starts the thread and its context. Fails with E510 without OpenGL.
    [[nodiscard]] static Result<std::unique_ptr<RenderService>> start();
    /// The same without waiting for the context; if there is none, each request fails with E510.
    [[nodiscard]] static std::unique_ptr<RenderService> startInBackground();
    /// Waits for the current request; queued ones end with an Error.
    ~RenderService();

    /// Builds the scene later, on the thread; cheap if an equal one exists. The experiment is kept until the scene is removed.
    /// `ghosts` are drawn grey and translucent under kMaskGhosts.
    [[nodiscard]] SceneId addScene(std::shared_ptr<const ExperimentSpec> experiment,
                                   std::shared_ptr<const ExperimentSpec> ghosts = nullptr);
    void removeScene(SceneId scene);

    /// Look of all later images except captures, which always use Automatic, so that a simulated camera gives the same image in
    /// all programs.
    void setLook(LookChoice look);
    /// A one-line warning for the user about the look; each is returned once, mostly empty.
    [[nodiscard]] std::string takeWarning();

    [[nodiscard]] std::future<Result<Image>> draw(PictureRequest request);
    void draw(PictureRequest request, ImageDone done);
    /// Depth and object number per pixel instead of the colours of draw(). Mask, samples, marks and lines are ignored.
    [[nodiscard]] std::future<Result<DataImage>> measure(PictureRequest request);
    /// The nearest object at a pixel.
    [[nodiscard]] std::future<Result<PickResult>> pick(PickRequest request);
    /// All objects at a pixel, nearest first.
    void pickAll(PickRequest request, PickDone done);

    // Both block until the context is open; empty and true if there is none.
    [[nodiscard]] const std::string& renderer() const; ///< GL_RENDERER
    [[nodiscard]] bool isSoftware() const;

private:
    struct Thread;
    explicit RenderService(std::unique_ptr<Thread> thread);
    std::unique_ptr<Thread> m_thread;
};

} // namespace trundle
