#include "devices/camera_device.h"

#include <numbers>

namespace trundle {

Camera::Camera() : m_fieldOfView(std::numbers::pi / 3) {}

void Camera::describe(Describe<Camera>& d) {
    d.help("Sees the scene along its own x with z up. Costs nothing until a picture is requested.").independent();
    Quantity pixels = number().within(1, 4096);
    pixels.type = TRUNDLE_INTEGER;
    const Quantity farthest = metres().within(-1e5, 1e5);
    d.field("Body", &Camera::m_bodyName, reference("Body").required(), "The body it is fixed to.");
    d.field("Pos", &Camera::m_position, farthest, "Of its lens in the body.");
    d.field("HPR", &Camera::m_turn, degrees().within(-1e6, 1e6), "Heading, pitch and roll in the body; 0,0,0 looks along x.");
    d.field("Resolution", &Camera::m_resolution, pixels, "Width and height in pixels.");
    d.field("FieldOfView", &Camera::m_fieldOfView, degrees().within(1, 170), "From the left edge to the right one.");
    d.field("Near", &Camera::m_near, metres().within(1e-3, 1e4), "What is nearer is not seen.");
    d.field("Far", &Camera::m_far, metres().within(1e-2, 1e5), "What is farther is not seen.");
    d.field("Mode", &Camera::m_mode, oneOf("color|grey|depth|segmentation"), "What each pixel holds.");
    d.field("Noise", &Camera::m_noise, number().within(0, 1),
            "Standard deviation of a pixel's brightness; 1 is all of it. Of a depth, as a part of it.");
    d.field("Exposure", &Camera::m_exposure, number().above(0).atMost(1000), "Factor on the light that falls in.");
    d.field("Distortion", &Camera::m_distortion, number().within(-1, 10),
            "k1 and k2 of the lens: r (1 + k1 r^2 + k2 r^4); below 0 a barrel, above 0 a cushion.");
    d.field("SeesSelf", &Camera::m_seesSelf, flag(), "Whether its own robot is in the picture, and its shadow.");
    d.field("UpdatePeriod", &Camera::m_updatePeriod, seconds().within(0, 1e6),
            "Time between the pictures of its stream; 0 takes one on each request.");
    d.field("Power", &Camera::m_power, unitOf("W").within(0, 1e6), "That it draws from the robot's Battery, if it has one.");
    CameraSignals::describe(d);
}

void Camera::setup(Mount& mount) {
    if (!(m_near < m_far)) mount.fail("Near must be smaller than Far");
}

/// The first image is that of the start state. Each later image is taken at the first tick at or after its due time, never
/// before.
void Camera::sense(Sensing& world) {
    if (!world.supply().powered()) return;
    if (m_power > 0) world.draw(m_power);
    const double now = world.time(), slack = 1e-6 * world.tick();
    if (m_taken > 0 && m_updatePeriod > 0 && now + slack < m_taken * m_updatePeriod) return;
    frame.set(m_taken);
    time.set(now);
    if (m_updatePeriod > 0) m_taken = std::max(m_taken + 1, std::floor((now + slack) / m_updatePeriod) + 1);
    else ++m_taken;
}

} // namespace trundle
