#include "project/edits/edit_target.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "project/edits/plan_targets.h"
#include "project/loading/search.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

/// The config that a path below an instance leads into, and the path within it. `config` is null if the path means a property of
/// the instance itself.
struct ConfigPath {
    const Part* config = nullptr;
    const Part* holder = nullptr; ///< block that has the value
    std::string within;           ///< "leftMotor.Resistance", "trackWidth"
};

ConfigPath configPathOf(const LoadedProject& loaded, const ObjectLocation& place, const std::string& key) {
    const Part* config = place.instance ? configOf(loaded, *place.instance) : nullptr;
    if (!config || !place.part) return {};
    if (place.part == place.instance) {
        const bool own = place.instance->kind && place.instance->kind->find(key);
        const bool theirs = config->param(key) || (config->kind && config->kind->find(key));
        return own || !theirs ? ConfigPath{} : ConfigPath{config, config, key};
    }
    const bool through = std::ranges::find(place.above, config) != place.above.end();
    return through ? ConfigPath{config, place.part, place.within + "." + key} : ConfigPath{};
}

/// Whether an instance is in a config, as a Part, or is one, as a variant.
bool isOfConfig(const Part& instance) { return instance.isPartUse() || isVariant(instance); }

/// Whether an edit is inside a block; an insertion right before the block is not.
bool isInside(const SourceRange& edit, const SourceRange& block) {
    return edit.file == block.file && block.range.begin < edit.range.begin && edit.range.end <= block.range.end &&
           edit.range.begin < block.range.end;
}

bool changesInside(const Part& part, const std::vector<TextEdit>& edits) {
    return std::any_of(edits.begin(), edits.end(), [&](const TextEdit& edit) { return isInside(edit.range, part.range); });
}

bool isChanged(const Part& part, const FileEdits& edits) {
    const auto here = edits.find(part.range.file);
    if (here != edits.end() && changesInside(part, here->second)) return true;
    return std::any_of(part.parts.begin(), part.parts.end(), [&](const Part& inner) {
        return inner.range.file != part.range.file && isChanged(inner, edits); // defined in a file that the block imports
    });
}

} // namespace

bool isShippedFile(const LoadedProject& loaded, FileId file) {
    if (file == 0 || file >= loaded.paths.size() || loaded.shippedConfigs.empty()) return false;
    return loaded.paths[file].starts_with(loaded.shippedConfigs + "/");
}

FileEdits editsOf(const Fix& fix) {
    FileEdits edits;
    for (const TextEdit& edit : fix.edits) edits[edit.range.file].push_back(edit);
    return edits;
}

std::vector<const Part*> instancesOf(const LoadedProject& loaded, const Part& config) {
    std::vector<const Part*> instances;
    for (const Part* repeat : loaded.outline->world.all())
        if (repeat->isRepeat())
            eachInWorld(*repeat, repeat->name, [&](const Part& part, const std::string&) {
                if (isPlaced(part) && configOf(loaded, part) == &config) instances.push_back(&part);
            });
    for (const auto& part : loaded.outline->parts) {
        const bool isInstance = isPlaced(*part) || isVariant(*part);
        if (isInstance && configOf(loaded, *part) == &config) instances.push_back(part.get());
        if (part->is(Role::Config))
            eachPartUse(*part, [&](const Part& use) {
                if (use.config == &config) instances.push_back(&use);
            });
    }
    return instances;
}

const Part* holderOf(const LoadedProject& loaded, const Part& user) {
    if (user.is(Role::Config)) return &user;
    for (const Part* config : loaded.outline->configs.all()) {
        bool has = false;
        eachPartUse(*config, [&](const Part& use) { has |= &use == &user; });
        if (has) return config;
    }
    return nullptr;
}

bool isUsedByOwnTexts(const LoadedProject& loaded, const Part& config) {
    std::set<const Part*> seen{&config};
    for (std::vector<const Part*> open{&config}; !open.empty();) {
        const Part* next = open.back();
        open.pop_back();
        for (const Part* user : instancesOf(loaded, *next)) {
            if (!isShippedFile(loaded, user->file)) return true;
            const Part* holder = holderOf(loaded, *user);
            if (holder && seen.insert(holder).second) open.push_back(holder);
        }
    }
    return false;
}

