// Needs: blocks and their target position. Gives: their text there, with references and poses updated.

#include "lang/characters.h"
#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "model/dotted_path.h"
#include "project/edits/edit_builder.h"
#include "project/edits/moved_block.h"
#include "project/edits/plan_targets.h"
#include "project/loading/import_lines.h"
#include "project/objects/name_scope.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

/// A block to be moved.
struct MovedItem {
    const Chosen* chosen = nullptr;
    const Part* part = nullptr;
    const Part* from = nullptr; ///< nullptr: the top level
    const Part* to = nullptr;
    std::string path; ///< path of the new parent
    std::string name;
    FileId file = 0;             ///< the target file
    const Part* next = nullptr;  ///< inserted before this block
    const Part* after = nullptr; ///< or after this one; at the end if both are null
    [[nodiscard]] bool goes() const { return after != part; }
};

/// Whether two blocks belong to the same group in the Scene tree.
bool hasSameType(const Part& a, const Part& b) {
    return a.kind && b.kind && (a.kind == b.kind || (isPlaced(a) && isPlaced(b)) || (a.kind->role == b.kind->role));
}

const Part* holderOf(const ObjectLocation& place) { return place.above.empty() ? nullptr : place.above.back(); }

/// The outermost block, a config or instance, around a block.
const Part* topOf(const Part* holder, const ObjectLocation& place) { return place.above.empty() ? holder : place.above.front(); }

ObjectLocation outer(ObjectLocation place) {
    place.part = holderOf(place);
    if (!place.above.empty()) place.above.pop_back();
    place.within = withoutLastWord(place.within);
    return place;
}

class Move {
public:
    Move(const LoadedProject& loaded, const std::vector<Chosen>& all, FileId file)
        : m_loaded(loaded), m_texts(loaded.outline->texts()), m_references(referencesIn(loaded)), m_ranges(rangesOf(all)),
          m_sheet(loaded), m_file(file) {
        for (const Chosen& c : all) m_moved.push_back({&c, c.place.part, holderOf(c.place), nullptr, {}, c.place.part->name});
    }

    Result<EditPlan> run(const std::string& parent, const std::string& before) {
        const std::optional<ObjectLocation> into = placeOf(m_loaded, parent);
        if (!into) return Error{Code::NoSuchPath, "there is no " + parent};
        m_into = *into;
        for (MovedItem& m : m_moved)
            if (Status status = settle(m, parent); !status.ok()) return status.error();
        if (!before.empty())
            if (Status status = findBefore(before); !status.ok()) return status.error();
        for (MovedItem& m : m_moved) choosePosition(m);
        if (nothingChanges()) {
            EditPlan same;
            for (const MovedItem& m : m_moved) same.selects.push_back(m.chosen->path);
            return same;
        }
        std::vector<std::string> selects;
        for (MovedItem& m : m_moved) {
            if (m.from != m.to)
                if (Status status = changePlace(m); !status.ok()) return status.error();
        }
        for (const MovedItem& m : m_moved) {
            if (Status status = put(m); !status.ok()) return status.error();
            const bool kindFirst = !m.to && m_loaded.outline->spaceOf(*m.part->kind) != &m_loaded.outline->world;
            selects.push_back((m.to ? m.path + "." : kindFirst ? m.part->kind->name + "." : "") + m.name);
        }
        if (Status status = import(); !status.ok()) return status.error();
        return m_sheet.plan(std::move(selects));
    }

private:
    Status settle(MovedItem& m, const std::string& parent) {
        const Part& part = *m.part;
        if (!part.kind) return Error{Code::UnknownKind, part.title() + " is of a kind that is not loaded"};
        const bool isInstance = m_into.part && m_into.part == m_into.instance && !m_into.part->isPartUse();
        const Part* config = isInstance ? configOf(m_loaded, *m_into.part) : nullptr;
        m.path = parent;
        if (isAllowedIn(*part.kind, m_into.part)) m.to = m_into.part;
        else if (config && isAllowedIn(*part.kind, config)) m.to = config;
        else
            return Error{Code::WrongPlace, allowedPlaces(*part.kind) + ", not " +
                                               (m_into.part ? "in " + m_into.part->title() : "at the top level")};
        if (m.to && isWithin(m.to->range, part.range))
            return Error{Code::WrongPlace, part.title() + " cannot be moved into itself"};
        if (m_loaded.outline->texts().commandLine(part.file)) return Error{Code::EditRefused, "a --set text cannot be changed"};
        std::size_t places = 0;
        const auto count = [&](const auto& self, const std::vector<Part>& parts) -> void {
            for (const Part& p : parts) {
                places += p.block == part.block;
                self(self, p.parts);
            }
        };
        for (const auto& top : m_loaded.outline->parts) count(count, top->parts);
        if (places > 1) return Error{Code::WrongPlace, part.title() + " is in a file that several blocks import"};
        if (m.from == m.to) return {};
        const auto isInPart = [](const ObjectLocation& place) { return std::ranges::any_of(place.above, &Part::isPartUse); };
        if (isInPart(m.chosen->place) || isInPart(m_into))
            return Error{Code::WrongPlace, "what is in a Part is moved in its PartConfig"};
        const auto isConfig = [](const Part* p) { return p->is(Role::Config); };
        const auto around = std::ranges::find_if(m_into.above, isConfig);
        const bool isInBody = std::ranges::any_of(m_into.above, [](const Part* p) { return p->is(Role::Body); });
        HeldBlocks held;
        held.add(part);
        if (m.to && (isInBody || m.to->is(Role::Body)) && !held.fitInBody(*part.kind))
            return Error{Code::WrongPlace, part.title() + " cannot be in a Body, which holds geoms and Repeats of geoms only"};
        const Part* holder = m.to && m.to->isRepeat() && !isInBody && around != m_into.above.end() ? *around : m.to;
        if (holder && holder->is(Role::Config)) {
            if (Status fits = held.fitsIn(m_loaded, *holder, part.title()); !fits.ok()) return fits;
        }
        const NameSpace* space = m.to ? nullptr : m_loaded.outline->spaceOf(*part.kind);
        m.name = m_names.try_emplace({m.to, space}, m_loaded, m.to, part.kind).first->second.take(part.name);
        return {};
    }

