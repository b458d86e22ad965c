#include "model/resolve/instance_values.h"

#include <algorithm>

#include "base/spelling.h"
#include "model/config_blocks.h"
#include "model/param_reference.h"
#include "model/repeat.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// `file`: the one that a relative path is searched from; none for a Param, whose path is searched from where the Param is used.
void appendKey(std::string& key, const std::string& name, const GivenValue& value, FileId file = kNoFile) {
    key += '\n' + name + '=';
    for (const GivenElement& e : value.elements) {
        key += static_cast<char>('0' + static_cast<int>(e.kind));
        key += elementText(e) + e.text + ',';
        const bool isText = e.kind == GivenElement::Kind::Word || e.kind == GivenElement::Kind::String;
        if (isText && file != kNoFile) key += std::to_string(file) + ',';
    }
}

class InstanceReader {
public:
    InstanceReader(ResolveContext& context, const Part& part, ParamScope& scope, InstanceValues& given)
        : m_context(context), m_part(part), m_scope(scope), m_given(given) {}

    /// Whether the words of a path from `first` on lead to something in a Part, whose config is this one; reports it otherwise.
    bool checkRest(const Part& use, const Part& config, const SourceAssignment& a, std::size_t first) {
        return checkPath(use, a, &config, first);
    }

    Record read(const Part*& config, std::string_view kind, const OverrideNode* outer, std::size_t member) {
        const Part* likely = likelyConfig();
        const OverrideNode* other = below(outer, "Config");
        m_isExchanged = other && other->value;
        ResolveContext::ExtraKeys extra;
        if (likely) {
            for (const SourceParam& p : likely->params) extra.words.push_back(p.name->text);
            for (const Property& p : likely->kind->properties)
                if (!m_part.kind->find(p.name)) extra.words.push_back(p.name);
        }
        std::vector<const SourceAssignment*> taken;
        extra.take = [&](const SourceAssignment& a) {
            if (a.path.size() == 1 && (!likely || (!likely->param(a.key) && !likely->kind->find(a.key)))) {
                const Part* block = ownBlock(a.key);
                if (!block && likely) block = likely->find(a.key);
                if (block && block->kind) return takesNoValue(*block, a.keyRange()), true;
                const std::vector<std::string> own = propertyNames(*m_part.kind);
                const bool isUnknown = !likely || likely->kind->name != kind || isBaseMissing(*likely);
                const bool isUndeclared = likely && !a.key.starts_with("index") && !m_context.globals.has(a.key) &&
                                          usesParam(*likely, a.key); // reported where it is used
                return (isUnknown && nearestWords(a.key, own).empty()) ||
                       isUndeclared; // of an unknown config the Params are unknown too
            }
            taken.push_back(&a);
            return true;
        };
        Record record = m_context.read(m_part, m_scope, outer, Origin::Instance, extra);
        config = m_context.configOf(record, m_part, kind);
        const ResolvedValue* count = m_part.is(Role::Layout) ? record.find("Count") : nullptr;
        // With a wrong Count, which is reported, the members have both numbers.
        if (m_part.is(Role::Layout)) setIndex(m_scope, member, count ? count->value.numbers : std::vector<double>{1, 1});
        if (!config) return record;
        checkOwnParams(*config);
        for (const SourceAssignment* a : taken) takeValue(*config, *a);
        return record;
    }

private:
    /// Whether it has blocks beside those of its config: controllers.
    bool hasOwnBlocks() const { return !m_part.isPartUse() && !m_part.is(Role::Config); }
    const Part* ownBlock(const std::string& name) const { return hasOwnBlocks() ? m_part.find(name) : nullptr; }

    /// The config that an instance probably names; reports no errors.
    const Part* likelyConfig() {
        const SourceAssignment* a = m_part.assignments.find("Config");
        if (!a || a->value->elements.size() != 1) return nullptr;
        const Element& e = a->value->elements[0];
        if (e.kind == Element::Kind::Word || e.kind == Element::Kind::String) return m_context.outline.configs.find(e.text);
        Diagnostics silent;
        Evaluator trial(m_context.texts, silent);
        const std::optional<GivenValue> value = trial.evaluate(*a->value, a->file, m_scope);
        return value && value->elements.size() == 1 ? m_context.outline.configs.find(value->elements[0].text) : nullptr;
    }

