#include "project/edits/template_values.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace trundle {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxEntries = 5000; ///< entries of folders searched for a file

} // namespace

double likelyNumber(const Property& p) {
    double value = p.unit == "m" ? 0.1 : p.unit == "V" ? 12 : p.unit == "Nm/A" ? 0.05 : 1;
    if (p.name.find("Separation") != std::string::npos) value = 0.3;
    const auto low = [&](double v) { return v > p.minimum || (v == p.minimum && !p.minExclusive); };
    const auto high = [&](double v) { return v < p.maximum || (v == p.maximum && !p.maxExclusive); };
    if (low(value) && high(value)) return value;
    const bool below = std::isfinite(p.minimum), above = std::isfinite(p.maximum);
    if (below && above) value = p.minExclusive || p.maxExclusive ? (p.minimum + p.maximum) / 2 : p.minimum;
    else if (below) value = p.minExclusive ? p.minimum + 1 : p.minimum;
    else value = p.maxExclusive ? p.maximum - 1 : p.maximum;
    return p.type == PropertyType::Integer ? std::floor(value) : value;
}

std::string likelyFile(const LoadedProject& loaded, const Property& p, const std::string& name) {
    std::string found;
    const auto fits = [&](const std::string& path) {
        return std::any_of(p.choices.begin(), p.choices.end(), [&](const std::string& e) { return path.ends_with("." + e); });
    };
    std::error_code ec;
    int looked = 0;
    fs::recursive_directory_iterator it(loaded.projectFolder, fs::directory_options::skip_permission_denied, ec), end;
    for (; !ec && it != end && ++looked < kMaxEntries; it.increment(ec)) {
        if (it.depth() > 4) it.disable_recursion_pending();
        std::error_code status;
        if (!it->is_regular_file(status) || !fits(it->path().filename().string())) continue;
        const std::string path = it->path().lexically_relative(loaded.projectFolder).generic_string();
        if (found.empty() || path < found) found = path;
    }
    if (found.empty())
        found = fits("block.obj")   ? "block.obj"
                : fits("hills.png") ? "hills.png"
                                    : name + "." + (p.choices.empty() ? "txt" : p.choices[0]);
    return "\"" + found + "\"";
}

} // namespace trundle
