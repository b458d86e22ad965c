#pragma once
// Pictures as signals with a buffer: what a simulated camera saw, and the port through which a run gets it without knowing who
// draws.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "signals/block.h"

namespace trundle {

/// Rows from the top, no padding.
struct Frame {
    std::uint32_t width = 0, height = 0;
    std::uint64_t tick = 0;             ///< completed ticks of the state it shows
    double time = 0;                    ///< s
    std::vector<std::uint8_t> pixels;   ///< red, green, blue
    std::vector<float> depth;           ///< m along the camera's axis, infinite where there is nothing; not in all modes
    std::vector<std::uint32_t> objects; ///< 0 where there is nothing; not in all modes
};

/// Equal states give equal bytes, in whatever order they are asked for. Used on one thread, which waits for each picture.
class FrameSource {
public:
    virtual ~FrameSource() = default;

    /// What the camera "robot0/eye" sees with everything where the block says. E510 where no OpenGL is to be had.
    [[nodiscard]] virtual Result<Frame> capture(const std::string& camera, const SignalBlock& block) = 0;
    /// A view of the experiment by its name, or of everything where that is empty.
    [[nodiscard]] virtual Result<Frame> view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                             const SignalBlock& block) = 0;
    /// A picture file, .png or .jpg by the ending of `fileName`, that says where and when it was taken.
    [[nodiscard]] virtual Result<std::string> encode(const Frame& frame, const std::string& camera,
                                                     const std::string& fileName) = 0;
    /// "robot0/chassis/hull" for a number in Frame::objects; empty where there is none.
    [[nodiscard]] virtual std::string objectName(std::uint32_t object) const = 0;
};

} // namespace trundle
