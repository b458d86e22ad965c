// needs        the project as loaded now, and the path that its opened file is to have
// assumptions  a text refers to other texts by imports only; an import looks first in the folder of the file it stands in
// method       the project is loaded from the new path, in memory, and both are walked together: an import that leads elsewhere than
//              before, or to a file that must move, gets that file a place beside the importing one; until nothing is left to move
// data         moves: old path -> new path; a file that stays has none

#include "editor/document/save_plan.h"

#include <filesystem>
#include <set>

#include "lang/tree_edit.h"
#include "project/search.h"

namespace trundle {

namespace fs = std::filesystem;

namespace {

const TextSet& textsOf(const Loaded& loaded) { return loaded.outline->texts(); }

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

/// Whether a path stays below the folder it starts from.
bool staysBelow(const std::string& written) {
    const fs::path path = fs::path(written).lexically_normal();
    return path.is_relative() && !path.empty() && *path.begin() != "..";
}

class SaveAs {
public:
    SaveAs(Parts& parts, const Loaded& loaded, OpenOptions options, const std::set<std::string>& mustMove)
        : m_parts(parts), m_loaded(loaded), m_options(std::move(options)), m_mustMove(mustMove) {
        m_options.previous = nullptr;
    }

    Result<SavePlan> plan(const std::string& target) {
        if (Status moved = move(0, target); !moved) return moved.error();
        for (std::size_t round = 0; round <= 2 * m_loaded.paths.size(); ++round) {
            OpenOptions options = m_options;
            for (const auto& [path, text] : m_plan.texts) options.texts.insert_or_assign(path, text);
            const Result<std::shared_ptr<const Loaded>> there = m_parts.open(target, options);
            if (!there) return there.error();
            m_seen.clear();
            const Result<bool> changed = compare(0, *there.value(), 0);
            if (!changed) return changed.error();
            if (!changed.value()) return std::move(m_plan);
        }
        return Error{Code::ImportNotFound, "what it imports cannot be found from there"};
    }

private:
    /// True where something had to be moved, so that all must be looked at again.
    Result<bool> compare(FileId before, const Loaded& there, FileId after) {
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
                if (Status done = bring(before, i, old->second); !done) return done.error();
                return true;
            }
            const Result<bool> below = compare(old->second, there, now->second);
            if (!below || below.value()) return below;
        }
        return false;
    }

    /// Makes import number `i` of a file lead to `imported`, by a copy beside the file or other words in it.
    Status bring(FileId importing, std::size_t i, FileId imported) {
        const std::string& from = m_loaded.paths[importing];
        const auto place = m_plan.moves.find(from);
        // A file that stays where it is cannot be made to find a copy: it moves first.
        if (place == m_plan.moves.end()) return moveBeside(importing);
        const std::string folder = fs::path(place->second).parent_path().string();
        const std::string& written = importsOf(*m_loaded.trees[importing])[i]->path;
        const std::string& file = m_loaded.paths[imported];
        const auto moved = m_plan.moves.find(file);
        if (moved == m_plan.moves.end() && staysBelow(written)) return move(imported, canonicalPath(folder + "/" + written));
        if (moved == m_plan.moves.end()) {
            if (Status done = moveBeside(imported); !done) return done;
        }
        const std::string path = fs::path(m_plan.moves.at(file)).lexically_relative(folder).string();
        return rewrite(importing, i, path);
    }

    Status moveBeside(FileId file) {
        const fs::path folder = fs::path(m_plan.moves.at(m_loaded.paths[0])).parent_path();
        return move(file, (folder / fs::path(m_loaded.paths[file]).filename()).string());
    }

    Status move(FileId file, const std::string& to) {
        const std::string_view bytes = m_loaded.trees[file]->source().bytes();
        std::error_code none;
        const bool taken = m_plan.texts.contains(to) || (file != 0 && fs::exists(to, none));
        if (taken) {
            const Result<std::string> there = readFile(to, kMostBytes);
            if (m_plan.texts.contains(to) || !there || there.value() != bytes)
                return Error{Code::FileUnwritable, "it needs " + m_loaded.trees[file]->source().path() + " beside it, and " + to +
                                                       " is another file; choose another folder"};
        }
        m_plan.moves.insert_or_assign(m_loaded.paths[file], to);
        m_plan.texts.insert_or_assign(to, std::make_shared<const std::string>(bytes));
        return {};
    }

    Status rewrite(FileId file, std::size_t i, const std::string& path) {
        m_rewritten[file][i] = path;
        std::vector<TextEdit> edits;
        const auto imports = importsOf(*m_loaded.trees[file]);
        for (const auto& [number, words] : m_rewritten[file])
            edits.push_back({{file, imports[number]->pathRange}, "\"" + words + "\""});
        Result<std::string> bytes = applyEdits(m_loaded.trees[file]->source().bytes(), edits);
        if (!bytes) return bytes.error();
        const std::string& place = m_plan.moves.at(m_loaded.paths[file]);
        m_plan.texts.insert_or_assign(place, std::make_shared<const std::string>(std::move(bytes).value()));
        return {};
    }

    static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

    Parts& m_parts;
    const Loaded& m_loaded;
    OpenOptions m_options;
    const std::set<std::string>& m_mustMove;
    SavePlan m_plan;
    std::set<FileId> m_seen;
    std::map<FileId, std::map<std::size_t, std::string>> m_rewritten;
};

} // namespace

Result<SavePlan> planSaveAs(Parts& parts, const Loaded& loaded, OpenOptions options, const std::string& target,
                            const std::set<std::string>& mustMove) {
    return SaveAs(parts, loaded, std::move(options), mustMove).plan(target);
}

} // namespace trundle