    bool isMoved(const BlockItem* block) const {
        return std::any_of(m_moved.begin(), m_moved.end(), [&](const MovedItem& m) { return m.part->block == block; });
    }

    std::vector<const Part*> siblings() const {
        std::vector<const Part*> all;
        const Part* to = m_moved.front().to;
        if (to)
            for (const Part& p : to->parts) all.push_back(&p);
        else
            for (const auto& p : m_loaded.outline->parts) all.push_back(p.get());
        return all;
    }

    Status findBefore(const std::string& path) {
        const std::optional<ObjectLocation> place = placeOf(m_loaded, path);
        const auto all = siblings();
        const auto it = place ? std::find(all.begin(), all.end(), place->part) : all.end();
        if (it == all.end()) return Error{Code::NoSuchPath, path + " is not in the same block"};
        m_before = *it;
        return {};
    }

    /// Chooses the position in the target file: before the requested block, or before the next one of the same type; else, if the
    /// block stays in its file, after the last one of the same type.
    void choosePosition(MovedItem& m) const {
        const bool stays = m.from == m.to && (m_file == kNoFile || m.to);
        m.file = stays ? m.part->file : m.to ? m.to->file : m_file == kNoFile ? FileId{0} : m_file;
        const auto all = siblings();
        const auto from = std::find(all.begin(), all.end(), m_before);
        const bool beside = from != all.end() && (!stays || (*from)->file == m.file);
        const auto fits = [&](const Part* p) { return p->file == m.file && !isMoved(p->block); };
        const auto alike = [&](const Part* p) { return fits(p) && hasSameType(*p, *m.part); };
        const auto next = beside ? std::find_if(from, all.end(), fits) : std::find_if(from, all.end(), alike);
        if (next != all.end()) m.next = *next;
        const bool inBlock = m.to && m.to->file == m.file; // inserting at its end is fine
        if (m.next || !stays || inBlock) return;
        const auto last = std::find_if(all.rbegin(), all.rend(), [&](const Part* p) { return alike(p) || p == m.part; });
        if (last != all.rend()) m.after = *last;
    }

    /// Whether all blocks are already at their target.
    bool nothingChanges() const {
        if (std::any_of(m_moved.begin(), m_moved.end(),
                        [](const MovedItem& m) { return m.from != m.to || m.part->file != m.file; }))
            return false;
        std::map<FileId, std::vector<const Part*>> before, after;
        for (const Part* p : siblings()) {
            before[p->file].push_back(p);
            const bool goes =
                std::any_of(m_moved.begin(), m_moved.end(), [&](const MovedItem& m) { return m.part == p && m.goes(); });
            if (!goes) after[p->file].push_back(p);
        }
        std::map<const Part*, std::ptrdiff_t> behind;
        for (const MovedItem& m : m_moved) {
            if (!m.goes()) continue;
            std::vector<const Part*>& now = after[m.file];
            auto at = std::find(now.begin(), now.end(), m.after ? m.after : m.next);
            if (m.after) at += 1 + behind[m.after]++;
            now.insert(at, m.part);
        }
        return before == after;
    }

