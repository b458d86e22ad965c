#include "project/loader.h"

#include <filesystem>

#include "schema/value_words.h"

namespace trundle {

namespace fs = std::filesystem;

Status Loader::open(const std::string& path) {
    Result<std::string> bytes = readFile(path, kMaxTextBytes);
    if (!bytes.ok()) return bytes.error();
    std::error_code ec;
    const fs::path real = fs::canonical(path, ec);
    m_byPath.emplace(ec ? path : real.string(), FileId{0});
    const FileId file = add(path, std::move(bytes).value(), (ec ? fs::path(path) : real).parent_path().string(), {});
    m_open.push_back(file);
    visit(m_texts.trees[file]->items(), file, 0);
    m_open.pop_back();
    m_texts.firstSet = static_cast<FileId>(m_texts.trees.size());
    return {};
}

FileId Loader::add(std::string shown, std::string bytes, const std::string& folder, SourceRange importedFrom) {
    m_bytes += bytes.size();
    auto text = std::make_shared<const SourceText>(std::move(shown), std::move(bytes));
    const FileId file = m_sources.add(text, importedFrom);
    m_texts.trees.push_back(parse(std::move(text), file));
    m_folders.push_back(folder);
    m_diagnostics.append(m_texts.trees.back()->diagnostics());
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
    if (item.path.empty()) return; // said by the parser
    const SourceRange range{file, item.pathRange};
    Result<std::string> found = m_search.find(item.path, m_folders[file]);
    if (!found.ok()) {
        Diagnostic& d = m_diagnostics.error(found.error().code, range, found.error().message);
        if (found.error().code == Code::ImportNotFound) suggestWords(d, m_search.nearest(item.path, m_folders[file]), range);
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
        m_diagnostics.error(Code::ImportDepth, range, "imports are nested more than " + std::to_string(kMaxImportDepth) + " deep");
        return;
    }
    if (m_texts.trees.size() >= kMaxFiles) {
        if (!m_tooMany) m_diagnostics.error(Code::TooManyFiles, range, "an experiment may hold " + std::to_string(kMaxFiles) + " files, this is one more");
        m_tooMany = true;
        return;
    }
    Result<std::string> bytes = readFile(path, kMaxTextBytes - m_bytes);
    if (!bytes.ok()) {
        m_diagnostics.error(bytes.error().code, range, shownPath(path) + bytes.error().message.substr(path.size()));
        return;
    }
    const FileId target = add(shownPath(path), std::move(bytes).value(), fs::path(path).parent_path().string(), range);
    m_byPath.emplace(path, target);
    m_texts.imports.emplace(&item, target);
    m_open.push_back(target);
    const std::shared_ptr<const Tree> tree = m_texts.trees[target];
    visit(tree->items(), target, depth + 1);
    m_open.pop_back();
}

void Loader::cycle(FileId target, SourceRange range) {
    std::string chain;
    bool inside = false;
    for (const FileId file : m_open) {
        inside = inside || file == target;
        if (inside) chain += m_texts.trees[file]->source().path() + " > ";
    }
    m_diagnostics.error(Code::ImportCycle, range, "files import each other in a circle: " + chain + m_texts.trees[target]->source().path());
}

void Loader::addSets(const std::vector<std::string>& sets) {
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const FileId file = add("--set#" + std::to_string(i + 1), sets[i], m_folders[0], {});
        const Tree& tree = *m_texts.trees[file];
        const AssignmentItem* item = tree.items().size() == 1 ? tree.items()[0].as<AssignmentItem>() : nullptr;
        const bool broken = std::any_of(tree.diagnostics().begin(), tree.diagnostics().end(), [](const Diagnostic& d) { return d.severity == Severity::Error; });
        if (!item && !broken) {
            const auto end = static_cast<std::uint32_t>(sets[i].size());
            m_diagnostics.error(Code::UnexpectedText, {file, {0, end}}, "--set takes PATH=VALUE, as in robot0.leftMotor.Resistance=3");
        }
        m_texts.sets.push_back({file, item});
    }
}

} // namespace trundle
