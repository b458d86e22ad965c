#include "fuzz/random_experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace trundle::fuzz {

std::uint32_t Choices::pick(std::uint32_t count) {
    if (count < 2 || spent()) return 0;
    std::uint32_t value = m_bytes[m_next++];
    if (count > 256 && !spent()) value = value * 256 + m_bytes[m_next++];
    return value % count;
}

namespace {

/// Names generated so far, by the kind or role that a reference may require.
struct Names {
    std::vector<std::string> bodies, geoms, joints, wheels;
    std::vector<std::pair<std::string, std::string>> devices; ///< kind, name
};

std::string show(double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.17g", value);
    return buffer;
}

/// Mostly typical values, sometimes a bound of the range, sometimes an extreme value.
double numberFor(Choices& c, const Property& p) {
    const double low = std::isfinite(p.minimum) ? p.minimum : -1e9;
    const double high = std::isfinite(p.maximum) ? p.maximum : 1e9;
    static const double common[] = {0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1, 1.5, 2, 3, 5, 10, 45, 90, -0.1, -0.5, -1, -90, 1e-3};
    static const double wild[] = {1e-12, 1e-9,  1e-6, 1e-4, 100,    1e3,   1e4,    1e6,
                                  1e9,   -1e-9, -1e3, -1e6, 1e-300, 1e300, -1e300, 1e18};
    double value = c.chance(15) ? common[c.pick(std::size(common))] : wild[c.pick(std::size(wild))];
    if (c.pick(64) == 1) value = low;
    if (c.pick(64) == 1) value = high;
    value = std::clamp(value, low, high);
    if (p.minExclusive && value <= low) value = low + (high - low > 1 ? 0.05 : (high - low) / 2);
    if (p.maxExclusive && value >= high) value = low + (high - low) / 2;
    return p.type == PropertyType::Integer ? std::trunc(value) : value;
}

std::string referenceFor(Choices& c, const Property& p, const Names& names) {
    std::vector<std::string> fitting;
    for (const std::string& wanted : p.choices) {
        if (wanted == "Body") fitting.insert(fitting.end(), names.bodies.begin(), names.bodies.end());
        else if (wanted == "Geom") fitting.insert(fitting.end(), names.geoms.begin(), names.geoms.end());
        else if (wanted == "Hinge" || wanted == "Joint" || wanted == "Suspension")
            fitting.insert(fitting.end(), names.joints.begin(), names.joints.end());
        else
            for (const auto& [kind, name] : names.devices)
                if (kind == wanted) fitting.push_back(name);
    }
    return fitting.empty() ? std::string() : fitting[c.pick(static_cast<std::uint32_t>(fitting.size()))];
}

std::string valueFor(Choices& c, const Property& p, const Names& names) {
    std::uint32_t count = p.minCount;
    if (p.maxCount > p.minCount) count += c.pick(std::min(p.maxCount - p.minCount + 1, 6u));
    std::string text;
    for (std::uint32_t i = 0; i < std::max(count, 1u); ++i) {
        if (i) text += ',';
        switch (p.type) {
        case PropertyType::Number:
        case PropertyType::Integer: text += show(numberFor(c, p)); break;
        case PropertyType::Boolean: text += c.pick(2) ? "true" : "false"; break;
        case PropertyType::Choice:
            text += p.choices.empty() ? "none" : p.choices[c.pick(static_cast<std::uint32_t>(p.choices.size()))];
            break;
        case PropertyType::Reference: {
            const std::string name = referenceFor(c, p, names);
            if (name.empty()) return {};
            text += name;
            break;
        }
        case PropertyType::Text: text += "\"x\""; break;
        case PropertyType::File: return {};
        }
    }
    return text;
}

bool given(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Properties of a kind except `without`; required ones always, optional ones sometimes.
std::string properties(Choices& c, const Kind& kind, const Names& names, const std::vector<std::string>& without,
                       std::uint32_t inSixteen) {
    std::string text;
    for (const Property& p : kind.properties) {
        if (given(without, p.name) || !(p.required || c.chance(inSixteen))) continue;
        const std::string value = valueFor(c, p, names);
        if (!value.empty()) text += " " + p.name + "=" + value;
    }
    return text;
}

std::string pose(Choices& c, double spread) {
    const auto coordinate = [&] { return show((static_cast<double>(c.pick(256)) - 128) / 128 * spread); };
    std::string text = " Pos=" + coordinate() + "," + coordinate() + "," + coordinate();
    if (c.chance(6))
        text += " HPR=" + std::to_string(c.pick(360)) + "," + std::to_string(c.pick(180)) + "," + std::to_string(c.pick(360));
    return text;
}

const std::vector<std::string> kPoseKeys = {"Pos", "HPR"};

std::string geom(Choices& c, const Registry& registry, const std::string& name, bool onStatic) {
    static const char* const onBodies[] = {"Box", "Sphere", "Cylinder", "Capsule"};
    static const char* const onStatics[] = {"Plane", "Box", "Sphere", "Cylinder", "Capsule"};
    const std::string kindName = onStatic ? onStatics[c.pick(5)] : onBodies[c.pick(4)];
    const Kind* kind = registry.find(kindName);
    if (!kind) return {};
    std::vector<std::string> without = kPoseKeys;
    without.insert(without.end(), {"Material", "Surface", "Mass", "Density", "Size", "Radius", "Length"});
    const auto length = [&] {
        return show(c.chance(15) ? 0.02 + 0.01 * c.pick(50) : numberFor(c, *kind->find(kindName == "Box" ? "Size" : "Radius")));
    };
    std::string text = "    " + kindName + " " + name + " {" + pose(c, 0.2);
    if (kindName == "Box") text += " Size=" + length() + "," + length() + "," + length();
    else if (kindName != "Plane") text += " Radius=" + length();
    if (kindName == "Cylinder" || kindName == "Capsule") text += " Length=" + length();
    if (!onStatic)
        text += c.chance(14) ? " Mass=" + show(0.05 * (1 + c.pick(100))) : " Density=" + show(100.0 * (1 + c.pick(200)));
    text += " Surface=s" + std::to_string(c.pick(3)) + properties(c, *kind, {}, without, 1);
    return text + " }\n";
}

std::string joint(Choices& c, const Registry& registry, const Names& names, const std::string& name, std::size_t child) {
    static const char* const kinds[] = {"Hinge", "Hinge", "Hinge", "Slider", "Ball", "Universal", "Fixed", "Suspension"};
    const std::string kindName = kinds[c.pick(8)];
    const Kind* kind = registry.find(kindName);
    if (!kind) return {};
    const std::string parent = c.chance(1) ? "world" : names.bodies[c.pick(static_cast<std::uint32_t>(child))];
    return "  " + kindName + " " + name + " { Parent=" + parent + " Child=" + names.bodies[child] +
           properties(c, *kind, names, {"Parent", "Child"}, 2) + " }\n";
}

/// A spring between two bodies, and a gear between two joints, which may be of kinds that it does not fit.
std::string couplings(Choices& c, const Registry& registry, const Names& names) {
    const Kind *spring = registry.find("Spring"), *gear = registry.find("Gear");
    if (!spring || !gear || names.bodies.size() < 2) return {};
    std::string text;
    const auto body = 1 + c.pick(static_cast<std::uint32_t>(names.bodies.size() - 1));
    if (c.chance(6))
        text += "  Spring spring { Parent=" + (c.chance(4) ? "world" : names.bodies[body - 1]) + " Child=" + names.bodies[body] +
                properties(c, *spring, names, {"Parent", "Child"}, 3) + " }\n";
    if (names.joints.size() > 1 && c.chance(1))
        text += "  Gear gear { Joint=" + names.joints[0] + " Other=" + names.joints[1] +
                " Ratio=" + show(c.chance(8) ? -0.5 : numberFor(c, *gear->find("Ratio"))) + " }\n";
    return text;
}

std::string devices(Choices& c, const Registry& registry, Names& names) {
    std::string text;
    std::vector<const Kind*> kinds;
    for (const Kind* kind : registry.all())
        if (kind->role == Role::Device) kinds.push_back(kind);
    if (kinds.empty()) return text;
    const std::uint32_t count = c.pick(6);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Kind& kind = *kinds[c.pick(static_cast<std::uint32_t>(kinds.size()))];
        const std::string name = "d" + std::to_string(names.devices.size());
        std::vector<std::string> without;
        if (kind.name == "RotaryMotor") without = {c.pick(2) ? "SpeedConstant" : "BackEmfConstant"};
        std::string body = properties(c, kind, names, without, kind.name == "RotaryMotor" ? 16 : 3);
        bool complete = true;
        for (const Property& p : kind.properties)
            complete = complete && (!p.required || body.find(" " + p.name + "=") != std::string::npos);
        if (!complete) continue;
        text += "  " + kind.name + " " + name + " {" + body + " }\n";
        names.devices.emplace_back(kind.name, name);
    }
    return text;
}

std::string robotConfig(Choices& c, const Registry& registry, const std::string& name) {
    Names names;
    std::string text = "RobotConfig " + name + " {\n";
    const std::uint32_t bodyCount = 1 + c.pick(4);
    for (std::uint32_t b = 0; b < bodyCount; ++b) {
        const std::string body = "b" + std::to_string(b);
        text += "  Body " + body + " {" + pose(c, 0.3) + "\n";
        const std::uint32_t geomCount = 1 + c.pick(3);
        for (std::uint32_t g = 0; g < geomCount; ++g) {
            const std::string geomName = "g" + std::to_string(g);
            text += geom(c, registry, geomName, false);
            names.geoms.push_back(body + "." + geomName);
        }
        text += "  }\n";
        names.bodies.push_back(body);
    }
    for (std::uint32_t b = 1; b < bodyCount; ++b) {
        if (c.chance(2)) continue;
        names.joints.push_back("j" + std::to_string(b));
        text += joint(c, registry, names, names.joints.back(), b);
    }
    text += devices(c, registry, names);
    text += couplings(c, registry, names);
    if (c.chance(3)) text += "  SelfCollision=true\n";
    return text + "}\n";
}

/// What is between robots: joints, a spring, a region, and pairs that do not touch each other.
std::string between(Choices& c, const Registry& registry, std::uint32_t robots) {
    std::string text;
    const auto robot = [&] { return "r" + std::to_string(c.pick(robots)); };
    for (int i = 0; robots > 1 && i < 2; ++i) {
        if (!c.chance(5)) continue;
        Names names;
        names.bodies = {robot() + ".b0", robot() + ".b0"};
        text += joint(c, registry, names, "link" + std::to_string(i), 1);
    }
    const Kind* spring = registry.find("Spring");
    if (spring && robots > 1 && c.chance(3))
        text += "Spring rope { Parent=" + robot() + ".b0 Child=" + robot() + ".b0" +
                properties(c, *spring, {}, {"Parent", "Child"}, 3) + " }\n";
    if (c.chance(4)) text += "Region region {" + pose(c, 1) + " Size=1," + show(0.1 + 0.1 * c.pick(20)) + ",0.5 }\n";
    if (robots > 1 && c.chance(3)) text += "NoContact=" + robot() + "," + robot() + "\n";
    return text;
}

} // namespace

