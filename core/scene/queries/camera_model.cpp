#include "scene/queries/camera_model.h"

namespace trundle {
namespace {

constexpr double kWidestHalfTangent = 20; // limit on tan(field of view / 2); wider images are mostly stretched edges
constexpr double kMaxDrawn = 4096;        // pixels along one side of the undistorted image

std::array<double, 3> tripleOf(const ComponentSpec& spec, std::string_view key) {
    const ResolvedValue* value = spec.find(key);
    std::array<double, 3> triple{0, 0, 0};
    if (value && value->value.numbers.size() == 3) std::copy_n(value->value.numbers.begin(), 3, triple.begin());
    return triple;
}

double elementOf(const ComponentSpec& spec, std::string_view key, std::size_t element, double otherwise) {
    const ResolvedValue* value = spec.find(key);
    return value && element < value->value.numbers.size() ? value->value.numbers[element] : otherwise;
}

CameraMode modeOf(const std::string& word) {
    return word == "grey"           ? CameraMode::Grey
           : word == "depth"        ? CameraMode::Depth
           : word == "segmentation" ? CameraMode::Segmentation
                                    : CameraMode::Colour;
}

/// Reads the properties by the names that the kind Camera declares.
CameraModel cameraFrom(const ComponentSpec& spec) {
    CameraModel camera;
    const auto position = tripleOf(spec, "Pos"), turn = tripleOf(spec, "HPR");
    camera.mounting = {Vec3(position.data()), rotationFromHpr(Vec3(turn.data()))};
    camera.width = static_cast<std::uint32_t>(elementOf(spec, "Resolution", 0, camera.width));
    camera.height = static_cast<std::uint32_t>(elementOf(spec, "Resolution", 1, camera.height));
    camera.fieldOfView = spec.number("FieldOfView", std::numbers::pi / 3);
    camera.nearPlane = spec.number("Near", camera.nearPlane);
    camera.farPlane = spec.number("Far", camera.farPlane);
    camera.mode = modeOf(spec.text("Mode"));
    camera.noise = spec.number("Noise", 0);
    camera.exposure = spec.number("Exposure", 1);
    camera.k1 = elementOf(spec, "Distortion", 0, 0);
    camera.k2 = elementOf(spec, "Distortion", 1, 0);
    camera.seesSelf = spec.number("SeesSelf", 1) != 0;
    return camera;
}

/// The distance from the centre at which the image starts to fold back, that is the first root of the slope 1 + 3 k1 r² + 5 k2 r⁴;
/// at most kWidestHalfTangent.
double firstFold(double k1, double k2) {
    const double half = -1.5 * k1, root = half * half - 5 * k2;
    if (root < 0 || half + std::sqrt(root) <= 0) return kWidestHalfTangent;
    return std::min(kWidestHalfTangent, std::sqrt(1 / (half + std::sqrt(root))));
}

/// Inverts the radial distortion: returns the undistorted distance from the centre for the distorted distance `shown`, or a
/// negative value where no ray before `fold` reaches `shown`. Newton's method with bisection as its safeguard.
double withoutDistortion(double shown, double fold, double k1, double k2) {
    const auto bent = [&](double r) { return r * (1 + k1 * r * r + k2 * r * r * r * r); };
    if (bent(fold) < shown) return -1;
    double low = 0, high = fold, r = std::min(shown, fold);
    for (int round = 0; round < 100; ++round) {
        const double r2 = r * r, slope = 1 + 3 * k1 * r2 + 5 * k2 * r2 * r2;
        (bent(r) < shown ? low : high) = r;
        double next = r - (bent(r) - shown) / slope;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        const double step = std::abs(next - r);
        r = next;
        if (step < 1e-12) break;
    }
    return r;
}

} // namespace

std::vector<CameraModel> camerasOf(const ExperimentSpec& experiment) {
    std::vector<CameraModel> cameras;
    std::size_t firstBody = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Camera") continue;
            CameraModel camera = cameraFrom(device);
            camera.path = robot.name + "/" + device.name;
            camera.robot = robot.name;
            const std::string body = device.text("Body");
            for (std::size_t b = 0; b < robot.config->bodies.size(); ++b)
                if (robot.config->bodies[b].name == body) camera.body = firstBody + b;
            cameras.push_back(std::move(camera));
        }
        firstBody += robot.config->bodies.size();
    }
    return cameras;
}

CameraView viewOf(const CameraModel& camera, const Pose& body) {
    const Pose lens = body * camera.mounting;
    CameraView view;
    view.eye = lens.position;
    view.target = lens * Vec3::UnitX();
    view.up = lens.rotation * Vec3::UnitZ();
    view.fieldOfView = camera.fieldOfView;
    view.nearPlane = camera.nearPlane;
    view.farPlane = camera.farPlane;
    return view;
}

std::optional<LensMap> lensMapOf(const CameraModel& camera) {
    if (camera.k1 == 0 && camera.k2 == 0) return std::nullopt;
    const double focal = 0.5 * camera.width / std::tan(0.5 * camera.fieldOfView); // pixels
    LensMap map;
    map.sources.resize(std::size_t(camera.width) * camera.height);
    std::vector<std::array<double, 2>> rays(map.sources.size(), {0, 0}); // ray tangents: right, down
    std::vector<bool> seen(map.sources.size(), false);
    const double fold = firstFold(camera.k1, camera.k2);
    double widest = 1e-3, highest = 1e-3;
    for (std::uint32_t y = 0; y < camera.height; ++y) {
        for (std::uint32_t x = 0; x < camera.width; ++x) {
            const double right = (x + 0.5 - 0.5 * camera.width) / focal, down = (y + 0.5 - 0.5 * camera.height) / focal;
            const double shown = std::hypot(right, down), real = withoutDistortion(shown, fold, camera.k1, camera.k2);
            if (real < 0) continue;
            const std::size_t i = std::size_t(y) * camera.width + x;
            const double stretch = shown > 0 ? real / shown : 1;
            rays[i] = {right * stretch, down * stretch};
            seen[i] = true;
            widest = std::max(widest, std::abs(rays[i][0]));
            highest = std::max(highest, std::abs(rays[i][1]));
        }
    }
    // Same resolution as the camera at the centre, with a margin of one pixel.
    const double drawnFocal = std::min({focal, 0.5 * kMaxDrawn / widest - 2, 0.5 * kMaxDrawn / highest - 2});
    map.width = static_cast<std::uint32_t>(2 * std::ceil(widest * drawnFocal + 1));
    map.height = static_cast<std::uint32_t>(2 * std::ceil(highest * drawnFocal + 1));
    map.fieldOfView = 2 * std::atan(0.5 * map.width / drawnFocal);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!seen[i]) continue;
        map.sources[i] = {static_cast<float>(0.5 * map.width + rays[i][0] * drawnFocal),
                          static_cast<float>(0.5 * map.height + rays[i][1] * drawnFocal)};
    }
    return map;
}

} // namespace trundle
