#include "model/outline.h"

#include <algorithm>

#include "model/dotted_path.h"
#include "model/part_builder.h"

namespace trundle {

namespace {

bool topLevelOnly(const Registry& registry, const BlockItem& block) {
    const Kind* kind = registry.find(block.type.text);
    return kind && (kind->role == Role::Material || kind->role == Role::Surface || kind->role == Role::Pattern ||
                    kind->role == Role::Config);
}

/// Materials, surfaces and configs of files that are imported inside a block: they belong to the top level, before the block that
/// imports them.
class ImportedTopLevel {
public:
    ImportedTopLevel(const TextSet& texts, const Registry& registry, std::span<const FileId> known)
        : m_texts(texts), m_registry(registry) {
        m_files.insert(0);
        m_files.insert(known.begin(), known.end());
    }

    std::vector<SourceBlock> from(const BlockItem& block) {
        m_found.clear();
        searchIn(block.items);
        return std::move(m_found);
    }

private:
    void searchIn(const std::vector<Item>& items) {
        for (const Item& item : items) {
            if (const auto* block = item.as<BlockItem>()) searchIn(block->items);
            if (const auto* import = item.as<ImportItem>()) searchInFile(*import);
        }
    }

    void searchInFile(const ImportItem& import) {
        const auto target = m_texts.imports.find(&import);
        if (target == m_texts.imports.end() || !m_files.insert(target->second).second) return;
        const std::vector<Item>& items = m_texts.trees[target->second]->items();
        searchIn(items);
        for (const Item& item : items) {
            const auto* block = item.as<BlockItem>();
            if (block && topLevelOnly(m_registry, *block)) m_found.push_back({&item, block, target->second});
        }
    }

    const TextSet& m_texts;
    const Registry& m_registry;
    std::unordered_set<FileId> m_files;
    std::vector<SourceBlock> m_found;
};

void checkMemberNames(const NameSpace& world, Diagnostics& diagnostics) {
    for (const Part* part : world.all()) {
        const std::optional<MemberName> member = memberName(part->name);
        const Part* repeat = member ? world.find(member->stem) : nullptr;
        if (!repeat || !repeat->isRepeat()) continue;
        Diagnostic& d = diagnostics.error(Code::DuplicateName, part->nameRange(),
                                          "the name " + part->name + " belongs to a member of " + repeat->title());
        d.notes.push_back({"defined here", repeat->nameRange()});
    }
}

} // namespace

const NameSpace* Outline::spaceOf(const Kind& kind) const {
    switch (kind.role) {
    case Role::Material: return &materials;
    case Role::Surface: return &surfaces;
    case Role::Pattern: return &patterns;
    case Role::Config: return &configs;
    case Role::Instance:
    case Role::Layout:
    case Role::Medium:
    case Role::Look:
    case Role::Joint: // at the top level, between robots
    case Role::Region:
    case Role::Repeat: // at the top level
    case Role::Log: return &world;
    default: return nullptr;
    }
}

std::shared_ptr<Outline> Outline::build(std::shared_ptr<const TextSet> texts, std::shared_ptr<const Registry> registry,
                                        Diagnostics& diagnostics) {
    auto outline = std::make_shared<Outline>();
    outline->m_texts = texts;
    outline->m_registry = registry;
    if (countBlocks(*texts, kMaxObjects) > kMaxObjects) {
        diagnostics.error(Code::TooManyObjects, {0, {0, 0}},
                          "the text holds more than 200000 blocks once its imports are in place");
        return outline;
    }
    BlockView top = viewOf(*texts, texts->trees[0]->items(), 0, diagnostics);
    outline->settings = std::move(top.assignments);
    outline->params = std::move(top.params);
    ImportedTopLevel lifter(*texts, *registry, top.imported);
    PartBuilder builder(*texts, *registry, diagnostics);
    builder.setTop(top);
    std::uint32_t order = 0;
    const auto place = [&](const SourceBlock& placed) {
        outline->parts.push_back(std::make_unique<Part>(builder.build(placed, nullptr, order)));
    };
    for (const SourceBlock& placed : top.blocks) {
        for (const SourceBlock& lifted : lifter.from(*placed.block)) place(lifted);
        ++order;
        place(placed);
    }
    // names are unique per name space: a robot may have the name of a material
    std::unordered_map<const NameSpace*, PartNames> namers;
    for (const auto& part : outline->parts) {
        if (NameSpace* space = part->kind ? const_cast<NameSpace*>(outline->spaceOf(*part->kind)) : nullptr;
            space && part->block->name) {
            namers.try_emplace(space, diagnostics).first->second.reserve(part->name);
        }
    }
    for (const auto& part : outline->parts) {
        NameSpace* space = part->kind && part->usable ? const_cast<NameSpace*>(outline->spaceOf(*part->kind)) : nullptr;
        if (!space) {
            if (part->block->name) outline->unknown.insert(part->name);
            continue;
        }
        if (!namers.try_emplace(space, diagnostics).first->second.name(*part)) part->usable = false;
        else space->add(*part);
    }
    checkMemberNames(outline->world, diagnostics);
    outline->linkParts();
    return outline;
}

static void addFirstMembers(const Part& part, const std::string& before, std::vector<std::pair<const Part*, std::string>>& all) {
    const bool hasMembers = part.isRepeat() || part.is(Role::Layout);
    const std::string name = before + part.name + (hasMembers ? "_0" : "");
    all.emplace_back(&part, name);
    for (const Part& inner : part.parts)
        if (part.isRepeat() && inner.usable && inner.kind) addFirstMembers(inner, name + ".", all);
}

std::vector<std::pair<const Part*, std::string>> firstMembers(const Outline& outline) {
    std::vector<std::pair<const Part*, std::string>> all;
    for (const Part* part : outline.world.all()) addFirstMembers(*part, {}, all);
    return all;
}

const Part* layoutOfMember(const Outline& outline, std::string_view name) {
    const std::optional<MemberName> member = memberName(name);
    const Part* part = member ? outline.world.find(member->stem) : nullptr;
    return part && part->is(Role::Layout) ? part : nullptr;
}

} // namespace trundle
