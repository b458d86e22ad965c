// needs        the loaded project, and the new path of its opened file
// assumptions  a text refers to other texts only by imports; a path in a text is resolved first in the folder of that text
// method       the project is loaded from the new path, in memory, and both versions are compared: if an import resolves to
//              another file than before, or to a file that must move, that file gets a path next to the importing one;
//              repeated until no file has to move. Then the same for meshes, images and modules: each is copied, or its
//              path in the text is changed
// data         moves: old path -> new path, without the files that stay; m_edits: changed paths, in the current texts

#include "project/saving/save_plan.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "base/platform/read_file.h"
#include "lang/tree_edit.h"
#include "project/loading/search.h"
#include "project/saving/named_files.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

const TextSet& textsOf(const LoadedProject& loaded) { return loaded.outline->texts(); }

void importsIn(const std::vector<Item>& items, std::vector<const ImportItem*>& found) {
    for (const Item& item : items) {
        if (const auto* block = item.as<BlockItem>()) importsIn(block->items, found);
        else if (const auto* import = item.as<ImportItem>()) found.push_back(import);
    }
}

std::vector<const ImportItem*> importsOf(const Tree& tree) {
    std::vector<const ImportItem*> found;
    importsIn(tree.items(), found);
    return found;
}

std::string quoted(const std::string& words) { return '"' + words + '"'; }

/// Whether a relative path stays below its start folder.
bool staysBelow(const std::string& written) {
    const fs::path path = fs::path(written).lexically_normal();
    return path.is_relative() && !path.empty() && *path.begin() != "..";
}

bool sameBytes(const std::string& a, const std::string& b) {
    const Result<FileStamp> first = regularFileStamp(a), second = regularFileStamp(b);
    if (!first || !second || first.value().size != second.value().size) return false;
    std::ifstream one(a, std::ios::binary), other(b, std::ios::binary);
    return std::equal(std::istreambuf_iterator<char>(one), {}, std::istreambuf_iterator<char>(other), {});
}

class SaveAs {
public:
    SaveAs(const SavePlanSources& sources, const LoadedProject& loaded, const std::set<std::string>& mustMove,
           ModuleCopies modules)
        : m_sources(sources), m_loaded(loaded), m_mustMove(mustMove), m_modules(modules) {}

    Result<SavePlan> plan(const std::string& target) {
        m_plan.target = target;
        if (Status moved = move(0, target); !moved) return moved.error();
        const std::vector<NamedFileUse> named = namedFiles(m_loaded, m_sources.modules);
        for (std::size_t round = 0; round <= 2 * m_loaded.paths.size() + named.size(); ++round) {
            const Result<std::shared_ptr<const LoadedProject>> there = m_sources.load(target, m_plan.texts);
            if (!there) return there.error();
            m_seen.clear();
            const Result<bool> changed = compare(0, *there.value(), 0);
            if (!changed) return changed.error();
            if (changed.value()) continue;
            const Result<bool> carried = carry(named, *there.value());
            if (!carried) return carried.error();
            if (!carried.value()) return std::move(m_plan);
        }
        return Error{Code::ImportNotFound, "its imports cannot be found from there"};
    }

private:
    /// Compares the imports of a file before and after. True if something had to move, so that the comparison must be
    /// repeated.
    Result<bool> compare(FileId before, const LoadedProject& there, FileId after) {
        if (!m_seen.insert(before).second) return false;
        const auto olds = importsOf(*m_loaded.trees[before]), news = importsOf(*there.trees[after]);
        for (std::size_t i = 0; i < olds.size() && i < news.size(); ++i) {
            const auto old = textsOf(m_loaded).imports.find(olds[i]);
            if (old == textsOf(m_loaded).imports.end()) continue; // was not found before either
            const auto now = textsOf(there).imports.find(news[i]);
            const std::string& file = m_loaded.paths[old->second];
            const auto moved = m_plan.moves.find(file);
            const std::string& wanted = moved == m_plan.moves.end() ? file : moved->second;
            const bool found = now != textsOf(there).imports.end() && there.paths[now->second] == wanted;
            if (!found || (moved == m_plan.moves.end() && m_mustMove.contains(file))) {
                if (Status done = bring(before, i, old->second, there.projectFolder); !done) return done.error();
                return true;
            }
            const Result<bool> below = compare(old->second, there, now->second);
            if (!below || below.value()) return below;
        }
        return false;
    }

