#include "model/resolve/part_expansion.h"

#include <algorithm>

#include "base/spelling.h"
#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/param_reference.h"
#include "model/part_depth.h"
#include "model/repeat.h"
#include "model/resolve/config_sizes.h"
#include "model/resolve/part_messages.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// A value that goes one Part further in: a name in it keeps naming what it named where it was written.
std::shared_ptr<const GivenValue> passedIn(const GivenValue& value) {
    auto passed = std::make_shared<GivenValue>(value);
    for (GivenElement& e : passed->elements) ++e.level;
    return passed;
}

/// Lays overrides from outside over those of a Part.
void lay(const OverrideNode& outside, OverrideNode& own) {
    if (outside.word.known()) own.word = outside.word;
    if (outside.value) {
        own.takeValueOf(outside);
        own.value = passedIn(*outside.value);
    }
    for (const auto& [name, node] : outside.children) lay(node, own.children[name]);
}

/// Lays the overrides of one member of a Repeat over those of all.
void layMember(const OverrideNode& member, OverrideNode& all) {
    if (member.word.known()) all.word = member.word;
    if (member.value) all.takeValueOf(member);
    for (const auto& [name, node] : member.children) layMember(node, all.children[name]);
}

const GivenValue* firstValue(const OverrideNode& node) {
    if (node.value) return node.value.get();
    for (const auto& [name, inner] : node.children)
        if (const GivenValue* value = firstValue(inner)) return value;
    return nullptr;
}

} // namespace

PartExpansion::PartExpansion(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides)
    : m_context(context), m_isScenery(config.kind->name == "StaticConfig") {
    PartFrame& root = m_frames.emplace_back();
    root.config = &config;
    root.scope = &scope;
    root.overrides = withVariants(config, scope, overrides);
    root.isOpen = config.kind->name == "PartConfig";
    expand(root);
    placeFrames();
}

PartExpansion::PartExpansion(ResolveContext& context) : m_context(context), m_isScenery(true) {
    PartFrame& root = m_frames.emplace_back();
    root.scope = &context.globals;
    for (const Part* part : context.outline.world.all())
        if (!isFull()) add(root, *part);
    placeFrames();
}

/// The blocks of a config; of a variant first those of what it is a variant of, as if they were written in it.
void PartExpansion::expand(PartFrame& frame, const Part& holder) {
    if (holder.config && holder.is(Role::Config)) expand(frame, *holder.config);
    for (const Part& part : holder.parts) {
        if (isFull()) return;
        if (!clashes(part, holder)) add(frame, part);
    }
}

void PartExpansion::add(PartFrame& frame, const Part& part) {
    if (part.isPartUse() || part.isRepeat()) {
        if (part.usable) part.isRepeat() ? expandRepeat(part, frame) : expandUse(part, frame);
        return;
    }
    if (frame.holder().use) checkContent(part, frame.holder());
    m_parts.push_back({&part, &frame});
}

static void reportTaken(ResolveContext& context, SourceRange name, std::string message, SourceRange by) {
    Diagnostic& d = context.diagnostics.error(Code::DuplicateName, name, std::move(message));
    d.notes.emplace_back("first defined here", by);
}

/// Whether a variant has a block with a name that is taken in what it is a variant of; reports it.
bool PartExpansion::clashes(const Part& part, const Part& holder) {
    if (!holder.config || part.name.empty()) return false;
    const Part* taken = holder.config->find(part.name);
    if (const SourceParam* param = taken ? nullptr : holder.config->param(part.name); param && part.kind) {
        reportTaken(m_context, part.nameRange(), holder.config->title() + " has a Param " + part.name + " already",
                    param->nameRange());
        return true;
    }
    if (!taken) return false;
    if (!part.kind) return true; // reported at its block
    reportTaken(m_context, part.nameRange(),
                holder.config->title() + " has " + taken->title() + " already; set its values by path, " + part.name + ". ...",
                taken->nameRange());
    return true;
}

/// The overrides of a frame: those that variants make in what they are variants of, and over them those from outside.
const OverrideNode* PartExpansion::withVariants(const Part& config, ParamScope& scope, const OverrideNode* outside) {
    if (!config.config) return outside;
    OverrideNode& all = m_overrides.emplace_back();
    addVariant(config, scope, all);
    if (outside) layMember(*outside, all);
    return &all;
}

