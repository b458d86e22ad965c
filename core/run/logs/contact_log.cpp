#include <set>

#include "run/logs/csv.h"
#include "run/logs/log.h"
#include "run/logs/log_choice.h"
#include "run/logs/log_settings.h"

namespace trundle {
namespace {

/// The first word of a path: "robot0" of "robot0/chassis/bumper".
std::string_view ownerOf(std::string_view path) { return path.substr(0, path.find('/')); }

class ContactLog final : public RunLog {
public:
    /// With an empty set, all contacts are logged.
    explicit ContactLog(std::set<std::string, std::less<>> robots) : m_robots(std::move(robots)) {}

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        for (const char* name : {"time [s]", "first", "second", "x [m]", "y [m]", "z [m]", "normal x", "normal y", "normal z",
                                 "depth [m]", "force [N]", "friction x [N]", "friction y [N]", "friction z [N]"})
            out.cell(name);
        out.endRow();
    }

    void rows(const World& world, double time, std::string& csv) override {
        CsvWriter out(csv);
        for (const WorldContact& contact : world.contacts()) {
            if (!wanted(contact)) continue;
            out.cell(time).cell(contact.first).cell(contact.second);
            for (int i = 0; i < 3; ++i) out.cell(contact.position[i]);
            for (int i = 0; i < 3; ++i) out.cell(contact.normal[i]);
            out.cell(contact.depth).cell(contact.force);
            for (int i = 0; i < 3; ++i) out.cell(contact.friction[i]);
            out.endRow();
        }
    }

private:
    bool wanted(const WorldContact& contact) const {
        return m_robots.empty() || m_robots.contains(ownerOf(contact.first)) || m_robots.contains(ownerOf(contact.second));
    }

    std::set<std::string, std::less<>> m_robots;
};

} // namespace

void ContactLogSettings::describe(Describe<ContactLogSettings>& d) {
    d.help("What touches what: place, normal towards the first, depth, force along it and friction on the first of each contact "
           "of the last tick.");
    d.field("Robot", &ContactLogSettings::robots, text(),
            "Contacts of these robots only: names, a Grid's name, or a pattern such as \"robot*\".");
    describeLogSettings(d);
}

std::unique_ptr<RunLog> makeContactLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    std::set<std::string, std::less<>> names;
    if (!spec.texts("Robot").empty())
        for (const std::size_t robot : chooseRobots(spec, world.experiment().robots, diagnostics))
            names.insert(world.experiment().robots[robot].name);
    return std::make_unique<ContactLog>(std::move(names));
}

} // namespace trundle
