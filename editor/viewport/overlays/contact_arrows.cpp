#include "editor/viewport/overlays/contact_arrows.h"

#include <algorithm>
#include <cmath>

namespace trundle {

double roundNumber(double most) {
    const double ten = std::pow(10.0, std::floor(std::log10(most)));
    return most >= 5 * ten ? 5 * ten : most >= 2 * ten ? 2 * ten : ten;
}

double forceUnit(const ExperimentSpec& experiment) {
    double most = 0;
    for (const RobotSpec& robot : experiment.robots) {
        double mass = 0;
        if (robot.config)
            for (const BodySpec& body : robot.config->bodies) mass += body.mass.mass;
        most = std::max(most, mass * experiment.settings.gravity.norm());
    }
    return most > 0 ? roundNumber(most) : 10;
}

std::vector<ContactArrow> contactArrows(const std::vector<LiveContact>& contacts, double unit) {
    std::vector<ContactArrow> arrows;
    for (const LiveContact& contact : contacts) {
        const double wanted = kForcePixels * std::max(0.0, contact.force) / unit;
        arrows.push_back({&contact, std::min(wanted, kMaxForcePixels), wanted > kMaxForcePixels});
    }
    if (arrows.size() <= kMaxContacts) return arrows;
    const auto stronger = [](const ContactArrow& a, const ContactArrow& b) { return a.contact->force > b.contact->force; };
    std::nth_element(arrows.begin(), arrows.begin() + kMaxContacts, arrows.end(), stronger);
    arrows.resize(kMaxContacts);
    return arrows;
}

} // namespace trundle