std::string randomExperiment(Choices& c, const Registry& registry) {
    std::string text = "Tick=" + std::string(c.chance(12) ? "0.01" : (c.pick(2) ? "0.03" : "0.001"));
    static const char* const solvers[] = {"auto", "quick", "exact"};
    const std::uint32_t robots = 1 + c.pick(6);
    // The exact solver is cubic in the contacts: for many robots it does not hang, but wastes fuzzing time.
    text += " Seed=" + std::to_string(c.pick(1000)) + " Solver=" + solvers[c.pick(robots > 2 ? 2 : 3)] + "\n";
    if (c.chance(2)) text += "Gravity=" + std::to_string(c.pick(9)) + ",0,-" + std::to_string(c.pick(30)) + "\n";
    const Kind* surface = registry.find("Surface");
    for (int i = 0; i < 3 && surface; ++i)
        text += "Surface s" + std::to_string(i) + " {" + properties(c, *surface, {}, {}, 8) + " }\n";
    const std::uint32_t configs = 1 + c.pick(2);
    for (std::uint32_t i = 0; i < configs; ++i) text += robotConfig(c, registry, "C" + std::to_string(i));
    text += "StaticConfig Ground {\n";
    const std::uint32_t geomCount = 1 + c.pick(3);
    for (std::uint32_t g = 0; g < geomCount; ++g) text += geom(c, registry, "g" + std::to_string(g), true);
    text += "}\nStatic ground { Config=Ground }\n";
    for (std::uint32_t i = 0; i < robots; ++i)
        text += "Robot r" + std::to_string(i) + " { Config=C" + std::to_string(c.pick(configs)) + pose(c, 1.5) + " }\n";
    if (robots > 2 && c.chance(4))
        text += "Grid swarm { Config=C0 Count=" + std::to_string(1 + c.pick(4)) + " Spacing=" + show(0.1 + 0.1 * c.pick(10)) +
                pose(c, 2) + " }\n";
    return text + between(c, registry, robots);
}

} // namespace trundle::fuzz