void PartExpansion::addVariant(const Part& config, ParamScope& scope, OverrideNode& overrides) {
    if (!config.config) return;
    addVariant(*config.config, scope, overrides);
    InstanceValues given;
    const Part* base = nullptr;
    (void)readInstance(m_context, config, scope, given, base, config.kind->name);
    for (const auto& [name, node] : given.overrides.children) layMember(node, overrides.children[name]);
    for (const SourceParam& param : config.params) { // those of the base are among them, unless they have been declared again
        const SourceParam* taken = config.config->param(param.name->text);
        const Part* block = taken ? nullptr : config.config->find(param.name->text);
        const std::string base = config.config->title() + " has ";
        if (block) reportTaken(m_context, param.nameRange(), base + block->title() + " already", block->nameRange());
        if (!taken || taken->name == param.name) continue;
        reportTaken(m_context, param.nameRange(),
                    base + "a Param " + param.name->text + " already; set its value: " + param.name->text + "=...",
                    taken->nameRange());
    }
}

Record readConfig(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides) {
    if (!config.assignments.find("Config")) return context.read(config, scope, overrides, Origin::Config);
    InstanceValues given;
    const Part* base = nullptr;
    Record record = readInstance(context, config, scope, given, base, config.kind->name, overrides);
    if (!config.config) return record;
    const Record inherited = readConfig(context, *config.config, scope, overrides);
    for (std::size_t i = 0; i < record.values.size(); ++i)
        if (!record.values[i] || record.values[i]->origin == Origin::Default) record.values[i] = inherited.values[i];
    return record;
}

bool PartExpansion::isFull() {
    if (m_isFull || std::max(m_parts.size(), m_frames.size()) <= kMaxObjects) return m_isFull;
    if (const Part* config = m_frames.front().config) {
        Diagnostic& d = m_context.diagnostics.error(Code::TooManyObjects, config->nameRange(),
                                                    config->title() + " would hold more than 200000 objects");
        noteCount(d, outermostRepeat(m_frames.back()));
    } else {
        m_context.diagnostics.error(Code::TooManyObjects, m_frames.back().use->nameRange(),
                                    "with " + m_frames.back().use->title() + " the world would hold more than 200000 objects");
    }
    return m_isFull = true;
}

void PartExpansion::expandRepeat(const Part& repeat, PartFrame& outer) {
    const OverrideNode* outside = below(outer.overrides, repeat.name);
    const OverrideNode* set = below(outside, "Count");
    ParamScope own(outer.scope);
    own.declare(repeat.params);
    const std::size_t first = m_context.diagnostics.all().size();
    const std::vector<double> counts =
        countsOf(repeat, m_context.evaluator, own, set ? set->value.get() : nullptr, m_context.diagnostics);
    nameUses(first, outer);
    const std::size_t count = memberCount(counts);
    checkMembers(repeat, outer, count);
    if (count == 0) (void)expandMember(repeat, outer, 0, {}); // for its diagnostics
    std::size_t member = 0;
    while (member < count && !isFull() && expandMember(repeat, outer, member, counts)) ++member;
    if (count == 0 || member < count) outer.unfinished.insert(repeat.name);
}

/// False, with diagnostics, if the values of the Repeat are not complete.
bool PartExpansion::expandMember(const Part& repeat, PartFrame& outer, std::size_t member, const std::vector<double>& counts) {
    const std::size_t first = m_context.diagnostics.all().size();
    PartFrame& frame = m_frames.emplace_back();
    frame.config = frame.use = &repeat;
    frame.outer = &outer;
    frame.member = member;
    frame.isOpen = outer.isOpen;
    const std::string name = repeat.name + "_" + std::to_string(member);
    frame.prefix = outer.prefix + name + ".";
    ParamScope& numbers = m_scopes.emplace_back(outer.scope);
    setIndex(numbers, member, counts);
    frame.scope = &m_scopes.emplace_back(&numbers);
    frame.scope->declare(repeat.params);
    frame.overrides = below(outer.overrides, repeat.name);
    if (const OverrideNode* one = below(outer.overrides, name)) {
        OverrideNode& both = m_overrides.emplace_back();
        if (frame.overrides) both = *frame.overrides;
        layMember(*one, both);
        frame.overrides = &both;
    }
    if (counts.empty() && (repeat.assignments.find("Count") || below(frame.overrides, "Count"))) { // it is reported already
        OverrideNode& counted = m_overrides.emplace_back();
        if (frame.overrides) counted = *frame.overrides;
        GivenElement one;
        one.kind = GivenElement::Kind::Number;
        one.number = 1;
        counted.children["Count"].value = std::make_shared<const GivenValue>(GivenValue{{one}, {}, false});
        frame.overrides = &counted;
    }
    m_context.evaluator.checkAll(*frame.scope);
    const Record record = m_context.read(repeat, *frame.scope, frame.overrides, Origin::Config);
    const bool isRing = repeat.kind->name == "Ring";
    const RingFields ring = isRing && record.complete ? fieldsFrom<RingFields>(record) : RingFields{};
    const bool hasAxis = Vec3(ring.axis.data()).norm() > 1e-9;
    if (!hasAxis)
        m_context.diagnostics.error(Code::BadJoint, record.rangeOf("Axis", repeat.nameRange()),
                                    "the Axis of " + repeat.title() + " is zero, it has no direction");
    nameUses(first, frame);
    if (!record.complete || counts.empty() || !hasAxis) return false;
    placeLater(frame, record);
    if (isRing) frame.placement = PartPlacement(memberPose(ring, member));
    else {
        const RepeatFields f = fieldsFrom<RepeatFields>(record);
        frame.placement = PartPlacement(poseOf(f.pos, f.hpr));
    }
    outer.inner.emplace(name, &frame);
    expand(frame);
    return true;
}

