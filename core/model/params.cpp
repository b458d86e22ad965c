#include "model/params.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>
#include <utility>

#include "base/units.h"
#include "model/literals.h"
#include "model/outline.h"
#include "schema/registry.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr std::size_t kLongestChain = 100;   ///< nesting depth of Params that use each other; limits the stack
constexpr std::size_t kMaxElements = 100000; ///< nested lists could grow exponentially

/// `element(list, number)`.
bool isPick(const Expression& e) {
    return e.op == Expression::Op::Call && e.name == "element" && e.arguments.size() == 2 &&
           e.arguments[0].op == Expression::Op::Name;
}

/// The Param that an expression names: itself, or of which it takes an element.
const std::string& nameIn(const Expression& e) { return isPick(e) ? e.arguments[0].name : e.name; }

void warnIfTaken(const SourceParam& param, Diagnostics& diagnostics) {
    const std::string& name = param.name->text;
    const auto warn = [&](const std::string& what) {
        diagnostics.warning(Code::DuplicateName, param.nameRange(), "the name " + name + " is taken by " + what);
    };
    if (name == "pi") warn("the number pi, which this Param replaces in $( )");
    else if (std::ranges::find(functionNames(), name) != functionNames().end()) warn("a function of $( ), " + name + "(...)");
}

} // namespace

void ParamScope::declare(const std::vector<SourceParam>& params) {
    for (const SourceParam& p : params) m_entries.try_emplace(p.name->text, Entry{p, this, State::Fresh, {}, false, false});
}

void ParamScope::preset(const std::string& name, const GivenValue& value) {
    const auto it = m_entries.find(name);
    if (it == m_entries.end()) return;
    it->second.state = State::Preset;
    it->second.isPreset = true;
    it->second.value = value;
}

void ParamScope::set(const std::string& name, double number) {
    GivenElement element;
    element.kind = GivenElement::Kind::Number;
    element.number = number;
    Entry entry{{}, this, State::Done, {}, false, false};
    entry.value.elements.push_back(element);
    m_entries.insert_or_assign(name, std::move(entry));
}

bool ParamScope::isUsed(const std::string& name) const {
    const auto it = m_entries.find(name);
    return it != m_entries.end() && it->second.isUsed;
}

ParamScope::Entry* ParamScope::find(std::string_view name) {
    for (ParamScope* scope = this; scope; scope = scope->m_outer) {
        const auto it = scope->m_entries.find(name);
        if (it != scope->m_entries.end()) return &it->second;
    }
    return nullptr;
}

std::size_t ParamScope::count() const {
    std::size_t count = 0;
    for (const ParamScope* scope = this; scope; scope = scope->m_outer) count += scope->m_entries.size();
    return count;
}

std::vector<std::string> ParamScope::names() const {
    std::vector<std::string> names;
    std::unordered_set<std::string_view> seen; // a name may hide the same one further out
    for (const ParamScope* scope = this; scope; scope = scope->m_outer) {
        for (const auto& [name, entry] : scope->m_entries)
            if (seen.insert(name).second) names.push_back(name);
    }
    return names;
}

bool Evaluator::broken(const SourceRange& range) {
    if (!range.known()) return false;
    const auto [it, fresh] = m_broken.try_emplace(range.file);
    std::vector<std::uint32_t>& places = it->second;
    if (fresh) {
        for (const Diagnostic& d : m_texts.trees[range.file]->diagnostics()) {
            if (d.severity == Severity::Error) places.push_back(d.range.range.begin);
        }
        std::sort(places.begin(), places.end());
    }
    const auto first = std::lower_bound(places.begin(), places.end(), range.range.begin);
    return first != places.end() && *first <= range.range.end;
}

std::optional<GivenValue> Evaluator::evaluate(const Value& value, FileId file, ParamScope& scope) {
    if (broken({file, value.range})) return std::nullopt; // contains syntax errors: the parsed part may be incomplete
    GivenValue out;
    out.range = {file, value.range};
    out.elements.reserve(value.elements.size());
    bool good = true;
    for (const Element& element : value.elements) good = addElement(element, file, scope, out) && good;
    if (!good || out.elements.empty()) return std::nullopt; // the parser has reported a missing value
    return out;
}

void Evaluator::checkAll(ParamScope& scope) {
    for (auto& [name, entry] : scope.m_entries) {
        if (!entry.param.name) continue;
        warnIfTaken(entry.param, m_diagnostics);
        (void)paramValue(name, {entry.param.file, entry.param.name->range}, scope);
    }
}