    /// A Param of an instance is its own: one with the name of a Param of the config was meant to set that.
    void checkOwnParams(const Part& config) {
        if (m_part.is(Role::Config)) return; // of a variant it is reported as a block with a taken name
        for (const SourceParam& own : m_part.params) {
            const SourceParam* meant = config.param(own.name->text);
            if (!meant || m_part.assignments.find(own.name->text)) continue;
            Diagnostic& d = m_context.diagnostics.error(Code::DuplicateName, own.nameRange(),
                                                        config.title() + " has a Param " + own.name->text +
                                                            " already; set its value: " + own.name->text + "=...");
            d.notes.emplace_back("defined here", meant->nameRange());
        }
    }

    void takeValue(const Part& config, const SourceAssignment& a) {
        const bool param = a.path.size() == 1 && config.param(a.key);
        if (m_isExchanged && !param && !PathWalk(*this, config, a).leads) return; // it is for the config in the text
        const Part* own = ownBlock(a.path[0].text);
        if (!param && a.path.size() > 1 && own) {
            m_context.diagnostics.error(Code::NoSuchPath, a.keyRange(),
                                        "set " + a.key.substr(a.path[0].text.size() + 1) + " inside the block of " +
                                            a.path[0].text);
            return;
        }
        if (!param && !checkPath(config, a)) return;
        std::optional<GivenValue> value = m_context.evaluator.evaluate(*a.value, a.file, m_scope);
        if (!value || (param && !m_context.evaluator.checkUnits(*value))) return;
        appendKey(m_given.key, a.key, *value, param ? kNoFile : a.file);
        if (param) {
            value->fromParam = true;
            m_given.params.emplace_back(a.key, std::move(*value));
            return;
        }
        OverrideNode* node = &m_given.overrides;
        for (const Name& name : a.path) {
            node = &node->children[name.text];
            if (!node->word.known()) node->word = {a.file, name.range};
        }
        node->origin = Origin::Instance;
        node->value = std::make_shared<const GivenValue>(std::move(*value));
        node->assignment = m_isExchanged ? nullptr : &a; // which may be for the config in the text
        node->writer = &m_part;
    }

    /// The way of a path into a config; through a Part whose config this instance exchanges, `left.Config=Other`, into that one. It
    /// ends at a Part whose config may vary: checkOverrides() walks on from there.
    struct PathWalk {
        const Part* at; ///< where it ends
        const Part* exchanged;
        std::size_t word;                  ///< the first one that is not there
        bool leads = false, isRaw = false; ///< isRaw: it ends in the text of a module that is not there

        PathWalk(const InstanceReader& reader, const Part& config, const SourceAssignment& a, const Part* configThere = nullptr,
                 std::size_t first = 0)
            : at(&config), exchanged(configThere), word(first) {
            for (; word + 1 < a.path.size(); ++word) {
                const Part* next = (exchanged ? exchanged : at)->find(a.path[word].text);
                if (!next) return;
                isRaw = !next->kind;
                if (isRaw) return;
                at = next;
                exchanged = next->isPartUse() ? reader.exchangedConfig(a, word) : nullptr;
                leads = !exchanged && reader.m_context.outline.hasVaryingConfig(*next);
                if (leads) return;
            }
            const std::string& key = a.path.back().text;
            const Part* used = exchanged ? exchanged : at->config;
            leads = at->kind->find(key) || (used && used->param(key));
        }
    };
    const Part* exchangedConfig(const SourceAssignment& a, std::size_t last) const {
        std::string key;
        for (std::size_t i = 0; i <= last; ++i) key += a.path[i].text + ".";
        const SourceAssignment* other = m_part.assignments.find(key + "Config");
        const bool isName = other && other->value->elements.size() == 1 && other->item != a.item;
        const Part* config = isName ? m_context.outline.configs.find(other->value->elements[0].text) : nullptr;
        return config && config->kind->name == "PartConfig" ? config : nullptr;
    }
    bool checkPath(const Part& config, const SourceAssignment& a, const Part* configThere = nullptr, std::size_t first = 0) {
        const PathWalk walk(*this, config, a, configThere, first);
        return walk.leads || (!walk.isRaw && noSuchPath(walk.exchanged ? *walk.exchanged : *walk.at, a, walk.word));
    }

