#pragma once
// The render service: one off-screen context on a thread of its own. Callers post requests and receive pixels; OSG and OpenGL are
// not visible to them.

#include <functional>
#include <future>
#include <memory>
#include <string>

#include "model/experiment_spec.h"
#include "render/data_image.h"
#include "render/image.h"
#include "render/look_choice.h"
#include "render/requests.h"

namespace trundle {

/// Thread-safe. Requests are served in order, captures before views; a request that cannot be served gives an Error. A `done`
/// callback is called exactly once, on the service's thread or, if the request is rejected, on any thread: it must not block, nor
/// call the service's destructor.
class RenderService {
public:
    using ImageDone = std::function<void(Result<Image>)>;
    using PickDone = std::function<void(Result<std::vector<PickResult>>)>;

    /// Starts the thread and its context. Fails with E510 without OpenGL.
    [[nodiscard]] static Result<std::unique_ptr<RenderService>> start();
    /// The same without waiting for the context; if there is none, each request fails with E510. `belowWindow`: software
    /// rendering uses all processors, and the thread of a window has priority over it.
    [[nodiscard]] static std::unique_ptr<RenderService> startInBackground(bool belowWindow = true);
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
