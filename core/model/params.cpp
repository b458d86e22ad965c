#include "model/params.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/units.h"
#include "model/outline.h"
#include "schema/registry.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr std::size_t kLongestChain = 100;   ///< nesting depth of Params that use each other; limits the stack
constexpr std::size_t kMaxElements = 100000; ///< nested lists could grow exponentially

/// The unit of plain numbers of a dimension in the language: m, deg ...
std::string baseUnit(std::string_view dimension) {
    if (dimension == "angle") return "deg";
    if (dimension == "rate") return "deg/s"; // so that its product with a time is in degrees
    if (dimension == "angular acceleration") return "deg/s^2";
    for (const std::string& name : allUnitNames()) {
        const UnitInfo* unit = findUnit(name);
        if (unit->dimension == dimension && unit->factor == 1) return name;
    }
    return {};
}

double sine(double degrees) {
    const double quarters = degrees / 90;
    if (quarters == std::nearbyint(quarters) && std::abs(quarters) < 1e15) {
        static const double exact[] = {0, 1, 0, -1};
        return exact[((static_cast<long long>(quarters) % 4) + 4) % 4];
    }
    return std::sin(degrees * std::numbers::pi / 180);
}

const std::set<std::string_view> kPairs{"mod", "atan2", "<", ">", "<=", ">=", "==", "!="};

const std::set<std::string_view> kWithoutUnit{"floor", "ceil", "round", "asin", "acos"};

std::string hasUnit(const std::string& function, const std::string& unit) {
    std::string message = function + " takes a number without unit, this is in " + unit;
    if (function.starts_with('a')) return message;
    return message + "; divide by the step: " + function + "(x / 1 " + unit + ") * 1 " + unit;
}

/// The angle of a sine or cosine in degrees; nothing for other functions and where there is no such angle.
std::optional<double> arc(const std::string& function, double value) {
    constexpr double kRounding = 1e-12; // a quotient of computed lengths may be just above 1
    if ((function != "asin" && function != "acos") || std::abs(value) > 1 + kRounding) return std::nullopt;
    const double exact = std::clamp(value, -1.0, 1.0);
    return (function == "asin" ? std::asin(exact) : std::acos(exact)) * 180 / std::numbers::pi;
}

std::optional<double> wholeNumber(const std::string& function, double value) {
    if (function == "floor") return std::floor(value);
    if (function == "ceil") return std::ceil(value);
    if (function == "round") return std::round(value);
    return std::nullopt;
}

/// An element that is written out; of others only where it is.
GivenElement literalOf(const Element& element, FileId file) {
    GivenElement given;
    given.range = {file, element.range};
    switch (element.kind) {
    case Element::Kind::Number:
        given.kind = GivenElement::Kind::Number;
        given.number = element.number;
        given.unit = element.unit;
        if (!element.unit.empty()) given.unitRange = {file, element.unitRange};
        break;
    case Element::Kind::Word:
        given.kind = GivenElement::Kind::Word;
        given.text = element.text;
        break;
    case Element::Kind::String:
        given.kind = GivenElement::Kind::String;
        given.text = element.text;
        break;
    case Element::Kind::Boolean:
        given.kind = GivenElement::Kind::Boolean;
        given.boolean = element.boolean;
        break;
    case Element::Kind::ParamRef:
    case Element::Kind::Expression: break;
    }
    return given;
}

} // namespace

void ParamScope::declare(const std::vector<SourceParam>& params) {
    for (const SourceParam& p : params) m_entries.try_emplace(p.name->text, Entry{p, this, State::Fresh, {}, false});
}

void ParamScope::preset(const std::string& name, const GivenValue& value) {
    const auto it = m_entries.find(name);
    if (it == m_entries.end()) return;
    it->second.state = State::Done;
    it->second.value = value;
}

