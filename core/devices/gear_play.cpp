#include "devices/gear_play.h"

#include <algorithm>
#include <cmath>

namespace trundle {

bool GearPlay::reaches(double torque) const {
    if (!exists()) return true;
    return torque > 0 ? m_at >= m_width / 2 : torque < 0 && m_at <= -m_width / 2;
}

bool GearPlay::reaches(double rateError, double slack, double lastTorque) const {
    if (std::abs(rateError) > slack) return reaches(rateError);
    return reaches(lastTorque != 0 ? lastTorque : m_at);
}

double GearPlay::turn(const Free& drive, double jointRate, double tick) {
    if (!m_wasFree) m_rate = jointRate;
    m_isFree = true;
    m_inertia = drive.inertia;
    const double before = m_rate;
    if (!(drive.softness > 0)) {
        m_rate = drive.rate;
        return 0;
    }
    const double pull = 1 / drive.softness, whole = m_inertia / tick + pull + drive.viscousFriction;
    m_rate = (m_inertia / tick * before + pull * drive.rate) / whole;
    double torque = (drive.rate - m_rate) * pull;
    if (std::abs(torque) > drive.limit && m_inertia > 0) { // at its limit the torque is constant
        torque = std::copysign(drive.limit, torque);
        m_rate = (m_inertia / tick * before + torque) / (m_inertia / tick + drive.viscousFriction);
    }
    const double slowed = std::abs(m_rate) - drive.dryFriction / whole;
    m_rate = std::copysign(std::max(slowed, 0.0), m_rate);
    return torque;
}

double GearPlay::follow(double jointRate, double tick) {
    m_wasFree = m_isFree;
    if (!m_isFree) return 0;
    m_isFree = false;
    m_at += (m_rate - jointRate) * tick;
    if (std::abs(m_at) < m_width / 2) return 0;
    m_at = std::copysign(m_width / 2, m_at);
    m_wasFree = false;
    return m_inertia * (m_rate - jointRate);
}

} // namespace trundle
