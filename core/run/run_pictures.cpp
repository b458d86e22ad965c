// What controllers ask of their cameras.

#include "run/experiment_runner.h"

namespace trundle {
namespace {

constexpr std::size_t kMostPictures = 100'000; // saved in one run

} // namespace

/// The run goes on, and says so once: that there are none, and that one failed. A file that cannot be written is its asker's to tell.
void ExperimentRunner::warnOfPictures(const Error& error) {
    const bool none = error.code == Code::NoGraphics;
    if (!none && error.code != Code::PictureFailed) return;
    if (std::exchange(none ? m_toldNoPictures : m_toldLostPicture, true)) return;
    const char* const what = none ? "cameras take no pictures: " : "a picture could not be taken: ";
    m_warnings.push_back({Severity::Warning, error.code, what + error.message, {}, {}, {}, {}});
}

/// Each cause once for each log: the causes of its files differ in their names alone.
void ExperimentRunner::warnOfLost(const ComponentSpec& log, const std::string& fileName, const Error& error) {
    if (error.code == Code::NoGraphics) return warnOfPictures(error);
    std::string cause = error.message;
    if (const std::size_t at = cause.find(fileName); at != std::string::npos) cause.erase(at, fileName.size());
    if (!m_toldLost.insert(log.name + "\n" + cause).second) return;
    const std::string message = "FrameLog " + log.name + " leaves out pictures, the first is " + fileName + ": " + error.message;
    m_warnings.push_back({Severity::Warning, error.code, message, log.nameRange, {}, {}, {}});
}

void ExperimentRunner::addCameras(ControllerOutlet& outlet, const std::string& robot) {
    outlet.capture = [this, robot](const std::string& camera) -> Result<const Frame*> {
        Result<const Frame*> frame = m_cameras.capture(robot + "/" + camera);
        if (!frame) warnOfPictures(frame.error());
        return frame;
    };
    outlet.savePicture = [this, robot](const std::string& camera, const std::string& fileName) {
        Status saved = savePicture(robot + "/" + camera, fileName);
        if (!saved) warnOfPictures(saved.error());
        return saved;
    };
    outlet.objectName = [this](std::uint32_t object) { return m_cameras.objectName(object); };
}

Status ExperimentRunner::savePicture(const std::string& camera, const std::string& fileName) {
    return writePicture(m_cameras.file(camera, fileName), fileName);
}

Result<double> ExperimentRunner::savePicture(const PictureWish& wish, const std::string& fileName) {
    std::uint64_t tick = m_world->ticks();
    Status saved;
    if (wish.camera.empty()) {
        saved = writePicture(m_cameras.viewFile(wish.view, wish.width, wish.height, fileName), fileName);
    } else if (saved = savePicture(wish.camera, fileName); saved) {
        if (const Result<const Frame*> frame = m_cameras.capture(wish.camera)) tick = frame.value()->tick; // the one just saved
    }
    if (saved) return tickTime(tick, experiment().settings.tick);
    return saved.error();
}

Status ExperimentRunner::writePicture(const Result<std::string>& bytes, const std::string& fileName) {
    if (m_pictures >= kMostPictures)
        return Error{Code::LogUnwritable, "no more than " + std::to_string(kMostPictures) + " pictures are saved in one run"};
    if (!bytes) return bytes.error();
    const Result<LogFile*> file = m_folder.create(fileName);
    if (!file) return file.error();
    ++m_pictures;
    file.value()->write(bytes.value());
    const Status written = file.value()->close();
    if (!written) m_folder.remove(*file.value()); // half a picture is of no use
    return written;
}

} // namespace trundle
