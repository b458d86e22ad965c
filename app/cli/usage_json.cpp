#include "cli/usage_json.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "cli/diagnostic_json.h"
#include "cli/run_report.h"

namespace trundle {

bool asksForJson(int argc, char** argv) {
    return std::any_of(argv + std::min(argc, 1), argv + argc,
                       [](const char* word) { return std::string_view(word) == "--json"; });
}

std::string usageJson(std::string_view command, const std::string& message) {
    nlohmann::ordered_json list = diagnosticsJson({{Severity::Error, Code::Internal, message, {}, {}, {}, {}}}, {});
    list[0]["code"] = "usage"; // not an error in a text, so none of the numbered codes
    if (command == "check") return jsonText(list);
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    if (command == "run") object = nlohmann::ordered_json::parse(runJson({}));
    object["diagnostics"] = list;
    return jsonText(object);
}

} // namespace trundle
