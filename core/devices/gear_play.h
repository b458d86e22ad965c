#pragma once

namespace trundle {

/// The play of a gear: its teeth touch on one side, on the other, or not at all. Angles at the joint.
class GearPlay {
public:
    void setWidth(double rad) { m_width = rad; }
    [[nodiscard]] bool any() const { return m_width > 0; }
    [[nodiscard]] bool isApart() const { return any() && m_side == 0; }
    /// The teeth part if they would have to pull, `torque` being that of the motor on the joint.
    void part(double torque) {
        if (torque * m_side < 0) m_side = 0;
    }
    /// The motor turned by so much and the joint by so much while the teeth were apart. At the end of the play they touch.
    void turn(double motor, double joint) {
        m_gap += motor - joint;
        if (m_gap >= m_width / 2) touch(1);
        else if (m_gap <= -m_width / 2) touch(-1);
    }

private:
    void touch(int side) {
        m_side = side;
        m_gap = side * m_width / 2;
    }

    double m_width = 0, m_gap = 0; ///< rad; gap: of the motor ahead of the joint, 0 in the middle
    int m_side = 0;
};

} // namespace trundle
