// Checks properties of which exactly one must be given, such as a motor's SpeedConstant or BackEmfConstant.
#include <algorithm>

#include "lang/tree_edit.h"
#include "model/resolve/record.h"
#include "model/resolve/resolve_context.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

std::size_t indexOf(const Kind& kind, const std::string& name) {
    const auto it =
        std::find_if(kind.properties.begin(), kind.properties.end(), [&](const Property& p) { return p.name == name; });
    return static_cast<std::size_t>(it - kind.properties.begin());
}

/// The item in the part's own file that sets this key; nullptr if it is set elsewhere.
const Item* itemSetting(const Part& part, const std::string& key) {
    const SourceAssignment* a = part.assignments.find(key);
    if (!a || a->file != part.file) return nullptr;
    for (const Item& item : part.block->items)
        if (item.as<AssignmentItem>() == a->item) return &item;
    return nullptr;
}

} // namespace

void ResolveContext::checkAlternatives(Record& record, const Part& part, const std::vector<bool>& validated,
                                       const std::vector<std::string>& meant) {
    for (const Alternatives& choice : record.kind->alternatives) {
        std::vector<std::string> there;
        bool misspelt = false;
        for (const std::string& name : choice.names) {
            const std::size_t i = indexOf(*record.kind, name);
            if (i < validated.size() && validated[i]) there.push_back(name);
            misspelt = misspelt || std::count(meant.begin(), meant.end(), name);
        }
        if (there.size() == 1) continue;
        record.complete = false;
        if (misspelt || brokenText(part.range)) continue;
        if (there.empty()) hasNone(record, part, choice);
        else hasSeveral(part, there);
    }
}

void ResolveContext::hasNone(const Record& record, const Part& part, const Alternatives& choice) {
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
        if (const Item* item = itemSetting(part, name))
            d.fixes.push_back({"without " + name, {editRemoveItem(*texts.trees[part.file], *item)}});
}

} // namespace trundle
