#include "model/set_targets.h"

#include "base/spelling.h"
#include "model/config_blocks.h"
#include "model/robot_path.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

class Applier {
public:
    /// `lays`: apply the sets to the outline, which must then be modifiable.
    Applier(const Outline& outline, bool lays, Diagnostics& diagnostics)
        : m_outline(outline), m_lays(lays), m_diagnostics(diagnostics) {}

    AppliedSets run(std::span<const SetText> sets) {
        for (const SetText& set : sets) {
            if (!set.item || set.item->path.empty()) continue;
            m_set = &set;
            apply();
        }
        return std::move(m_applied);
    }

private:
    void apply() {
        const std::vector<Name>& path = m_set->item->path;
        if (path.size() == 1) return setTop();
        std::vector<std::string> words;
        for (const Name& name : path) words.push_back(name.text);
        const PathStart start = startOfPath(m_outline, words);
        if (!start.part) return noStart();
        const Part* at = m_outline.world.find(words[0]);
        for (std::size_t i = 0; at && i < start.words; at = ++i < start.words ? at->find(words[i]) : nullptr)
            if (isOneMember(*at, i)) return;
        if (start.words >= path.size()) return takesNoValue(*start.part, path.back());
        descend(*start.part, start.words);
    }

    /// Reports a word of a path that is the name of one member of a Repeat: its text is that of all.
    bool isOneMember(const Part& part, std::size_t word) {
        const Name& name = m_set->item->path[word];
        if (!m_lays || !part.isRepeat() || part.name == name.text) return false; // in the window all get it
        m_diagnostics.error(Code::ReplaceBySingles, {m_set->file, name.range},
                            name.text + " is one member of " + part.title() + " and they have one text; set " + part.name +
                                (part.isInWorld ? " for all of them" : " for all of them, or set it in a robot for one"));
        return true;
    }

    void setTop() {
        const std::string& key = m_set->item->path[0].text;
        const Kind* settings = m_outline.registry().find("settings");
        for (const SourceParam& p : m_outline.params) {
            if (p.name->text == key && !(settings && settings->find(key))) return setParam(p, nullptr, key);
        }
        if (const Part* part = settings && settings->find(key) ? nullptr : m_outline.world.find(key))
            return takesNoValue(*part, m_set->item->path[0]);
        put(m_outline.settings, nullptr, 0);
    }

    void takesNoValue(const Part& part, const Name& name) {
        m_diagnostics.error(Code::NoSuchPath, {m_set->file, name.range},
                            part.title() + " takes no value itself; set one of its properties, " + name.text + ". ...");
    }

    /// Follows the words of the path from `i` on, starting at `part`.
    void descend(const Part& part, std::size_t i) {
        const std::vector<Name>& path = m_set->item->path;
        const Part* at = &part;
        for (; i + 1 < path.size(); ++i) {
            const Part* next = at->isPartUse() ? nullptr : at->find(path[i].text);
            if (next && isVariant(*at) && at->config->find(path[i].text) == next) break; // it is described in the other config
            if (next && isOneMember(*next, i)) return;
            if (next) {
                at = next;
                continue;
            }
            if (at->is(Role::Instance) || at->is(Role::Layout)) break; // the rest is the path of an override
            if (const Part* layout = at->isRepeat() ? inRepeat(*at, path[i].text) : nullptr)
                return (void)m_diagnostics.error(Code::ReplaceBySingles, {m_set->file, path[i].range},
                                                 path[i].text + " is a member of " + layout->title() + ", which is in " +
                                                     at->title() + ": members have no text of their own; set " + layout->name +
                                                     " for all of them");
            return noSuch({m_set->file, path[i].range}, at->title() + " has no " + path[i].text, namesIn(*at), path[i].text);
        }
        const std::string& key = path.back().text;
        const bool isInherited = isVariant(*at) && at->config->param(key);
        if (at->is(Role::Config) && i + 1 == path.size() && !at->kind->find(key) && !isInherited) {
            for (const SourceParam& p : at->params) {
                if (p.name->text == key) return setParam(p, at, key);
            }
        }
        put(at->assignments, at, i);
    }

