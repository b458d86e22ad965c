#include "run/camera_capture.h"

#include <algorithm>

namespace trundle {

CameraCapture::CameraCapture(const World& world, ImageSourceFactory maker) : m_world(world), m_maker(std::move(maker)) {
    for (const RobotSpec& robot : world.experiment().robots) {
        if (!robot.config) continue;
        const bool mayBeOff =
            std::ranges::find(robot.config->devices, "Battery", &ComponentSpec::kind) != robot.config->devices.end();
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Camera" || !(device.number("UpdatePeriod") > 0 || mayBeOff)) continue;
            const std::string path = robot.name + "/" + device.name;
            if (const auto frame = world.layout().find(path + "/frame")) m_streams[path].frameSlot = frame->offset;
        }
    }
    afterTick();
}

/// Stores the signal state of each new image instead of drawing it: most images are never requested.
void CameraCapture::afterTick() {
    std::shared_ptr<SignalBlock> now;
    for (auto& [path, stream] : m_streams) {
        const double frame = m_world.block().slots()[stream.frameSlot];
        if (frame == stream.frame) continue;
        if (!now) {
            now = stream.then.use_count() == 1 ? stream.then : std::make_shared<SignalBlock>(m_world.layout());
            now->copyFrom(m_world.block());
        }
        stream.frame = frame;
        stream.then = now;
    }
}

Result<ImageSource*> CameraCapture::source() {
    if (m_failure) return *m_failure;
    if (!m_source) {
        Result<std::unique_ptr<ImageSource>> made =
            m_maker ? m_maker(m_world.experiment(), m_world.layout())
                    : Result<std::unique_ptr<ImageSource>>(Error{Code::NoGraphics, "this run has nothing to draw pictures with"});
        if (!made) {
            m_failure = made.error();
            return *m_failure;
        }
        m_source = std::move(made).value();
    }
    return m_source.get();
}

Result<const CameraImage*> CameraCapture::capture(const std::string& camera) {
    const auto stream = m_streams.find(camera);
    const SignalBlock& state = stream == m_streams.end() ? m_world.block() : *stream->second.then;
    const auto taken = m_taken.find(camera);
    const CameraImage* before = taken == m_taken.end() ? nullptr : taken->second.image.get();
    if (before && before->tick == state.header().tick) return before;
    const Result<ImageSource*> source = this->source();
    if (!source) return source.error();
    Result<CameraImage> frame = source.value()->capture(camera, state);
    if (!frame) {
        // OpenGL does not become available during a run.
        if (frame.error().code == Code::NoGraphics) m_failure = frame.error();
        return frame.error();
    }
    auto image = std::make_shared<const CameraImage>(std::move(frame).value());
    const std::uint64_t interval = before ? image->tick - before->tick : 1;
    return m_taken.insert_or_assign(camera, RunImage{std::move(image), interval}).first->second.image.get();
}

Result<CameraImage> CameraCapture::view(const std::string& name, std::uint32_t width, std::uint32_t height) {
    const Result<ImageSource*> source = this->source();
    if (!source) return source.error();
    return source.value()->view(name, width, height, m_world.block());
}

Result<std::string> CameraCapture::file(const std::string& camera, const std::string& fileName) {
    const Result<const CameraImage*> frame = capture(camera);
    if (!frame) return frame.error();
    return m_source->encode(*frame.value(), camera, fileName);
}

Result<std::string> CameraCapture::viewFile(const std::string& name, std::uint32_t width, std::uint32_t height,
                                            const std::string& fileName) {
    const Result<CameraImage> frame = view(name, width, height);
    if (!frame) return frame.error();
    return m_source->encode(frame.value(), "", fileName);
}

} // namespace trundle
