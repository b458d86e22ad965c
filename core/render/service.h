#pragma once
// The render service: one off-screen context on a thread of its own. Others post requests and get pixels back; no OSG and no
// OpenGL outside it.

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "model/experiment_spec.h"
#include "render/image.h"
#include "render/look_choice.h"
#include "render/measured.h"
#include "render/outline.h"
#include "scene/masks.h"
#include "scene/overlay.h"
#include "scene/poses.h"
#include "scene/scene_marks.h"
#include "scene/view.h"

namespace trundle {

inline constexpr std::uint32_t kMostPixels = 4096; ///< along each side of a picture

/// Scenes are numbered from 1 and never numbered twice.
enum class SceneId : std::uint64_t { None = 0 };

struct PictureRequest {
    SceneId scene = SceneId::None;
    std::optional<CameraView> view;           ///< none: the default view of the scene
    std::uint32_t width = 1280, height = 720; ///< 1 .. kMostPixels
    std::uint32_t mask = kMaskStill;
    /// For each pixel; 1: jagged, and in the fast look, but for a capture, for which 4 are taken where it is rich.
    int samples = 4;
    std::shared_ptr<const BodyPoses> poses; ///< none: start poses
    std::uint64_t stream = 0;               ///< not 0: a newer request of the same stream takes the place of one that still waits
    bool capture = false;                   ///< a simulated camera waits for it: it goes before all views
    /// Only a finer picture of what is shown already: it ends, with an Error of no words, as soon as a request waits that is none.
    bool yields = false;
    bool wireframe = false; ///< robots and statics as lines
    bool floorLines = true; ///< metres marked on floors that have no picture
    SceneMarks marks;       ///< outlined; paths as "robot0/chassis/hull"
    OutlineStyle outline;
    std::vector<std::string> hidden; ///< left out, as the marks by path
    SceneOverlay overlay;            ///< what kMaskOverlay shows
};

struct PickRequest {
    SceneId scene = SceneId::None;
    CameraView view;
    std::uint32_t width = 1280, height = 720;
    double x = 0, y = 0; ///< pixels from the left and the top
    std::uint32_t mask = kMaskRobots | kMaskStatics;
    std::shared_ptr<const BodyPoses> poses;
};

struct Picked {
    std::string path; ///< "robot0/chassis/hull"; empty: nothing there
    Vec3 point = Vec3::Zero();
};

/// Safe to call from any thread. Requests are served in order, captures before views; a request that cannot be served gives an
/// Error, never a crash. A `done` is called once, on the service's thread or, where the request is refused, on any: it must
/// not wait, nor call the service's destructor.
class RenderService {
public:
    using ImageDone = std::function<void(Result<Image>)>;
    using PickDone = std::function<void(Result<std::vector<Picked>>)>;

    /// Starts the thread and its context. E510 where no OpenGL is to be had.
    [[nodiscard]] static Result<std::unique_ptr<RenderService>> start();
    /// The same without waiting for the context; where there is none, each request ends with E510.
    [[nodiscard]] static std::unique_ptr<RenderService> startInBackground();
    /// Waits for the request in work; those behind it end with an Error.
    ~RenderService();

    /// Builds the scene (later, on the thread), at little cost where one like it is there already. The experiment is kept until
    /// the scene goes. `ghosts` are drawn grey and translucent under kMaskGhosts.
    [[nodiscard]] SceneId addScene(std::shared_ptr<const ExperimentSpec> experiment,
                                   std::shared_ptr<const ExperimentSpec> ghosts = nullptr);
    void removeScene(SceneId scene);

    /// Of all pictures from now on but captures: theirs is Automatic, so that what a simulated camera sees is the same in all programs.
    void setLook(LookChoice look);
    /// A line for a person about the look of what was drawn, each once; mostly empty.
    [[nodiscard]] std::string takeNotice();

    [[nodiscard]] std::future<Result<Image>> draw(PictureRequest request);
    void draw(PictureRequest request, ImageDone done);
    /// How far away everything is, and what it is, where draw() would give its colour. Mask, samples, marks and lines do not matter.
    [[nodiscard]] std::future<Result<Measured>> measure(PictureRequest request);
    /// What is nearest below a pixel.
    [[nodiscard]] std::future<Result<Picked>> pick(PickRequest request);
    /// Everything below a pixel, nearest first.
    void pickAll(PickRequest request, PickDone done);

    // Both wait until the context is there; empty and true where there is none.
    [[nodiscard]] const std::string& renderer() const; ///< GL_RENDERER
    [[nodiscard]] bool isSoftware() const;

private:
    struct Thread;
    explicit RenderService(std::unique_ptr<Thread> thread);
    std::unique_ptr<Thread> m_thread;
};

} // namespace trundle
