#pragma once
#include "devices/wheeled_drive.h"

namespace trundle {

/// A base on two tracks, which turns by running one faster. Its pose is that of the body that carries both; where each track has a body of
/// its own, of the middle between these.
class TrackDrive final : public Drive, public DifferentialDriveSignals {
public:
    static void describe(Describe<TrackDrive>& d);
    /// Fails if both tracks are the same.
    void setup(Mount& mount) override;
    void act(Actuation& world) override;
    void sense(Sensing& world) override;

private:
    struct TrackState {
        Port<TrackSignals> port;
        double travel = 0; ///< m, at the last sense
        BodyId body;       ///< that carries it
    };
    /// m/s, by which it runs faster than the robot moves there; `side`: how far to the left of its body it is (m).
    [[nodiscard]] static double slipOf(const Services& world, TrackState& track, double side);
    [[nodiscard]] static double travelledSince(TrackState& track);

    std::string m_leftName, m_rightName;
    double m_separationM = 0, m_skidFactor = 1;

    TrackState m_left, m_right;
    PlanePose m_odometryPose;
};

} // namespace trundle
