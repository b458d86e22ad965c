#include "render/render_entry.h"

#include <cstdio>
#include <exception>

#include "render/service.h"

namespace trundle {
namespace {

Vec3 vectorOf(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

Status renderOnce(const RenderJob& job) {
    if (job.structSize != sizeof(RenderJob)) return Error{Code::Internal, "the render library is of another build"};
    if (!job.experiment || !job.outputPath) return Error{Code::Internal, "no experiment or no file to write"};
    Result<std::unique_ptr<RenderService>> service = RenderService::start();
    if (!service) return service.error();

    PictureRequest request;
    // Only borrowed: the service ends before this function does.
    request.scene = service.value()->addScene({std::shared_ptr<const void>(), job.experiment});
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
    return image ? saveImage(image.value(), job.outputPath) : Status(image.error());
}

} // namespace
} // namespace trundle

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
