#include "project/objects/typed_number.h"

#include "model/params.h"
#include "project/objects/value_text.h"
#include "schema/value_reader.h"

namespace trundle {

Result<double> typedNumber(const std::string& typed, const Property& property) {
    const Error none{Code::WrongType, property.name + " is a number in " + property.unit};
    TextSet texts;
    const std::string text = withArithmetic(tidied(typed), true).text();
    texts.trees = {parse(std::make_shared<const SourceText>("value", "v = " + text + "\n"), 0)};
    const Tree& tree = *texts.trees[0];
    const auto* assignment = tree.items().size() == 1 ? tree.items()[0].as<AssignmentItem>() : nullptr;
    if (!tree.diagnostics().empty() || !assignment || assignment->value.elements.size() != 1) return none;
    ParamScope scope;
    Diagnostics diagnostics;
    const auto given = Evaluator(texts, diagnostics).evaluate(assignment->value, 0, scope);
    const auto value = given ? readValue(property, *given, diagnostics) : std::nullopt;
    if (value) return value->numbers.front();
    return diagnostics.all().empty() ? none : Error{diagnostics.all().front().code, diagnostics.all().front().message};
}

} // namespace trundle
