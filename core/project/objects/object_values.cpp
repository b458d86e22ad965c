#include "project/objects/object_values.h"

#include <algorithm>

#include "model/dotted_path.h"
#include "model/set_targets.h"
#include "project/objects/object_location.h"
#include "project/objects/value_text.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

bool isFormula(const Element& e) { return e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression; }

} // namespace

std::string FieldValue::element(std::size_t i) const {
    return i < elements.size() ? text.substr(elements[i].begin, elements[i].size()) : std::string();
}

std::string FieldValue::with(std::size_t i, const std::string& element) const {
    if (i < elements.size()) return text.substr(0, elements[i].begin) + element + text.substr(elements[i].end);
    std::string longer = text;
    for (std::size_t at = elements.size(); at <= i; ++at) {
        if (!longer.empty()) longer += separator;
        longer += at == i || elements.empty() ? element : this->element(elements.size() - 1);
    }
    return longer;
}

std::string FieldValue::before(std::size_t i) const {
    return i == 0 || elements.size() < i ? std::string() : text.substr(0, elements[i - 1].end);
}

ObjectValues::ObjectValues(std::shared_ptr<const LoadedProject> loaded, std::string path)
    : m_loaded(std::move(loaded)), m_path(path), m_shownPath(std::move(path)), m_evaluator(m_loaded->outline->texts(), m_silent) {
    m_globals = m_scope = inside(nullptr, m_loaded->outline->params);
    if (m_path.empty()) m_kind = m_loaded->registry->find("settings");
    else walk(DottedPath(m_path).words());
}

ParamScope* ObjectValues::inside(ParamScope* outer, const std::vector<SourceParam>& params) {
    ParamScope& scope = m_scopes.emplace_back(outer);
    scope.declare(params);
    return &scope;
}

void ObjectValues::walk(const std::vector<std::string>& words) {
    const Outline& outline = *m_loaded->outline;
    std::vector<std::string> longer = words;
    longer.emplace_back("x"); // a placeholder property: startOfPath() parses property paths
    PathStart start = startOfPath(outline, longer);
    if (!start.part) {
        start = {layoutOfMember(outline, words[0]), 1};
        m_member = start.part != nullptr;
        if (m_member) m_path.replace(0, words[0].size(), start.part->name); // edits apply to the whole Grid or Scatter
    }
    if (!start.part || start.words > words.size()) return;
    if (isPlaced(*start.part)) return enterInstance(words, start.words);
    if (start.part->is(Role::Config)) m_config = start.part;
    m_scope = inside(m_globals, start.part->params);
    descend(start.part, words, start.words);
}

void ObjectValues::enterInstance(const std::vector<std::string>& words, std::size_t used) {
    const Outline& outline = *m_loaded->outline;
    m_instance = m_member ? layoutOfMember(outline, words[0]) : outline.world.find(words[0]);
    m_instanceScope = m_scope = inside(m_globals, m_instance->params);
    m_config = configOf(*m_loaded, *m_instance);
    if (m_config) {
        m_configScope = inside(m_globals, m_config->params);
        for (const SourceAssignment& a : m_instance->assignments.all()) {
            if (a.path.size() != 1 || m_instance->kind->find(a.key) || !m_config->param(a.key)) continue;
            if (const auto given = m_evaluator.evaluate(*a.value, a.file, *m_instanceScope)) m_configScope->preset(a.key, *given);
        }
    }
    if (used == words.size() || m_instance->find(words[used])) return descend(m_instance, words, used);
    if (!m_config) return;
    m_inConfig = true;
    m_scope = m_configScope;
    for (std::size_t i = used; i < words.size(); ++i) m_within = pathInside(m_within, words[i]);
    descend(m_config, words, used);
}

void ObjectValues::descend(const Part* from, const std::vector<std::string>& words, std::size_t used) {
    for (; used < words.size(); ++used) {
        from = from->find(words[used]);
        if (!from) return;
        m_scope = inside(m_scope, from->params);
    }
    m_part = from;
    m_kind = from->kind;
}

std::string ObjectValues::below(std::string_view name) const { return pathInside(m_path, name); }

const std::string& ObjectValues::separator() {
    if (!m_separator.empty()) return m_separator;
    const FileId file = m_instance ? m_instance->file : m_part ? m_part->file : FileId{0};
    const auto& trees = m_loaded->trees;
    return m_separator = file < trees.size() ? separatorOf(*trees[file]) : ",";
}

std::vector<FieldValue> ObjectValues::properties() {
    std::vector<FieldValue> fields;
    if (!m_kind) return fields;
    for (const Property& p : m_kind->properties) fields.push_back(*property(p.name));
    return fields;
}

std::optional<FieldValue> ObjectValues::property(std::string_view name) {
    const Property* p = m_kind ? m_kind->find(name) : nullptr;
    if (!p) return std::nullopt;
    const AssignmentList& list = m_part ? m_part->assignments : m_loaded->outline->settings;
    return read(*p, below(name), &list, m_scope, m_inConfig ? m_within + "." + std::string(name) : std::string());
}

std::vector<FieldValue> ObjectValues::configProperties() {
    std::vector<FieldValue> fields;
    if (!isInstance() || !m_config || !m_config->kind) return fields;
    for (const Property& p : m_config->kind->properties)
        if (!m_kind->find(p.name)) fields.push_back(read(p, below(p.name), &m_config->assignments, m_configScope, p.name));
    return fields;
}

