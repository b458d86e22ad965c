#include "project/wizard/mesh_text.h"

#include <algorithm>
#include <cmath>

#include "project/wizard/floor_path.h"

namespace trundle {
namespace {

constexpr double kLeastMass = 1e-4; // kg

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string three(const std::array<double, 3>& v) { return tidyNumber(v[0]) + "," + tidyNumber(v[1]) + "," + tidyNumber(v[2]); }

bool isZero(const std::array<double, 3>& v) { return three(v) == "0,0,0"; }

std::string posText(const std::array<double, 3>& v) { return isZero(v) ? "" : " Pos=" + three(v); }

std::string massText(const MeshPart& part) { return part.mass ? " Mass=" + tidyNumber(*part.mass) : ""; }

std::string fileText(const std::string& file) {
    const bool isPlain = std::ranges::all_of(
        file, [](char c) { return isLetter(c) || isDigit(c) || c == '_' || c == '.' || c == '/' || c == '-'; });
    return " File=" + (isPlain ? file : '"' + file + '"');
}

/// Each has its share of the mass.
std::string hullsText(const MeshPart& part) {
    double whole = 0, left = part.mass.value_or(0);
    for (const double volume : part.shape.volumes) whole += volume;
    std::string text;
    for (std::size_t i = 0; i < part.shape.files.size(); ++i) {
        text += "Convex " + part.name + "Part" + std::to_string(i + 1) + " {" + fileText(part.shape.files[i]) + " Visible=false";
        if (part.mass) {
            const bool isLast = i + 1 == part.shape.files.size();
            const double share = std::round(*part.mass * part.shape.volumes[i] / whole * 1e4) / 1e4;
            const double mass = std::max(kLeastMass, isLast ? left : share);
            left -= mass;
            text += " Mass=" + tidyNumber(mass);
        }
        text += " Material=grey Surface=" + part.surface + " }\n";
    }
    return text;
}

std::string shapeText(const MeshPart& part) {
    const CollisionShape& s = part.shape;
    if (s.kind == CollisionShape::Kind::Hulls) return hullsText(part);
    constexpr const char* kKinds[] = {"Box", "Cylinder", "Sphere", "Capsule"};
    std::string text = std::string(kKinds[static_cast<int>(s.kind)]) + " " + part.name + "Shape {" + posText(s.centre);
    const bool isRound = s.kind == CollisionShape::Kind::Cylinder || s.kind == CollisionShape::Kind::Capsule;
    if (isRound && s.axis == 0) text += " HPR=0,90,0";
    if (isRound && s.axis == 1) text += " HPR=0,0,90";
    if (s.kind == CollisionShape::Kind::Box) text += " Size=" + three(s.size);
    else text += " Radius=" + tidyNumber(s.radius);
    if (isRound) text += " Length=" + tidyNumber(s.length);
    return text + " Visible=false" + massText(part) + " Material=grey Surface=" + part.surface + " }\n";
}

} // namespace

std::string meshName(const std::string& file) {
    const std::size_t from = file.find_last_of('/') + 1;
    std::string name;
    bool isNewWord = false;
    for (const char c : file.substr(from, file.find_last_of('.') - from)) {
        if (!isLetter(c) && !isDigit(c)) {
            isNewWord = !name.empty();
            continue;
        }
        if (name.empty() && !isLetter(c)) continue;
        name += name.empty() ? lower(c) : isNewWord ? upper(c) : c;
        isNewWord = false;
    }
    return name.empty() ? "mesh" : name;
}

std::string meshGeomsText(const MeshPart& part) {
    const bool isHull = part.shape.kind == CollisionShape::Kind::Hull;
    std::string text = "Mesh " + part.name + " {" + fileText(part.file);
    if (part.scale != 1) text += " Scale=" + tidyNumber(part.scale);
    text += posText(part.origin);
    if (part.isYUp) text += " HPR=0,0,90";
    text += isHull ? " Shape=hull" + massText(part) : std::string(" Shape=none");
    if (!part.hasOwnLook) text += " Material=grey";
    text += " Surface=" + part.surface + " }\n";
    return isHull ? text : text + shapeText(part);
}

std::string meshSceneryText(const MeshPart& part) {
    std::string config = part.name, geoms;
    config[0] = upper(config[0]);
    std::string lines = meshGeomsText(part);
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t end = lines.find('\n', at);
        geoms += "  " + lines.substr(at, end - at) + "\n";
        at = end + 1;
    }
    return "StaticConfig " + config + " {\n" + geoms + "}\nStatic " + part.name + " { Config=" + config + " }\n";
}

} // namespace trundle