    /// Checks the references to and from a block that gets another parent, and updates them.
    Status changePlace(MovedItem& m) {
        const bool isRepeated = (m.from && m.from->isRepeat()) || (m.to && m.to->isRepeat()); // names get or lose a member
        const bool sameConfig =
            m.part->is(Role::Geom) && !isRepeated && m.from && m.to && topOf(m.from, m.chosen->place) == topOf(m.to, m_into);
        const Part* top = sameConfig ? nullptr : m.to;
        std::vector<const NameReference*> users, wants;
        for (const NameReference& reference : m_references) {
            const bool byMoved = reference.user && movedAlong(*reference.user);
            if (reference.target && containsBlock(reference.target, *m.part) && reference.name.known()) {
                const bool isIt = reference.target == m.part->block;
                const bool losesPrefix = isIt && reference.before.known() && !m.to; // what stands before it would have to go
                if (isIt && !losesPrefix && (sameConfig || byMoved || m.from == nullptr)) {
                    if (reference.before.known()) change({reference.before, m.to->name});
                    change({reference.name, m.name});
                } else if (losesPrefix || (!sameConfig && !byMoved && !reference.pattern && m.from)) users.push_back(&reference);
            }
            if (!byMoved || !isWithin(reference.user->range, m.part->range)) continue;
            if (top && reference.target && !isTop(reference.target) && !movedTarget(reference.target) &&
                !top->find(m_texts.slice(reference.before.known() ? reference.before : reference.name)))
                wants.push_back(&reference);
            if (reference.param && !seenAt(m, m_texts.slice(reference.name)) && !inMoved(reference)) wants.push_back(&reference);
        }
        if (!users.empty()) return Error{Code::UnknownReference, m.part->title() + " is still used by " + usersText(users)};
        if (!wants.empty())
            return Error{Code::UnknownReference, m.part->title() + " uses " + std::string(m_texts.slice(wants[0]->name)) +
                                                     ", which " + (m.to ? m.to->title() : "the experiment") + " does not have"};
        return {};
    }

    /// Whether a block is a moved one or is inside one.
    bool movedAlong(const Part& user) const {
        return std::any_of(m_moved.begin(), m_moved.end(),
                           [&](const MovedItem& m) { return isWithin(user.range, m.part->range); });
    }
    static bool containsBlock(const BlockItem* block, const Part& part) {
        return part.block == block ||
               std::any_of(part.parts.begin(), part.parts.end(), [&](const Part& p) { return containsBlock(block, p); });
    }
    bool movedTarget(const BlockItem* block) const {
        return std::any_of(m_moved.begin(), m_moved.end(), [&](const MovedItem& m) { return containsBlock(block, *m.part); });
    }
    bool isTop(const BlockItem* block) const {
        return std::any_of(m_loaded.outline->parts.begin(), m_loaded.outline->parts.end(),
                           [&](const auto& p) { return p->block == block; });
    }
    bool inMoved(const NameReference& reference) const { // its Param is moved too
        const auto declares = [&](const auto& self, const std::vector<Item>& items) -> bool {
            return std::any_of(items.begin(), items.end(), [&](const Item& item) {
                const auto* block = item.as<BlockItem>();
                return item.as<ParamItem>() == reference.param || (block && self(self, block->items));
            });
        };
        return std::any_of(m_moved.begin(), m_moved.end(),
                           [&](const MovedItem& m) { return declares(declares, m.part->block->items); });
    }
    bool seenAt(const MovedItem& m, std::string_view name) const {
        const auto has = [&](const std::vector<SourceParam>& params) {
            return std::any_of(params.begin(), params.end(), [&](const SourceParam& p) { return p.name->text == name; });
        };
        if (has(m_loaded.outline->params) || (m.to && has(m.to->params))) return true;
        return m.to == m_into.part &&
               std::any_of(m_into.above.begin(), m_into.above.end(), [&](const Part* p) { return has(p->params); });
    }

    /// Adds an edit: to the moved text if it is inside one, else to the files.
    void change(TextEdit edit) {
        for (const MovedItem& m : m_moved) {
            if (!isWithin(edit.range, m.part->range)) continue;
            edit.range.range.begin -= m.part->range.range.begin;
            edit.range.range.end -= m.part->range.range.begin;
            std::vector<TextEdit>& edits = m_inside[m.part];
            const bool known = std::any_of(edits.begin(), edits.end(), [&](const TextEdit& e) { return e.range == edit.range; });
            if (!known) edits.push_back(std::move(edit));
            return;
        }
        m_sheet.add(std::move(edit));
    }