bool Evaluator::addElement(const Element& element, FileId file, ParamScope& scope, GivenValue& out) {
    if (element.kind == Element::Kind::ParamRef) return addParam(element.text, {file, element.range}, scope, out);
    GivenElement given = literalOf(element, file);
    if (element.kind == Element::Kind::Expression) {
        if (!element.expression) return false; // reported by the parser
        const SourceRange outer = std::exchange(m_source, {});
        const Expression* held = this->held(*element.expression, file, scope);
        if (held && isPick(*held) && scope.find(held->arguments[0].name)) {
            m_source = outer;
            return addPicked(*held, file, scope, given.range, out);
        }
        if (held && isText(*held, file, scope)) {
            m_source = outer;
            return addParam(held->name, given.range, scope, out);
        }
        const std::optional<Amount> result = held ? amount(*held, file, scope) : std::nullopt;
        given.source = std::exchange(m_source, outer);
        if (!result) return false;
        out.fromParam = true;
        given.kind = GivenElement::Kind::Number;
        given.number = result->value;
        given.unit = result->unit;
        given.literal = false;
    }
    out.elements.push_back(std::move(given));
    return true;
}

/// `$(element(colours, index))`: of whatever type it is.
bool Evaluator::addPicked(const Expression& e, FileId file, ParamScope& scope, SourceRange place, GivenValue& out) {
    const GivenElement* picked = this->picked(e, file, scope);
    if (!picked) return false;
    GivenElement given = *picked;
    if (!given.source.known()) given.source = given.range;
    given.range = place;
    given.unitRange = {};
    given.literal = false;
    out.fromParam = true;
    out.elements.push_back(std::move(given));
    return true;
}

/// The element of a Param that `element(list, number)` names; nullptr, with a diagnostic, if the list is shorter.
const GivenElement* Evaluator::picked(const Expression& e, FileId file, ParamScope& scope) {
    const GivenValue* list = paramValue(e.arguments[0].name, {file, e.arguments[0].range}, scope);
    const std::optional<Amount> at = amount(e.arguments[1], file, scope);
    if (!list || !at) return nullptr;
    const auto size = static_cast<double>(list->elements.size());
    if (at->unit.empty() && at->value == std::floor(at->value) && at->value >= 0 && at->value < size)
        return &list->elements[static_cast<std::size_t>(at->value)];
    (void)fault(e.arguments[1], file,
                "Param " + e.arguments[0].name + " has the elements 0 to " + numberText(size - 1) + ", not " +
                    numberText(at->value) + (at->unit.empty() ? "" : " " + at->unit));
    return nullptr;
}

/// All elements of a Param, which may be a list.
bool Evaluator::addParam(std::string_view name, SourceRange place, ParamScope& scope, GivenValue& out) {
    const GivenValue* value = paramValue(name, place, scope);
    if (!value) return false;
    out.fromParam = true;
    if (out.elements.size() + value->elements.size() > kMaxElements) {
        m_diagnostics.error(Code::WrongCount, place, "the list grows beyond 100000 elements");
        return false;
    }
    for (GivenElement e : value->elements) {
        if (!e.source.known()) e.source = e.range;
        e.range = place;
        e.unitRange = {};
        e.literal = false;
        out.elements.push_back(std::move(e));
    }
    return true;
}

const GivenValue* Evaluator::paramValue(std::string_view name, SourceRange place, ParamScope& scope) {
    ParamScope::Entry* entry = scope.find(name);
    if (!entry) {
        unknown(name, place, scope);
        return nullptr;
    }
    using State = ParamScope::State;
    entry->isUsed = true;
    if (entry->state == State::Busy) {
        circle(*entry);
        return nullptr;
    }
    if (entry->state == State::Fresh || entry->state == State::Preset) finish(*entry);
    return entry->state == State::Done ? &entry->value : nullptr;
}

/// Evaluates a Param, and compares its value with what is said about it.
void Evaluator::finish(ParamScope::Entry& entry) {
    using State = ParamScope::State;
    std::optional<GivenValue> value;
    if (entry.state == State::Preset) value = std::move(entry.value);
    entry.state = State::Busy;
    m_chain.push_back(&entry);
    if (m_chain.size() > kLongestChain) {
        m_diagnostics.error(Code::ParamCycle, entry.param.nameRange(), "more than 100 Params need each other in a row");
        value.reset();
    } else if (!value) {
        value = evaluate(*entry.param.value, entry.param.valueFile, *entry.scope);
        if (value && !checkUnits(*value)) value.reset();
    }
    m_chain.pop_back();
    const ParamDescription* description = entry.param.description.get();
    if (value && description && !checkValue(*description, *value, m_diagnostics)) value.reset();
    entry.state = value && entry.state != State::Failed ? State::Done : State::Failed;
    if (value) entry.value = std::move(*value);
}

