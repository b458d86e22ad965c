// Finds a ball and a goal by their colours in its camera image, goes around the ball until the goal is behind it, and pushes it there.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <trundle/controller.h>

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kInMouth = 0.13;                 // m
constexpr double kAligned = 0.06, kLoseWay = 0.5; // rad: it begins to push, it gives up
constexpr double kLoseSide = 0.05;                // m

double hueOf(double r, double g, double b) { return std::atan2(std::sqrt(3.0) * (g - b), 2 * r - g - b); }

/// Pixels of one colour in an image.
struct Blob {
    int pixels = 0, bottom = 0; ///< bottom: its lowest row
    double column = 0, row = 0; ///< means
};

/// On the floor, in the robot's frame, m.
struct Spot {
    double x = 0, y = 0;
    [[nodiscard]] double distance() const { return std::sqrt(x * x + y * y); } ///< in the same bits as in Python
};

struct Striker : trundle::Controller {
    std::array<double, 3> ballColour{0.9, 0.5, 0.1}, goalColour{0.15, 0.35, 0.7};
    double speed = 0.8, orbit = 0.22, kickAt = 0.6;
    double ballRadius = 0.0215, forward = 0.058, height = 0.135, pitch = 36 * kDegree, fieldOfView = 90 * kDegree;
    std::string cameraName = "eye", driveName = "base";

    static void describe(trundle::Describe<Striker>& d) {
        using trundle::metres, trundle::degrees;
        d.help("Finds a ball and a goal in its camera, goes around the ball and pushes it into the goal; for an OmniDrive.");
        d.field("BallColor", &Striker::ballColour, trundle::number().within(0, 1), "Red, green and blue; the hue counts.");
        d.field("GoalColor", &Striker::goalColour, trundle::number().within(0, 1), "Red, green and blue; the hue counts.");
        d.field("Speed", &Striker::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "With the ball.");
        d.field("Orbit", &Striker::orbit, metres().within(0.05, 10).live(), "How far from the ball it goes around it.");
        d.field("KickAt", &Striker::kickAt, metres().within(0, 10).live(),
                "It brakes that far from the goal; the ball rolls on.");
        d.field("BallRadius", &Striker::ballRadius, metres().above(0).atMost(1), "Its middle is that high.");
        d.field("CameraForward", &Striker::forward, metres().within(-1, 1), "Place of the camera before the middle of the base.");
        d.field("CameraHeight", &Striker::height, metres().above(0).atMost(10), "Above the floor.");
        d.field("CameraPitch", &Striker::pitch, degrees().within(0, 89), "How far it looks down.");
        d.field("FieldOfView", &Striker::fieldOfView, degrees().within(10, 150), "Of the camera, from left to right.");
        d.field("Camera", &Striker::cameraName, trundle::needs("Camera"), "The robot's Camera.");
        d.field("Drive", &Striker::driveName, trundle::needs("OmniDrive"), "The robot's OmniDrive.");
        d.output("kicked", &Striker::kicked, "", "1 after it let the ball roll.");
    }

    void setup(trundle::RobotPorts& robot) override {
        m_drive = robot.omniDrive(driveName);
        m_camera = robot.camera(cameraName);
    }

    void update(trundle::Seconds) override {
        if (m_ended) return;
        const trundle::Picture picture = m_camera.capture();
        if (!picture) return end("cannot see, stays where it is: " + picture.error());
        const std::optional<Spot> goal = goalIn(picture);
        std::optional<Spot> ball = ballIn(picture);
        if (!ball && goal && m_pushes && m_ball.distance() < kInMouth) ball = m_ball; // too near to be seen
        if (!ball) return m_drive.move(0, 0, 2);
        m_ball = *ball;
        if (goal && m_pushes && goal->distance() < kickAt) {
            kicked.set(1);
            return end("kicks");
        }
        play(*ball, goal);
    }

    trundle::OutputSlot<int> kicked;

private:
    /// Without a goal in sight it goes around the ball until there is one.
    void play(const Spot& ball, const std::optional<Spot>& goal) {
        const double bearing = std::atan2(ball.y, ball.x);
        const double way = goal ? std::atan2(goal->y - ball.y, goal->x - ball.x) : 0; // from the ball to the goal
        const double error = goal ? std::remainder(way - bearing, 2 * std::numbers::pi) : 1;
        m_pushes = goal && (m_pushes ? std::abs(way) < kLoseWay && std::abs(ball.y) < kLoseSide && ball.x < orbit + kLoseSide
                                     : std::abs(error) < kAligned && std::abs(bearing) < 2 * kAligned);
        if (m_pushes) return m_drive.move(speed, std::clamp(3 * ball.y, -0.2, 0.2), 2.5 * way);
        const double near = std::clamp(orbit / ball.distance(), 0.0, 1.0); // far away it only drives to the ball
        const double ahead = std::clamp(2 * (ball.distance() - orbit), -0.3, 1.0),
                     aside = near * std::clamp(-1.5 * error, -0.5, 0.5);
        m_drive.move(ahead, aside, 3 * bearing - aside / ball.distance());
    }

    [[nodiscard]] std::optional<Spot> ballIn(const trundle::Picture& picture) const {
        const Blob blob = find(picture, ballColour, 14 * kDegree);
        if (blob.pixels < 2) return std::nullopt;
        return onFloor(picture, blob.column, blob.row, ballRadius);
    }

    [[nodiscard]] std::optional<Spot> goalIn(const trundle::Picture& picture) const {
        const Blob blob = find(picture, goalColour, 20 * kDegree);
        if (blob.pixels < 6) return std::nullopt;
        return onFloor(picture, blob.column, blob.bottom + 1, 0);
    }

    /// Where a pixel's ray comes to a height above the floor; nothing above the horizon.
    [[nodiscard]] std::optional<Spot> onFloor(const trundle::Picture& picture, double column, double row, double up) const {
        const double focus = picture.width() / 2.0 / std::tan(fieldOfView / 2);
        const double left = (picture.width() / 2.0 - column) / focus, high = (picture.height() / 2.0 - row) / focus;
        const double ahead = std::cos(pitch) + high * std::sin(pitch), down = std::sin(pitch) - high * std::cos(pitch);
        if (down < 0.01 || ahead <= 0) return std::nullopt;
        const double scale = (height - up) / down;
        return Spot{forward + ahead * scale, left * scale};
    }

    static Blob find(const trundle::Picture& picture, const std::array<double, 3>& colour, double tolerance) {
        const double hue = hueOf(colour[0], colour[1], colour[2]);
        Blob blob;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const trundle::Colour c = picture.at(x, y);
                const int high = std::max({c.red, c.green, c.blue}), low = std::min({c.red, c.green, c.blue});
                if (high < 40 || high - low < high / 2) continue; // too dark or too pale
                if (std::abs(std::remainder(hueOf(c.red, c.green, c.blue) - hue, 2 * std::numbers::pi)) > tolerance) continue;
                ++blob.pixels;
                blob.column += x + 0.5;
                blob.row += y + 0.5;
                blob.bottom = y;
            }
        }
        blob.column /= std::max(blob.pixels, 1);
        blob.row /= std::max(blob.pixels, 1);
        return blob;
    }

    void end(const std::string& why) {
        print(why);
        m_ended = true;
        m_drive.stop();
    }

    trundle::OmniDrivePort m_drive;
    trundle::CameraPort m_camera;
    Spot m_ball; ///< where it was seen last
    bool m_pushes = false, m_ended = false;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Striker>("Striker"); }