std::string shippedDefinitionAt(const LoadedProject& loaded, const std::string& path) {
    const Outline& outline = *loaded.outline;
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place) // an object may have the name of a Param
        for (const SourceParam& param : outline.params)
            if (param.name->text == path) return isShippedFile(loaded, param.file) ? path : std::string();
    if (!place || !place->part || place->instance || !isShippedFile(loaded, place->part->file)) return {};
    const Part& top = place->above.empty() ? *place->part : *place->above.front();
    const NameSpace* space = top.kind ? outline.spaceOf(*top.kind) : nullptr;
    const bool isDefinition = space == &outline.materials || space == &outline.surfaces || space == &outline.patterns;
    return space && isDefinition ? pathOfConfig(top) : std::string();
}

EditTarget targetOfStructure(const LoadedProject& loaded, const Part& config, const Part* instance, ConfigUsers& users) {
    EditTarget target;
    target.path = pathOfConfig(config);
    target.file = config.file;
    target.config = &config;
    target.instance = instance;
    target.isShipped = isShippedFile(loaded, config.file);
    target.instances = instancesOf(loaded, config).size();
    if (!target.isShipped) target.users = users.of(loaded, config);
    return target;
}

EditTarget targetOfValue(const LoadedProject& loaded, const std::string& propertyPath, ConfigUsers& users) {
    EditTarget target;
    target.path = propertyPath;
    const std::string key(lastWord(propertyPath));
    if (key == propertyPath) {
        target.definition = shippedDefinitionAt(loaded, propertyPath);
        target.isShipped = !target.definition.empty();
        return target;
    }
    const std::optional<ObjectLocation> place = placeOf(loaded, withoutLastWord(propertyPath));
    if (!place || !place->part || place->member) return target;
    target.file = place->part->file;
    const Part* top = place->above.empty() ? place->part : place->above.front();
    if (!place->instance) {
        if (top->is(Role::Config)) target.config = top;
        if (!target.config) target.definition = shippedDefinitionAt(loaded, std::string(withoutLastWord(propertyPath)));
        target.isShipped = isShippedFile(loaded, target.file) && (target.config || !target.definition.empty());
        return target;
    }
    target.instance = place->instance;
    if (isOfConfig(*place->instance) &&
        isShippedFile(loaded, target.instance->file)) { // its override is in the config that has it
        target.config = top;
        target.file = target.instance->file;
        target.isOverride = place->part != place->instance;
        target.isShipped = true;
        return target;
    }
    const ConfigPath inConfig = configPathOf(loaded, *place, key);
    if (!inConfig.config) return target;
    target.config = inConfig.config;
    target.isOverride = true;
    target.file = place->instance->file;
    target.instances = instancesOf(loaded, *inConfig.config).size();
    const bool apart = inConfig.config->file != target.file || inConfig.holder->file != target.file;
    if (apart || target.instances != 1 || overrideAt(loaded, *place, key)) return target;
    std::vector<std::string> all = users.of(loaded, *inConfig.config);
    if (std::any_of(all.begin(), all.end(), [&](const std::string& user) { return user != loaded.paths[target.file]; }))
        return target;
    target.isOverride = false;
    target.path = pathOfConfig(*inConfig.config) + "." + inConfig.within;
    const std::optional<ObjectLocation> there = placeOf(loaded, withoutLastWord(target.path));
    if (there && there->instance) return targetOfValue(loaded, target.path, users); // of a Part in the config
    target.users = std::move(all);
    return target;
}

std::vector<const Part*> configsChangedBy(const LoadedProject& loaded, const EditPlan& plan) {
    const auto isUserOnly = [&](const Part& config) {
        return !plan.renamedIn.empty() && plan.renamedIn != pathOfConfig(config) && !isShippedFile(loaded, config.file);
    };
    std::vector<const Part*> changed;
    for (const Part* config : loaded.outline->configs.all())
        if (isChanged(*config, plan.edits) && !isUserOnly(*config)) changed.push_back(config);
    return changed;
}

std::vector<std::string> definitionsChangedBy(const LoadedProject& loaded, const EditPlan& plan) {
    const Outline& outline = *loaded.outline;
    std::vector<std::string> changed;
    for (const NameSpace* space : {&outline.materials, &outline.surfaces, &outline.patterns})
        for (const Part* part : space->all())
            if (isShippedFile(loaded, part->file) && isChanged(*part, plan.edits)) changed.push_back(pathOfConfig(*part));
    for (const SourceParam& param : outline.params) {
        const auto here = plan.edits.find(param.file);
        if (here == plan.edits.end() || !isShippedFile(loaded, param.file)) continue;
        const TextRange text{param.name->range.begin, param.value->range.end};
        if (std::ranges::any_of(here->second, [&](const TextEdit& edit) {
                return text.begin <= edit.range.range.begin && edit.range.range.end <= text.end;
            }))
            changed.push_back(param.name->text);
    }
    return changed;
}

} // namespace trundle