bool Evaluator::checkUnits(const GivenValue& value) {
    if (!m_registry) return true;
    const auto isKnown = [this](const std::string& unit) {
        if (exponentsOf(unit) || findUnit(unit)) return true;
        return std::ranges::any_of(m_registry->all(), [&](const Kind* kind) {
            return std::ranges::any_of(kind->properties, [&](const Property& property) { return property.unit == unit; });
        });
    };
    for (const GivenElement& e : value.elements) {
        if (!e.unitRange.known() || isKnown(e.unit)) continue; // reported where the unit is written
        Diagnostic& d = m_diagnostics.error(Code::UnknownUnit, e.unitRange, "there is no unit " + e.unit);
        suggest(d, e.unit, allUnitNames(), e.unitRange);
        return false;
    }
    return true;
}

void Evaluator::unknown(std::string_view name, SourceRange place, ParamScope& scope) {
    std::string message = "there is no Param " + std::string(name);
    if (name == "index") message += " here; it is there in a Repeat or Ring, not in its Count, and in the values of a Grid or Scatter; a part gets it by a Param";
    if (name == "index2") message += "; it is there in a Repeat or Grid with two numbers, Count=5,2";
    // excludes the `$` of `$name` from the range
    const std::string_view text = m_texts.slice(place);
    if (text.size() == name.size() + 1 && text.front() == '$') ++place.range.begin;
    if (const std::size_t at = text.find(name); text.starts_with("$(") && at != std::string_view::npos) { // the name alone
        place.range.begin += static_cast<std::uint32_t>(at);
        place.range.end = place.range.begin + static_cast<std::uint32_t>(name.size());
    }
    Diagnostic& d = m_diagnostics.error(Code::UnknownParam, place, std::move(message));
    if (name == "index" || name == "index2") return; // no other word is meant
    constexpr std::size_t kMany = 1000, kFirst = 20; // with many Params, suggestions for each error would take minutes
    if (manyAlready(m_diagnostics) || (scope.count() > kMany && m_diagnostics.all().size() > kFirst)) return;
    std::vector<std::string> names = scope.names();
    if (name == "PI" || name == "Pi") names.emplace_back("pi");
    suggest(d, name, names, place);
    if (d.suggestions.empty() && !names.empty())
        d.message += (names.size() == 1 ? "; there is " : "; there are ") + listText(names, "and");
}

void Evaluator::circle(const ParamScope::Entry& entry) {
    std::string chain;
    bool inside = false;
    const ParamScope::Entry* closing = nullptr; // the value from outside, without which there were no circle
    for (ParamScope::Entry* e : m_chain) {
        inside = inside || e == &entry;
        if (!inside) continue;
        chain += e->param.name->text + " > ";
        e->state = ParamScope::State::Failed;
        if (e->isFromOutside() && e->param.value) closing = e;
    }
    const std::string message = "Params need each other in a circle: " + chain + entry.param.name->text;
    if (!closing) {
        m_diagnostics.error(Code::ParamCycle, entry.param.nameRange(), message);
        return;
    }
    Diagnostic& d = m_diagnostics.error(Code::ParamCycle, {closing->param.valueFile, closing->param.value->range}, message);
    d.notes.emplace_back("the Param is declared here", closing->param.nameRange());
}

std::optional<Amount> Evaluator::fault(const Expression& e, FileId file, std::string message) {
    Diagnostic& d = m_diagnostics.error(Code::ExpressionValue, {file, e.range}, std::move(message));
    if (m_source.known()) d.notes.push_back({kGivenHere, m_source});
    return std::nullopt;
}

std::optional<Amount> Evaluator::paramAmount(const Expression& e, FileId file, ParamScope& scope) {
    const GivenValue* value = nullptr;
    if (e.name == "pi" && !scope.find("pi")) return Amount{std::numbers::pi, {}};
    value = paramValue(e.name, {file, e.range}, scope);
    if (!value) return std::nullopt;
    if (!m_source.known() && !value->elements.empty()) {
        const GivenElement& first = value->elements[0];
        m_source = first.source.known() ? first.source : scope.find(e.name)->isFromOutside() ? first.range : SourceRange();
    }
    if (value->elements.size() != 1)
        return fault(e, file,
                     "Param " + e.name + " is a list of " + std::to_string(value->elements.size()) +
                         ", an expression takes numbers");
    return numberOf(value->elements[0], e, file);
}

