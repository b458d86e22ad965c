#pragma once
// The cameras of a run: pictures drawn when somebody asks, of this tick or of the last one that a camera's stream came to.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "signals/frame.h"
#include "world/world.h"

namespace trundle {

/// Opens whatever draws. Experiment and layout outlive what it gives.
using FrameSourceMaker =
    std::function<Result<std::unique_ptr<FrameSource>>(const ExperimentSpec& experiment, const SignalLayout& layout)>;

class CameraDesk {
public:
    /// `maker` is called with the first picture that is asked for; none: every picture ends with E510.
    CameraDesk(const World& world, FrameSourceMaker maker);

    /// Notes what streams show from now on. After each tick, and once at the start.
    void afterTick();

    /// What the camera "robot0/eye" gives now; good until it takes its next picture.
    [[nodiscard]] Result<const Frame*> capture(const std::string& camera);
    /// The state of this tick through a view, or of everything where `name` is empty.
    [[nodiscard]] Result<Frame> view(const std::string& name, std::uint32_t width, std::uint32_t height);
    /// capture() as a picture file, by the ending of `fileName`.
    [[nodiscard]] Result<std::string> file(const std::string& camera, const std::string& fileName);
    /// view() as a picture file.
    [[nodiscard]] Result<std::string> viewFile(const std::string& name, std::uint32_t width, std::uint32_t height,
                                               const std::string& fileName);
    [[nodiscard]] std::string objectName(std::uint32_t object);

private:
    struct Stream {
        std::uint32_t frameSlot = 0;
        double frame = -1;                       ///< number of the picture
        std::shared_ptr<const SignalBlock> then; ///< the state it shows; shared by all of one tick
    };
    [[nodiscard]] Result<FrameSource*> source();

    const World& m_world;
    FrameSourceMaker m_maker;
    std::unique_ptr<FrameSource> m_source;
    std::optional<Error> m_failure;
    std::map<std::string, Stream> m_streams;
    std::map<std::string, Frame> m_taken;
};

} // namespace trundle
