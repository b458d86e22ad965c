#pragma once
// The camera images that controllers and logs of a run ask for, with their files and warnings.

#include <set>
#include <string>
#include <vector>

#include "control/backend.h"
#include "run/camera_capture.h"
#include "run/logs/log.h"
#include "run/logs/log_folder.h"

namespace trundle {

class RunPictures {
public:
    /// All must outlive this object and what addTo() gave functions to.
    RunPictures(const World& world, CameraCapture& cameras, LogFolder& folder, std::vector<Diagnostic>& warnings)
        : m_world(world), m_cameras(cameras), m_folder(folder), m_warnings(warnings) {}

    /// The functions by which the controller of a robot uses its cameras.
    void addTo(ControllerOutputs& outputs, const std::string& robot);
    /// Saves an image that a log asks for, and returns the time that it shows. Warns if it is left out.
    [[nodiscard]] Result<double> saveFor(const ComponentSpec& log, const PictureOptions& options, const std::string& fileName);

private:
    [[nodiscard]] Result<double> save(const PictureOptions& options, const std::string& fileName);
    [[nodiscard]] Status saveImage(const std::string& camera, const std::string& fileName);
    [[nodiscard]] Status write(const Result<std::string>& bytes, const std::string& fileName);
    void warnOfPictures(const Error& error);
    void warnOfLost(const ComponentSpec& log, const std::string& fileName, const Error& error);

    const World& m_world;
    CameraCapture& m_cameras;
    LogFolder& m_folder;
    std::vector<Diagnostic>& m_warnings;
    std::size_t m_saved = 0;              ///< number of saved pictures
    std::vector<std::string> m_objects;   ///< their names, once one is asked for
    std::set<std::string> m_reportedLost; ///< log name and cause of left-out pictures, already reported
    bool m_reportedNoPictures = false, m_reportedLostPicture = false;
};

} // namespace trundle