    /// Makes import number `i` of a file resolve to `imported`, by a copy next to the file or by another path in the import. `project`:
    /// folder of the project at the new path; what is in it too is not copied.
    Status bring(FileId importing, std::size_t i, FileId imported, const std::string& project) {
        const std::string& from = m_loaded.paths[importing];
        const auto place = m_plan.moves.find(from);
        // A file that stays in place cannot be made to find a copy: it moves first.
        if (place == m_plan.moves.end()) return moveBeside(importing);
        const std::string folder = fs::path(place->second).parent_path().string();
        const std::string& written = importsOf(*m_loaded.trees[importing])[i]->path;
        const std::string& file = m_loaded.paths[imported];
        const auto moved = m_plan.moves.find(file);
        const bool isReachable =
            project == m_loaded.projectFolder && staysBelow(fs::path(file).lexically_relative(project).string());
        if (moved == m_plan.moves.end() && isReachable && !m_mustMove.contains(file))
            return rewrite(importing, {importsOf(*m_loaded.trees[importing])[i]->pathRange},
                           fs::path(file).lexically_relative(folder).generic_string());
        if (moved == m_plan.moves.end() && staysBelow(written)) return move(imported, canonicalPath(folder + "/" + written));
        if (moved == m_plan.moves.end()) {
            if (Status done = moveBeside(imported); !done) return done;
        }
        const std::string path = fs::path(m_plan.moves.at(file)).lexically_relative(folder).string();
        return rewrite(importing, {importsOf(*m_loaded.trees[importing])[i]->pathRange}, path);
    }

    /// Copies files that the texts refer to and that would not be found any more. True if texts have moved or changed.
    Result<bool> carry(const std::vector<NamedFileUse>& named, const LoadedProject& there) {
        for (const NamedFileUse& file : named) {
            if (isFoundFrom(there, file)) continue;
            const auto place = m_plan.moves.find(m_loaded.paths[file.text]);
            const Status done = place == m_plan.moves.end()
                                    ? moveBeside(file.text)
                                    : bring(file, fs::path(place->second).parent_path(), there.projectFolder);
            if (!done) return done.error();
            if (place == m_plan.moves.end()) return true;
        }
        return false;
    }

    [[nodiscard]] bool isFoundFrom(const LoadedProject& there, const NamedFileUse& file) const {
        if (m_brought.contains({file.text, file.written})) return true;
        const std::string& before = m_loaded.paths[file.text];
        const auto place = m_plan.moves.find(before);
        const std::string& now = place == m_plan.moves.end() ? before : place->second;
        if (file.module) return libraryOf(file.written, fs::path(now).parent_path().string(), m_sources.modules) == file.path;
        const auto text = std::ranges::find(there.paths, now);
        const auto found = there.named.find({static_cast<FileId>(text - there.paths.begin()), file.written});
        return found != there.named.end() && found->second.path == file.path;
    }

    /// `folder`: new folder of the text that refers to the file.
    Status bring(const NamedFileUse& file, const fs::path& folder, const std::string& project) {
        m_brought.insert({file.text, file.written});
        const fs::path from = file.path;
        // Texts name a module without the platform's prefix and suffix.
        const fs::path shown = file.module ? fs::path(file.written).filename() : from.filename();
        if (file.module && m_modules == ModuleCopies::Name) {
            m_plan.companions.modules.push_back(file.path);
            return rewrite(file, (from.parent_path() / shown).string());
        }
        if (!file.module && staysBelow(from.lexically_relative(project).string()))
            return rewrite(file, from.lexically_relative(folder).string());
        const bool stays = staysBelow(file.written);
        const fs::path place = stays ? folder / fs::path(file.written).parent_path() : folder;
        (file.module ? m_plan.companions.modules : m_plan.companions.files).push_back(file.path);
        if (Status done = copy(from, place / from.filename()); !done) return done;
        for (const std::string& part : neededBy(file))
            if (Status done = copy(from.parent_path() / part, place / part); !done) return done;
        return stays ? Status() : rewrite(file, shown.string());
    }

