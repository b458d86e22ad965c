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
    d.output("count", "", "Counts since the start, negative backwards.", 1, TRUNDLE_INTEGER_SIGNAL);
    d.output("angle", "rad", "The angle that the count represents.");
    d.output("rate", "rad/s", "Counts of the last tick as a rate.");
    d.output("index", "", "In the last tick the index mark passed.", 1, TRUNDLE_BOOLEAN_SIGNAL);
}

void Encoder::setup(Mount& mount) {
    m_joint = mount.joint(m_jointName);
    m_count = mount.signal("count");
    m_angle = mount.signal("angle");
    m_rate = mount.signal("rate");
    m_index = mount.signal("index");
}

void Encoder::sense(Sensing& world) {
    const double perTurn = m_countsPerRevolution * (m_quadrature ? 4 : 1);
    const double angle = world.jointPosition(m_joint);
    const double count = encoderCount(angle, perTurn);
    const double turn = encoderCount(angle, 1);
    m_count.set(count);
    m_angle.set(count / perTurn * kTurn);
    m_rate.set((count - m_lastCount) / perTurn * kTurn / world.tick());
    m_index.set(m_hasIndex && turn != m_lastTurn);
    m_lastCount = count;
    m_lastTurn = turn;
}

} // namespace trundle
