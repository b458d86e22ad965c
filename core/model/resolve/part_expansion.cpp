#include "model/resolve/part_expansion.h"

#include <algorithm>

#include "model/dotted_path.h"
#include "model/part_depth.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// A value that goes one Part further in: what was given through a Param keeps naming what it named.
std::shared_ptr<const GivenValue> passedIn(const GivenValue& value, bool alsoLiteral) {
    auto passed = std::make_shared<GivenValue>(value);
    for (GivenElement& e : passed->elements) e.level += alsoLiteral || !e.literal;
    return passed;
}

/// Lays overrides from outside over those of a Part.
void lay(const OverrideNode& outside, OverrideNode& own) {
    if (outside.value) {
        own.value = passedIn(*outside.value, false);
        own.origin = outside.origin;
    }
    for (const auto& [name, node] : outside.children) lay(node, own.children[name]);
}

/// An empty chain: no circle, but too deep.
void reportCircle(ResolveContext& context, SourceRange place, const std::string& chain) {
    if (chain.empty())
        context.diagnostics.error(Code::TooManyObjects, place,
                                  "PartConfigs are nested more than " + std::to_string(kDeepestParts) + " deep");
    else context.diagnostics.error(Code::WrongPlace, place, "PartConfigs contain each other in a circle: " + chain);
}

} // namespace

const Part* PartFrame::find(std::string_view name) const {
    const std::string_view first = firstWord(name);
    if (first != name)
        if (const auto it = inner.find(first); it != inner.end()) return it->second->find(withoutFirstWord(name));
    return config->findPath(name);
}

PartExpansion::PartExpansion(ResolveContext& context, const Part& config, ParamScope& scope, const OverrideNode* overrides)
    : m_context(context), m_isScenery(config.kind->name == "StaticConfig") {
    PartFrame& root = m_frames.emplace_back();
    root.config = &config;
    root.scope = &scope;
    root.overrides = overrides;
    root.isOpen = config.kind->name == "PartConfig";
    expand(root);
}

void PartExpansion::expand(PartFrame& frame) {
    for (const Part& part : frame.config->parts) {
        if (part.isPartUse()) {
            if (part.usable) expandUse(part, frame);
            continue;
        }
        if (m_parts.size() >= kMaxObjects && !m_isFull) {
            m_isFull = true;
            m_context.diagnostics.error(Code::TooManyObjects, m_frames.front().config->nameRange(),
                                        m_frames.front().config->title() + " would hold more than 200000 objects");
        }
        if (m_isFull) return;
        if (frame.use) checkContent(part, frame);
        m_parts.push_back({&part, &frame});
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
    if (outer.use) nameUses(first, outer);
    if (!frame.config) return;
    frame.prefix = outer.prefix + use.name + ".";
    if (isCircle(outer, *frame.config, record.rangeOf("Config", use.nameRange()))) return;
    OverrideNode& overrides = m_overrides.emplace_back();
    for (auto& [name, node] : frame.given.overrides.children) lay(node, overrides.children[name]);
    if (outside) lay(*outside, overrides);
    frame.overrides = &overrides;
    frame.scope = &m_scopes.emplace_back(&m_context.globals);
    frame.scope->declare(frame.config->params);
    if (!takeParams(frame, outside, *frame.scope) || !record.complete || outer.isOpen) return;
    frame.placement = PartPlacement(fieldsFrom<PartFields>(record));
    outer.inner.emplace(use.name, &frame);
    const std::size_t values = m_context.diagnostics.all().size();
    m_context.evaluator.checkAll(*frame.scope);
    nameUses(values, frame);
    expand(frame);
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
            std::shared_ptr<GivenValue> value = std::make_shared<GivenValue>(*passedIn(*node->value, true));
            value->fromParam = true;
            scope.preset(name, *value);
        } else if (own != frame.given.params.end()) {
            scope.preset(name, *passedIn(own->second, true));
        } else if (frame.use->assignments.find(name)) {
            good = false; // it is reported, or comes from outside of a PartConfig by itself
        } else if (param.required && param.value->elements.empty() && !m_context.brokenText(frame.use->range)) {
            Diagnostic& d = m_context.diagnostics.error(Code::MissingRequired, frame.use->nameRange(),
                                                        frame.use->title() + " needs " + name + ": what " +
                                                            frame.config->title() + " is joined to");
            d.notes.push_back({kUsedHere, param.nameRange()});
            const auto body = std::ranges::find_if(frame.outer->config->parts, [](const Part& p) { return p.is(Role::Body); });
            if (body != frame.outer->config->parts.end()) m_context.fixAdd(d, *frame.use, name, body->name);
            good = false;
        }
    }
    return good;
}

bool PartExpansion::isCircle(const PartFrame& outer, const Part& config, SourceRange place) {
    std::vector<const Part*> chain;
    for (const PartFrame* at = &outer; at; at = at->outer) chain.insert(chain.begin(), at->config);
    const auto begin = std::ranges::find(chain, &config);
    if (begin == chain.end() && chain.size() <= kDeepestParts) return false;
    std::string text;
    if (begin == chain.end()) {
        if (m_context.outline.partCircles().empty()) reportCircle(m_context, place, text); // by a Param
        return true;
    }
    for (auto it = begin; it != chain.end(); ++it) text += (*it)->name + " > ";
    if (m_context.outline.partCircles().empty()) reportCircle(m_context, place, text + config.name); // by a Param
    return true;
}

/// What a PartConfig has and the config that it is used in cannot have.
void PartExpansion::checkContent(const Part& part, const PartFrame& frame) {
    const std::size_t first = m_context.diagnostics.all().size();
    if (!part.usable) return;
    if (m_isScenery && !part.is(Role::Geom)) {
        m_context.diagnostics.error(Code::WrongPlace, part.typeRange(),
                                    "scenery holds geoms only: " + part.title() + " of " + frame.config->title() +
                                        " cannot be used in a StaticConfig");
    } else if (!m_isScenery && part.is(Role::Geom)) {
        m_context.diagnostics.error(Code::WrongPlace, part.typeRange(),
                                    part.title() + " of " + frame.config->title() +
                                        " has no Body: without one it can be used in a StaticConfig only");
    }
    nameUses(first, frame);
}

void PartExpansion::nameUses(std::size_t first, const PartFrame& frame) {
    if (m_context.diagnostics.all().size() == first) return;
    for (const PartFrame* at = &frame; at->use; at = at->outer)
        nameInstance(m_context, first, at->given, *at->use, "used here by " + at->use->title());
}

double ConfigSizes::of(const Part& config) {
    const auto [it, isNew] = m_known.try_emplace(&config, 1); // of a circle, what is known so far
    if (!isNew) return it->second;
    const double size = count(config);
    return m_known[&config] = size;
}

double ConfigSizes::count(const Part& part) {
    double size = 1;
    for (const Part& inner : part.parts) size += inner.config ? 1 + of(*inner.config) : count(inner);
    return size;
}

void reportPartCircles(ResolveContext& context) {
    for (const Outline::PartCircle& circle : context.outline.partCircles())
        reportCircle(context, circle.use->assignments.find("Config")->valueRange(), circle.chain);
}

} // namespace trundle