    Status copy(const fs::path& from, const fs::path& to) {
        const std::string target = to.lexically_normal().string();
        std::error_code none;
        const auto [known, isNew] = m_copies.emplace(target, from.string());
        const bool there = fs::exists(target, none), same = there && sameBytes(from.string(), target);
        if (m_plan.texts.contains(target) || (!isNew && known->second != from.string()) || (there && !same))
            return Error{Code::FileUnwritable,
                         "it needs " + from.string() + " beside it, and " + target + " is another file; choose another folder"};
        if (!there) m_plan.copies.emplace(target, from.string());
        return {};
    }

    Status rewrite(const NamedFileUse& file, const std::string& words) {
        if (m_fileWords.empty()) m_fileWords = fileWordsIn(m_loaded);
        return rewrite(file.text, file.module ? std::vector{file.range} : m_fileWords[{file.text, file.written}], words);
    }

    Status moveBeside(FileId file) {
        const std::string& path = m_loaded.paths[file];
        const bool inPlace = m_plan.moves.at(m_loaded.paths[0]) == m_loaded.paths[0];
        if (inPlace && !m_mustMove.contains(path) &&
            staysBelow(fs::path(path).lexically_relative(m_loaded.projectFolder).string()))
            return move(file, path); // rewritten at its path
        const fs::path folder = fs::path(m_plan.moves.at(m_loaded.paths[0])).parent_path();
        return move(file, (folder / fs::path(m_loaded.paths[file]).filename()).string());
    }

    Status move(FileId file, const std::string& to) {
        const std::string_view bytes = m_loaded.trees[file]->source().bytes();
        std::error_code none;
        const bool own = to == m_loaded.paths[file];
        const bool taken = m_plan.texts.contains(to) || (file != 0 && !own && fs::exists(to, none));
        if (taken) {
            const Result<std::string> there = readFile(to, kMaxBytes);
            if (m_plan.texts.contains(to) || !there || there.value() != bytes)
                return Error{Code::FileUnwritable, "it needs " + m_loaded.trees[file]->source().path() + " beside it, and " + to +
                                                       " is another file; choose another folder"};
        }
        m_plan.moves.insert_or_assign(m_loaded.paths[file], to);
        m_plan.texts.insert_or_assign(to, std::make_shared<const std::string>(bytes));
        return {};
    }

    Status rewrite(FileId file, const std::vector<TextRange>& places, const std::string& words) {
        for (const TextRange& place : places) m_edits[file].insert_or_assign(place.begin, TextEdit{{file, place}, quoted(words)});
        std::vector<TextEdit> edits;
        for (const auto& [at, edit] : m_edits[file]) edits.push_back(edit);
        Result<std::string> bytes = applyEdits(m_loaded.trees[file]->source().bytes(), edits);
        if (!bytes) return bytes.error();
        const std::string& place = m_plan.moves.at(m_loaded.paths[file]);
        m_plan.texts.insert_or_assign(place, std::make_shared<const std::string>(std::move(bytes).value()));
        return {};
    }

    static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

    const SavePlanSources& m_sources;
    const LoadedProject& m_loaded;
    const std::set<std::string>& m_mustMove;
    const ModuleCopies m_modules;
    SavePlan m_plan;
    std::set<FileId> m_seen;
    std::set<std::pair<FileId, std::string>> m_brought;
    std::map<std::string, std::string> m_copies; // including files that already exist there
    FileWords m_fileWords;                       // of the current texts, once they are needed
    std::map<FileId, std::map<std::uint32_t, TextEdit>> m_edits;
};

} // namespace

Result<SavePlan> planSaveAs(const SavePlanSources& sources, const LoadedProject& loaded, const std::string& target,
                            const std::set<std::string>& mustMove, ModuleCopies modules) {
    return SaveAs(sources, loaded, mustMove, modules).plan(target);
}

} // namespace trundle