    void takesNoValue(const Part& block, SourceRange place) {
        m_context.diagnostics.error(Code::NoSuchPath, place,
                                    block.title() + " takes no value itself; set one of its properties, " + block.name + ". ...");
    }

    bool noSuchPath(const Part& part, const SourceAssignment& a, std::size_t i) {
        const Part* config = part.is(Role::Config) ? &part : part.config;
        if ((part.isPartUse() && !config) || (config && isBaseMissing(*config)))
            return false; // what is unknown there is reported
        std::vector<std::string> words;
        std::string member;
        const bool isOfInstance = i == 0 && hasOwnBlocks() && !m_part.parts.empty();
        const auto add = [&](const Part& inner) {
            if (!inner.name.empty()) words.push_back(inner.name);
        };
        if (isOfInstance) std::ranges::for_each(m_part.parts, add);
        eachBlock(part, [&](const Part& inner) {
            add(inner);
            const std::string& word = a.path[i].text; // `m0` for `m_0`
            if (inner.isRepeat() && word.size() > inner.name.size() && word.starts_with(inner.name) &&
                word.find_first_not_of("0123456789", inner.name.size()) == std::string::npos)
                member = inner.name + "_" + word.substr(inner.name.size());
        });
        if (i + 1 == a.path.size()) {
            words = part.is(Role::Config) ? std::vector<std::string>() : propertyNames(*part.kind);
            if (config)
                for (const SourceParam& param : config->params) words.push_back(param.name->text);
        }
        const SourceRange place{a.file, a.path[i].range};
        const Part* block = i + 1 == a.path.size() ? part.find(a.path[i].text) : nullptr;
        if (block && block->kind) return takesNoValue(*block, place), false;
        if (i + 1 < a.path.size() && part.kind && part.kind->find(a.path[i].text)) // `left.Pos.x`
            return m_context.diagnostics.error(Code::NoSuchPath, {a.file, a.path[i + 1].range},
                                               a.path[i].text + " of " + part.title() +
                                                   " has nothing in it; it is set as a whole, " + a.path[i].text + "=..."),
                   false;
        Diagnostic& d = m_context.diagnostics.error(Code::NoSuchPath, place,
                                                    (isOfInstance ? m_part : part).title() + " has no " + a.path[i].text);
        if (words.empty()) return false;
        d.message += "; it has " + listText(words, "and", 20);
        if (manyAlready(m_context.diagnostics)) return false;
        if (member.empty()) suggest(d, a.path[i].text, words, place);
        else suggestWords(d, {member}, place);
        if (d.suggestions.empty() && i + 1 < a.path.size()) suggestWords(d, oneDeeper(part, a.path[i].text), place);
        return false;
    }

    /// Paths with one more level for a missing word: `chassis.hull.Size` for `hull.Size`.
    static std::vector<std::string> oneDeeper(const Part& part, const std::string& name) {
        std::vector<std::string> paths;
        eachBlock(part, [&](const Part& inner) {
            if (inner.find(name)) paths.push_back(inner.name + "." + name);
        });
        return paths;
    }

    ResolveContext& m_context;
    const Part& m_part;
    ParamScope& m_scope;
    InstanceValues& m_given;
    bool m_isExchanged = false; ///< an override names another config
};

class OverrideCheck {
public:
    OverrideCheck(ResolveContext& context, const Part& use, const Part& config, const std::vector<const Part*>& writers,
                  std::set<const SourceAssignment*>& reported)
        : m_context(context), m_use(use), m_config(config), m_writers(writers), m_reported(reported) {}