    static std::vector<std::string> namesIn(const Part& part) {
        std::vector<std::string> names;
        for (const Part& inner : part.parts) names.push_back(inner.name);
        return names;
    }

    void setParam(const SourceParam& param, const Part* part, const std::string& key) {
        if (param.required) m_applied.targets.push_back({part, "Param " + key, valueRange(), {}}); // it is declared nowhere
        else m_applied.targets.push_back({part, key, valueRange(), {param.valueFile, param.value->range}});
        if (!m_lays) return;
        auto& own = const_cast<SourceParam&>(param);
        own.value = &m_set->item->value;
        own.valueFile = m_set->file;
    }

    void put(const AssignmentList& list, const Part* part, std::size_t firstWord) {
        const std::span<const Name> path = std::span(m_set->item->path).subspan(firstWord);
        std::string key = path[0].text;
        for (const Name& name : path.subspan(1)) key += "." + name.text;
        const SourceAssignment* before = list.find(key);
        m_applied.targets.push_back({part, key, valueRange(), before ? before->valueRange() : SourceRange{}});
        if (m_lays) const_cast<AssignmentList&>(list).replace({key, path, &m_set->item->value, m_set->file, m_set->item});
    }

    SourceRange valueRange() const { return {m_set->file, m_set->item->value.range}; }

    void noSuch(SourceRange place, std::string message, const std::vector<std::string>& words, const std::string& word) {
        Diagnostic& d = m_diagnostics.error(Code::NoSuchPath, place, std::move(message));
        if (!words.empty())
            d.message += "; there " + std::string(words.size() == 1 ? "is " : "are ") + listText(words, "and", 20);
        if (!manyAlready(m_diagnostics)) suggest(d, word, words, place);
    }

    void noStart() {
        const std::vector<Name>& path = m_set->item->path;
        const SourceRange first{m_set->file, path[0].range}, second{m_set->file, path[1].range};
        if (const Part* layout = layoutOfMember(m_outline, path[0].text)) {
            m_applied.members.push_back({layout, path[0].text, first});
            return;
        }
        const Kind* kind = m_outline.registry().find(path[0].text);
        const NameSpace* space = kind ? m_outline.spaceOf(*kind) : nullptr;
        if (space && path.size() > 2) {
            std::vector<std::string> names;
            for (const Part* part : space->all()) {
                if (part->kind == kind) names.push_back(part->name);
            }
            return noSuch(second, "there is no " + kind->name + " " + path[1].text, names, path[1].text);
        }
        if (space) {
            m_diagnostics.error(Code::NoSuchPath, first,
                                "a path into " + withArticle(kind->name) + " is " + kind->name + ".name.property");
            return;
        }
        std::vector<std::string> words = m_outline.world.names();
        if (words.empty()) words = {"RobotConfig", "StaticConfig", "Material", "Surface"};
        noSuch(first, "nothing in the world is named " + path[0].text, words, path[0].text);
    }

    const Outline& m_outline;
    bool m_lays;
    Diagnostics& m_diagnostics;
    const SetText* m_set = nullptr;
    AppliedSets m_applied;
};

} // namespace

PathStart startOfPath(const Outline& outline, std::span<const std::string> path) {
    if (path.empty()) return {};
    if (const Part* part = outline.world.find(path[0])) {
        std::size_t words = 1;
        for (const Part* inner = part; part->isRepeat() && words < path.size() && (inner = part->find(path[words])); ++words)
            part = inner;
        return {part, words};
    }
    const Kind* kind = outline.registry().find(path[0]);
    const NameSpace* space = kind && path.size() > 2 ? outline.spaceOf(*kind) : nullptr;
    const Part* part = space ? space->find(path[1]) : nullptr;
    if (!part || part->kind != kind) return {};
    return {part, 2};
}

AppliedSets applySets(Outline& outline, Diagnostics& diagnostics) {
    AppliedSets applied = Applier(outline, true, diagnostics).run(outline.texts().sets);
    if (!applied.targets.empty()) outline.linkParts(); // a set may name another PartConfig
    return applied;
}

AppliedSets targetsOfSets(const Outline& outline, std::span<const SetText> sets, Diagnostics& diagnostics) {
    return Applier(outline, false, diagnostics).run(sets);
}

} // namespace trundle
