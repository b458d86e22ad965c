#include "render/camera_image_renderer.h"

#include "render/image_metadata.h"
#include "scene/queries/framing.h"
#include "scene/scene.h"

namespace trundle {

CameraImageRenderer::CameraImageRenderer(std::shared_ptr<const ExperimentSpec> experiment, const SignalLayout& layout,
                                         ImageSourceRequest imageRequest)
    : m_experiment(std::move(experiment)), m_reader(*m_experiment, layout), m_imageRequest(std::move(imageRequest)) {
    for (CameraModel& model : camerasOf(*m_experiment)) {
        std::optional<LensMap> lens = lensMapOf(model);
        std::string path = model.path;
        m_cameras.emplace(std::move(path), Camera{std::move(model), std::move(lens)});
    }
}

CameraImageRenderer::CameraImageRenderer(std::shared_ptr<const ExperimentSpec> experiment, RenderService& service)
    : CameraImageRenderer(std::move(experiment), SignalLayout()) {
    m_service = &service;
}

CameraImageRenderer::~CameraImageRenderer() {
    if (m_service && m_scene != SceneId::None) m_service->removeScene(m_scene);
}

void CameraImageRenderer::start() {
    if (!m_service) {
        m_own = RenderService::startInBackground(m_imageRequest.belowWindow);
        m_own->setLook(m_imageRequest.look);
        m_service = m_own.get();
    }
    if (m_scene == SceneId::None) m_scene = m_service->addScene(m_experiment);
}

Result<Image> CameraImageRenderer::drawn(PictureRequest request) {
    Result<Image> image = m_service->draw(std::move(request)).get();
    if (m_own && m_imageRequest.warn)
        if (const std::string notice = m_own->takeWarning(); !notice.empty()) m_imageRequest.warn(notice);
    return image;
}

Result<CameraImageRenderer::Camera*> CameraImageRenderer::cameraAt(const std::string& path) {
    const auto it = m_cameras.find(path);
    if (it != m_cameras.end()) return &it->second;
    std::string names;
    for (const auto& [name, camera] : m_cameras)
        if (names.size() < 200) names += (names.empty() ? "" : ", ") + name;
    return Error{Code::PictureFailed,
                 "there is no camera " + path + (names.empty() ? "; the experiment has none" : "; there is " + names)};
}

ImageTime CameraImageRenderer::momentOf(const SignalBlock& block) const {
    auto poses = std::make_shared<BodyPoses>();
    m_reader.read(block, *poses);
    return {std::move(poses), block.header().tick, block.header().time};
}

Result<CameraImage> CameraImageRenderer::capture(const std::string& path, const SignalBlock& block) {
    return capture(path, momentOf(block));
}

Result<CameraImage> CameraImageRenderer::capture(const std::string& path, const ImageTime& moment,
                                                 std::optional<CameraMode> mode) {
    const Result<Camera*> found = cameraAt(path);
    if (!found) return found.error();
    CameraModel model = found.value()->model;
    const std::optional<LensMap>& lens = found.value()->lens;
    if (mode) model.mode = *mode;
    start();

    PictureRequest request;
    request.scene = m_scene;
    request.view = settled(viewOf(model, model.body < moment.poses->size() ? (*moment.poses)[model.body] : Pose{}));
    request.width = lens ? lens->width : model.width;
    request.height = lens ? lens->height : model.height;
    if (lens) request.view->fieldOfView = lens->fieldOfView;
    request.mask = kMaskSensor;
    request.samples = 1;
    request.capture = true;
    request.floorLines = false; // a help for the eye, no property of the floor
    if (!model.seesSelf) request.hidden = {model.robot};
    request.poses = moment.poses;

    CameraImage frame;
    if (model.mode == CameraMode::Colour || model.mode == CameraMode::Grey) {
        request.exposure = model.exposure;
        Result<Image> image = drawn(std::move(request));
        if (!image) return image.error();
        frame = applySensorModel(model, lens, std::move(image).value());
    } else {
        Result<DataImage> measured = m_service->measure(std::move(request)).get();
        if (!measured) return measured.error();
        frame = applySensorModel(model, lens, std::move(measured).value());
    }
    frame.tick = moment.tick;
    frame.time = moment.time;
    addNoise(model, m_experiment->settings.seed, frame);
    return frame;
}

Result<CameraView> CameraImageRenderer::viewCalled(const std::string& name, const BodyPoses& poses) const {
    if (const std::optional<CameraView> view = namedView(*m_experiment, name, poses)) return *view;
    const std::string names = viewNames(*m_experiment);
    return Error{Code::PictureFailed,
                 "there is no view " + name + (names.empty() ? "; the text has none" : "; there is " + names)};
}

Status CameraImageRenderer::hasCamera(const std::string& path) {
    const Result<Camera*> camera = cameraAt(path);
    return camera ? Status() : Status(camera.error());
}

Status CameraImageRenderer::hasView(const std::string& name) const {
    const Result<CameraView> view = viewCalled(name, startPoses(*m_experiment));
    return view ? Status() : Status(view.error());
}

Result<CameraImage> CameraImageRenderer::view(const std::string& name, std::uint32_t width, std::uint32_t height,
                                              const SignalBlock& block) {
    const ImageTime moment = momentOf(block);
    PictureRequest request;
    if (name.empty()) {
        request.view = defaultView(*m_experiment, startPoses(*m_experiment), width, height);
    } else {
        const Result<CameraView> named = viewCalled(name, *moment.poses);
        if (!named) return named.error();
        request.view = named.value();
    }
    request.width = width;
    request.height = height;
    return picture(std::move(request), moment);
}

Result<CameraImage> CameraImageRenderer::picture(PictureRequest request, const ImageTime& moment) {
    start();
    request.scene = m_scene;
    request.poses = moment.poses;
    CameraImage frame;
    frame.width = request.width;
    frame.height = request.height;
    frame.tick = moment.tick;
    frame.time = moment.time;
    Result<Image> image = drawn(std::move(request));
    if (!image) return image.error();
    frame.pixels = std::move(std::move(image).value().pixels);
    return frame;
}

Result<std::string> CameraImageRenderer::encode(const CameraImage& frame, const std::string& camera,
                                                const std::string& fileName) {
    const auto it = m_cameras.find(camera);
    const std::string note = imageMetadata(frame, it == m_cameras.end() ? nullptr : &it->second.model, m_experiment->settings);
    const Image image{frame.width, frame.height, frame.pixels};
    Result<std::string> bytes = imageBytes(image, fileName);
    if (!bytes) return bytes;
    return withMetadata(std::move(bytes).value(), note);
}

} // namespace trundle
