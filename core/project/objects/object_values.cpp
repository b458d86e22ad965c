#include "project/objects/object_values.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "model/robot_path.h"
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
    : m_loaded(std::move(loaded)), m_path(path), m_shownPath(std::move(path)) {
    const Outline& outline = *m_loaded->outline;
    if (m_path.empty()) m_kind = m_loaded->registry->find("settings");
    if (const LayoutMember member = layoutMemberIn(outline, m_path); member.layout) {
        m_member = true;
        m_path = std::string(member.all()) + m_path.substr(member.name.size()); // edits apply to the whole Grid or Scatter
    }
    if (auto place = placeOf(*m_loaded, m_path)) m_place = std::move(*place);
    m_scopes = std::make_unique<PathScopes>(*m_loaded, m_place);
    m_part = m_place.part;
    if (!m_part) return;
    m_kind = m_part->kind;
    const Part& top = m_place.above.empty() ? *m_part : *m_place.above.front();
    m_inConfig = m_place.instance && m_part != m_place.instance && (&top != m_place.instance || isVariant(*m_place.instance));
    if (isInstance()) m_config = configOf(*m_loaded, *m_part);
    else if (m_place.instance) m_config = configOf(*m_loaded, *m_place.instance);
    else if (top.is(Role::Config)) m_config = &top;
}

const Part* ObjectValues::definedIn() const {
    const auto config = std::find_if(m_place.above.rbegin(), m_place.above.rend(), [](const Part* p) { return p->is(Role::Config); });
    return config == m_place.above.rend() ? nullptr : *config;
}

std::string ObjectValues::below(std::string_view name) const { return pathInside(m_path, name); }

const std::string& ObjectValues::separator() {
    if (!m_separator.empty()) return m_separator;
    const FileId file = m_place.instance ? m_place.instance->file : m_part ? m_part->file : FileId{0};
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
    return read(*p, below(name), m_part ? &m_part->assignments : &m_loaded->outline->settings, m_scopes->scope());
}

std::vector<FieldValue> ObjectValues::configProperties() {
    std::vector<FieldValue> fields;
    if (!isInstance() || !m_config || !m_config->kind) return fields;
    for (const Property& p : m_config->kind->properties)
        if (!m_kind->find(p.name)) fields.push_back(read(p, below(p.name), &m_config->assignments, m_scopes->configScope()));
    return fields;
}

std::vector<FieldValue> ObjectValues::params(std::size_t most) {
    std::vector<FieldValue> fields;
    const bool isDeclaredHere = isInstance() || (!m_inConfig && (!m_part || m_part->is(Role::Config)));
    if (!isDeclaredHere || (isInstance() && !m_config)) return fields;
    for (const SourceParam& p : isInstance() ? m_config->params : m_part ? m_part->params : m_loaded->outline->params)
        if (fields.size() < most && (!m_kind || !m_kind->find(p.name->text))) fields.push_back(readParam(p));
    return fields;
}

std::vector<std::string> ObjectValues::overrides() const {
    std::vector<std::string> paths;
    if (!isInstance()) return paths;
    for (const SourceAssignment& a : m_part->assignments.all())
        if (a.path.size() > 1) paths.push_back(a.key);
    return paths;
}

FieldValue ObjectValues::read(const Property& property, const std::string& path, const AssignmentList* list, ParamScope& scope) {
    FieldValue field;
    field.path = path;
    field.property = &property;
    if (property.maxCount > 1) field.separator = separator();
    if (m_part) field.place = m_part->nameRange();
    const bool isOfConfig = list != (m_part ? &m_part->assignments : &m_loaded->outline->settings);
    const std::vector<PathScopes::Override> all = m_scopes->overridesOf(property.name, isOfConfig);
    const SourceAssignment* a = list->find(property.name);
    if (!all.empty()) {
        // What an inner Part sets is the config's value for the outer instance.
        const PathScopes::Override& set = all.front();
        const bool isOurs = set.layer->instance == m_place.instance;
        fill(field, {set.assignment->value, set.assignment->file, set.layer->scope,
                     isOurs ? ValueOrigin::Override : ValueOrigin::Config});
        const std::string own = pathInside(m_place.within, property.name);
        if (isOurs && set.assignment->key != own) field.setForAll = set.assignment->key;
        const auto isOther = [&](const PathScopes::Override& other) { return other.layer != set.layer; };
        if (const auto next = std::ranges::find_if(all, isOther); next != all.end()) a = next->assignment; // an inner Part's
        fillInherited(field, *set.layer, a ? a->value : nullptr, a ? a->file : kNoFile);
    } else if (a) {
        fill(field, {a->value, a->file, &scope, m_inConfig || isOfConfig ? ValueOrigin::Config : ValueOrigin::Own});
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

FieldValue ObjectValues::readParam(const SourceParam& param) {
    FieldValue field;
    field.path = below(param.name->text);
    field.description = param.description.get();
    const auto set = isInstance() ? m_scopes->overrideOf(param.name->text, true) : std::nullopt;
    if (set) {
        const bool isOurs = set->layer->instance == m_place.instance;
        fill(field, {set->assignment->value, set->assignment->file, set->layer->scope,
                     isOurs ? ValueOrigin::Override : ValueOrigin::Config});
        fillInherited(field, *set->layer, param.value, param.valueFile);
    } else if (param.value->elements.empty() && param.required) { // every use must give it
        field.place = m_part ? m_part->nameRange() : param.nameRange();
    } else {
        ParamScope& scope = isInstance() ? m_scopes->configScope() : m_scopes->scope();
        fill(field, {param.value, param.valueFile, &scope, isInstance() ? ValueOrigin::Config : ValueOrigin::Own});
    }
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
    field.broken = written.value->broken || m_scopes->evaluator().broken(field.place);
    const std::optional<GivenValue> given = m_scopes->evaluator().evaluate(*written.value, written.file, *written.scope);
    if (!given) return;
    if (field.property) field.value = readValue(*field.property, *given, m_silent);
    if (field.formula) showFormula(field, *given);
}

/// The value without the override: the text in the config, or the default.
void ObjectValues::fillInherited(FieldValue& field, const PathScopes::Layer& from, const Value* value, FileId file) const {
    if (from.config) field.config = from.config->name;
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