void ParamScope::set(const std::string& name, double number) {
    GivenElement element;
    element.kind = GivenElement::Kind::Number;
    element.number = number;
    Entry entry{{}, this, State::Done, {}, false};
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

std::vector<std::string> ParamScope::names() const {
    std::vector<std::string> names;
    for (const ParamScope* scope = this; scope; scope = scope->m_outer) {
        for (const auto& [name, entry] : scope->m_entries) names.push_back(name);
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
    for (auto& [name, entry] : scope.m_entries)
        if (entry.param.name) (void)paramValue(name, {entry.param.file, entry.param.name->range}, scope);
}

bool Evaluator::addElement(const Element& element, FileId file, ParamScope& scope, GivenValue& out) {
    if (element.kind == Element::Kind::ParamRef) return addParam(element.text, {file, element.range}, scope, out);
    GivenElement given = literalOf(element, file);
    if (element.kind == Element::Kind::Expression) {
        if (!element.expression) return false; // reported by the parser
        const std::optional<Amount> result = amount(*element.expression, file, scope);
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
    if (entry->state == State::Fresh) {
        entry->state = State::Busy;
        m_chain.push_back(entry);
        std::optional<GivenValue> value;
        if (m_chain.size() > kLongestChain) {
            m_diagnostics.error(Code::ParamCycle, entry->param.nameRange(), "more than 100 Params need each other in a row");
        } else {
            value = evaluate(*entry->param.value, entry->param.valueFile, *entry->scope);
            if (value && !checkUnits(*value)) value.reset();
        }
        m_chain.pop_back();
        const bool failed = !value || entry->state == State::Failed;
        entry->state = failed ? State::Failed : State::Done;
        if (value) entry->value = std::move(*value);
    }
    return entry->state == State::Done ? &entry->value : nullptr;
}

bool Evaluator::checkUnits(const GivenValue& value) {
    if (!m_registry) return true;
    const auto isKnown = [this](const std::string& unit) {
        if (unit.empty() || findUnit(unit)) return true;
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
    // excludes the `$` of `$name` from the range
    const std::string_view text = m_texts.slice(place);
    if (text.size() == name.size() + 1 && text.front() == '$') ++place.range.begin;
    Diagnostic& d = m_diagnostics.error(Code::UnknownParam, place, std::move(message));
    constexpr std::size_t kMany = 1000, kFirst = 20; // with many Params, suggestions for each error would take minutes
    if (manyAlready(m_diagnostics)) return;
    const std::vector<std::string> names = scope.names();
    if (names.size() > kMany && m_diagnostics.all().size() > kFirst) return;
    suggest(d, name, names, place);
    if (d.suggestions.empty() && !names.empty()) d.message += "; there are " + listText(names, "and");
}

void Evaluator::circle(const ParamScope::Entry& entry) {
    std::string chain;
    bool inside = false;
    for (ParamScope::Entry* e : m_chain) {
        inside = inside || e == &entry;
        if (inside) {
            chain += e->param.name->text + " > ";
            e->state = ParamScope::State::Failed;
        }
    }
    m_diagnostics.error(Code::ParamCycle, entry.param.nameRange(),
                        "Params need each other in a circle: " + chain + entry.param.name->text);
}

std::optional<Evaluator::Amount> Evaluator::fault(const Expression& e, FileId file, std::string message) {
    m_diagnostics.error(Code::ExpressionValue, {file, e.range}, std::move(message));
    return std::nullopt;
}

std::optional<Evaluator::Amount> Evaluator::finite(const Expression& e, FileId file, Amount amount) {
    if (std::isfinite(amount.value)) return amount;
    return fault(e, file, "the result is not a number that can be used");
}

std::optional<Evaluator::Amount> Evaluator::paramAmount(const Expression& e, FileId file, ParamScope& scope) {
    const GivenValue* value = nullptr;
    if (e.name == "pi" && !scope.find("pi")) return Amount{std::numbers::pi, {}};
    value = paramValue(e.name, {file, e.range}, scope);
    if (!value) return std::nullopt;
    if (value->elements.size() != 1)
        return fault(e, file,
                     "Param " + e.name + " is a list of " + std::to_string(value->elements.size()) +
                         ", an expression takes numbers");
    const GivenElement& element = value->elements[0];
    if (element.kind != GivenElement::Kind::Number)
        return fault(e, file, "Param " + e.name + " is " + elementText(element) + ", an expression takes numbers");
    if (!element.unit.empty() && !findUnit(element.unit))
        return fault(e, file, "Param " + e.name + " is " + elementText(element) + ": there is no unit " + element.unit);
    return inBaseUnit(element.number, element.unit);
}

/// With the unit of plain numbers of its dimension.
Evaluator::Amount Evaluator::inBaseUnit(double number, const std::string& written) {
    const UnitInfo* unit = findUnit(written);
    if (!unit) return {number, {}};
    if (written == "%") return {number * unit->factor, {}};
    const std::string base = baseUnit(unit->dimension);
    return {convertUnit(number, written, base).value_or(number), base};
}

std::optional<Evaluator::Amount> Evaluator::amount(const Expression& e, FileId file, ParamScope& scope) {
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
    switch (e.op) {
    case Op::Add:
    case Op::Subtract:
        if (!a->unit.empty() && !b->unit.empty() && a->unit != b->unit) {
            return fault(e, file, a->unit + " and " + b->unit + " cannot be added");
        }
        return finite(e, file,
                      {e.op == Op::Add ? a->value + b->value : a->value - b->value, a->unit.empty() ? b->unit : a->unit});
    case Op::Multiply:
        // the product of two units is treated as a plain number: its dimension is not checked
        return finite(e, file, {a->value * b->value, a->unit.empty() ? b->unit : b->unit.empty() ? a->unit : std::string()});
    case Op::Divide:
        if (b->value == 0) return fault(e, file, "division by zero");
        return finite(e, file, {a->value / b->value, b->unit.empty() ? a->unit : std::string()});
    default: return finite(e, file, {std::pow(a->value, b->value), {}});
    }
}

/// Whether there are all Params that an expression names.
bool Evaluator::hasNames(const Expression& e, FileId file, ParamScope& scope) {
    if (e.op == Expression::Op::Name && e.name != "pi" && !scope.find(e.name)) {
        unknown(e.name, {file, e.range}, scope);
        return false;
    }
    return std::ranges::all_of(e.arguments, [&](const Expression& argument) { return hasNames(argument, file, scope); });
}

/// Of a condition only the branch that holds is evaluated: the other one may divide by zero.
std::optional<Evaluator::Amount> Evaluator::choice(const Expression& e, FileId file, ParamScope& scope) {
    const std::optional<Amount> condition = amount(e.arguments[0], file, scope);
    const bool holds = condition && condition->value != 0;
    if (!condition || !hasNames(e.arguments[holds ? 2 : 1], file, scope)) return std::nullopt;
    return amount(e.arguments[holds ? 1 : 2], file, scope);
}

std::optional<Evaluator::Amount> Evaluator::withTwo(const Expression& e, FileId file, const Amount& a, const Amount& b) {
    if (!a.unit.empty() && !b.unit.empty() && a.unit != b.unit)
        return fault(e, file, a.unit + " and " + b.unit + " cannot be compared");
    if (e.name == "mod") {
        if (b.value == 0) return fault(e, file, "division by zero");
        const double rest = std::fmod(a.value, b.value); // with the sign of b, so that angles wrap
        return Amount{rest != 0 && (rest < 0) != (b.value < 0) ? rest + b.value : rest, a.unit.empty() ? b.unit : a.unit};
    }
    if (e.name == "atan2") return Amount{std::atan2(a.value, b.value) * 180 / std::numbers::pi, "deg"};
    const bool holds = e.name == "<"    ? a.value < b.value
                       : e.name == ">"  ? a.value > b.value
                       : e.name == "<=" ? a.value <= b.value
                       : e.name == ">=" ? a.value >= b.value
                       : e.name == "==" ? a.value == b.value
                                        : a.value != b.value;
    return Amount{holds ? 1.0 : 0.0, {}};
}

std::optional<Evaluator::Amount> Evaluator::call(const Expression& e, FileId file, ParamScope& scope) {
    if (e.name == "if" && e.arguments.size() == 3) return choice(e, file, scope);
    std::vector<Amount> args;
    for (const Expression& argument : e.arguments) {
        const std::optional<Amount> a = amount(argument, file, scope);
        if (!a) return std::nullopt;
        args.push_back(*a);
    }
    const auto takes = [&](std::size_t count) { return args.size() == count; };
    if (e.name == "min" || e.name == "max") {
        if (args.empty()) return fault(e, file, e.name + " takes at least one number");
        Amount best = args[0];
        for (const Amount& a : args) {
            if (!a.unit.empty() && !best.unit.empty() && a.unit != best.unit)
                return fault(e, file, best.unit + " and " + a.unit + " cannot be compared");
            if (e.name == "min" ? a.value < best.value : a.value > best.value) best.value = a.value;
            if (best.unit.empty()) best.unit = a.unit;
        }
        return best;
    }
    if (kPairs.contains(e.name) && takes(2)) return withTwo(e, file, args[0], args[1]);
    static const std::string functions[] = {"min",  "max", "abs",   "sqrt", "sin",   "cos",   "tan", "asin",
                                            "acos", "mod", "floor", "ceil", "round", "atan2", "if"};
    if (std::find(std::begin(functions), std::end(functions), e.name) == std::end(functions)) {
        Diagnostic& d = m_diagnostics.error(Code::ExpressionValue, {file, e.range},
                                            "there is no function " + e.name + "; there are " + listText(functions, "and"));
        const std::uint32_t begin = e.range.begin;
        suggest(d, e.name, functions, {file, {begin, begin + static_cast<std::uint32_t>(e.name.size())}});
        return std::nullopt;
    }
    if (!takes(1)) return fault(e, file, e.name + " takes one number");
    const Amount a = args[0];
    if (e.name == "abs") return Amount{std::abs(a.value), a.unit};
    if (kWithoutUnit.contains(e.name) && !a.unit.empty()) return fault(e, file, hasUnit(e.name, a.unit));
    if (const auto whole = wholeNumber(e.name, a.value)) return Amount{*whole, {}};
    if (const auto degrees = arc(e.name, a.value)) return Amount{*degrees, "deg"};
    if (e.name == "asin" || e.name == "acos") return fault(e, file, e.name + " of " + numberText(a.value) + " is not a number");
    if (e.name == "sqrt") {
        if (a.value < 0) return fault(e, file, "the square root of " + numberText(a.value) + " is not a number");
        return Amount{std::sqrt(a.value), {}};
    }
    if (!a.unit.empty() && a.unit != "deg") return fault(e, file, e.name + " takes an angle in degrees, this is in " + a.unit);
    if (e.name == "sin") return Amount{sine(a.value), {}};
    if (e.name == "cos") return Amount{sine(a.value + 90), {}};
    if (sine(a.value + 90) == 0) return fault(e, file, "the tangent of " + numberText(a.value) + " degrees is not a number");
    return Amount{sine(a.value) / sine(a.value + 90), {}};
}

} // namespace trundle
