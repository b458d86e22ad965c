#include "render/render_entry.h"

#include <cstdio>
#include <exception>

#include "base/platform/atomic_file.h"
#include "render/camera_image_renderer.h"

namespace trundle {
namespace {

Vec3 vectorOf(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

/// Non-owning; the experiment outlives every user of the pointer.
std::shared_ptr<const ExperimentSpec> borrowed(const ExperimentSpec* experiment) {
    return {std::shared_ptr<const void>(), experiment};
}

Status renderNamed(const RenderJob& job) {
    const SignalLayout noLayout;
    const SignalBlock noBlock(noLayout); // an empty block: everything is at its start pose
    const bool started = job.layout && job.block;
    CameraImageRenderer drawer(borrowed(job.experiment), started ? *job.layout : noLayout,
                               {job.look, job.warn ? *job.warn : std::function<void(const std::string&)>()});
    const SignalBlock& block = started ? *job.block : noBlock;
    const Result<CameraImage> frame =
        job.camera ? drawer.capture(job.camera, block) : drawer.view(job.view, job.width, job.height, block);
    if (!frame) return frame.error();
    const Result<std::string> bytes = drawer.encode(frame.value(), job.camera ? job.camera : "", job.outputPath);
    return bytes ? writeFileAtomically(job.outputPath, bytes.value()) : Status(bytes.error());
}

Status check(const RenderJob& job) {
    const SignalLayout noLayout;
    CameraImageRenderer drawer(borrowed(job.experiment), noLayout);
    Status status = job.camera ? drawer.hasCamera(job.camera) : job.view ? drawer.hasView(job.view) : Status();
    if (!status) return status;
    const Result<std::string> bytes = imageBytes({1, 1, {0, 0, 0}}, job.outputPath); // checks the extension
    return bytes ? Status() : Status(bytes.error());
}

Status renderOnce(const RenderJob& job) {
    if (job.structSize != sizeof(RenderJob)) return Error{Code::Internal, "the render library is of another build"};
    if (!job.experiment || !job.outputPath) return Error{Code::Internal, "no experiment or no file to write"};
    if (job.onlyCheck) return check(job);
    if (job.camera || job.view) return renderNamed(job);
    Result<std::unique_ptr<RenderService>> service = RenderService::start();
    if (!service) return service.error();

    service.value()->setLook(job.look);
    PictureRequest request;
    request.scene = service.value()->addScene(borrowed(job.experiment));
    request.width = job.width;
    request.height = job.height;
    if (job.hasView) {
        CameraView view;
        view.eye = vectorOf(job.eye);
        view.target = vectorOf(job.target);
        view.up = vectorOf(job.up);
        if (job.fieldOfView != 0) view.fieldOfView = job.fieldOfView;
        request.view = view;
    }
    if (job.layout && job.block) {
        auto poses = std::make_shared<BodyPoses>();
        PoseReader(*job.experiment, *job.layout).read(*job.block, *poses);
        request.poses = std::move(poses);
    }
    const Result<Image> image = service.value()->draw(std::move(request)).get();
    if (const std::string notice = service.value()->takeWarning(); job.warn && !notice.empty()) (*job.warn)(notice);
    return image ? saveImage(image.value(), job.outputPath) : Status(image.error());
}

} // namespace
} // namespace trundle

extern "C" trundle::ImageSource* trundle_frame_source(const trundle::ExperimentSpec* experiment,
                                                      const trundle::SignalLayout* layout,
                                                      const trundle::ImageSourceRequest* imageRequest, std::size_t build) {
    using namespace trundle;
    if (!experiment || !layout || !imageRequest || build != sizeof(RenderJob)) return nullptr;
    try {
        return new CameraImageRenderer(borrowed(experiment), *layout, *imageRequest);
    } catch (const std::exception&) { return nullptr; }
}

extern "C" int trundle_render_experiment(const trundle::RenderJob* job) {
    using namespace trundle;
    if (!job) return int(Code::Internal);
    Status status = Error{Code::Internal, "the render library failed"};
    try {
        status = renderOnce(*job);
    } catch (const std::exception& e) { status = Error{Code::PictureFailed, e.what()}; }
    if (status.ok()) return 0;
    if (job->error && job->errorSize > 0) std::snprintf(job->error, job->errorSize, "%s", status.error().message.c_str());
    return int(status.error().code);
}
