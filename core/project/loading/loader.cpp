#include "project/loading/loader.h"

#include <algorithm>
#include <filesystem>

#include "schema/value_words.h"

namespace trundle {

namespace fs = std::filesystem;

Status Loader::open(const std::string& path) {
    const std::string absolute = canonicalPath(path);
    Result<Bytes> bytes = read(path, absolute, path, kMaxTextBytes);
    if (!bytes.ok()) return bytes.error();
    m_byPath.emplace(absolute, FileId{0});
    const std::string shown = m_options.shownFrom.empty() ? path : shownPath(absolute, m_options.shownFrom);
    const FileId file = add(shown, absolute, std::move(bytes).value(), fs::path(absolute).parent_path().string(), {});
    m_open.push_back(file);
    visit(m_texts.trees[file]->items(), file, 0);
    m_open.pop_back();
    m_texts.firstSet = static_cast<FileId>(m_texts.trees.size());
    return {};
}

Result<Loader::Bytes> Loader::read(const std::string& path, const std::string& absolute, const std::string& shown,
                                   std::size_t most) const {
    if (m_options.texts) {
        if (const auto held = m_options.texts->find(absolute); held != m_options.texts->end()) {
            if (held->second->size() > most)
                return Error{Code::TooLarge, shown + " is too large: an experiment may hold 64 MiB of text"};
            return Bytes{{}, held->second};
        }
    }
    Result<std::string> bytes = readFile(path, most, shown);
    if (!bytes.ok()) return bytes.error();
    return Bytes{std::move(bytes).value(), nullptr};
}

std::shared_ptr<const Tree> Loader::sameAsBefore(FileId file, const std::string& shown, const std::string& absolute,
                                                 std::string_view bytes) const {
    const LoadedProject* before = m_options.previous;
    if (!before || absolute.empty() || file >= before->paths.size() || before->paths[file] != absolute) return nullptr;
    const std::shared_ptr<const Tree>& tree = before->trees[file];
    if (!tree) return nullptr;
    const bool same = tree->source().path() == shown && tree->source().bytes() == bytes;
    return same && tree->extent() != Tree::Extent::Limited ? tree : nullptr;
}

FileId Loader::add(std::string shown, std::string absolute, Bytes bytes, const std::string& folder, SourceRange importedFrom) {
    m_bytes += bytes.view().size();
    const auto file = static_cast<FileId>(m_sources.size());
    std::shared_ptr<const Tree> tree = sameAsBefore(file, shown, absolute, bytes.view());
    if (!tree) {
        const std::size_t left = m_options.mostTokens - std::min(m_tokens, m_options.mostTokens);
        tree = parse(std::make_shared<const SourceText>(std::move(shown), bytes.take()), file, left);
        ++m_parses;
    }
    m_tokens += tree->tokens().size();
    if (tree->extent() == Tree::Extent::Limited && m_limited == kNoFile) m_limited = file;
    m_sources.add(tree->sharedSource(), importedFrom);
    m_texts.trees.push_back(tree);
    m_folders.push_back(folder);
    m_paths.push_back(std::move(absolute));
    m_diagnostics.append(tree->diagnostics());
    return file;
}

void Loader::visit(const std::vector<Item>& items, FileId file, int depth) {
    for (const Item& item : items) {
        if (const auto* block = item.as<BlockItem>()) visit(block->items, file, depth);
        else if (const auto* found = item.as<ImportItem>()) import(*found, file, depth);
        else if (const auto* module = item.as<ModuleItem>()) {
            if (!module->path.empty()) m_modules.push_back({module->path, m_folders[file], {file, module->pathRange}});
        }
    }
}

void Loader::import(const ImportItem& item, FileId file, int depth) {
    if (item.path.empty()) return; // reported by the parser
    const SourceRange range{file, item.pathRange};
    if (m_notFound > kMaxNotFound) return; // searching for each of them would take minutes
    Result<std::string> found = m_search.find(item.path, m_folders[file]);
    if (!found.ok()) {
        m_texts.openImports = true;
        Diagnostic& d = m_diagnostics.error(found.error().code, range, found.error().message);
        if (++m_notFound > kMaxNotFound) d.message = "too many imports are not found; those from here on are not looked for";
        else if (found.error().code == Code::ImportNotFound) suggestWords(d, importsLike(item.path, file), range);
        return;
    }
    const std::string& path = found.value();
    if (const auto known = m_byPath.find(path); known != m_byPath.end()) {
        for (const FileId open : m_open) {
            if (open == known->second) return cycle(open, range);
        }
        m_texts.imports.emplace(&item, known->second);
        return;
    }
    if (depth + 1 > kMaxImportDepth) {
        m_diagnostics.error(Code::ImportDepth, range,
                            "imports are nested more than " + std::to_string(kMaxImportDepth) + " deep");
        return;
    }
    if (m_texts.trees.size() >= kMaxFiles) {
        if (!m_tooMany)
            m_diagnostics.error(Code::TooManyFiles, range,
                                "an experiment may hold " + std::to_string(kMaxFiles) + " files, this is one more");
        m_tooMany = true;
        return;
    }
    const std::string shown = shownPath(path, m_options.shownFrom);
    Result<Bytes> bytes = read(path, path, shown, kMaxTextBytes - m_bytes);
    if (!bytes.ok()) {
        m_diagnostics.error(bytes.error().code, range, bytes.error().message);
        return;
    }
    const FileId target = add(shown, path, std::move(bytes).value(), fs::path(path).parent_path().string(), range);
    m_byPath.emplace(path, target);
    m_texts.imports.emplace(&item, target);
    m_open.push_back(target);
    const std::shared_ptr<const Tree> tree = m_texts.trees[target];
    visit(tree->items(), target, depth + 1);
    m_open.pop_back();
}

/// Without those that import this one, or are it.
std::vector<std::string> Loader::importsLike(const std::string& written, FileId file) const {
    std::vector<std::string> near = m_search.nearest(written, m_folders[file], "sim");
    std::erase_if(near, [&](const std::string& name) {
        const Result<std::string> found = m_search.find(name, m_folders[file]);
        return found && std::ranges::any_of(m_open, [&](FileId open) { return m_paths[open] == found.value(); });
    });
    return near;
}

void Loader::cycle(FileId target, SourceRange range) {
    std::string chain;
    bool inside = false;
    for (const FileId file : m_open) {
        inside = inside || file == target;
        if (inside) chain += m_texts.trees[file]->source().path() + " > ";
    }
    m_diagnostics.error(Code::ImportCycle, range,
                        "files import each other in a circle: " + chain + m_texts.trees[target]->source().path());
}

void Loader::addSets(const std::vector<std::string>& sets) {
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const FileId file = add("--set#" + std::to_string(i + 1), {}, {sets[i], nullptr}, m_folders[0], {});
        m_texts.sets.push_back({file, assignmentOf(*m_texts.trees[file], m_diagnostics)});
    }
}

const AssignmentItem* assignmentOf(const Tree& tree, Diagnostics& diagnostics) {
    const AssignmentItem* item = tree.items().size() == 1 ? tree.items()[0].as<AssignmentItem>() : nullptr;
    const bool broken = std::any_of(tree.diagnostics().begin(), tree.diagnostics().end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::Error; });
    if (!item && !broken)
        diagnostics.error(Code::UnexpectedText, {tree.file(), {0, static_cast<std::uint32_t>(tree.source().bytes().size())}},
                          "--set takes PATH=VALUE, as in robot0.leftMotor.Resistance=3");
    return broken ? nullptr : item;
}

} // namespace trundle
