#include "remote/arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/clean_text.h"
#include "base/spelling.h"

namespace trundle {
namespace {

/// Not finite if it is no such number; true and false count as 1 and 0.
double finiteNumber(const nlohmann::json& value) {
    if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

const nlohmann::json* Arguments::find(const std::string& name, bool required) {
    m_expected.push_back(name);
    const auto found = m_request.find(name);
    if (found != m_request.end()) return &*found;
    if (required) setProblem(name + " is missing");
    return nullptr;
}

void Arguments::setProblem(std::string problem) {
    if (m_problem.empty()) m_problem = std::move(problem);
}

bool Arguments::has(const std::string& name) { return find(name, false) != nullptr; }

double Arguments::number(const std::string& name, std::optional<double> otherwise) {
    const nlohmann::json* value = find(name, !otherwise);
    if (!value) return otherwise.value_or(0);
    if (value->is_number() && std::isfinite(value->get<double>())) return value->get<double>();
    setProblem(name + " must be a finite number");
    return 0;
}

std::uint64_t Arguments::count(const std::string& name, std::uint64_t most, std::optional<std::uint64_t> otherwise) {
    const nlohmann::json* value = find(name, !otherwise);
    if (!value) return otherwise.value_or(0);
    if (value->is_number_unsigned() && value->get<std::uint64_t>() <= most) return value->get<std::uint64_t>();
    setProblem(name + " must be a whole number from 0 to " + std::to_string(most));
    return 0;
}

bool Arguments::flag(const std::string& name, bool otherwise) {
    const nlohmann::json* value = find(name, false);
    if (!value) return otherwise;
    if (value->is_boolean()) return value->get<bool>();
    setProblem(name + " must be true or false");
    return otherwise;
}

std::string Arguments::text(const std::string& name, std::optional<std::string> otherwise) {
    const nlohmann::json* value = find(name, !otherwise);
    if (!value) return otherwise.value_or("");
    if (value->is_string()) return value->get<std::string>();
    setProblem(name + " must be a text");
    return {};
}

std::vector<std::string> Arguments::texts(const std::string& name) {
    const nlohmann::json* value = find(name, true);
    std::vector<std::string> all;
    if (!value) return all;
    const bool valid = value->is_array() && std::ranges::all_of(*value, [](const nlohmann::json& each) { return each.is_string(); });
    if (!valid) setProblem(name + " must be an array of texts");
    else for (const nlohmann::json& each : *value) all.push_back(each.get<std::string>());
    return all;
}

std::vector<double> Arguments::numbers(const std::string& name, std::size_t size) {
    const nlohmann::json* value = find(name, true);
    std::vector<double> all(size);
    if (!value) return all;
    const auto isFinite = [](const nlohmann::json& each) { return each.is_number() && std::isfinite(each.get<double>()); };
    if (!value->is_array() || value->size() != size || !std::ranges::all_of(*value, isFinite))
        setProblem(name + " must be an array of " + std::to_string(size) + " finite numbers");
    else std::ranges::transform(*value, all.begin(), [](const nlohmann::json& each) { return each.get<double>(); });
    return all;
}

std::vector<std::pair<std::string, std::vector<double>>> Arguments::values(const std::string& name) {
    const nlohmann::json* value = find(name, false);
    std::vector<std::pair<std::string, std::vector<double>>> all;
    if (!value) return all;
    if (!value->is_object()) setProblem(name + " must be an object");
    else
        for (const auto& [path, given] : value->items()) {
            std::vector<double> numbers;
            if (given.is_array())
                for (const nlohmann::json& each : given) numbers.push_back(finiteNumber(each));
            else numbers.push_back(finiteNumber(given));
            if (numbers.empty() || !std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
                setProblem("the value of " + cleanLine(path) + " must be a finite number, or an array of them");
            else all.emplace_back(path, std::move(numbers));
        }
    return all;
}

std::string Arguments::problem() const {
    if (!m_problem.empty()) return m_problem;
    for (const auto& [name, value] : m_request.items()) {
        if (std::ranges::find(m_expected, name) != m_expected.end()) continue;
        const std::vector<std::string> near = nearestWords(name, m_expected, 1);
        return "unknown member " + cleanLine(name.substr(0, 100)) + (near.empty() ? "" : "; did you mean " + near[0] + "?");
    }
    return {};
}

} // namespace trundle
