// Finds names that a pasted text uses but does not define.

#include <set>

#include "model/dotted_path.h"
#include "project/edits/pasted_blocks.h"
#include "project/objects/name_references.h"
#include "project/objects/object_location.h"
#include "project/objects/reference_space.h"

namespace trundle {

/// Names visible inside a block.
struct PastedBlocks::PasteContext {
    std::set<std::string> params;
    const BlockItem* pastedConfig = nullptr;     ///< set inside a config that is pasted as a whole
    bool isInPart = false;                       ///< inside a PartConfig that is pasted
    const Part* config = nullptr;                ///< set if the target is this config
    std::vector<const BlockItem*> pastedRepeats; ///< around the value
    std::vector<const Part*> repeats;            ///< the same, of the target
};

namespace {

/// The first name of an expression that is not a Param in scope.
std::string unknownIn(const Expression& e, const std::set<std::string>& params) {
    if (e.op == Expression::Op::Name && e.name != "pi" && !params.count(e.name)) return "$" + e.name;
    for (const Expression& argument : e.arguments)
        if (std::string name = unknownIn(argument, params); !name.empty()) return name;
    return {};
}

const BlockItem* blockNamed(const BlockItem& holder, const std::string& name) {
    for (const Item& item : holder.items) {
        const auto* block = item.as<BlockItem>();
        // An unnamed block matches any name: its default name depends on its siblings.
        if (block && (block->name ? block->name->text == name : true)) return block;
    }
    return nullptr;
}

/// Whether a property names a block of the same config.
bool isLocal(const LoadedProject& loaded, const Property& property) {
    const auto hasNoSpace = [&](const std::string& choice) {
        const Kind* kind = loaded.registry->find(choice);
        return !kind || !referenceSpace(*loaded.outline, *kind);
    };
    return property.type == PropertyType::Reference &&
           (property.choices.empty() || std::ranges::any_of(property.choices, hasNoSpace));
}

bool isIn(const BlockItem& repeat, const std::string& name) { return blockNamed(repeat, name); }
bool isIn(const Part& repeat, const std::string& name) { return repeat.find(name); }

void addIndex(std::set<std::string>& params) { params.insert({"index", "index2"}); }

} // namespace

bool PastedBlocks::leadsSomewhere(const LoadedProject& loaded, const Entry& entry, const Kind& kind, const Property& property,
                                  const std::string& word, const PasteContext& seen) const {
    if (namesWorld(kind, property) || named(loaded, entry, property, word)) return true;
    for (const std::string& choice : property.choices) {
        const Kind* named = loaded.registry->find(choice);
        const NameSpace* space = named ? referenceSpace(*loaded.outline, *named) : nullptr;
        if (choice == word || (space && space->find(word))) return true; // such as `world`
        if (space && word == "default") return true;
    }
    if (!isLocal(loaded, property)) return false;
    const std::string first(firstWord(word));
    const auto hasFirst = [&](const auto* repeat) { return isIn(*repeat, first); };
    if (std::ranges::any_of(seen.pastedRepeats, hasFirst) || std::ranges::any_of(seen.repeats, hasFirst)) return true;
    if (const auto member = memberName(first);
        member && seen.pastedConfig && blockNamed(*seen.pastedConfig, std::string(member->stem)))
        return true;
    if (seen.pastedConfig) return blockNamed(*seen.pastedConfig, first);
    if (!seen.config || named(loaded, entry, property, first)) return true;
    return seen.config->findPath(word);
}

std::string PastedBlocks::missingIn(const LoadedProject& loaded, const Entry& entry, const BlockItem& block,
                                    PasteContext seen) const {
    const Kind* kind = loaded.registry->find(block.type.text);
    for (const Item& item : block.items)
        if (const auto* param = item.as<ParamItem>()) seen.params.insert(param->name.text);
        else if (item.as<ImportItem>()) return {}; // the imported file may define anything
    if (kind && kind->role == Role::Config) seen.pastedConfig = &block;
    if (kind && kind->name == "PartConfig") seen.isInPart = true;
    if (kind && kind->role == Role::Repeat) seen.pastedRepeats.push_back(&block);
    if (kind && (kind->role == Role::Repeat || kind->role == Role::Layout)) addIndex(seen.params);
    for (const Item& item : block.items) {
        std::string found;
        if (const auto* inner = item.as<BlockItem>()) found = missingIn(loaded, entry, *inner, seen);
        const auto* a = item.as<AssignmentItem>();
        const auto* param = item.as<ParamItem>();
        const Value* value = a ? &a->value : param ? &param->value : nullptr;
        const Property* property = a && kind && a->path.size() == 1 ? kind->find(a->path[0].text) : nullptr;
        // A PartConfig needs no Param for what it names outside, `Parent=$carrier`, also where it hands it on to a Part.
        const bool isOfPart = a && kind && kind->name == "Part" && !property;
        const bool isImplied = seen.isInPart && (isOfPart || (property && isLocal(loaded, *property)));
        for (const Element& e : value ? value->elements : std::vector<Element>()) {
            if (e.kind == Element::Kind::ParamRef && !isImplied && !seen.params.count(e.text)) return "$" + e.text;
            if (e.expression) found = unknownIn(*e.expression, seen.params);
            const bool word = e.kind == Element::Kind::Word || e.kind == Element::Kind::String;
            if (word && property && property->type == PropertyType::Reference && !e.text.empty() &&
                !leadsSomewhere(loaded, entry, *kind, *property, e.text, seen))
                found = property->name + " " + e.text;
            if (!found.empty()) return found;
        }
        if (!found.empty()) return found;
    }
    return {};
}

std::string PastedBlocks::missing(const LoadedProject& loaded, const Entry& entry, const std::vector<const Part*>& round) const {
    PasteContext seen;
    for (const SourceParam& p : loaded.outline->params) seen.params.insert(p.name->text);
    for (const auto& [name, text] : params) seen.params.insert(name);
    for (const Part* part : round) {
        for (const SourceParam& p : part->params) seen.params.insert(p.name->text);
        if (part->is(Role::Config)) seen.config = part;
        if (part->isRepeat()) seen.repeats.push_back(part);
        if (part->isRepeat() || part->is(Role::Layout)) addIndex(seen.params);
        if (isPlaced(*part)) seen.config = configOf(loaded, *part);
    }
    return missingIn(loaded, entry, *entry.block, seen);
}

} // namespace trundle
