#include "project/loading/import_lines.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "lang/edit_style.h"
#include "project/loading/import_path.h"
#include "project/loading/search.h"

namespace trundle {

namespace {

constexpr std::string_view kImport = "#import", kModule = "#loadModule";

struct Directive {
    bool module = false;
    std::string path;
};

std::string normalised(std::string path) {
    std::replace(path.begin(), path.end(), '\\', '/');
    while (path.starts_with("./")) path.erase(0, 2);
    return path;
}

Result<Directive> read(std::string_view text) {
    Directive d;
    const auto trim = [&] {
        while (!text.empty() && std::string_view(" \t").find(text.front()) != std::string_view::npos) text.remove_prefix(1);
        while (!text.empty() && std::string_view(" \t").find(text.back()) != std::string_view::npos) text.remove_suffix(1);
    };
    trim();
    if (text.starts_with('#')) {
        d.module = text.starts_with(kModule);
        text.remove_prefix(std::min(text.size(), d.module ? kModule.size() : kImport.size()));
        trim();
    }
    if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    d.path = normalised(std::string(text));
    if (d.path.empty() || d.path.find_first_of(std::string("\r\n\"\0", 4)) != std::string::npos)
        return Error{Code::ImportNotFound, "`" + d.path + "` cannot be the path of a file"};
    return d;
}

/// Whether an absolute path ends with a written path, at a folder boundary.
bool isFile(const std::string& absolute, const std::string& written) {
    return absolute == written || (absolute.size() > written.size() && absolute.ends_with(written) &&
                                   absolute[absolute.size() - written.size() - 1] == '/');
}

/// The path as an author would write it: relative for a file that is shipped or in the project.
std::string asWritten(const LoadedProject& loaded, FileId file, const std::string& path) {
    namespace fs = std::filesystem;
    if (!fs::path(path).is_absolute()) return path;
    const fs::path own = fs::path(loaded.paths[file]).parent_path();
    const std::string shown = shownInProject(path, loaded.projectFolder);
    const bool hidden = std::ranges::any_of(std::array{own, fs::path(loaded.projectFolder)}, [&](const fs::path& folder) {
        std::error_code none; // without error; another file is found first under that name
        return fs::exists(folder / shown, none) && canonicalPath((folder / shown).string()) != path;
    });
    if (!hidden) return shown;
    const bool inProject = pathBelow(path, std::array{loaded.projectFolder}).has_value();
    return inProject ? fs::path(path).lexically_relative(own).generic_string() : path;
}

class Lines {
public:
    Lines(const LoadedProject& loaded, FileId file, const ImportItem* without)
        : m_loaded(loaded), m_file(file), m_without(without), m_tree(*loaded.trees[file]), m_lineEnd(editStyle(m_tree).lineEnd) {}

    bool has(const Directive& d) const {
        if (d.module)
            return std::any_of(m_loaded.trees.begin(), m_loaded.trees.end(), [&](const auto& t) { return loads(*t, d.path); });
        if (isFile(m_loaded.paths[m_file], d.path)) return true;
        std::set<FileId> visited{m_file};
        return reaches(m_file, d.path, visited);
    }

    TextEdit add(bool module, const std::string& lines) const {
        const Item* last = nullptr;
        for (const Item& item : m_tree.items())
            if (module ? item.as<ModuleItem>() != nullptr || (item.as<ImportItem>() && !hasModule())
                       : item.as<ImportItem>() != nullptr)
                last = &item;
        std::uint32_t place = last ? behindLine(last->range.end) : beforeFirst(module);
        const auto bytes = m_tree.source().bytes();
        const bool inLine = place > 0 && bytes[place - 1] != '\n' && bytes[place - 1] != '\r' &&
                            !(place == 3 && bytes.starts_with("\xEF\xBB\xBF"));
        return {{m_file, {place, place}}, inLine ? m_lineEnd + lines.substr(0, lines.size() - m_lineEnd.size()) : lines};
    }
    const std::string& lineEnd() const { return m_lineEnd; }

private:
    bool hasModule() const {
        return std::any_of(m_tree.items().begin(), m_tree.items().end(),
                           [](const Item& i) { return i.as<ModuleItem>() != nullptr; });
    }
    static bool loads(const Tree& tree, const std::string& path) {
        return std::any_of(tree.items().begin(), tree.items().end(), [&](const Item& item) {
            const auto* module = item.as<ModuleItem>();
            return module && normalised(module->path) == path;
        });
    }
    bool reaches(FileId from, const std::string& path, std::set<FileId>& visited) const {
        const TextSet& texts = m_loaded.outline->texts();
        for (const Item& item : m_loaded.trees[from]->items()) {
            const auto* import = item.as<ImportItem>();
            if (!import || import == m_without) continue;
            if (normalised(import->path) == path) return true;
            const auto target = texts.imports.find(import);
            if (target == texts.imports.end() || !visited.insert(target->second).second) continue;
            if (isFile(m_loaded.paths[target->second], path) || reaches(target->second, path, visited)) return true;
        }
        return false;
    }

    /// The offset after the end of the line that contains an offset; line ends inside comments do not count.
    std::uint32_t behindLine(std::uint32_t from) const {
        for (const Token& token : m_tree.tokens())
            if (token.kind == TokenKind::LineEnd && token.range.begin >= from) return token.range.end;
        return static_cast<std::uint32_t>(m_tree.source().bytes().size());
    }
    /// The start of the line of the first item (for an import, of the first module).
    std::uint32_t beforeFirst(bool module) const {
        const Item* first = m_tree.items().empty() ? nullptr : &m_tree.items().front();
        for (const Item& item : m_tree.items())
            if (!module && item.as<ModuleItem>()) {
                first = &item;
                break;
            }
        if (!first) return static_cast<std::uint32_t>(m_tree.source().bytes().size());
        std::uint32_t place = m_tree.source().bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0;
        for (const Token& token : m_tree.tokens())
            if (token.kind == TokenKind::LineEnd && token.range.end <= first->range.begin) place = token.range.end;
        return place;
    }

    const LoadedProject& m_loaded;
    FileId m_file;
    const ImportItem* m_without;
    const Tree& m_tree;
    std::string m_lineEnd;
};

} // namespace

Result<std::vector<TextEdit>> editsForImports(const LoadedProject& loaded, FileId file,
                                              const std::vector<std::string>& directives, const ImportItem* without) {
    const Lines lines(loaded, file, without);
    std::string texts[2];
    std::set<std::pair<bool, std::string>> done;
    for (const std::string& text : directives) {
        const Result<Directive> d = read(text);
        if (!d.ok()) return d.error();
        const auto& [module, path] = d.value();
        if (lines.has(d.value()) || !done.emplace(module, path).second) continue;
        const std::string words = module ? path : asWritten(loaded, file, path);
        const bool quoted = words.find("//") != std::string::npos || words.find("/*") != std::string::npos;
        texts[module] += std::string(module ? kModule : kImport) + " " + (quoted ? "\"" + words + "\"" : words) + lines.lineEnd();
    }
    std::vector<TextEdit> edits;
    for (const bool module : {false, true})
        if (!texts[module].empty()) edits.push_back(lines.add(module, texts[module]));
    return edits;
}

} // namespace trundle
