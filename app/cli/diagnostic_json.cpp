#include "cli/diagnostic_json.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/clean_text.h"
#include "base/utf8.h"

namespace trundle {
namespace {

using Json = nlohmann::ordered_json;

/// file, line, column, end_line, end_column
Json placeJson(const SourceRange& range, const SourceTable& sources) {
    Json place;
    LineColumn begin{0, 0}, end{0, 0};
    std::string file;
    if (range.known() && range.file < sources.size()) {
        const SourceText& text = *sources[range.file].text;
        file = text.path();
        begin = text.position(range.range.begin);
        end = text.position(range.range.end);
    }
    place["file"] = file;
    place["line"] = begin.line;
    place["column"] = begin.column;
    place["end_line"] = end.line;
    place["end_column"] = end.column;
    return place;
}

const char* severityText(Severity severity) {
    switch (severity) {
    case Severity::Error: return "error";
    case Severity::Warning: return "warning";
    case Severity::Hint: return "hint";
    }
    return "error";
}

Json fixJson(const Fix& fix, const SourceTable& sources) {
    Json edits = Json::array();
    for (const TextEdit& edit : fix.edits) {
        Json entry = placeJson(edit.range, sources);
        entry["text"] = edit.text;
        edits.push_back(std::move(entry));
    }
    return {{"title", fix.title}, {"edits", std::move(edits)}};
}

} // namespace

Json diagnosticsJson(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources) {
    Json all = Json::array();
    for (const Diagnostic& diagnostic : diagnostics) {
        Json entry = placeJson(diagnostic.range, sources);
        entry["severity"] = severityText(diagnostic.severity);
        entry["code"] = codeName(diagnostic.code);
        entry["message"] = diagnostic.message;
        entry["suggestions"] = diagnostic.suggestions;
        Json fixes = Json::array();
        for (const Fix& fix : diagnostic.fixes) fixes.push_back(fixJson(fix, sources));
        entry["fixes"] = std::move(fixes);
        for (const auto& [text, range] : diagnostic.notes) {
            Json note = placeJson(range, sources);
            note["message"] = text;
            entry["notes"].push_back(std::move(note));
        }
        if (diagnostic.more > 0) entry["more"] = diagnostic.more;
        all.push_back(std::move(entry));
    }
    return all;
}

namespace {

// The JSON library escapes characters below U+0020. Terminals interpret some others too; they can occur only inside strings.
std::string escaped(const std::string& text) {
    std::string safe;
    safe.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = codePointAt(text, at);
        if (point.value >= 0x7F && isControl(point.value)) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(point.value));
            safe += escape;
        } else {
            safe.append(text, at, point.length);
        }
        at += point.length;
    }
    return safe;
}

} // namespace

std::string diagnosticEntries(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources) {
    const std::string list = escaped(diagnosticsJson(diagnostics, sources).dump(-1, ' ', false, Json::error_handler_t::replace));
    return list.substr(1, list.size() - 2);
}

std::string jsonText(const Json& json) { return escaped(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n"; }

} // namespace trundle
