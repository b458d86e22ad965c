#pragma once
// Camera images as signals, and the interface through which a run gets them independently of the renderer.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "signals/block.h"

namespace trundle {

/// Rows from the top, without padding.
struct CameraImage {
    std::uint32_t width = 0, height = 0;
    std::uint64_t tick = 0;             ///< completed ticks of the state shown
    double time = 0;                    ///< s
    std::vector<std::uint8_t> pixels;   ///< RGB
    std::vector<float> depth;           ///< m along the camera's axis, infinite without an object; only in some modes
    std::vector<std::uint32_t> objects; ///< object numbers, 0 without an object; only in some modes
};

/// The newest image that a run made of a camera, for a controller or a log.
struct RunImage {
    std::shared_ptr<const CameraImage> image;
    std::uint64_t interval = 1; ///< ticks since the image before it

    /// The run's next image of the camera is not overdue after this number of completed ticks.
    [[nodiscard]] bool isRecentAt(std::uint64_t tick) const { return image->tick <= tick && tick - image->tick <= interval + 1; }
};
using RunImages = std::map<std::string, RunImage>; ///< by camera: "robot0/eye"

/// Provides camera images. Equal states give equal bytes, in any order of requests. Called on one thread, which blocks until each
/// image is complete.
class ImageSource {
public:
    virtual ~ImageSource() = default;

    /// The image of the camera "robot0/eye" with all poses taken from the block. E510 without OpenGL.
    [[nodiscard]] virtual Result<CameraImage> capture(const std::string& camera, const SignalBlock& block) = 0;
    /// A view of the experiment by name; if the name is empty, a view of the whole scene.
    [[nodiscard]] virtual Result<CameraImage> view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                                   const SignalBlock& block) = 0;
    /// Encodes an image file, .png or .jpg according to the extension of `fileName`, with the camera's pose and the time as
    /// metadata.
    [[nodiscard]] virtual Result<std::string> encode(const CameraImage& frame, const std::string& camera,
                                                     const std::string& fileName) = 0;
};

} // namespace trundle
