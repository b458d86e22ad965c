// Properties of which exactly one is given: a motor's SpeedConstant or its BackEmfConstant.
#include <algorithm>

#include "lang/tree_edit.h"
#include "model/record.h"
#include "model/resolve_context.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

std::size_t indexOf(const Kind& kind, const std::string& name) {
    const auto it =
        std::find_if(kind.properties.begin(), kind.properties.end(), [&](const Property& p) { return p.name == name; });
    return static_cast<std::size_t>(it - kind.properties.begin());
}

/// The item of the part's own text that sets this key, or nullptr.
const Item* itemThatSets(const Part& part, const std::string& key) {
    const PlacedAssignment* a = part.assignments.find(key);
    if (!a || a->file != part.file) return nullptr;
    for (const Item& item : part.block->items)
        if (item.as<AssignmentItem>() == a->item) return &item;
    return nullptr;
}

} // namespace

void ResolveContext::checkAlternatives(Record& record, const Part& part, const std::vector<bool>& tried,
                                       const std::vector<std::string>& meant) {
    for (const Alternatives& choice : record.kind->alternatives) {
        std::vector<std::string> there;
        bool misspelt = false;
        for (const std::string& name : choice.names) {
            const std::size_t i = indexOf(*record.kind, name);
            if (i < tried.size() && tried[i]) there.push_back(name);
            misspelt = misspelt || std::count(meant.begin(), meant.end(), name);
        }
        if (there.size() == 1) continue;
        record.complete = false;
        if (misspelt || brokenText(part.range)) continue;
        if (there.empty()) missesAll(record, part, choice);
        else hasSeveral(part, there);
    }
}

void ResolveContext::missesAll(const Record& record, const Part& part, const Alternatives& choice) {
    Diagnostic& d = diagnostics.error(Code::MissingRequired, part.nameRange(),
                                      part.title() + " needs " + listText(choice.names) + ", exactly one of them");
    const ResolvedValue* likely = record.find(choice.likely);
    if (!likely || likely->value.numbers.empty() || texts.commandLine(part.file)) return;
    const double scale = record.kind->find(choice.likely)->scale;
    fixAdd(d, part, choice.names.back(), numberText(likely->value.numbers[0] / scale));
}

void ResolveContext::hasSeveral(const Part& part, const std::vector<std::string>& there) {
    Diagnostic& d =
        diagnostics.error(Code::Conflict, part.nameRange(),
                          part.title() + " has " + listText(there, "and") + ": they say the same thing, give one of them");
    for (const std::string& name : there)
        if (const Item* item = itemThatSets(part, name))
            d.fixes.push_back({"without " + name, {editRemoveItem(*texts.trees[part.file], *item)}});
}

} // namespace trundle
