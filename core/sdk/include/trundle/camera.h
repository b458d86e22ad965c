// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// What a robot's camera gives. A picture costs nothing before it is asked for.

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <trundle/abi.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

/// What a camera saw at one moment. A value: it stays as it is whatever the camera does next. Rows count from the top.
class Picture {
public:
    Picture() = default;

    /// False where no picture could be taken, as on a machine without OpenGL; error() says why.
    [[nodiscard]] explicit operator bool() const { return m_width > 0; }
    [[nodiscard]] const std::string& error() const { return m_error; }

    [[nodiscard]] int width() const { return m_width; }
    [[nodiscard]] int height() const { return m_height; }
    /// Simulated s at which it was taken.
    [[nodiscard]] Seconds time() const { return {m_time}; }

    /// Black outside the picture.
    [[nodiscard]] Colour at(int x, int y) const {
        if (!holds(x, y)) return {};
        const std::uint8_t* p = m_pixels.data() + 3 * place(x, y);
        return {p[0], p[1], p[2]};
    }
    /// Red, green, blue, row by row.
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return m_pixels; }
    /// m along the way the camera looks (its axis), infinite where nothing is seen. Of cameras with Mode=depth and Mode=segmentation.
    [[nodiscard]] double depth(int x, int y) const {
        return holds(x, y) && !m_depth.empty() ? m_depth[place(x, y)] : std::numeric_limits<double>::infinity();
    }
    /// Which object is seen, 0 for none; CameraPort::objectName tells its name. Of cameras with Mode=segmentation.
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

class CameraPort {
public:
    /// What it sees now. Of a camera with an UpdatePeriod, the newest picture of its stream.
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
        m_seen = m_frame.get();
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

    /// Writes what capture() would give into the run's log folder, as .png or .jpg by the ending of the name, with where and
    /// when it was taken. False where that is refused: error() says why.
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

    /// Of a camera with an UpdatePeriod: its stream has a picture that capture() has not given yet. Else always true.
    [[nodiscard]] bool fresh() const { return m_frame.get() != m_seen; }

    /// "robot1/chassis/hull" for a number of Picture::object; empty where there is none.
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
    Slot m_frame;
    double m_seen = -1;
};

} // namespace sdk1
} // namespace trundle
