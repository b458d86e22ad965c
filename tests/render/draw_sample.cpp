// Draws a sample or an experiment into a file: draw_sample WHAT OUT [eye x y z target x y z fov]. With the environment variable
// TIMES it prints drawing times, the best of ROUNDS times 5, for images whose name contains the value of TIMES. LOOK is rich or fast.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numbers>

#ifdef WITH_CONFIGS
#include "render/config_experiment.h"
#endif
#include "render/sample_experiment.h"
#include "render/service.h"

using namespace trundle;

int main(int argc, char** argv) {
    if (argc < 3) return std::fprintf(stderr, "draw_sample N|shapes|FILE OUT [EYE TARGET FOV] (6 numbers and degrees)\n"), 2;
    const int robots = std::atoi(argv[1]);
    const double side = std::max(4.0, 0.8 * std::ceil(std::sqrt(double(robots))));
    std::shared_ptr<const ExperimentSpec> experiment;
    if (std::strcmp(argv[1], "shapes") == 0) experiment = shapesExperiment();
    else if (robots > 0) experiment = sampleExperiment({robots, 0.7, true, side});
#ifdef WITH_CONFIGS
    else experiment = readExperiment(argv[1]);
#endif
    if (!experiment) return std::fprintf(stderr, "no experiment %s\n", argv[1]), 2;
    auto service = RenderService::start();
    if (!service) return std::fprintf(stderr, "%s\n", service.error().message.c_str()), 1;
    if (const char* look = std::getenv("LOOK")) service.value()->setLook(*look == 'r' ? LookChoice::Rich : LookChoice::Fast);
    PictureRequest request;
    request.scene = service.value()->addScene(experiment);
    if (argc >= 10) {
        CameraView view;
        for (int i = 0; i < 3; ++i) view.eye[i] = std::atof(argv[3 + i]), view.target[i] = std::atof(argv[6 + i]);
        view.fieldOfView = std::atof(argv[9]) * std::numbers::pi / 180;
        request.view = view;
    }
    if (std::getenv("TIMES")) request.width = 64, request.height = 48, request.mask = kMaskSensor, request.samples = 1;
    const auto image = service.value()->draw(request).get();
    if (!image) return std::fprintf(stderr, "%s\n", image.error().message.c_str()), 1;
    const Status saved = saveImage(image.value(), argv[2]);
    if (!saved) return std::fprintf(stderr, "%s\n", saved.error().message.c_str()), 1;
    const int rounds = std::getenv("ROUNDS") ? std::atoi(std::getenv("ROUNDS")) : 12;
    const auto time = [&](const char* what, std::uint32_t mask, int samples, std::uint32_t w, std::uint32_t h) {
        if (!std::strstr(what, std::getenv("TIMES"))) return;
        request.mask = mask, request.samples = samples, request.width = w, request.height = h;
        constexpr int kPictures = 5;
        double best = 1e9, processor = 1e9;
        for (int round = 0; round < rounds; ++round) {
            const std::clock_t busy = std::clock();
            for (int i = 0; i < kPictures; ++i) {
                const auto begin = std::chrono::steady_clock::now();
                (void)service.value()->draw(request).get();
                best =
                    std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
            }
            processor = std::min(processor, 1000.0 * double(std::clock() - busy) / CLOCKS_PER_SEC / kPictures);
        }
        std::printf("%-34s %7.2f ms best, %7.2f ms of processor time\n", what, best, processor);
    };
    if (std::getenv("TIMES")) {
        time("still 1280x720 soft 4 samples", kMaskStill, 4, 1280, 720);
        time("view 1280x720 sharp 1 sample", kMaskSensor, 1, 1280, 720);
        time("view 1280x720 no shadow 1 sample", kMaskWorld, 1, 1280, 720);
        time("sky and floor only", kMaskFloor | kMaskSky, 1, 1280, 720);
        time("sky and floor only 640x480", kMaskFloor | kMaskSky, 1, 640, 480);
        time("no shadow 640x480", kMaskWorld, 1, 640, 480);
        time("sensor 640x480", kMaskSensor, 1, 640, 480);
        time("sensor 320x240", kMaskSensor, 1, 320, 240);
        time("sensor 64x48", kMaskSensor, 1, 64, 48);
    }
    return 0;
}