    /// Adds imports for what the moved blocks use to each file that receives a block, unless that would create an import cycle.
    /// The opened file is never imported.
    Status import() {
        std::map<FileId, std::vector<std::string>> imports;
        const std::set<FileId> atTop = imported(0); // files imported inside a block do not count
        const auto use = [&](FileId used, FileId by) {
            if (used != 0 && used != by && atTop.contains(used) && atTop.contains(by) && !imported(used).contains(by))
                imports[by].push_back(m_loaded.paths[used]);
        };
        for (const NameReference& reference : m_references) {
            const auto m = std::find_if(m_moved.begin(), m_moved.end(), [&](const MovedItem& one) {
                return reference.user && one.file != one.part->file && isWithin(reference.user->range, one.part->range);
            });
            if (m == m_moved.end()) continue;
            for (const auto& part : m_loaded.outline->parts)
                if (reference.target && part->block == reference.target && !reference.pattern && !movedTarget(part->block))
                    use(part->file, m->file);
            for (const SourceParam& param : m_loaded.outline->params)
                if (reference.param && param.name == &reference.param->name) use(param.file, m->file);
        }
        for (const auto& [file, paths] : imports) {
            Result<std::vector<TextEdit>> edits = editsForImports(m_loaded, file, paths);
            if (!edits.ok()) return edits.error();
            for (TextEdit& edit : edits.value()) m_sheet.addFirst(std::move(edit));
        }
        return {};
    }
    /// A file and its imports, direct and indirect.
    std::set<FileId> imported(FileId file) const {
        std::set<FileId> files{file};
        eachItem(m_texts, m_loaded.trees[file]->items(), file, [&](const Item& item, FileId) {
            const auto* import = item.as<ImportItem>();
            if (const auto it = m_texts.imports.find(import); import && it != m_texts.imports.end()) files.insert(it->second);
        });
        return files;
    }

    /// The path of an object below its config.
    static std::string withinOf(const ObjectLocation& place) {
        std::string within;
        for (std::size_t i = 1; i < place.above.size(); ++i)
            if (!place.above[i]->is(Role::Config)) within += place.above[i]->name + ".";
        return place.above.empty() || !place.part ? std::string() : within + place.part->name;
    }
    /// Pose in the new parent that keeps the pose in the world, and pose in the old parent, evaluated with the given instances.
    std::pair<Pose, Pose> posesOf(const MovedItem& m, const Part* oldInstance, const Part* newInstance) const {
        ObjectLocation old = m.chosen->place, into = m_into;
        const bool ofConfig = into.part != m.to; // "robot0" means its config
        if (ofConfig) into.part = m.to;
        old.instance = oldInstance;
        old.within = withinOf(old);
        into.instance = newInstance;
        into.within = withinOf(into);
        old.members.insert(old.members.end(), into.members.begin(), into.members.end()); // of a Repeat the same one for both
        into.members = old.members;
        const auto frame = [&](ObjectLocation holder) {
            while (holder.part && holder.part->isRepeat() && !holder.above.empty()) holder = outer(holder);
            return holder.part && holder.part->is(Role::Body) ? poseInConfig(m_loaded, holder) : Pose{};
        };
        Pose from = frame(outer(old)), to = ofConfig ? Pose{} : frame(into);
        if (oldInstance && newInstance && oldInstance != newInstance && !old.member && !into.member) {
            const auto world = [&](const Part* instance) {
                ObjectLocation place;
                place.part = place.instance = instance;
                return poseAt(m_loaded, place);
            };
            from = world(oldInstance) * from;
            to = world(newInstance) * to;
        }
        const Pose before = poseAt(m_loaded, old);
        return {to.inverse() * (from * before), before};
    }
    static bool isSame(const Pose& a, const Pose& b) {
        return (a.position - b.position).norm() < 1e-9 && a.rotation.angularDistance(b.rotation) < 1e-9;
    }