std::vector<FieldValue> ObjectValues::params(std::size_t most) {
    std::vector<FieldValue> fields;
    if (isInstance()) {
        for (const SourceParam& p : m_config ? m_config->params : std::vector<SourceParam>())
            if (fields.size() < most && !m_kind->find(p.name->text))
                fields.push_back(readParam(p, m_configScope, m_instance->assignments.find(p.name->text)));
        return fields;
    }
    if (m_inConfig || (m_part && !m_part->is(Role::Config))) return fields;
    for (const SourceParam& p : m_part ? m_part->params : m_loaded->outline->params)
        if (fields.size() < most && (!m_kind || !m_kind->find(p.name->text))) fields.push_back(readParam(p, m_scope, nullptr));
    return fields;
}

std::vector<std::string> ObjectValues::overrides() const {
    std::vector<std::string> paths;
    if (!isInstance()) return paths;
    for (const SourceAssignment& a : m_instance->assignments.all())
        if (a.path.size() > 1) paths.push_back(a.key);
    return paths;
}

FieldValue ObjectValues::read(const Property& property, const std::string& path, const AssignmentList* list, ParamScope* scope,
                              const std::string& overrideKey) {
    FieldValue field;
    field.path = path;
    field.property = &property;
    if (property.maxCount > 1) field.separator = separator();
    if (m_part) field.place = m_part->nameRange();
    const bool throughInstance = !overrideKey.empty();
    const SourceAssignment* over = throughInstance && m_instance ? m_instance->assignments.find(overrideKey) : nullptr;
    const SourceAssignment* a = list->find(property.name);
    if (over) {
        fill(field, {over->value, over->file, m_instanceScope, ValueOrigin::Override});
        fillInherited(field, a ? a->value : nullptr, a ? a->file : kNoFile);
    } else if (a) {
        fill(field, {a->value, a->file, scope, throughInstance ? ValueOrigin::Config : ValueOrigin::Own});
    }
    if (field.given() || !property.defaultValue) return field;
    field.value = property.defaultValue;
    for (const std::string& element : elementsOf(property, *property.defaultValue)) {
        if (!field.elements.empty()) field.text += field.separator;
        const auto begin = static_cast<std::uint32_t>(field.text.size());
        field.text += element;
        field.elements.push_back({begin, static_cast<std::uint32_t>(field.text.size())});
    }
    return field;
}

FieldValue ObjectValues::readParam(const SourceParam& param, ParamScope* scope, const SourceAssignment* own) {
    FieldValue field;
    field.path = below(param.name->text);
    if (own) {
        fill(field, {own->value, own->file, m_instanceScope, ValueOrigin::Override});
        fillInherited(field, param.value, param.valueFile);
    } else fill(field, {param.value, param.valueFile, scope, isInstance() ? ValueOrigin::Config : ValueOrigin::Own});
    return field;
}

void ObjectValues::fill(FieldValue& field, const ValueText& written) {
    const TextSet& texts = m_loaded->outline->texts();
    const std::uint32_t begin = written.value->range.begin;
    field.origin = texts.commandLine(written.file) ? ValueOrigin::CommandLine : written.origin;
    field.place = {written.file, written.value->range};
    field.isLong = written.value->range.end - begin > kMaxShownValue;
    if (field.isLong) return;
    field.text = texts.slice(field.place);
    for (const Element& e : written.value->elements) {
        field.elements.push_back({e.range.begin - begin, e.range.end - begin});
        field.formula = field.formula || isFormula(e);
    }
    field.broken = written.value->broken || m_evaluator.broken(field.place);
    const std::optional<GivenValue> given = m_evaluator.evaluate(*written.value, written.file, *written.scope);
    if (!given) return;
    if (field.property) field.value = readValue(*field.property, *given, m_silent);
    if (field.formula) showFormula(field, *given);
}

/// The value without the override: the text in the config, or the default.
void ObjectValues::fillInherited(FieldValue& field, const Value* value, FileId file) const {
    if (m_config) field.config = m_config->name;
    const Property* property = field.property;
    bool bare = true; // the numbers are written without units
    if (value && value->range.end - value->range.begin > kMaxShownValue) {
        field.inherited = "…";
        bare = false;
    } else if (value) {
        field.inherited = m_loaded->outline->texts().slice({file, value->range});
        bare = std::ranges::all_of(value->elements,
                                   [](const Element& e) { return e.kind == Element::Kind::Number && e.unit.empty(); });
    } else if (property && property->defaultValue) {
        field.inherited = joined(elementsOf(*property, *property->defaultValue), ",");
    }
    if (property && !property->unit.empty() && bare && !field.inherited.empty()) field.inherited += " " + property->unit;
}

void ObjectValues::showFormula(FieldValue& field, const GivenValue& given) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < given.elements.size(); ++i) {
        const GivenElement& e = given.elements[i];
        if (field.property && isNumeric(*field.property) && field.value && i < field.value->numbers.size())
            words.push_back(rounded(field.value->numbers[i] / field.property->scale));
        else if (e.kind == GivenElement::Kind::Number) words.push_back(rounded(e.number) + (e.unit.empty() ? "" : " " + e.unit));
        else words.push_back(elementText(e));
    }
    field.shown = joined(words, ", ");
    if (words.size() == field.elements.size()) field.parts = words;
}

} // namespace trundle
