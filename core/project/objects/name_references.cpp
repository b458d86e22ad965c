// Needs: a load. Gives: every reference by name. Walks the blocks as written, with imports expanded in place, and looks up each
// name in the same scopes as the resolver: the top-level name spaces, the config, and the visible Params.
#include "project/objects/name_references.h"

#include <algorithm>
#include <deque>
#include <set>

#include "model/config_blocks.h"
#include "model/param_reference.h"
#include "model/robot_path.h"
#include "project/objects/name_scope.h"
#include "project/objects/object_location.h"
#include "project/objects/reference_space.h"

namespace trundle {

namespace {

bool hasWildcard(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

/// What `find` has by a word; a Repeat, Grid or Scatter also by a pattern for its members, "lane_*" or "lane_1?".
template <class Find> const Part* foundBy(std::string_view word, const Find& find) {
    if (const Part* part = find(word)) return part;
    const std::size_t bar = word.rfind('_');
    if (bar == std::string_view::npos || bar == 0 || bar + 1 == word.size()) return nullptr;
    const bool isMember = word.find_first_not_of("0123456789*?", bar + 1) == std::string_view::npos;
    const Part* part = isMember ? find(word.substr(0, bar)) : nullptr;
    return part && (part->isRepeat() || part->is(Role::Layout)) ? part : nullptr;
}
const Part* namedIn(const Part& holder, std::string_view word) {
    return foundBy(word, [&](std::string_view name) { return holder.find(name); });
}
const Part* partAt(const Part& holder, std::string_view path) {
    const Part* at = namedIn(holder, firstWord(path));
    while (at && firstWord(path) != path) {
        path = withoutFirstWord(path);
        at = namedIn(*at, firstWord(path));
    }
    return at;
}

/// A word of a value and its source range.
struct ValueWord {
    std::string_view text;
    SourceRange range;

    [[nodiscard]] ValueWord piece(std::size_t begin, std::size_t length) const {
        const auto from = range.range.begin + static_cast<std::uint32_t>(begin);
        return {text.substr(begin, length), {range.file, {from, from + static_cast<std::uint32_t>(length)}}};
    }
};

class ReferenceSearch {
public:
    explicit ReferenceSearch(const LoadedProject& loaded)
        : m_loaded(loaded), m_outline(*loaded.outline), m_texts(m_outline.texts()) {}

    std::vector<NameReference> run() {
        eachInWorld(m_outline, [&](const Part& part, const std::string&) {
            if (const Part* config = isPlaced(part) ? configOf(m_loaded, part) : nullptr)
                m_instances[config].push_back({&part, nullptr, {}});
        });
        for (const auto& part : m_outline.parts) {
            if (isVariant(*part)) m_instances[part->config].push_back({part.get(), nullptr, {}});
            collectUses(*part, *part, {});
        }
        m_globals = NameScope(m_texts, m_texts.trees[0]->items(), 0, nullptr);
        values(m_texts.trees[0]->items(), 0, {nullptr, m_outline.registry().find("settings"), nullptr, nullptr}, m_globals);
        for (const auto& part : m_outline.parts) visit(*part, nullptr, m_globals);
        return std::move(m_found);
    }

private:
    using Repeats = std::vector<const Part*>; ///< around a place, outermost first
    /// The block whose values are searched.
    struct ValueContext {
        const Part* user = nullptr;
        const Kind* kind = nullptr;
        const Part* config = nullptr;   ///< the config that its references are resolved in
        const Part* instance = nullptr; ///< set if the block is an instance
        Repeats repeats = {};           ///< in the config, in which its references are resolved first
        std::vector<const Part*> inside =
            {}; ///< of an override the Parts on its path: what is not in the config is looked up there
    };
    struct Use {
        const Part* instance = nullptr;
        const Part* owner = nullptr; ///< the config that a Part is in
        Repeats repeats = {};
    };

    void collectUses(const Part& holder, const Part& config, const Repeats& repeats) {
        for (const Part& inner : holder.parts) {
            if (inner.config) m_instances[inner.config].push_back({&inner, &config, repeats});
            if (!inner.isRepeat()) continue;
            Repeats around = repeats;
            around.push_back(&inner);
            collectUses(inner, config, around);
        }
    }

    void visit(const Part& part, const Part* config, const NameScope& outer) {
        const NameScope scope(m_texts, part.block->items, part.file, &outer, part.is(Role::Config) ? &part : nullptr);
        const bool placed = isPlaced(part);
        if (part.is(Role::Config)) config = &part;
        if (placed) config = configOf(m_loaded, part);
        if (part.isRepeat()) m_repeats.push_back(&part);
        const bool setsValues = placed || isVariant(part);
        values(part.block->items, part.file, {&part, part.kind, config, setsValues ? &part : nullptr, m_repeats}, scope);
        if (part.is(Role::Controller) && config) defaults(part, *config);
        for (const Part& inner : part.parts) visit(inner, config, scope);
        if (part.parts.empty()) raw(part.block->items, part.file, part, config, scope); // invalid blocks have no parts
        if (part.isRepeat()) m_repeats.pop_back();
    }

    /// Searches blocks that are not in the outline; their references count too.
    void raw(const std::vector<Item>& items, FileId file, const Part& user, const Part* config, const NameScope& outer) {
        for (const Item& item : items) {
            const auto* block = item.as<BlockItem>();
            if (!block) continue;
            const NameScope scope(m_texts, block->items, file, &outer);
            values(block->items, file, {&user, m_outline.registry().find(block->type.text), config, nullptr, m_repeats}, scope);
            raw(block->items, file, user, config, scope);
        }
    }

    void values(const std::vector<Item>& items, FileId file, const ValueContext& place, const NameScope& scope) {
        eachItem(m_texts, items, file, [&](const Item& item, FileId in) {
            if (const auto* param = item.as<ParamItem>()) params(param->value, in, place.user, param->name.text, scope);
            const auto* a = item.as<AssignmentItem>();
            if (!a || a->path.empty()) return;
            const std::string key(m_texts.slice(in, a->pathRange));
            params(a->value, in, place.user, key, scope);
            if (const Property* property = propertyOf(*a, in, place, key)) {
                const bool reference = property->type == PropertyType::Reference;
                if (reference || property->type == PropertyType::Text)
                    words(*property, a->value, in, insideOf(*a, place), key, scope);
            }
        });
    }

    static ValueContext insideOf(const AssignmentItem& a, const ValueContext& place) {
        ValueContext inside = place;
        const Part* at = place.instance ? place.config : nullptr;
        for (std::size_t i = 0; at && i + 1 < a.path.size(); ++i) {
            at = at->find(a.path[i].text);
            if (at && (at->isPartUse() || at->isRepeat())) inside.inside.push_back(at);
        }
        const bool isParam = at && at != place.config && at->config && at->config->param(a.path.back().text);
        if (isParam) inside.inside.pop_back(); // what a Part is joined to is not in it, but around it
        return inside;
    }

    /// The property that an assignment sets; also adds references for the names in an override's path.
    const Property* propertyOf(const AssignmentItem& a, FileId file, const ValueContext& place, const std::string& key) {
        const Property* own = a.path.size() == 1 && place.kind ? place.kind->find(a.path[0].text) : nullptr;
        if (own || !place.instance || !place.config) return own;
        if (a.path.size() == 1) {
            if (const SourceParam* param = place.config->param(a.path[0].text))
                addParam(*param, {file, a.path[0].range}, {}, place.user, key);
            return param(place, a) ? nullptr : place.config->kind->find(a.path[0].text);
        }
        const Part* at = place.config;
        SourceRange before;
        for (std::size_t i = 0; i + 1 < a.path.size(); ++i) {
            at = at->find(a.path[i].text);
            if (!at) return nullptr;
            const SourceRange word = nameRange(*at, {a.path[i].text, {file, a.path[i].range}});
            m_found.push_back({at->block, nullptr, word, before, place.user, key, false});
            before = {file, a.path[i].range};
        }
        if (const SourceParam* param = at->config ? at->config->param(a.path.back().text) : nullptr) {
            addParam(*param, {file, a.path.back().range}, before, place.user, key);
            return propertyNamedBy(*at->config, param->name->text);
        }
        return at->kind ? at->kind->find(a.path.back().text) : nullptr;
    }
    static bool param(const ValueContext& place, const AssignmentItem& a) { return place.config->param(a.path[0].text); }

    /// Finds the ParamItem whose member `name` is param.name.
    const ParamItem* declarationOf(const SourceParam& param) {
        const ParamItem* found = nullptr;
        const auto look = [&](const auto& self, const std::vector<Item>& items) -> void {
            for (const Item& item : items) {
                if (const auto* p = item.as<ParamItem>(); p && &p->name == param.name) found = p;
                if (const auto* block = item.as<BlockItem>()) self(self, block->items);
                if (found) return;
            }
        };
        const auto [it, fresh] = m_declarations.try_emplace(param.name, nullptr);
        if (fresh) {
            look(look, m_texts.trees[param.file]->items());
            it->second = found;
        }
        return it->second;
    }

    void addParam(std::string_view name, SourceRange range, const Part* user, const std::string& key, const NameScope& scope) {
        if (const ParamItem* item = scope.find(name).item) {
            m_found.push_back({nullptr, item, range, {}, user, key, false});
            return;
        }
        const Part* config = scope.enclosingConfig();
        const SourceParam* param = config ? config->param(name) : nullptr;
        if (param && !param->item) addParam(*param, range, {}, user, key);
    }
    void addParam(const SourceParam& param, SourceRange range, SourceRange before, const Part* user, const std::string& key) {
        m_found.push_back({nullptr, param.item ? declarationOf(param) : nullptr, range, before, user, key, false});
        if (!param.item) m_found.back().implied = param.name;
    }

    /// Adds references for every `$name` and every name in a `$( )`.
    void params(const Value& value, FileId file, const Part* user, const std::string& key, const NameScope& scope) {
        if (m_texts.commandLine(file)) return;
        for (const Element& e : value.elements) {
            if (e.kind == Element::Kind::ParamRef) addParam(e.text, {file, {e.range.begin + 1, e.range.end}}, user, key, scope);
            if (e.expression) names(*e.expression, file, user, key, scope);
        }
    }
    void names(const Expression& e, FileId file, const Part* user, const std::string& key, const NameScope& scope) {
        if (e.op == Expression::Op::Name) addParam(e.name, {file, e.range}, user, key, scope);
        for (const Expression& argument : e.arguments) names(argument, file, user, key, scope);
    }

    /// Adds references for the words of a value, also those given through Params.
    void words(const Property& property, const Value& value, FileId file, const ValueContext& place, const std::string& key,
               const NameScope& scope) {
        std::set<const Value*> seen;
        follow(property, value, file, place, key, scope, seen);
    }
    void follow(const Property& property, const Value& value, FileId file, const ValueContext& place, const std::string& key,
                const NameScope& scope, std::set<const Value*>& seen) {
        if (!seen.insert(&value).second || seen.size() > 1000) return;
        for (const Element& e : value.elements) {
            if (e.kind == Element::Kind::Word) word(property, {e.text, {file, e.range}}, place, key);
            if (e.kind == Element::Kind::String && e.range.size() == e.text.size() + 2) // only strings without escapes
                word(property, {e.text, {file, {e.range.begin + 1, e.range.end - 1}}}, place, key);
            const auto param = [&](const std::string& name) { followParam(property, name, place, key, scope, seen); };
            if (e.kind == Element::Kind::ParamRef) param(e.text);
            if (e.expression) eachNameGiven(*e.expression, param);
        }
    }
    void followParam(const Property& property, const std::string& name, const ValueContext& place, const std::string& key,
                     const NameScope& scope, std::set<const Value*>& seen) {
        const NameScope::Declaration d = scope.find(name);
        const SourceParam* implied = d.item || !place.config ? nullptr : place.config->param(name);
        if (d.item) follow(property, d.item->value, d.file, place, key, *d.scope, seen);
        if (d.item || implied) followUsers(property, name, d.item ? d.scope->config() : place.config, place, key, seen);
    }
    /// The values that instances of a config give to one of its Params. A name that a Part gives is one of the config around it.
    void followUsers(const Property& property, const std::string& param, const Part* config, const ValueContext& place,
                     const std::string& key, std::set<const Value*>& seen) {
        const auto users = m_instances.find(config);
        if (users == m_instances.end()) return;
        for (const auto& [instance, owner, repeats] : users->second) {
            const SourceAssignment* preset = instance->assignments.find(param);
            if (!preset || (instance->kind && instance->kind->find(param))) continue;
            ValueContext there = place;
            if (owner) there = {instance, place.kind, owner, nullptr, repeats};
            if (isVariant(*instance)) there.config = instance;
            const NameScope own(m_texts, instance->block->items, instance->file, owner ? &scopeOf(*owner) : &m_globals);
            follow(property, *preset->value, preset->file, there, owner ? param : key, own, seen);
        }
    }

    /// Of a config; it may hold very many Parts.
    const NameScope& scopeOf(const Part& config) {
        const auto it = m_configScopes.find(&config);
        if (it != m_configScopes.end()) return it->second;
        return m_configScopes.try_emplace(&config, m_texts, config.block->items, config.file, &m_globals, &config).first->second;
    }

    void word(const Property& property, const ValueWord& said, const ValueContext& place, const std::string& key) {
        if (said.text.empty() || m_texts.commandLine(said.range.file)) return;
        if (place.kind && namesWorld(*place.kind, property)) return world(said, place, key);
        if (property.type == PropertyType::Text) {
            if (!place.kind || place.kind->role != Role::Controller || !place.config) return;
            const Part* part = place.config->findPath(said.text);
            if (part && part->is(Role::Device)) path(*place.config, said, place, key);
            return;
        }
        bool local = property.choices.empty();
        for (const std::string& choice : property.choices) {
            const Kind* kind = m_outline.registry().find(choice);
            const NameSpace* space = kind ? referenceSpace(m_outline, *kind) : nullptr;
            local = local || !space;
            const Part* part = space ? space->find(said.text) : nullptr;
            if (part) return add(*part, said.range, {}, place, key);
        }
        if (local && !place.config && place.kind && place.kind->role == Role::Joint) return bodyOfRobot(said, place, key);
        if (!local || !place.config) return;
        path(*place.config, said, place, key);
    }

    /// The block of the world that a path begins with, "tractor", "trailer_2", "row_3.cart", in a Repeat first what is in that.
    /// Adds references for its words; `size`: their length.
    const Part* startInWorld(const ValueWord& said, const ValueContext& place, const std::string& key, std::size_t& size) {
        const ValueWord first = said.piece(0, firstWord(said.text).size());
        const Part* at = nullptr;
        for (auto it = place.repeats.rbegin(); it != place.repeats.rend() && !at; ++it) at = namedIn(**it, first.text);
        if (!at) at = foundBy(first.text, [&](std::string_view name) { return m_outline.world.find(name); });
        if (!at) return nullptr;
        add(*at, nameRange(*at, first), {}, place, key);
        size = first.text.size();
        for (SourceRange before = first.range; at->isRepeat() && size < said.text.size();) {
            const ValueWord next = said.piece(size + 1, firstWord(said.text.substr(size + 1)).size());
            const Part* inner = namedIn(*at, next.text);
            if (!inner) return nullptr;
            add(*inner, nameRange(*inner, next), before, place, key);
            before = next.range;
            at = inner;
            size += 1 + next.text.size();
        }
        return at;
    }

    /// Of a joint at the top level: "tractor.chassis", "trailer_2.frame".
    void bodyOfRobot(const ValueWord& said, const ValueContext& place, const std::string& key) {
        std::size_t size = 0;
        const Part* instance = startInWorld(said, place, key, size);
        const Part* config = instance ? configOf(m_loaded, *instance) : nullptr;
        if (!config || size + 1 >= said.text.size()) return;
        const std::size_t before = said.text.substr(0, size).rfind('.') + 1; // of the last word: npos + 1 is 0
        path(*config, said.piece(size + 1, said.text.size() - size - 1), place, key, false,
             said.piece(before, size - before).range);
    }

    /// Of "roller_3", a member of a Repeat, Grid or Scatter, the name of that.
    static SourceRange nameRange(const Part& part, const ValueWord& word) {
        return (part.isRepeat() || part.is(Role::Layout)) && word.text != part.name ? word.piece(0, part.name.size()).range
                                                                                    : word.range;
    }

    /// Every word of "left.wheel.tyre" names something.
    void path(const Part& config, const ValueWord& said, const ValueContext& place, const std::string& key, bool pattern = false,
              SourceRange before = {}) {
        const Part* at = &config;
        for (auto it = place.repeats.rbegin(); it != place.repeats.rend() && at == &config && &config == place.config; ++it)
            if ((*it)->find(firstWord(said.text))) at = *it;
        const auto hasFirst = [first = firstWord(said.text)](const Part* part) { return part->find(first); };
        const auto inside = std::find_if(place.inside.rbegin(), place.inside.rend(), hasFirst);
        const bool isInside = &config == place.config && at == &config && inside != place.inside.rend() && !hasFirst(&config);
        if (isInside) at = *inside;
        for (std::size_t begin = 0; begin <= said.text.size();) {
            const ValueWord word = said.piece(begin, firstWord(said.text.substr(begin)).size());
            at = namedIn(*at, word.text);
            if (!at) return;
            add(*at, nameRange(*at, word), before, place, key, pattern);
            if (isInside && begin == 0) m_found.back().lookedUpFirst = &config;
            before = word.range;
            begin += word.text.size() + 1;
        }
    }

    /// A path into the world: "robot0", "swarm_*", "robot0/leftEncoder/count".
    void world(const ValueWord& said, const ValueContext& place, const std::string& key) {
        const std::size_t slash = std::min(said.text.find('/'), said.text.size());
        const ValueWord first = said.piece(0, slash);
        const bool isPattern = hasWildcard(first.text);
        std::size_t size = 0;
        const Part* part = startInWorld(first, place, key, size);
        std::vector<const Part*> meant;
        if (part && part->isRepeat() && isPattern) {
            eachInWorld(*part, {}, [&](const Part& inner, const std::string&) {
                if (isPlaced(inner)) meant.push_back(&inner);
            });
        } else if (part && size == first.text.size()) {
            meant = {part};
        } else if (isPattern) {
            for (const auto& [placed, name] : firstMembers(m_outline))
                if (isPlaced(*placed) && fitsPattern(first.text, name)) meant.push_back(placed);
        }
        if (slash < said.text.size()) signal(said, slash + 1, meant, place, key);
    }

    /// The second word of a signal path: a body, joint or device, or the robot's controller.
    void signal(const ValueWord& said, std::size_t from, const std::vector<const Part*>& meant, const ValueContext& place,
                const std::string& key) {
        const std::size_t end = std::min(said.text.find('/', from), said.text.size());
        const ValueWord second = said.piece(from, end - from);
        std::set<const BlockItem*> named;
        for (const Part* instance : meant) {
            const Part* config = configOf(m_loaded, *instance);
            const Part* part = config ? partAt(*config, second.text) : nullptr;
            const Part& holder = part ? *config : *instance;
            if (!part) part = instance->find(second.text);
            if (part && named.insert(part->block).second) path(holder, second, place, key, meant.size() > 1);
        }
    }

    /// Adds references for text properties of a controller whose default is the name of a device.
    void defaults(const Part& controller, const Part& config) {
        for (const Property& p : controller.kind->properties) {
            if (p.type != PropertyType::Text || !p.defaultValue || p.defaultValue->texts.size() != 1) continue;
            if (controller.assignments.find(p.name)) continue;
            const Part* part = config.find(p.defaultValue->texts[0]);
            if (part && part->is(Role::Device)) m_found.push_back({part->block, nullptr, {}, {}, &controller, p.name, false});
        }
    }

    void add(const Part& target, SourceRange name, SourceRange before, const ValueContext& place, const std::string& key,
             bool pattern = false) {
        m_found.push_back({target.block, nullptr, name, before, place.user, key, pattern});
    }

    const LoadedProject& m_loaded;
    const Outline& m_outline;
    const TextSet& m_texts;
    NameScope m_globals;
    Repeats m_repeats; ///< around the block that is visited
    std::unordered_map<const Part*, NameScope> m_configScopes;
    std::unordered_map<const Part*, std::vector<Use>> m_instances;
    std::unordered_map<const Name*, const ParamItem*> m_declarations;
    std::vector<NameReference> m_found;
};

} // namespace

std::vector<NameReference> referencesIn(const LoadedProject& loaded) { return ReferenceSearch(loaded).run(); }

bool fitsPattern(std::string_view pattern, std::string_view name) {
    std::vector<bool> fits(name.size() + 1, false); // whether the pattern so far matches the first i characters
    fits[0] = true;
    for (const char c : pattern) {
        if (c == '*') {
            for (std::size_t i = 1; i < fits.size(); ++i) fits[i] = fits[i] || fits[i - 1];
            continue;
        }
        for (std::size_t i = fits.size(); i-- > 1;) fits[i] = fits[i - 1] && (c == '?' || c == name[i - 1]);
        fits[0] = false;
    }
    return fits.back();
}

bool namesWorld(const Kind& kind, const Property& property) {
    if (kind.role == Role::Settings) return property.name == "NoContact";
    if (kind.role != Role::Log && kind.role != Role::Look && kind.role != Role::Region) return false;
    static const char* const names[] = {"Robot", "Robots", "Signal", "Signals", "Camera", "View"};
    return (property.type == PropertyType::Text || property.type == PropertyType::Reference) &&
           std::find(std::begin(names), std::end(names), property.name) != std::end(names);
}

} // namespace trundle
