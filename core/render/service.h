#pragma once
// The render service: one off-screen context on a thread of its own. Others post requests and get pixels back; no OSG and no
// OpenGL outside it.

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "model/experiment_spec.h"
#include "render/image.h"
#include "scene/masks.h"
#include "scene/poses.h"
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
    int samples = 4;                          ///< for each pixel; 1: fast and jagged
    std::shared_ptr<const BodyPoses> poses;   ///< none: start poses
    std::uint64_t stream = 0; ///< not 0: a newer request of the same stream takes the place of one that still waits
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

/// Safe to call from any thread. Requests are served in order; a request that cannot be served gives an Error, never a crash.
class RenderService {
public:
    /// Starts the thread and its context. E510 where no OpenGL is to be had.
    [[nodiscard]] static Result<std::unique_ptr<RenderService>> start();
    /// Waits for the request in work; those behind it end with an Error.
    ~RenderService();

    /// Builds the scene (later, on the thread). The experiment is kept until the scene goes.
    [[nodiscard]] SceneId addScene(std::shared_ptr<const ExperimentSpec> experiment);
    void removeScene(SceneId scene);

    [[nodiscard]] std::future<Result<Image>> draw(PictureRequest request);
    [[nodiscard]] std::future<Result<Picked>> pick(PickRequest request);

    [[nodiscard]] const std::string& renderer() const; ///< GL_RENDERER
    [[nodiscard]] bool isSoftware() const;

private:
    struct Thread;
    explicit RenderService(std::unique_ptr<Thread> thread);
    std::unique_ptr<Thread> m_thread;
};

} // namespace trundle