/// Reports overrides of members that there are not.
void PartExpansion::checkMembers(const Part& repeat, const PartFrame& outer, std::size_t count) {
    if (!outer.overrides || count == 0) return;
    for (auto it = outer.overrides->children.lower_bound(repeat.name + "_"); it != outer.overrides->children.end(); ++it) {
        const std::optional<MemberName> member = memberName(it->first);
        if (!it->first.starts_with(repeat.name + "_")) break;
        if (const OverrideNode* own = below(&it->second, "Count"); own && own->value && member && member->stem == repeat.name)
            m_context.diagnostics.error(Code::NoSuchPath, own->value->range,
                                        "one member of " + repeat.title() + " has no Count; set " + repeat.name + ".Count");
        const GivenValue* value =
            member && member->stem == repeat.name && member->index >= count ? firstValue(it->second) : nullptr;
        if (!value) continue;
        const std::string last = repeat.name + "_" + std::to_string(count - 1);
        const SourceRange word = it->second.word;
        Diagnostic& d = m_context.diagnostics.error(Code::NoSuchPath, word.known() ? word : value->range,
                                                    repeat.title() + " has no member " + it->first + "; the last one is " + last);
        if (word.known()) suggestWords(d, {last}, word);
    }
}

void PartExpansion::expandUse(const Part& use, PartFrame& outer) {
    const std::size_t first = m_context.diagnostics.all().size();
    PartFrame& frame = m_frames.emplace_back();
    frame.use = &use;
    frame.outer = &outer;
    const OverrideNode* outside = below(outer.overrides, use.name);
    ParamScope& own = m_scopes.emplace_back(outer.scope);
    own.declare(use.params);
    m_context.evaluator.checkAll(own);
    const Record record = readInstance(m_context, use, own, frame.given, frame.config, "PartConfig", outside);
    if (frame.config && outside && m_context.outline.hasVaryingConfig(use))
        checkOverrides(m_context, use, *frame.config, *outside, outer.writers(), m_astray);
    if (outer.use) nameUses(first, outer);
    if (!frame.config) return;
    placeLater(frame, record);
    frame.prefix = outer.prefix + use.name + ".";
    if (isCircle(frame, record.rangeOf("Config", use.nameRange()))) return;
    OverrideNode& overrides = m_overrides.emplace_back();
    for (auto& [name, node] : frame.given.overrides.children) lay(node, overrides.children[name]);
    if (outside) lay(*outside, overrides);
    frame.scope = &m_scopes.emplace_back(&m_context.globals);
    frame.scope->declare(frame.config->params);
    if (!takeParams(frame, outside, *frame.scope) || !record.complete || outer.isOpen) return;
    frame.overrides = withVariants(*frame.config, *frame.scope, &overrides);
    frame.placement = PartPlacement(fieldsFrom<PartFields>(record));
    outer.inner.emplace(use.name, &frame);
    const std::size_t values = m_context.diagnostics.all().size();
    m_context.evaluator.checkAll(*frame.scope);
    nameUses(values, frame);
    expand(frame);
}

/// Its In may name what is further down in the text.
void PartExpansion::placeLater(PartFrame& frame, const Record& record) {
    if (const ResolvedValue* in = record.find("In"); in && !in->value.texts.empty()) m_toPlace.emplace_back(&frame, record);
}

