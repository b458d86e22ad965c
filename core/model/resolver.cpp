#include "model/resolver.h"

#include "base/spelling.h"
#include "model/resolve/resolve_steps.h"
#include "model/robot_path.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr std::size_t kMostNames = 500; // that a message chooses from

/// Where several robots may be named, the name of all members of a Repeat comes before theirs.
std::vector<std::string> robotNames(const ResolveContext& context, const Property& property) {
    std::vector<std::string> names;
    for (const Part* part : context.outline.world.all())
        if (part->kind->name == "Robot" || part->is(Role::Layout)) names.push_back(part->name);
    const auto isInRepeat = [](const RobotSpec& robot) { return !robot.scenery && robot.name.find('.') != std::string::npos; };
    for (const RobotSpec& robot : context.out.robots) {
        std::string all = isInRepeat(robot) && property.maxCount > 1 ? nameOfAll(robot.name) : std::string();
        if (!all.empty() && std::ranges::find(names, all) == names.end() && names.size() < kMostNames)
            names.push_back(std::move(all));
    }
    for (const RobotSpec& robot : context.out.robots)
        if (isInRepeat(robot) && names.size() < kMostNames) names.push_back(robot.name);
    return names;
}

void reportNoRobot(ResolveContext& context, const Property& property, const std::string& name, const std::string& what,
                   SourceRange place, bool isLiteral) {
    Diagnostic& d = context.diagnostics.error(Code::UnknownReference, place,
                                              property.name + " names " + name + ", " + what + "; it takes a robot");
    suggest(d, name, robotNames(context, property), isLiteral ? place : SourceRange{});
}

/// Whether a name is that of a robot in a member that a Repeat, Grid or Scatter does not have; reports it.
bool isMissingMember(ResolveContext& context, const Property& property, const std::string& name, SourceRange place,
                     bool isLiteral) {
    const std::optional<MissingMember> missing = missingMember(context.out.robots, name);
    const Part* block = missing ? context.outline.world.find(missing->all) : nullptr;
    if (!block) return false;
    Diagnostic& d = context.diagnostics.error(Code::UnknownReference, place,
                                              property.name + " names " + name + ", but " + block->title() + " has no member " +
                                                  missing->name + "; the last one is " + missing->last);
    const bool isWritten = isLiteral && context.texts.slice(place) == name; // in a member of a Repeat it may be `cart_2`
    suggestWords(d, {missing->inLast}, isWritten ? place : SourceRange{});
    return true;
}

/// Whether a Grid or Scatter has put scenery into the world.
bool isScenery(const ResolveContext& context, const Part& layout) {
    return std::ranges::find(context.out.statics, layout.range, &StaticSpec::range) != context.out.statics.end();
}

} // namespace

bool checkRobots(ResolveContext& context, const Property& property, ResolvedValue& value) {
    std::vector<std::string> names;
    const IsOwnName isOwn{context.outline};
    const bool isLiteral = value.origin != Origin::Param && (value.value.texts.size() == 1 || !value.names.empty());
    for (std::size_t k = 0; k < value.value.texts.size(); ++k) {
        const std::string& name = value.value.texts[k];
        const SourceRange& place = value.rangeOf(k);
        const Part* part = context.outline.world.find(name);
        const bool isInRepeat = part && name.find('.') != std::string::npos;
        if ((!part && layoutOfMember(context.outline, name)) || isInRepeat) {
            const bool isForAll = isInRepeat && property.maxCount > 1; // `row.cart` names all members
            const bool there = std::ranges::any_of(context.out.robots, [&](const RobotSpec& robot) {
                return robot.name == name || (isForAll && isNamedBy(robot.name, name, isOwn));
            });
            if (!there && context.isFailedRobot(name)) return false;
            if (!there && !context.out.robots.empty()) {
                if (!isMissingMember(context, property, name, place, isLiteral))
                    context.unknownReference(property.name, "robot", name, place, false, robotNames(context, property));
                return false;
            }
        } else if (!part && !context.outline.unknown.count(name)) {
            context.unknownReference(property.name, "robot", name, place, isLiteral, robotNames(context, property));
            return false;
        } else if (part && part->kind->name != "Robot" && !part->is(Role::Layout)) {
            reportNoRobot(context, property, name, withArticle(part->kind->name), place, isLiteral);
            return false;
        }
        if (part && (part->is(Role::Layout) || isInRepeat) && property.maxCount > 1) {
            const std::size_t before = names.size();
            for (const RobotSpec& robot : context.out.robots)
                if (isNamedBy(robot.name, name, isOwn)) names.push_back(robot.name);
            if (names.size() == before && isScenery(context, *part)) {
                reportNoRobot(context, property, name, withArticle(part->kind->name) + " of scenery", place, isLiteral);
                return false;
            }
        } else {
            names.push_back(name);
        }
    }
    value.value.texts = std::move(names);
    value.names.clear();
    return true;
}

