// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Access to a robot's cameras. An image is rendered only when it is requested.

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <trundle/abi.h>
#include <trundle/device_signals.h>
#include <trundle/port.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

/// The image of a camera at one time. A value type, independent of later images. Rows count from the top.
class Picture {
public:
    Picture() = default;

    /// False if no image is available, for example on a machine without OpenGL; error() gives the reason.
    [[nodiscard]] explicit operator bool() const { return m_width > 0; }
    [[nodiscard]] const std::string& error() const { return m_error; }

    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    /// Simulated time of the image, s.
    [[nodiscard]] Seconds time() const { return {m_time}; }

    /// Black outside the image.
    [[nodiscard]] Colour at(int x, int y) const {
        if (!holds(x, y)) return {};
        const std::uint8_t* p = m_pixels.data() + 3 * place(x, y);
        return {p[0], p[1], p[2]};
    }
    /// RGB, row-major.
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return m_pixels; }
    /// Distance in m along the camera's axis; infinite where there is no object. Only with Mode=depth and Mode=segmentation.
    [[nodiscard]] double depth(int x, int y) const {
        return holds(x, y) && !m_depth.empty() ? m_depth[place(x, y)] : std::numeric_limits<double>::infinity();
    }
    /// Number of the object at this pixel, 0 for none; CameraPort::objectName gives its name. Only with Mode=segmentation.
    [[nodiscard]] std::uint32_t object(int x, int y) const {
        return holds(x, y) && !m_objects.empty() ? m_objects[place(x, y)] : 0;
    }

private:
    friend class CameraPort;
    [[nodiscard]] bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < m_width && y < m_height; }
    [[nodiscard]] std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }

    int m_width = 0, m_height = 0;
    double m_time = 0;
    std::string m_error = "no picture was taken";
    std::vector<std::uint8_t> m_pixels;
    std::vector<float> m_depth;
    std::vector<std::uint32_t> m_objects;
};

class CameraPort : public Port<CameraSignals> {
public:
    /// Renders the current image. For a camera with an UpdatePeriod, returns the newest image of its stream.
    [[nodiscard]] Picture capture() {
        Picture picture;
        if (!cameras()) {
            picture.m_error = noCameras();
            return picture;
        }
        TrundlePicture taken{};
        taken.size = sizeof taken;
        if (cameras()->capture(cameras()->context, m_name.c_str(), &taken) != 0) {
            picture.m_error = cameras()->lastError(cameras()->context);
            return picture;
        }
        m_seen = m_signals.frame.get();
        const std::size_t count = std::size_t(taken.width) * taken.height;
        picture.m_width = static_cast<int>(taken.width);
        picture.m_height = static_cast<int>(taken.height);
        picture.m_time = taken.time;
        picture.m_error.clear();
        picture.m_pixels.assign(taken.pixels, taken.pixels + 3 * count);
        if (taken.depth) picture.m_depth.assign(taken.depth, taken.depth + count);
        if (taken.objects) picture.m_objects.assign(taken.objects, taken.objects + count);
        return picture;
    }

    /// Saves the image that capture() would return to the run's log folder, as .png or .jpg according to the file name's
    /// extension, with the camera's pose and the time as metadata. On failure returns false; error() gives the reason.
    bool save(const std::string& fileName) {
        m_error = noCameras();
        if (!cameras()) return false;
        if (cameras()->save(cameras()->context, m_name.c_str(), fileName.c_str()) == 0) {
            m_error.clear();
            return true;
        }
        m_error = cameras()->lastError(cameras()->context);
        return false;
    }
    [[nodiscard]] const std::string& error() const { return m_error; } ///< of the last save

    /// For a camera with an UpdatePeriod: its stream has an image that capture() has not returned yet. Otherwise always true.
    [[nodiscard]] bool fresh() const { return m_signals.frame.get() != m_seen; }

    /// "robot1/chassis/hull" for an object number of Picture::object; empty if there is no such object.
    [[nodiscard]] std::string objectName(std::uint32_t object) const {
        const char* name = cameras() ? cameras()->objectName(cameras()->context, object) : nullptr;
        return name ? name : "";
    }

private:
    friend class RobotPorts;
    [[nodiscard]] const char* noCameras() const {
        return m_name.empty() ? "this port has no camera; robot.camera(\"NAME\") in setup() gives it one"
                              : "this program takes no pictures";
    }
    [[nodiscard]] const TrundleCameras* cameras() const { return m_cameras; }

    const TrundleCameras* m_cameras = nullptr;
    std::string m_name, m_error;
    double m_seen = -1;
};

} // namespace sdk1
} // namespace trundle