    Status keepPose(const MovedItem& m, MovedBlock& text) const {
        if (!m.part->is(Role::Geom) && !m.part->is(Role::Body)) return {};
        const Part* config = topOf(m.from, m.chosen->place);
        const bool sameConfig = config && config->is(Role::Config) && config == topOf(m.to, m_into);
        const auto [after, before] =
            sameConfig ? posesOf(m, nullptr, nullptr) : posesOf(m, m.chosen->place.instance, m_into.instance);
        const std::string within = withinOf(m.chosen->place);
        for (const auto& part : m_loaded.outline->parts) { // other instances may differ by a Param or an override
            if (!sameConfig || !isPlaced(*part) || configOf(m_loaded, *part) != config) continue;
            const auto [own, was] = posesOf(m, part.get(), part.get());
            const bool said = part->assignments.find(within + ".Pos") || part->assignments.find(within + ".HPR");
            if (said ? isSame(own, was) && isSame(after, before) : isSame(own, after)) continue;
            return Error{Code::WrongPlace, m.part->title() + " cannot keep its pose in " + part->title() +
                                               ", which sets a Pos, HPR or Param of its own there; reset that first"};
        }
        if ((after.position - before.position).norm() > 1e-12) text.set("Pos", positionText(after.position));
        if (after.rotation.angularDistance(before.rotation) > 1e-9) text.set("HPR", headingText(after.rotation));
        return {};
    }

    Status put(const MovedItem& m) {
        const Part& part = *m.part;
        if (!m.goes()) return {};
        const Result<std::string> written = applyEdits(m_texts.slice(part.range), m_inside[&part]);
        if (!written.ok()) return written.error();
        const std::size_t indent = indentOfLine(m_loaded.trees[part.file]->source().bytes(), part.range.range.begin).size();
        const SourceRange whole = withOwnComments(m_loaded, part.range, m_ranges);
        const std::string above(m_texts.slice({whole.file, {whole.range.begin, part.range.range.begin}}));
        const std::string behind(m_texts.slice({whole.file, {part.range.range.end, whole.range.end}}));
        MovedBlock text(dedented(above + written.value() + behind, indent));
        if (m.name != part.name || !part.block->name) text.rename(m.name);
        if (m.from != m.to)
            if (Status kept = keepPose(m, text); !kept.ok()) return kept;
        m_sheet.removeItem(whole);
        std::vector<const Part*> all;
        for (const MovedItem& other : m_moved) all.push_back(other.part);
        if (!part.block->name && m.from) keepNames(m.from->parts, part.block->type.text, m_references, all, m_sheet);
        if (!m.next && !m.after) {
            m_sheet.addItem(m.file, m.to ? m.to->block : nullptr, text.text());
            return {};
        }
        const SourceRange other = (m.next ? m.next : m.after)->range;
        TextRange beside = other.range;
        const std::uint32_t begin = withComments(m_loaded, other).range.begin;
        if (m.next && begin > 3) beside.begin = begin; // whatever that comment is about; not above one that begins the file
        const Tree& tree = *m_loaded.trees[m.file];
        const std::string_view bytes = tree.source().bytes();
        const std::string lineEnd = editStyle(tree).lineEnd + indentOfLine(bytes, beside.begin);
        const bool lines = text.text().find('\n') != std::string::npos || text.text().find("//") != std::string::npos;
        std::string out;
        for (const char c : text.text()) out += c == '\n' ? lineEnd : std::string(1, c);
        if (m.after) { // a trailing comment stays with it
            const std::optional<std::uint32_t> end = endOfLineBehind(tree, beside.end);
            const std::uint32_t at = end.value_or(beside.end);
            m_sheet.add({{m.file, {at, at}}, end ? lineEnd + out : lines ? lineEnd + out + lineEnd : " " + out});
            return {};
        }
        const std::uint32_t at = beside.begin;
        std::uint32_t start = at;
        while (start > 0 && isBlank(bytes[start - 1])) --start;
        const bool first = start == 0 || bytes[start - 1] == '\n' || bytes[start - 1] == '\r';
        if (first) out += lineEnd;
        else out = lines ? lineEnd + out + lineEnd : out + " ";
        m_sheet.add({{m.file, {at, at}}, out});
        return {};
    }

    const LoadedProject& m_loaded;
    const TextSet& m_texts;
    const std::vector<NameReference> m_references;
    const std::vector<SourceRange> m_ranges; ///< of the moved blocks
    EditBuilder m_sheet;
    std::vector<MovedItem> m_moved;
    ObjectLocation m_into;
    const FileId m_file; ///< kNoFile: no file was requested
    const Part* m_before = nullptr;
    std::map<std::pair<const Part*, const NameSpace*>, UsedNames> m_names;
    std::map<const Part*, std::vector<TextEdit>> m_inside; ///< edits of the moved texts, relative to their beginnings
};

} // namespace

Result<EditPlan> planMove(const LoadedProject& loaded, const std::vector<std::string>& paths, const std::string& parent,
                          const std::string& before, FileId file) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    return Move(loaded, all.value(), file).run(parent, before);
}

} // namespace trundle
