#include "devices/encoder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trundle {
namespace {
constexpr double kTurn = 2 * std::numbers::pi;
} // namespace

double encoderCount(double angle, double countsPerTurn) { return std::floor(angle / kTurn * countsPerTurn + 1e-9); }

void Encoder::describe(Describe<Encoder>& d) {
    d.help("Counts the steps that a joint turns or slides.").independent();
    d.field("Joint", &Encoder::m_jointName, reference("Hinge|Suspension|Slider").required(), "The joint it sits on.");
    Quantity counts = number().within(1, 1e9);
    counts.type = TRUNDLE_INTEGER;
    d.field("CountsPerRevolution", &Encoder::m_countsPerRevolution, counts,
            "Lines of the disc; on a Slider, lines from one index mark to the next.");
    d.field("Quadrature", &Encoder::m_quadrature, flag(), "Counts all four edges of a line.");
    d.field("Index", &Encoder::m_hasIndex, flag(), "Gives a pulse once per revolution.");
    d.field("Pitch", &Encoder::m_pitchM, metres().within(1e-9, 1e3), "Of a line, on a Slider.");
    d.field("MaxFrequency", &Encoder::m_maxFrequency, hertz().within(1e-3, 1e12),
            "Lines per second that it can count; what passes faster is lost. Not given: any.");
    d.field("Type", &Encoder::m_kindName, oneOf("incremental|absolute"),
            "incremental: counts from 0 at the start; absolute: reads its position within a revolution, 0 to counts - 1.");
    d.field("Offset", &Encoder::m_offset, degrees().within(-1e6, 1e6),
            "Angle that an absolute one has in the joint's start pose.");
    EncoderSignals::describe(d);
}

void Encoder::setup(Mount& mount) {
    m_joint = mount.joint(m_jointName);
    m_isAbsolute = m_kindName == "absolute";
    m_perTurn = m_countsPerRevolution * (m_quadrature ? 4 : 1);
    m_turn = m_pitchM ? *m_pitchM * m_countsPerRevolution : kTurn;
    if (m_isAbsolute && m_maxFrequency) mount.fail("an absolute encoder reads its position: it has no MaxFrequency");
    if (!m_isAbsolute && m_offset != 0) mount.fail("Offset is that of an absolute encoder; an incremental one starts at 0");
}

double Encoder::countedOf(double passed, const Services& world) {
    if (!m_maxFrequency) return passed;
    const double most = m_left + *m_maxFrequency * world.tick() * m_perTurn / m_countsPerRevolution;
    const double counted = std::min(std::abs(passed), std::floor(most + 1e-9)), lost = std::abs(passed) - counted;
    m_left = most - counted;
    m_isTooFast = lost > 0 || (m_isTooFast && m_left < 2);
    // Edges of an even turn do not come evenly in ticks: one count may be left for the next edge, nearly two while edges are lost.
    if (!m_isTooFast) m_left = std::min(m_left, 1.0);
    m_missed += lost;
    return std::copysign(counted, passed);
}

void Encoder::sense(Sensing& world) {
    const double at = (m_pitchM ? world.jointPosition(m_joint) / m_turn * kTurn : world.jointPosition(m_joint)) + m_offset;
    const double passed = encoderCount(at, m_perTurn), turn = m_hasIndex ? encoderCount(at, 1) : 0;
    if (world.time() == 0) {
        m_lastPassed = passed;
        m_lastTurn = turn;
        if (m_isAbsolute) m_count = passed;
    }
    const double counted = m_isAbsolute ? passed - m_lastPassed : countedOf(passed - m_lastPassed, world);
    m_count += counted;
    const double code = m_isAbsolute ? m_count - m_perTurn * std::floor(m_count / m_perTurn) : m_count;
    count.set(code);
    angle.set(code / m_perTurn * m_turn);
    rate.set(counted / m_perTurn * m_turn / world.tick());
    index.set(turn != m_lastTurn);
    missed.set(m_missed);
    m_lastPassed = passed;
    m_lastTurn = turn;
}

} // namespace trundle
