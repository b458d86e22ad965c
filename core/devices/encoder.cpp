#include "devices/encoder.h"

#include <numbers>

namespace trundle {
namespace {
constexpr double kTurn = 2 * std::numbers::pi;
} // namespace

double encoderCount(double angle, double countsPerTurn) { return std::floor(angle / kTurn * countsPerTurn + 1e-9); }

void Encoder::describe(Describe<Encoder>& d) {
    d.help("Counts the steps that a joint turns.");
    d.field("Joint", &Encoder::m_jointName, reference("Hinge|Suspension").required(), "The joint it sits on.");
    Quantity counts = number().within(1, 1e9);
    counts.type = TRUNDLE_INTEGER;
    d.field("CountsPerRevolution", &Encoder::m_countsPerRevolution, counts, "Lines of the disc.");
    d.field("Quadrature", &Encoder::m_quadrature, flag(), "Counts all four edges of a line.");
    d.field("Index", &Encoder::m_hasIndex, flag(), "Gives a pulse once per revolution.");
    EncoderSignals::describe(d);
}

void Encoder::setup(Mount& mount) { m_joint = mount.joint(m_jointName); }

void Encoder::sense(Sensing& world) {
    const double perTurn = m_countsPerRevolution * (m_quadrature ? 4 : 1);
    const double turned = world.jointPosition(m_joint);
    const double counted = encoderCount(turned, perTurn);
    const double turn = encoderCount(turned, 1);
    count.set(counted);
    angle.set(counted / perTurn * kTurn);
    rate.set((counted - m_lastCount) / perTurn * kTurn / world.tick());
    index.set(m_hasIndex && turn != m_lastTurn);
    m_lastCount = counted;
    m_lastTurn = turn;
}

} // namespace trundle