/// An element of the Param that an expression uses, as a number.
std::optional<Amount> Evaluator::numberOf(const GivenElement& element, const Expression& e, FileId file) {
    if (element.kind != GivenElement::Kind::Number)
        return fault(e, file, "Param " + nameIn(e) + " is " + elementText(element) + ", an expression takes numbers");
    if (!findUnit(element.unit) && !exponentsOf(element.unit))
        return fault(e, file, "Param " + nameIn(e) + " is " + elementText(element) + ": there is no unit " + element.unit);
    return inBaseUnit(element.number, element.unit);
}

std::optional<Amount> Evaluator::amount(const Expression& e, FileId file, ParamScope& scope) {
    using Op = Expression::Op;
    if (e.op == Op::Number) return inBaseUnit(e.number, e.name);
    if (e.op == Op::Name) return paramAmount(e, file, scope);
    if (e.op == Op::Call) return call(e, file, scope);
    if (e.arguments.empty() || (e.op != Op::Negate && e.arguments.size() < 2)) return std::nullopt; // reported by the parser
    std::optional<Amount> a = amount(e.arguments[0], file, scope);
    if (e.op == Op::Negate) {
        if (a) a->value = -a->value;
        return a;
    }
    const std::optional<Amount> b = amount(e.arguments[1], file, scope);
    if (!a || !b) return std::nullopt;
    return orFault(combined(e.op, *a, *b), e, file);
}

std::optional<Amount> Evaluator::orFault(Result<Amount> computed, const Expression& e, FileId file) {
    return computed.ok() ? std::optional(std::move(computed.value())) : fault(e, file, computed.error().message);
}

/// Whether there are all Params that an expression names.
bool Evaluator::hasNames(const Expression& e, FileId file, ParamScope& scope) {
    if (e.op == Expression::Op::Name && e.name != "pi" && !scope.find(e.name)) {
        unknown(e.name, {file, e.range}, scope);
        return false;
    }
    return std::ranges::all_of(e.arguments, [&](const Expression& argument) { return hasNames(argument, file, scope); });
}

/// Of an `if` the branch that holds; the other one is not evaluated, it may divide by zero. nullptr, with a diagnostic, if the condition
/// has no value.
const Expression* Evaluator::held(const Expression& e, FileId file, ParamScope& scope) {
    if (e.op != Expression::Op::Call || e.name != "if" || e.arguments.size() != 3) return &e;
    const std::optional<Amount> condition = amount(e.arguments[0], file, scope);
    const bool holds = condition && condition->value != 0;
    if (!condition || !hasNames(e.arguments[holds ? 2 : 1], file, scope)) return nullptr;
    return held(e.arguments[holds ? 1 : 2], file, scope);
}

/// Whether it is a Param that is a word, a string or a list, which an `if` may choose.
bool Evaluator::isText(const Expression& e, FileId file, ParamScope& scope) {
    if (e.op != Expression::Op::Name || !scope.find(e.name)) return false;
    const GivenValue* value = paramValue(e.name, {file, e.range}, scope);
    return value && (value->elements.size() != 1 || value->elements[0].kind != GivenElement::Kind::Number);
}

std::optional<Amount> Evaluator::call(const Expression& e, FileId file, ParamScope& scope) {
    if (e.name == "if" && e.arguments.size() == 3) {
        const Expression* held = this->held(e, file, scope);
        return held ? amount(*held, file, scope) : std::nullopt;
    }
    if (e.name == "element") {
        if (!isPick(e)) return fault(e, file, "element takes the name of a Param that is a list, and a number from 0");
        const GivenElement* element = picked(e, file, scope);
        return element ? numberOf(*element, e, file) : std::nullopt;
    }
    std::vector<Amount> args;
    for (const Expression& argument : e.arguments) {
        const std::optional<Amount> a = amount(argument, file, scope);
        if (!a) return std::nullopt;
        args.push_back(*a);
    }
    const std::span<const std::string> functions = functionNames();
    if (std::ranges::find(functions, e.name) != functions.end() || isComparison(e.name))
        return orFault(applied(e.name, args), e, file);
    Diagnostic& d = m_diagnostics.error(Code::ExpressionValue, {file, e.range},
                                        "there is no function " + e.name + "; there are " + listText(functions, "and", functions.size()));
    const std::uint32_t begin = e.range.begin;
    suggest(d, e.name, functions, {file, {begin, begin + static_cast<std::uint32_t>(e.name.size())}});
    return std::nullopt;
}

} // namespace trundle
