#pragma once
// The camera images of a run, drawn on request from the current state or from the last state that a camera published.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "signals/camera_image.h"
#include "world/world.h"

namespace trundle {

/// Opens the image renderer. `experiment` and `layout` must outlive it.
using ImageSourceFactory =
    std::function<Result<std::unique_ptr<ImageSource>>(const ExperimentSpec& experiment, const SignalLayout& layout)>;

class CameraCapture {
public:
    /// `maker` is called at the first request; without it every request fails with E510.
    CameraCapture(const World& world, ImageSourceFactory maker);

    /// Records the states that the cameras' current images show. Must be called after each tick, and once at the start.
    void afterTick();

    /// The current image of the camera "robot0/eye"; valid until the camera's next image.
    [[nodiscard]] Result<const CameraImage*> capture(const std::string& camera);
    /// The current state seen from a view, or the whole scene if `name` is empty.
    [[nodiscard]] Result<CameraImage> view(const std::string& name, std::uint32_t width, std::uint32_t height);
    /// The image of capture(), encoded as a file; the format follows the ending of `fileName`.
    [[nodiscard]] Result<std::string> file(const std::string& camera, const std::string& fileName);
    /// The image of view(), encoded as a file.
    [[nodiscard]] Result<std::string> viewFile(const std::string& name, std::uint32_t width, std::uint32_t height,
                                               const std::string& fileName);
    /// The newest image of each camera that was captured so far.
    [[nodiscard]] const RunImages& images() const { return m_taken; }

private:
    struct Stream {
        std::uint32_t frameSlot = 0;
        double frame = -1;                       ///< number of the image
        std::shared_ptr<SignalBlock> then;       ///< the state that it shows; shared by all cameras of one tick
    };
    [[nodiscard]] Result<ImageSource*> source();

    const World& m_world;
    ImageSourceFactory m_maker;
    std::unique_ptr<ImageSource> m_source;
    std::optional<Error> m_failure;
    std::map<std::string, Stream> m_streams;
    RunImages m_taken;
};

} // namespace trundle
