// Measures camera images: camera_bench FILE ROBOT/CAMERA PICTURES. In every tick the run's own image and one drawn by a bare OSG
// loop are timed one after the other, and the share of bytes that differ is measured. One JSON object on standard output.
// Run by run_bench.py.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "app/application.h"
#include "bench/cameras/bare_view.h"
#include "render/camera_image_renderer.h"

using namespace trundle;

namespace {

constexpr int kUnmeasured = 20; // the first images compile shaders and create buffers

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

struct Times {
    std::vector<double> seconds;
    [[nodiscard]] double at(double share) {
        std::sort(seconds.begin(), seconds.end());
        return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    }
    [[nodiscard]] double mean() const {
        double sum = 0;
        for (const double s : seconds) sum += s;
        return sum / static_cast<double>(seconds.size());
    }
};

/// The share of bytes that differ by more than 2: for coplanar faces the drawing order is visible.
double differenceOf(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) count += std::abs(int(a[i]) - int(b[i])) > 2;
    return a.size() == b.size() ? static_cast<double>(count) / static_cast<double>(a.size()) : 1;
}

int failed(const char* what) { return std::fprintf(stderr, "camera_bench: %s\n", what), 1; }

} // namespace

int main(int argc, char** argv) {
    if (argc != 4) return failed("FILE ROBOT/CAMERA PICTURES");
    const std::string camera = argv[2];
    const int pictures = std::atoi(argv[3]);
    const std::unique_ptr<Application> application = makeApplication();
    const auto loaded = application->open(argv[1], {});
    if (!loaded || !loaded.value()->experiment) return failed("the experiment cannot be read");
    const std::shared_ptr<const ExperimentSpec> experiment = loaded.value()->experiment;
    RunOptions options;
    options.pictures = [&](const ExperimentSpec&, const SignalLayout& layout) -> Result<std::unique_ptr<ImageSource>> {
        return std::unique_ptr<ImageSource>(std::make_unique<CameraImageRenderer>(experiment, layout));
    };
    Diagnostics problems;
    const std::unique_ptr<Runner> runner = application->makeRunner(*loaded.value(), options, problems);
    if (!runner) return failed("the experiment cannot be run");
    const auto bare = BareView::create(*experiment, runner->world().layout(), camera);
    if (!bare) return failed("no OpenGL");

    Times ours, theirs, ticks;
    double differing = 0;
    for (int i = -kUnmeasured; i < pictures; ++i) {
        double begin = now();
        if (!runner->tick()) return failed("the run ended early");
        const double tick = now() - begin;
        begin = now();
        const Result<const CameraImage*> frame = runner->cameras().capture(camera);
        const double taken = now() - begin;
        if (!frame) return failed(frame.error().message.c_str());
        begin = now();
        const std::vector<std::uint8_t>& pixels = bare->draw(runner->world().block());
        const double drawn = now() - begin;
        differing = std::max(differing, differenceOf(pixels, frame.value()->pixels));
        if (i < 0) continue;
        ours.seconds.push_back(taken);
        theirs.seconds.push_back(drawn);
        ticks.seconds.push_back(tick);
    }
    std::printf("{\"product\": [%.6g, %.6g, %.6g], \"bare\": [%.6g, %.6g, %.6g], \"tick\": %.6g, \"differing\": %.4g}\n",
                ours.at(0.1), ours.at(0.5), ours.mean(), theirs.at(0.1), theirs.at(0.5), theirs.mean(), ticks.mean(), differing);
    return 0;
}
