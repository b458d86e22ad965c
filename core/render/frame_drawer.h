#pragma once
#include <map>
#include <memory>

#include "render/develop.h"
#include "render/render_entry.h"
#include "render/service.h"
#include "scene/camera_model.h"
#include "signals/frame.h"

namespace trundle {

/// Where everything stands, and when that is.
struct FrameMoment {
    std::shared_ptr<const BodyPoses> poses;
    std::uint64_t tick = 0;
    double time = 0; ///< s
};

/// Draws what the cameras of an experiment see, with a render service of its own. Nothing is started before the first picture is
/// asked for. Where no OpenGL is to be had every picture ends with E510.
class FrameDrawer final : public FrameSource {
public:
    /// `layout` is that of all blocks to come. Keeps the experiment.
    FrameDrawer(std::shared_ptr<const ExperimentSpec> experiment, const SignalLayout& layout, FrameSourceWish wish = {});
    /// The same for moments alone, with a service that is there already and outlives this.
    FrameDrawer(std::shared_ptr<const ExperimentSpec> experiment, RenderService& service);
    ~FrameDrawer() override;

    [[nodiscard]] Result<Frame> capture(const std::string& camera, const SignalBlock& block) override;
    [[nodiscard]] Result<Frame> view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                     const SignalBlock& block) override;
    [[nodiscard]] Result<std::string> encode(const Frame& frame, const std::string& camera, const std::string& fileName) override;
    [[nodiscard]] std::string objectName(std::uint32_t object) const override;

    /// What capture() gives while everything stands so; `mode` takes the place of the camera's own.
    [[nodiscard]] Result<Frame> capture(const std::string& camera, const FrameMoment& moment,
                                        std::optional<CameraMode> mode = std::nullopt);
    /// A picture of its scene from anywhere, at that moment. The request's own scene and poses do not matter.
    [[nodiscard]] Result<Frame> picture(PictureRequest request, const FrameMoment& moment);
    /// Fail with the words that a picture would fail with. Nothing is started for them.
    [[nodiscard]] Status hasCamera(const std::string& path);
    [[nodiscard]] Status hasView(const std::string& name) const;

private:
    struct Camera {
        CameraModel model;
        std::optional<LensMap> lens;
    };
    [[nodiscard]] Result<Camera*> cameraAt(const std::string& path);
    [[nodiscard]] Result<CameraView> viewCalled(const std::string& name, const BodyPoses& poses) const;
    [[nodiscard]] FrameMoment momentOf(const SignalBlock& block) const;
    void start();
    [[nodiscard]] Result<Image> drawn(PictureRequest request);

    std::shared_ptr<const ExperimentSpec> m_experiment;
    PoseReader m_reader;
    std::map<std::string, Camera> m_cameras;
    std::vector<std::string> m_objects;
    FrameSourceWish m_wish; // of its own service
    std::unique_ptr<RenderService> m_own;
    RenderService* m_service = nullptr;
    SceneId m_scene = SceneId::None;
};

} // namespace trundle