void PartExpansion::placeFrames() {
    std::set<const Part*> failed; // the other members of a Repeat would repeat it
    for (auto& [frame, record] : m_toPlace) {
        const std::size_t first = m_context.diagnostics.all().size();
        if (failed.contains(frame->use) || takeIn(m_context, *frame, record)) continue;
        failed.insert(frame->use);
        nameUses(first, frame->member ? *frame : *frame->outer);
    }
    m_toPlace.clear();
}

/// The body that a Part or Repeat is placed from. False, with a diagnostic, if it names none.
bool PartExpansion::takeIn(ResolveContext& context, PartFrame& frame, const Record& record) {
    const PartFrame* root = &frame;
    while (root->outer) root = root->outer;
    if (const ResolvedValue* in = record.find("In"); root->config && root->config->is(Role::Body) && in && !in->value.texts.empty()) {
        context.diagnostics.error(Code::WrongPlace, in->range,
                                  "In has no meaning in a Body: its geoms are described in " + root->config->title() + " itself");
        return false;
    }
    const std::optional<std::string> in = bodyOfIn(context, record, *frame.outer, frame.use->name);
    if (!in) return false;
    frame.in = *in;
    frame.inRange = record.rangeOf("In", frame.use->nameRange());
    return true;
}

/// The Params of a part, from its use and from overrides outside of that. False, with a diagnostic, if one is missing.
bool PartExpansion::takeParams(PartFrame& frame, const OverrideNode* outside, ParamScope& scope) {
    bool good = true;
    for (const SourceParam& param : frame.config->params) {
        const std::string& name = param.name->text;
        if (frame.use->kind->find(name)) continue;
        const OverrideNode* node = below(outside, name);
        const auto own = std::ranges::find_if(frame.given.params, [&](const auto& given) { return given.first == name; });
        if (node && node->value) {
            std::shared_ptr<GivenValue> value = std::make_shared<GivenValue>(*passedIn(*node->value));
            value->fromParam = true;
            scope.preset(name, *value);
        } else if (own != frame.given.params.end()) {
            scope.preset(name, *passedIn(own->second));
        } else if (frame.use->assignments.find(name)) {
            good = false; // it is reported, or comes from outside of a PartConfig by itself
        } else if (param.required && param.value->elements.empty() && !m_context.brokenText(frame.use->range)) {
            if (!isMisspelt(*frame.use, *frame.config, name)) reportMissing(m_context, frame, outside, param);
            good = false;
        }
    }
    return good;
}

bool PartExpansion::isCircle(const PartFrame& frame, SourceRange place) {
    std::vector<const Part*> chain;
    for (const PartFrame* at = frame.outer; at; at = at->outer)
        if (!at->member) chain.insert(chain.begin(), at->config);
    const auto begin = std::ranges::find(chain, frame.config);
    if (begin == chain.end() && chain.size() <= kDeepestParts) return false;
    std::string text;
    if (begin == chain.end()) {
        if (m_context.outline.partCircles().empty()) reportCircle(m_context, *frame.use, place, text); // by a Param
        return true;
    }
    for (auto it = begin; it != chain.end(); ++it) text += (*it)->name + " > ";
    if (m_context.outline.partCircles().empty())
        reportCircle(m_context, *frame.use, place, text + frame.config->name); // by a Param
    return true;
}

/// Geoms without a body, which a PartConfig may have and a RobotConfig that it is used in cannot.
void PartExpansion::checkContent(const Part& part, const PartFrame& frame) {
    const std::size_t first = m_context.diagnostics.all().size();
    if (!part.usable) return;
    if (!m_isScenery && part.is(Role::Geom)) {
        m_context.diagnostics.error(Code::WrongPlace, part.typeRange(),
                                    part.title() + " of " + frame.config->title() +
                                        " has no Body: without one it can be used in a StaticConfig only");
    }
    nameUses(first, frame);
}

void PartExpansion::nameUses(std::size_t first, const PartFrame& frame) {
    if (m_context.diagnostics.all().size() == first) return;
    for (const PartFrame* at = &frame; at->use; at = at->outer) {
        if (!at->member) {
            for (std::size_t i = first; i < m_context.diagnostics.all().size(); ++i)
                adviseToDeclare(m_context, m_context.diagnostics.at(i), *at);
            nameInstance(m_context, first, at->given, at->use, "used here by " + at->use->title());
            continue;
        }
        for (std::size_t i = first; i < m_context.diagnostics.all().size(); ++i)
            nameMember(m_context, m_context.diagnostics.at(i), *at->use, *at->member);
    }
}

} // namespace trundle
