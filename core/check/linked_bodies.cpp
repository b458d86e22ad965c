#include "check/linked_bodies.h"

#include <map>
#include <set>
#include <utility>

namespace trundle {
namespace {

class LinkedBodies {
public:
    explicit LinkedBodies(const ExperimentSpec& experiment) : m_experiment(experiment) {}

    template <class Spec> void add(const std::vector<Link<Spec>>& links, std::vector<Spec>& to) {
        std::set<SourceRange> seen;
        for (const Link<Spec>& link : links) {
            if (!seen.insert(link.spec.nameRange).second) continue;
            Spec spec = link.spec;
            spec.child = indexOf(link.childRobot, spec.child);
            spec.parent = indexOf(link.parentRobot, spec.parent);
            if (spec.child != kWorldBody) to.push_back(std::move(spec));
        }
    }
    RobotConfigSpec config;

private:
    int indexOf(int robot, int body) {
        if (robot == kWorldBody || body == kWorldBody) return kWorldBody;
        const RobotSpec& owner = m_experiment.robots[static_cast<std::size_t>(robot)];
        if (owner.config->bodies[static_cast<std::size_t>(body)].isFixed) return kWorldBody;
        const auto [known, isNew] = m_indices.try_emplace({robot, body}, static_cast<int>(config.bodies.size()));
        if (isNew) {
            BodySpec copy = owner.config->bodies[static_cast<std::size_t>(body)];
            copy.name = owner.name + "." + copy.name;
            copy.pose = owner.pose * copy.pose;
            copy.geoms.clear();
            config.bodies.push_back(std::move(copy));
        }
        return known->second;
    }

    const ExperimentSpec& m_experiment;
    std::map<std::pair<int, int>, int> m_indices;
};

} // namespace

RobotConfigSpec linkedBodies(const ExperimentSpec& experiment) {
    LinkedBodies linked(experiment);
    linked.add(experiment.joints, linked.config.joints);
    linked.add(experiment.springs, linked.config.springs);
    return std::move(linked.config);
}

} // namespace trundle
