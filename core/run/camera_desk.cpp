#include "run/camera_desk.h"

namespace trundle {

CameraDesk::CameraDesk(const World& world, FrameSourceMaker maker) : m_world(world), m_maker(std::move(maker)) {
    for (const RobotSpec& robot : world.experiment().robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Camera" || !(device.number("UpdatePeriod") > 0)) continue;
            const std::string path = robot.name + "/" + device.name;
            if (const SignalEntry* frame = world.layout().find(path + "/frame")) m_streams[path].frameSlot = frame->offset;
        }
    }
    afterTick();
}

/// Where the world stands is kept, not a picture of it: most are never looked at.
void CameraDesk::afterTick() {
    std::shared_ptr<SignalBlock> now;
    for (auto& [path, stream] : m_streams) {
        const double frame = m_world.block().slots()[stream.frameSlot];
        if (frame == stream.frame) continue;
        if (!now) {
            now = std::make_shared<SignalBlock>(m_world.layout());
            now->copyFrom(m_world.block());
        }
        stream.frame = frame;
        stream.then = now;
    }
}

Result<FrameSource*> CameraDesk::source() {
    if (m_failure) return *m_failure;
    if (!m_source) {
        Result<std::unique_ptr<FrameSource>> made =
            m_maker ? m_maker(m_world.experiment(), m_world.layout())
                    : Result<std::unique_ptr<FrameSource>>(Error{Code::NoGraphics, "this run has nothing to draw pictures with"});
        if (!made) {
            m_failure = made.error();
            return *m_failure;
        }
        m_source = std::move(made).value();
    }
    return m_source.get();
}

Result<const Frame*> CameraDesk::capture(const std::string& camera) {
    const auto stream = m_streams.find(camera);
    const SignalBlock& state = stream == m_streams.end() ? m_world.block() : *stream->second.then;
    const auto taken = m_taken.find(camera);
    if (taken != m_taken.end() && taken->second.tick == state.header().tick) return &taken->second;
    const Result<FrameSource*> source = this->source();
    if (!source) return source.error();
    Result<Frame> frame = source.value()->capture(camera, state);
    if (!frame) {
        // A machine without OpenGL does not get one while the run goes on.
        if (frame.error().code == Code::NoGraphics) m_failure = frame.error();
        return frame.error();
    }
    return &m_taken.insert_or_assign(camera, std::move(frame).value()).first->second;
}

Result<Frame> CameraDesk::view(const std::string& name, std::uint32_t width, std::uint32_t height) {
    const Result<FrameSource*> source = this->source();
    if (!source) return source.error();
    return source.value()->view(name, width, height, m_world.block());
}

Result<std::string> CameraDesk::file(const std::string& camera, const std::string& fileName) {
    const Result<const Frame*> frame = capture(camera);
    if (!frame) return frame.error();
    return m_source->encode(*frame.value(), camera, fileName);
}

Result<std::string> CameraDesk::viewFile(const std::string& name, std::uint32_t width, std::uint32_t height,
                                         const std::string& fileName) {
    const Result<Frame> frame = view(name, width, height);
    if (!frame) return frame.error();
    return m_source->encode(frame.value(), "", fileName);
}

std::string CameraDesk::objectName(std::uint32_t object) {
    const Result<FrameSource*> source = this->source();
    return source ? source.value()->objectName(object) : std::string();
}

} // namespace trundle
