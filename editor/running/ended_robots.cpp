#include "editor/running/ended_robots.h"

#include <QStringList>

#include "editor/running/active_run.h"
#include "editor/running/run_edits.h"
#include "editor/widgets/name_list.h"
#include "editor/widgets/strings.h"
#include "model/robot_path.h"
#include "model/outline.h"
#include "model/passive_objects.h"

namespace trundle {
namespace {

constexpr int kMaxNamed = 3;

/// "row.cart" of "row_3.cart", in a Repeat of the world.
std::string allMembers(std::string_view robot) {
    std::string all;
    for (; firstWord(robot) != robot; robot = withoutFirstWord(robot)) {
        const std::optional<MemberName> member = memberName(firstWord(robot));
        all += std::string(member ? member->stem : firstWord(robot)) + ".";
    }
    return all + std::string(robot);
}

/// "swarm" of "swarm_3", "row.swarm" of "row_0.swarm_3"; empty if it is in no Grid or Scatter.
std::string layoutOf(const Outline& outline, const std::string& robot) {
    return layoutOfMember(outline, robot) ? std::string(memberName(allMembers(robot))->stem) : std::string();
}

} // namespace

EndedRobots::EndedRobots(const RunResults& results, const RunEdits& edits, QObject* parent)
    : QObject(parent), m_results(results), m_edits(edits) {}

void EndedRobots::update() {
    const std::size_t count = m_results.snapshot ? m_results.snapshot->ended.size() : 0;
    if (count == m_ends.size()) return; // a run only adds to them
    m_byInstance.clear();
    m_ends.clear();
    m_objects = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const RobotEnd& end = m_results.snapshot->ended[i];
        const RobotSpec& robot = m_results.experiment->robots[end.robot];
        m_objects += isPassive(robot) ? 1 : 0;
        m_ends.push_back({robot.name, end.fault});
    }
    for (const End& end : m_ends) {
        m_byInstance[end.robot].push_back(&end);
        const std::string layout = layoutOf(*m_results.built->outline, end.robot);
        if (!layout.empty() && layout != end.robot) m_byInstance[layout].push_back(&end);
        if (const std::string all = allMembers(end.robot); all != end.robot) m_byInstance[all].push_back(&end);
    }
    Q_EMIT changed();
}

const EndedRobots::Ends* EndedRobots::endsOf(std::string_view instance) const {
    const auto it = m_byInstance.find(instance);
    return it != m_byInstance.end() && m_edits.isOfRun(it->first) ? &it->second : nullptr;
}

/// The start of the path that names a robot, or members, of which one has ended.
std::string_view EndedRobots::instanceIn(std::string_view path) const {
    return shortestStart(path, [this](std::string_view start) { return m_byInstance.contains(start); });
}

bool EndedRobots::hasEnded(std::string_view path) const {
    const std::string_view robot = instanceIn(path);
    const Ends* ends = endsOf(robot);
    return ends && ends->front()->robot == robot;
}

QString EndedRobots::namesOf(const Ends& ends) {
    QStringList names;
    for (const End* end : ends) names << toQString(end->robot);
    return listed(names, kMaxNamed);
}

std::size_t EndedRobots::countOf(std::string_view instance) const {
    const Ends* ends = endsOf(instance);
    return ends ? ends->size() : 0;
}

QString EndedRobots::label(std::string_view instance) const {
    const Ends* ends = endsOf(instance);
    if (!ends) return {};
    return ends->front()->robot == instance ? tr("ended") : tr("%1 ended").arg(ends->size());
}

QString EndedRobots::explanation(std::string_view path) const {
    const std::string instance(instanceIn(path));
    const Ends* ends = endsOf(instance);
    if (!ends) return {};
    const End& first = *ends->front();
    if (first.robot != instance)
        return tr("%1 of its members have ended by a fault: %2").arg(QString::number(ends->size()), namesOf(*ends));
    return tr("%1 has ended by a fault at t = %2 s: %3 stopped: %4. It stays where it is and touches nothing; its controller and "
              "devices are not called any more")
        .arg(toQString(instance), QString::number(first.fault.time), toQString(first.fault.body), toQString(first.fault.reason));
}

QString EndedRobots::summary() const {
    Ends all;
    for (const End& end : m_ends) all.push_back(&end);
    return all.empty() ? QString() : tr("Ended by a fault: %1").arg(namesOf(all));
}

} // namespace trundle