    void run(const OverrideNode& outside) {
        const OverrideNode* other = below(&outside, "Config");
        m_first = other && other->writer ? placeOf(other->writer) : 0;
        check(outside, 0);
    }

private:
    std::ptrdiff_t placeOf(const Part* writer) const { return std::ranges::find(m_writers, writer) - m_writers.begin(); }

    void check(const OverrideNode& node, std::size_t depth) {
        for (const auto& [name, inner] : node.children) check(inner, depth + 1);
        const SourceAssignment* a = node.assignment;
        if (!a || depth == 0 || m_reported.contains(a)) return;
        if (placeOf(node.writer) < m_first) return; // it is for a config that another block further out exchanges
        ParamScope none;
        InstanceValues given;
        if (!InstanceReader(m_context, *node.writer, none, given).checkRest(m_use, m_config, *a, a->path.size() - depth))
            m_reported.insert(a);
    }

    ResolveContext& m_context;
    const Part &m_use, &m_config;
    const std::vector<const Part*>& m_writers; ///< innermost first
    std::set<const SourceAssignment*>& m_reported;
    std::ptrdiff_t m_first = 0; ///< the place of the block that names the config
};

bool inside(const SourceRange& a, const SourceRange& b) {
    return a.file == b.file && a.range.begin >= b.range.begin && a.range.end <= b.range.end;
}

/// Whether what is wrong is in one block of the top level and the value in another one, a variant or what a Part is in, or on the
/// command line.
bool isFromElsewhere(const ResolveContext& context, const SourceRange& value, const SourceRange& wrong) {
    if (context.texts.commandLine(value.file)) return true;
    const Part* own = nullptr;
    const Part* other = nullptr;
    for (const auto& part : context.outline.parts) {
        if (inside(wrong, part->range)) own = part.get();
        if (inside(value, part->range)) other = part.get();
    }
    return own && other && own != other;
}

/// Its fixes are for the place in the config, which other instances use too. The word of a reference is given for it alone.
bool moveToValue(const ResolveContext& context, Diagnostic& d, const InstanceValues& given) {
    if (d.notes.empty() || d.notes[0].first != kGivenHere) return false;
    const SourceRange value = d.notes[0].second;
    const auto param = std::ranges::find_if(given.params, [&](const auto& p) { return inside(value, p.second.range); });
    const bool isOwn = param != given.params.end();
    if (!isOwn && !isFromElsewhere(context, value, d.range)) return false;
    d.notes[0] = {kUsedHere, d.range};
    d.range = d.code == Code::WrongCount && isOwn ? param->second.range : value;
    d.fixes.clear();
    if (d.code == Code::UnknownReference && !d.suggestions.empty())
        d.fixes.push_back({d.suggestions.front(), {{value, d.suggestions.front()}}});
    return true;
}

} // namespace

void InstanceValues::addParam(const std::string& name, GivenValue value) {
    std::erase_if(params, [&](const auto& p) { return p.first == name; });
    appendKey(key, name, value);
    params.emplace_back(name, std::move(value));
}

Record readInstance(ResolveContext& context, const Part& part, ParamScope& scope, InstanceValues& given, const Part*& config,
                    std::string_view kind, const OverrideNode* outer, std::size_t member) {
    return InstanceReader(context, part, scope, given).read(config, kind, outer, member);
}

void checkOverrides(ResolveContext& context, const Part& use, const Part& config, const OverrideNode& outside,
                    const std::vector<const Part*>& writers, std::set<const SourceAssignment*>& reported) {
    OverrideCheck(context, use, config, writers, reported).run(outside);
}

void nameInstance(ResolveContext& context, std::size_t first, const InstanceValues& given, const Part* instance,
                  const std::string& note) {
    if (context.diagnostics.all().size() == first || manyAlready(context.diagnostics)) return;
    for (std::size_t i = first; i < context.diagnostics.all().size(); ++i) {
        Diagnostic& d = context.diagnostics.at(i);
        if (moveToValue(context, d, given)) continue;
        if (instance && !inside(d.range, instance->range)) d.notes.push_back({note, instance->nameRange()});
    }
}

} // namespace trundle
