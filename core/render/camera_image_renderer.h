#pragma once
#include <map>
#include <memory>

#include "render/image_source_request.h"
#include "render/sensor_model.h"
#include "render/service.h"
#include "scene/queries/camera_model.h"
#include "signals/camera_image.h"

namespace trundle {

/// Body poses and the time they belong to.
struct ImageTime {
    std::shared_ptr<const BodyPoses> poses;
    std::uint64_t tick = 0;
    double time = 0; ///< s
};

/// Renders the camera images of an experiment with a render service of its own, which is started by the first request. Without
/// OpenGL every request fails with E510.
class CameraImageRenderer final : public ImageSource {
public:
    /// `layout` describes all blocks passed later. Shares ownership of the experiment.
    CameraImageRenderer(std::shared_ptr<const ExperimentSpec> experiment, const SignalLayout& layout,
                        ImageSourceRequest imageRequest = {});
    /// The same for ImageTime requests only, with an existing service that must outlive this object.
    CameraImageRenderer(std::shared_ptr<const ExperimentSpec> experiment, RenderService& service);
    ~CameraImageRenderer() override;

    [[nodiscard]] Result<CameraImage> capture(const std::string& camera, const SignalBlock& block) override;
    [[nodiscard]] Result<CameraImage> view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                           const SignalBlock& block) override;
    [[nodiscard]] Result<std::string> encode(const CameraImage& frame, const std::string& camera,
                                             const std::string& fileName) override;

    /// The image that capture() would give for these poses; `mode` overrides the camera's own.
    [[nodiscard]] Result<CameraImage> capture(const std::string& camera, const ImageTime& moment,
                                              std::optional<CameraMode> mode = std::nullopt);
    /// A rendered image of the scene from any view, for these poses. The request's own scene and poses are ignored.
    [[nodiscard]] Result<CameraImage> picture(PictureRequest request, const ImageTime& moment);
    /// Fail with the message that a request would fail with. They start nothing.
    [[nodiscard]] Status hasCamera(const std::string& path);
    [[nodiscard]] Status hasView(const std::string& name) const;

private:
    struct Camera {
        CameraModel model;
        std::optional<LensMap> lens;
    };
    [[nodiscard]] Result<Camera*> cameraAt(const std::string& path);
    [[nodiscard]] Result<CameraView> viewCalled(const std::string& name, const BodyPoses& poses) const;
    [[nodiscard]] ImageTime momentOf(const SignalBlock& block) const;
    void start();
    [[nodiscard]] Result<Image> drawn(PictureRequest request);

    std::shared_ptr<const ExperimentSpec> m_experiment;
    PoseReader m_reader;
    std::map<std::string, Camera> m_cameras;
    ImageSourceRequest m_imageRequest; // for its own service
    std::unique_ptr<RenderService> m_own;
    RenderService* m_service = nullptr;
    SceneId m_scene = SceneId::None;
};

} // namespace trundle
