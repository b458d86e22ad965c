#include "model/param_reference.h"

#include <algorithm>
#include <set>

#include "model/config_blocks.h"
#include "schema/kind.h"

namespace trundle {
namespace {

class Search {
public:
    const Property* in(const Part& config, std::string_view param) {
        if (!m_seen.emplace(&config, std::string(param)).second) return nullptr;
        if (isVariant(config) && config.config)
            if (const Property* found = in(*config.config, param)) return found;
        return inside(config, param);
    }

private:
    const Property* inside(const Part& holder, std::string_view param) {
        for (const Part& part : holder.parts) {
            for (const SourceAssignment& assignment : part.assignments.all())
                if (part.kind && isValueOf(assignment, param))
                    if (const Property* found = of(part, assignment.key)) return found;
            if (const Property* found = inside(part, param)) return found;
        }
        return nullptr;
    }
    const Property* of(const Part& part, const std::string& key) {
        if (const Property* own = part.kind->find(key)) return own->type == PropertyType::Reference ? own : nullptr;
        return part.config ? in(*part.config, key) : nullptr;
    }
    static bool isValueOf(const SourceAssignment& assignment, std::string_view param) {
        return std::ranges::any_of(assignment.value->elements, [&](const Element& e) {
            bool isIt = e.kind == Element::Kind::ParamRef && e.text == param;
            if (e.expression) eachNameGiven(*e.expression, [&](const std::string& name) { isIt = isIt || name == param; });
            return isIt;
        });
    }

    std::set<std::pair<const Part*, std::string>> m_seen; ///< PartConfigs in a circle end there
};

bool names(const Expression& expression, std::string_view param) {
    if (expression.op == Expression::Op::Name && expression.name == param) return true;
    return std::ranges::any_of(expression.arguments, [&](const Expression& argument) { return names(argument, param); });
}

} // namespace

bool usesParam(const Part& config, std::string_view param) {
    if (config.param(param)) return false;
    const auto isUse = [&](const Element& e) {
        return (e.kind == Element::Kind::ParamRef && e.text == param) || (e.expression && names(*e.expression, param));
    };
    const auto isIn = [&](const SourceAssignment& a) { return std::ranges::any_of(a.value->elements, isUse); };
    return std::ranges::any_of(config.assignments.all(), isIn) ||
           std::ranges::any_of(config.parts, [&](const Part& part) { return usesParam(part, param); });
}

void eachNameGiven(const Expression& expression, const std::function<void(const std::string&)>& take) {
    const std::vector<Expression>& arguments = expression.arguments;
    if (expression.op == Expression::Op::Name) return take(expression.name);
    if (expression.op != Expression::Op::Call) return;
    if (expression.name == "element" && !arguments.empty()) eachNameGiven(arguments[0], take);
    if (expression.name == "if" && arguments.size() == 3)
        for (std::size_t i : {1, 2}) eachNameGiven(arguments[i], take);
}

const Property* propertyNamedBy(const Part& config, std::string_view param) { return Search().in(config, param); }

} // namespace trundle
