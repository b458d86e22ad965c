#include "app/compiler_messages.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <utility>

#include "base/clean_text.h"
#include "base/platform/read_file.h"
#include "lang/characters.h"
#include "project/loading/loaded_project.h"
#include "project/loading/loader.h"

namespace trundle {

namespace {

namespace fs = std::filesystem;
using MessageKind = CompilerMessage::Kind;

constexpr std::size_t kMostMessages = 200;

/// Takes ":12" from the front. 0: there is no number.
std::uint32_t takeNumber(std::string_view& rest) {
    if (rest.size() < 2 || rest[0] != ':' || !isDigit(rest[1])) return 0;
    std::uint32_t number = 0;
    const auto [end, failure] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), number);
    if (failure != std::errc()) return 0;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return number;
}

std::string_view withoutBlanks(std::string_view text) {
    while (!text.empty() && (isBlank(text.front()) || text.front() == '\r')) text.remove_prefix(1);
    while (!text.empty() && (isBlank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

bool take(std::string_view& rest, std::string_view word) {
    if (!rest.starts_with(word)) return false;
    rest.remove_prefix(word.size());
    rest = withoutBlanks(rest);
    return true;
}

/// "wall.cpp:12:5: error: text"
std::optional<CompilerMessage> ofCompiler(std::string_view line) {
    for (std::size_t colon = line.find(':'); colon != std::string_view::npos; colon = line.find(':', colon + 1)) {
        std::string_view rest = line.substr(colon);
        CompilerMessage message;
        message.line = takeNumber(rest);
        if (message.line == 0 || colon == 0) continue;
        message.column = takeNumber(rest);
        if (!take(rest, ":")) continue;
        if (take(rest, "fatal error:") || take(rest, "error:")) message.kind = MessageKind::Error;
        else if (take(rest, "warning:")) message.kind = MessageKind::Warning;
        else if (take(rest, "note:")) message.kind = MessageKind::Note;
        else if (!rest.starts_with("undefined reference") && !rest.starts_with("multiple definition")) continue;
        std::string_view file = line.substr(0, colon);
        if (const std::size_t tool = file.rfind(": "); tool != std::string_view::npos) file.remove_prefix(tool + 2); // "/usr/bin/ld: "
        message.file = file;
        message.text = rest;
        return message;
    }
    return {};
}

/// "CMake Error at CMakeLists.txt:4 (find_package):"
std::optional<CompilerMessage> ofCMake(std::string_view line) {
    CompilerMessage message;
    if (take(line, "CMake Error")) message.kind = MessageKind::Error;
    else if (take(line, "CMake Warning")) message.kind = MessageKind::Warning;
    else return {};
    take(line, "(dev)");
    if (take(line, "at")) {
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) return {};
        message.file = line.substr(0, colon);
        line.remove_prefix(colon);
        message.line = takeNumber(line);
        return message; // its text follows
    }
    if (take(line, ":")) message.text = line;
    return message;
}

/// "/usr/bin/ld: wall.cpp:(.text+0x1f): undefined reference to `foo()'", "ld.lld: error: undefined symbol: foo()"
std::optional<CompilerMessage> ofLinker(std::string_view line) {
    for (const std::string_view word : {"undefined reference to ", "undefined symbol: ", "multiple definition of ", "cannot find -l"})
        if (const std::size_t at = line.find(word); at != std::string_view::npos)
            return CompilerMessage{MessageKind::Error, {}, 0, 0, std::string(line.substr(at))};
    return {};
}

/// Adds the messages and the texts that they are about.
class Messages {
public:
    Messages(const std::string& folder, const std::string& project, const std::function<bool(const std::string&)>& isShown)
        : m_folder(folder), m_isShown(isShown), m_sources(std::make_shared<LoadedProject>()) {
        m_sources->projectFolder = project;
    }

    void add(const CompilerMessage& message) {
        if (m_made.found.size() >= kMostMessages) return;
        Diagnostic d{message.kind == MessageKind::Error ? Severity::Error : Severity::Warning, Code::ModuleUnreadable,
                     cleanLine(message.text), {}, {}, {}, {}};
        d.range = placeOf(message);
        if (message.kind == MessageKind::Note) {
            if (!m_made.found.empty() && !m_repeated) m_made.found.back().notes.emplace_back(d.message, d.range);
            return;
        }
        const auto isSame = [&](const Diagnostic& other) {
            return other.severity == d.severity && other.message == d.message && other.range == d.range;
        };
        m_repeated = std::ranges::any_of(m_made.found, isSame); // of a header that several sources include
        if (!m_repeated) m_made.found.push_back(std::move(d));
    }
    BuildMessages take() {
        m_made.sources = m_sources;
        return std::move(m_made);
    }

private:
    SourceRange placeOf(const CompilerMessage& message) {
        if (message.file.empty() || message.line == 0) return {};
        const std::string path = (fs::path(m_folder) / message.file).lexically_normal().string();
        if (!m_isShown(path)) return {};
        const std::optional<FileId> file = idOf(path);
        if (!file) return {};
        const SourceText& text = *m_sources->sources[*file].text;
        if (message.line > text.lineCount()) return {};
        const std::string_view line = text.line(message.line);
        const std::size_t begin = static_cast<std::size_t>(line.data() - text.bytes().data());
        const std::size_t column = std::min<std::size_t>(message.column > 0 ? message.column - 1 : 0, line.size());
        std::size_t end = column;
        while (end < line.size() && isIdent(line[end])) ++end;
        return {*file, {static_cast<std::uint32_t>(begin + column), static_cast<std::uint32_t>(begin + end)}};
    }
    std::optional<FileId> idOf(const std::string& path) {
        const auto known = m_ids.find(path);
        if (known != m_ids.end()) return known->second;
        Result<std::string> bytes = readRegularFile(path, kMaxTextBytes);
        if (!bytes) return m_ids[path] = std::nullopt;
        m_sources->paths.push_back(path);
        return m_ids[path] = m_sources->sources.add(std::make_shared<const SourceText>(path, std::move(bytes).value()));
    }

    std::string m_folder;
    const std::function<bool(const std::string&)>& m_isShown;
    std::shared_ptr<LoadedProject> m_sources;
    std::map<std::string, std::optional<FileId>> m_ids; ///< none: it cannot be read
    BuildMessages m_made;
    bool m_repeated = false;
};

} // namespace

std::optional<CompilerMessage> compilerMessage(std::string_view line) {
    if (auto message = ofCompiler(line)) return message;
    if (auto message = ofCMake(line)) return message;
    return ofLinker(line);
}

BuildMessages readBuildOutput(std::string_view output, const std::string& folder, const std::string& project,
                              const std::function<bool(const std::string& file)>& isShown) {
    Messages messages(folder, project, isShown);
    std::optional<CompilerMessage> open; // of CMake: its text has not come yet
    while (!output.empty()) {
        const std::size_t end = output.find('\n');
        const std::string_view line = output.substr(0, end);
        output.remove_prefix(end == std::string_view::npos ? output.size() : end + 1);
        if (open) {
            if (withoutBlanks(line).empty()) continue;
            open->text = withoutBlanks(line);
            messages.add(*std::exchange(open, std::nullopt));
            continue;
        }
        std::optional<CompilerMessage> message = compilerMessage(line);
        if (!message) continue;
        if (message->text.empty()) open = std::move(message);
        else messages.add(*message);
    }
    return messages.take();
}

} // namespace trundle