namespace {

void reportDefaults(ResolveContext& context) {
    if (context.defaulted.empty()) return;
    const auto& [part, missing] = context.defaulted.front();
    std::string text = part->title() + " names no " + missing + ": the built-in default is used";
    if (const std::size_t others = context.defaulted.size() - 1)
        text += " (here and for " + std::to_string(others) + (others == 1 ? " other geom)" : " other geoms)");
    context.diagnostics.hint(Code::DefaultUsed, part->nameRange(), text);
}

/// Where a lamp or the sun of a member of a Repeat is.
void placeLight(const ExpandedPart& expanded, ComponentSpec& light) {
    const auto numbersOf = [&](const char* key) -> std::vector<double>* {
        const auto it = light.values.find(key);
        return it != light.values.end() && it->second.value.numbers.size() == 3 ? &it->second.value.numbers : nullptr;
    };
    if (!expanded.frame->use) return;
    const auto put = [](std::vector<double>& numbers, const Vec3& v) { numbers = {v.x(), v.y(), v.z()}; };
    if (auto* pos = numbersOf("Pos")) put(*pos, expanded.placed({Vec3(pos->data()), Quat::Identity()}).position);
    if (auto* direction = numbersOf("Direction")) put(*direction, expanded.placed(Pose{}).rotation * Vec3(direction->data()));
}

/// Where a view of a member of a Repeat is; one that goes along with a robot is where the robot is.
void placeView(const ExpandedPart& expanded, ComponentSpec& view) {
    if (!expanded.frame->use || !view.text("Robot").empty()) return;
    for (const char* key : {"Eye", "Target"}) {
        ResolvedValue& value = view.values[key];
        const Vec3 point = expanded.placed({Vec3(value.value.numbers.data()), Quat::Identity()}).position;
        value.value.numbers = {point.x(), point.y(), point.z()};
    }
}

/// Text of a log or view in a member of a Repeat that names a robot or a view of the world: "cart/leftMotor/*" of "lane_1.cart/leftMotor/*".
/// A file gets the name of the member in front, so that each member has one of its own.
void nameInMember(const ExpandedPart& expanded, const std::string& key, std::string& text) {
    const PartFrame& frame = *expanded.frame;
    if (!frame.use || text.empty()) return;
    if (key == "File") text.insert(text.rfind('/') + 1, frame.prefix);
    if (key == "View" && frame.config->find(text)) text = frame.prefix + text;
    if (key != "Robot" && key != "Camera" && key != "Signals") return;
    const std::size_t slash = std::min(text.find('/'), text.size());
    text = nameMeant(text.substr(0, slash), frame) + text.substr(slash);
}

void resolveLog(ResolveContext& context, AppearanceChecker& looks, const ExpandedPart& expanded) {
    const Part& part = *expanded.part;
    ParamScope scope(expanded.frame->scope);
    scope.declare(part.params);
    Record record = context.read(part, scope, nullptr, Origin::Config);
    bool good = record.complete;
    for (std::size_t i = 0; i < record.values.size(); ++i) {
        const Property& property = record.kind->properties[i];
        if (!record.values[i] || record.values[i]->origin == Origin::Default) continue;
        std::vector<std::string>& texts = record.values[i]->value.texts;
        for (std::string& text : texts) nameInMember(expanded, property.name, text);
        const auto isFailed = [&](const std::string& text) { return context.isFailedRobot(text); };
        if (property.name == "Robot" && std::ranges::any_of(texts, isFailed)) good = false; // reported at the robot
        const bool robots =
            property.type == PropertyType::Reference && std::count(property.choices.begin(), property.choices.end(), "Robot");
        if (robots) good = checkRobots(context, property, *record.values[i]) && good;
    }
    looks.check(record, part);
    if (!good) return;
    ComponentSpec spec = componentFrom(record, part);
    spec.name = expanded.name();
    if (part.kind->name == "Light") placeLight(expanded, spec);
    if (part.kind->name == "View") placeView(expanded, spec);
    (part.is(Role::Log) ? context.out.logs : context.out.looks).push_back(std::move(spec));
}

} // namespace

void resolveLogs(ResolveContext& context, PartExpansion& world) {
    AppearanceChecker looks(context);
    world.each(Role::Log, [&](const ExpandedPart& part) { resolveLog(context, looks, part); });
    world.each(Role::Look, [&](const ExpandedPart& part) { resolveLog(context, looks, part); });
}

std::shared_ptr<ExperimentSpec> resolve(const Outline& outline, const AssetLookup& assets, Diagnostics& diagnostics) {
    auto experiment = std::make_shared<ExperimentSpec>();
    ResolveContext context(outline, assets, diagnostics, *experiment);
    context.evaluator.checkAll(context.globals);
    experiment->settings = resolveSettings(context);
    resolveMaterials(context);
    resolveSurfaces(context);
    resolveRadio(context);
    PartExpansion world(context);
    resolveInstances(context, world);
    resolveLinks(context, world);
    checkRadios(context);
    resolveLogs(context, world);
    checkFrameLogs(context);
    reportDefaults(context);
    return experiment;
}

} // namespace trundle
