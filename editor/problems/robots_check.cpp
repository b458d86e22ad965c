#include "editor/problems/robots_check.h"

#include <algorithm>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "base/platform/process.h"

namespace trundle {
namespace {

QString text(const std::string& bytes) { return QString::fromStdString(bytes); }

/// All texts by path; empty if one is not UTF-8, which JSON cannot hold.
QByteArray textsJson(const LoadedProject& loaded) {
    QJsonObject texts;
    for (std::size_t i = 0; i < loaded.paths.size(); ++i) {
        if (loaded.paths[i].empty()) continue;
        const std::string_view bytes = loaded.sources[static_cast<FileId>(i)].text->bytes();
        const QString shown = QString::fromUtf8(bytes.data(), static_cast<qsizetype>(bytes.size()));
        if (shown.toUtf8() != QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()))) return {};
        texts.insert(text(loaded.paths[i]), shown);
    }
    return QJsonDocument(texts).toJson(QJsonDocument::Compact);
}

std::vector<std::string> arguments(const RobotsCheck& check, const LoadedProject& loaded) {
    std::vector<std::string> words{"check", "--robots-of-texts"};
    const auto add = [&words](const char* option, const std::vector<std::string>& values) {
        for (const std::string& value : values) words.insert(words.end(), {option, value});
    };
    add("-I", check.options.includes);
    add("--modules", check.options.modules);
    add("--modules", check.options.trusted); // the window has found all modules: only these are looked for
    add("--set", check.options.sets);
    if (check.options.trust) words.emplace_back("--trust");
    words.insert(words.end(), {"--", loaded.paths[0]});
    return words;
}

Diagnostic diagnosticOf(const QJsonObject& entry, const LoadedProject& loaded) {
    Diagnostic d;
    d.severity = Severity::Error;
    d.code = static_cast<Code>(entry[u"code"].toString().mid(1).toInt());
    d.message = entry[u"message"].toString().toStdString();
    const auto file = std::ranges::find(loaded.paths, entry[u"file"].toString().toStdString());
    if (file == loaded.paths.end() || file->empty()) return d;
    d.range = {static_cast<FileId>(file - loaded.paths.begin()),
               {static_cast<std::uint32_t>(entry[u"begin"].toInt()), static_cast<std::uint32_t>(entry[u"end"].toInt())}};
    return d;
}

Diagnostic slow(const RobotsCheck& check) {
    const std::string seconds = QString::number(check.seconds).toStdString();
    return {Severity::Warning,
            Code::ControllerFailed,
            "setting up the robots took more than " + seconds +
                " s, so that problems of controllers and devices are not shown before a run",
            {},
            {},
            {},
            {}};
}

} // namespace

std::vector<Diagnostic> checkRobots(const RobotsCheck& check, const LoadedProject& loaded, const std::stop_token& stop) {
    const ExperimentSpec& experiment = *loaded.experiment;
    if (check.program.empty() || loaded.paths.empty() || experiment.modules.empty() || experiment.robots.empty()) return {};
    ProcessRequest request;
    request.program = check.program;
    request.arguments = arguments(check, loaded);
    request.input = textsJson(loaded).toStdString();
    request.seconds = check.seconds;
    request.stop = stop;
    if (request.input.empty()) return {};
    const Result<ProcessResult> ended = runProcess(request);
    if (stop.stop_requested() || !ended) return {};
    if (ended.value().end == ProcessEnd::TimedOut) return {slow(check)};
    const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(ended.value().output));
    // A module that ended the process: the object of a run.
    const QJsonArray entries = json.isObject() ? json.object()[u"diagnostics"].toArray() : json.array();
    std::vector<Diagnostic> found;
    for (const QJsonValue& entry : entries) found.push_back(diagnosticOf(entry.toObject(), loaded));
    return found;
}

} // namespace trundle
