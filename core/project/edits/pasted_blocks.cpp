#include "project/edits/pasted_blocks.h"

#include "lang/characters.h"
#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "project/edits/edit_builder.h"
#include "project/objects/object_location.h"
#include "project/objects/reference_space.h"

namespace trundle {

namespace {

bool isGap(char c) { return isBlank(c) || c == '\n' || c == '\r'; }

/// Whether `chassis.hull` may refer to a pasted block `chassis`: it contains a `hull`, or an unnamed block or import that may
/// provide it.
bool holds(const BlockItem& block, const std::string& word, std::size_t dot) {
    if (dot >= word.size() || word[dot] != '.') return true;
    return std::any_of(block.items.begin(), block.items.end(), [&](const Item& item) {
        const auto* inner = item.as<BlockItem>();
        return item.as<ImportItem>() || (inner && (!inner->name || inner->name->text == word.substr(dot + 1)));
    });
}

} // namespace

Result<PastedBlocks> PastedBlocks::read(const Registry& registry, const std::string& text) {
    PastedBlocks pasted;
    pasted.m_tree = parse(std::make_shared<const SourceText>("the text", text), 0);
    for (const Diagnostic& d : pasted.m_tree->diagnostics()) {
        if (d.severity != Severity::Error) continue;
        return Error{d.code, "line " + std::to_string(pasted.m_tree->source().position(d.range.range.begin).line) +
                                 " of the text to be added: " + d.message};
    }
    const std::string_view bytes = pasted.m_tree->source().bytes();
    std::uint32_t done = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (const Item& item : pasted.m_tree->items()) {
        const auto* block = item.as<BlockItem>();
        TextRange whole{done, endOfLineBehind(*pasted.m_tree, item.range.end).value_or(item.range.end)};
        while (whole.begin < item.range.begin && isGap(bytes[whole.begin])) ++whole.begin;
        done = whole.end;
        if (block) pasted.entries.push_back({&item, block, registry.find(block->type.text), nullptr, {}, whole});
        else if (const auto* param = item.as<ParamItem>())
            pasted.params.emplace(param->name.text, GivenParam{std::string(pasted.m_tree->source().slice(item.range)),
                                                               std::string(pasted.m_tree->source().slice(param->value.range))});
        else if (item.as<ImportItem>() || item.as<ModuleItem>())
            pasted.directives.emplace_back(pasted.m_tree->source().slice(item.range));
        else
            return Error{Code::UnexpectedText, "only blocks can be added, not `" +
                                                   std::string(pasted.m_tree->source().slice(item.range).substr(0, 40)) + "`"};
    }
    if (!pasted.entries.empty() && pasted.entries.back().item == &pasted.m_tree->items().back()) { // trailing comments
        TextRange& last = pasted.entries.back().whole;
        last.end = static_cast<std::uint32_t>(bytes.size());
        while (isGap(bytes[last.end - 1])) --last.end;
    }
    if (pasted.entries.empty() && pasted.directives.empty()) return Error{Code::UnexpectedText, "the text holds no block"};
    return pasted;
}

const PastedBlocks::Entry* PastedBlocks::named(const LoadedProject& loaded, const Entry& user, const Property& property,
                                               std::string_view name) const {
    const Outline& outline = *loaded.outline;
    const auto find = [&](const NameSpace* space, const Part* target) -> const Entry* {
        for (const Entry& e : entries) {
            if (!e.block->name || e.block->name->text != name || e.target != target || !e.kind) continue;
            if (!space || outline.spaceOf(*e.kind) == space) return &e;
        }
        return nullptr;
    };
    if (user.kind && namesWorld(*user.kind, property)) return find(&outline.world, nullptr);
    if (property.type != PropertyType::Reference) return nullptr;
    bool local = property.choices.empty();
    for (const std::string& choice : property.choices) {
        const Kind* kind = loaded.registry->find(choice);
        const NameSpace* space = kind ? referenceSpace(outline, *kind) : nullptr;
        local = local || !space;
        if (const Entry* entry = space ? find(space, nullptr) : nullptr) return entry;
    }
    if (!local) return nullptr;
    // A controller refers to parts of its robot's config.
    const Part* holder = user.target && isPlaced(*user.target) ? configOf(loaded, *user.target) : user.target;
    return holder ? find(nullptr, holder) : nullptr;
}

void PastedBlocks::collect(const LoadedProject& loaded, const Entry& entry, const BlockItem& block, const Kind* kind,
                           std::vector<TextEdit>& edits) const {
    for (const Item& item : block.items) {
        if (const auto* inner = item.as<BlockItem>())
            collect(loaded, entry, *inner, loaded.registry->find(inner->type.text), edits);
        const auto* a = item.as<AssignmentItem>();
        const Property* property = a && kind && a->path.size() == 1 ? kind->find(a->path[0].text) : nullptr;
        if (!property) continue;
        for (const Element& e : a->value.elements) {
            const bool quoted = e.kind == Element::Kind::String && e.range.size() == e.text.size() + 2;
            if (!quoted && e.kind != Element::Kind::Word) continue;
            const std::string word = e.text.substr(0, e.text.find_first_of("./"));
            const Entry* other = named(loaded, entry, *property, word);
            if (!other || other->name == word || !holds(*other->block, e.text, word.size())) continue;
            const std::uint32_t begin = e.range.begin + (quoted ? 1 : 0);
            edits.push_back({{0, {begin, begin + static_cast<std::uint32_t>(word.size())}}, other->name});
        }
    }
}

std::string PastedBlocks::textOf(const LoadedProject& loaded, const Entry& entry) const {
    std::vector<TextEdit> edits;
    const BlockItem& block = *entry.block;
    if (block.name) edits.push_back({{0, block.name->range}, entry.name});
    else if (!entry.name.empty()) edits.push_back({{0, {block.type.range.end, block.type.range.end}}, " " + entry.name});
    collect(loaded, entry, block, entry.kind, edits);
    const TextRange whole = entry.whole;
    for (TextEdit& edit : edits) {
        edit.range.range.begin -= whole.begin;
        edit.range.range.end -= whole.begin;
    }
    const Result<std::string> text = applyEdits(m_tree->source().slice(whole), edits);
    const std::size_t indent = indentOfLine(m_tree->source().bytes(), whole.begin).size();
    return dedented(text.ok() ? std::string_view(text.value()) : m_tree->source().slice(whole), indent);
}

} // namespace trundle
