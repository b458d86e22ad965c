#include "run/run_pictures.h"

#include "model/object_numbers.h"
#include "run/schedule.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxPictures = 100'000; // saved per run

} // namespace

/// Warns once that there is no graphics, and once that an image failed; the run continues. File errors are reported by the
/// caller.
void RunPictures::warnOfPictures(const Error& error) {
    const bool none = error.code == Code::NoGraphics;
    if (!none && error.code != Code::PictureFailed) return;
    if (std::exchange(none ? m_reportedNoPictures : m_reportedLostPicture, true)) return;
    const char* const what = none ? "cameras take no pictures: " : "a picture could not be taken: ";
    m_warnings.push_back({Severity::Warning, error.code, what + error.message, {}, {}, {}, {}});
}

/// Warns once per log and cause; file names are removed from the cause before comparing.
void RunPictures::warnOfLost(const ComponentSpec& log, const std::string& fileName, const Error& error) {
    if (error.code == Code::NoGraphics) return warnOfPictures(error);
    std::string cause = error.message;
    if (const std::size_t at = cause.find(fileName); at != std::string::npos) cause.erase(at, fileName.size());
    if (!m_reportedLost.insert(log.name + "\n" + cause).second) return;
    const std::string message = "FrameLog " + log.name + " leaves out pictures, the first is " + fileName + ": " + error.message;
    m_warnings.push_back({Severity::Warning, error.code, message, log.nameRange, {}, {}, {}});
}

void RunPictures::addTo(ControllerOutputs& outputs, const std::string& robot) {
    outputs.capture = [this, robot](const std::string& camera) -> Result<const CameraImage*> {
        Result<const CameraImage*> frame = m_cameras.capture(robot + "/" + camera);
        if (!frame) warnOfPictures(frame.error());
        return frame;
    };
    outputs.savePicture = [this, robot](const std::string& camera, const std::string& fileName) {
        Status saved = saveImage(robot + "/" + camera, fileName);
        if (!saved) warnOfPictures(saved.error());
        return saved;
    };
    outputs.objectName = [this](std::uint32_t object) {
        if (m_objects.empty()) m_objects = objectNames(m_world.experiment());
        return object < m_objects.size() ? m_objects[object] : std::string();
    };
}

Status RunPictures::saveImage(const std::string& camera, const std::string& fileName) {
    return write(m_cameras.file(camera, fileName), fileName);
}

Result<double> RunPictures::saveFor(const ComponentSpec& log, const PictureOptions& options, const std::string& fileName) {
    Result<double> saved = save(options, fileName);
    if (!saved) warnOfLost(log, fileName, saved.error());
    return saved;
}

Result<double> RunPictures::save(const PictureOptions& options, const std::string& fileName) {
    std::uint64_t tick = m_world.ticks();
    Status saved;
    if (options.camera.empty()) {
        saved = write(m_cameras.viewFile(options.view, options.width, options.height, fileName), fileName);
    } else if (saved = saveImage(options.camera, fileName); saved) {
        if (const Result<const CameraImage*> frame = m_cameras.capture(options.camera))
            tick = frame.value()->tick; // the image just saved
    }
    if (saved) return tickTime(tick, m_world.experiment().settings.tick);
    return saved.error();
}

Status RunPictures::write(const Result<std::string>& bytes, const std::string& fileName) {
    if (m_saved >= kMaxPictures)
        return Error{Code::LogUnwritable, "no more than " + std::to_string(kMaxPictures) + " pictures are saved in one run"};
    if (!bytes) return bytes.error();
    const Result<LogFile*> file = m_folder.create(fileName);
    if (!file) return file.error();
    ++m_saved;
    file.value()->write(bytes.value());
    const Status written = file.value()->close();
    if (!written) m_folder.remove(*file.value()); // remove an incomplete image file
    return written;
}

} // namespace trundle
