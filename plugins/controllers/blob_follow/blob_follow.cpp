// Finds a blob of one colour in the camera image, turns and drives towards it, and stops in front of it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <trundle/controller.h>

namespace {

/// Position and size of the blob in an image.
struct Blob {
    int pixels = 0;
    double side = 0;  ///< of its centre: -1 at the left edge, 1 at the right edge
    double share = 0; ///< fraction of the image width that it covers
};

/// rad.
double hueOf(double r, double g, double b) { return std::atan2(std::sqrt(3.0) * (g - b), 2 * r - g - b); }

struct BlobFollow : trundle::Controller {
    std::array<double, 3> colour{0.85, 0.1, 0.08};
    double tolerance = 25 * std::numbers::pi / 180;
    double speed = 0.3, turnRate = 0.8, stopShare = 0.5;
    int minPixels = 6, keepEvery = 10;
    std::string cameraName = "eye", driveName = "base";

    static void describe(trundle::Describe<BlobFollow>& d) {
        d.help("Finds a blob of one colour in its camera and drives to it; keeps some of the pictures.");
        d.field("Color", &BlobFollow::colour, trundle::number().within(0, 1), "Red, green and blue of the blob; its hue counts.");
        d.field("Tolerance", &BlobFollow::tolerance, trundle::degrees().within(1, 180), "How far a pixel's hue may be off.");
        d.field("MinPixels", &BlobFollow::minPixels, trundle::number().within(1, 1e6), "Fewer pixels are no blob.");
        d.field("Speed", &BlobFollow::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "Towards the blob.");
        d.field("TurnRate", &BlobFollow::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(),
                "While it looks around, and at most.");
        d.field("StopShare", &BlobFollow::stopShare, trundle::number().above(0).atMost(1),
                "It is there when the blob takes that share of the picture's width.");
        d.field("KeepEvery", &BlobFollow::keepEvery, trundle::number().within(0, 1e6),
                "Every so manieth picture is kept in the log folder; 0 keeps none.");
        d.field("Camera", &BlobFollow::cameraName, trundle::needs("Camera"), "The robot's Camera.");
        d.field("Drive", &BlobFollow::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

    void setup(trundle::RobotPorts& robot) override {
        m_name = robot.name();
        m_drive = robot.differentialDrive(driveName);
        m_camera = robot.camera(cameraName);
        m_hue = hueOf(colour[0], colour[1], colour[2]);
    }

    void update(trundle::Seconds) override {
        if (m_there || m_blind) return;
        const trundle::Picture picture = m_camera.capture();
        if (!picture) return goBlind(picture.error());
        keep();
        const Blob blob = find(picture);
        if (blob.pixels < minPixels) return m_drive.move(0, turnRate);
        if (blob.share >= stopShare) {
            m_there = true;
            print("there");
            return m_drive.stop();
        }
        // The speed decreases with the distance from the centre of the image.
        m_drive.move(speed * std::max(0.0, 1 - 1.5 * std::abs(blob.side)), -turnRate * std::clamp(1.5 * blob.side, -1.0, 1.0));
    }

private:
    [[nodiscard]] bool isMeant(trundle::Colour c) const {
        const double r = c.red / 255.0, g = c.green / 255.0, b = c.blue / 255.0;
        const double brightness = std::max({r, g, b}), saturation = (brightness - std::min({r, g, b})) / brightness;
        // Most of an image is grey, so the angle is calculated last.
        if (brightness < 0.15 || saturation < 0.45) return false;
        return std::abs(std::remainder(hueOf(r, g, b) - m_hue, 2 * std::numbers::pi)) <= tolerance;
    }

    [[nodiscard]] Blob find(const trundle::Picture& picture) const {
        Blob blob;
        double sum = 0;
        int left = picture.width(), right = -1;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (!isMeant(picture.at(x, y))) continue;
                ++blob.pixels;
                sum += x + 0.5;
                left = std::min(left, x);
                right = std::max(right, x);
            }
        }
        if (blob.pixels == 0) return blob;
        blob.side = sum / blob.pixels / picture.width() * 2 - 1;
        blob.share = double(right - left + 1) / picture.width();
        return blob;
    }

    void keep() {
        if (keepEvery == 0 || m_pictures++ % keepEvery != 0) return;
        char number[16];
        std::snprintf(number, sizeof number, "%05d", m_kept++);
        if (!m_camera.save(m_name + "_" + number + ".jpg")) keepEvery = 0; // the run has no logs
    }

    void goBlind(const std::string& why) {
        warn("cannot see, stays where it is: ", why);
        m_blind = true;
        m_drive.stop();
    }

    std::string m_name;
    trundle::DifferentialDrivePort m_drive;
    trundle::CameraPort m_camera;
    double m_hue = 0; // rad
    int m_pictures = 0, m_kept = 0;
    bool m_there = false, m_blind = false;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<BlobFollow>("BlobFollow"); }
