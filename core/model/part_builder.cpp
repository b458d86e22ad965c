#include "model/part_builder.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/spelling.h"
#include "model/dotted_path.h"
#include "schema/allowed_parents.h"
#include "schema/foreign_words.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

std::string_view kindIn(const Part* parent) { return parent ? std::string_view(parent->block->type.text) : std::string_view(); }

std::string placeText(std::vector<std::string> all) {
    std::erase_if(all, [](const std::string& place) { return place == "Repeat" || place == "Ring"; }); // in the same configs
    std::replace(all.begin(), all.end(), std::string(), std::string("the top level"));
    for (std::string& place : all) {
        if (place != "the top level") place = withArticle(place);
    }
    return listText(all);
}

/// The kind whose Config names a block of kind `type`; empty: none.
std::string userOfConfig(std::string_view type) {
    return type == "RobotConfig" ? "Robot" : type == "StaticConfig" ? "Static" : type == "PartConfig" ? "Part" : "";
}

std::string lowerFirst(std::string word) {
    if (!word.empty()) word[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(word[0])));
    return word;
}

} // namespace

void PartBuilder::setTop(const BlockView& top) {
    m_top = &top;
    const auto isInner = [&](const SourceBlock& block) {
        const Kind* kind = m_registry.find(block.block->type.text);
        const bool isPlaced = kind && (kind->role == Role::Instance || kind->role == Role::Layout) && allows(nullptr, *kind);
        return block.file == 0 ? belongsInside(*block.block) : !isPlaced; // a joint joins robots that are imported
    };
    const auto isOwn = [](const auto& what) { return what.file == 0; };
    m_isFragment = std::ranges::any_of(top.blocks, isOwn) && std::ranges::all_of(top.blocks, isInner) &&
                   std::ranges::none_of(top.assignments.all(), isOwn);
}

/// Whether a block is written for another block: a Repeat is if what it repeats is.
bool PartBuilder::belongsInside(const BlockItem& block) const {
    const Kind* kind = m_registry.find(block.type.text);
    if (!kind || kind->role == Role::Settings) return false;
    if (kind->role != Role::Repeat) return !allows(nullptr, *kind) || kind->role == Role::Joint;
    return std::ranges::any_of(block.items, [&](const Item& item) {
        const auto* inner = item.as<BlockItem>();
        return inner && belongsInside(*inner);
    });
}

Part PartBuilder::build(const SourceBlock& placed, const Part* parent, std::uint32_t order) {
    Part part;
    part.block = placed.block;
    part.file = placed.file;
    part.range = {placed.file, placed.item->range};
    part.kind = m_registry.find(placed.block->type.text);
    part.order = order;
    if (placed.block->name) part.name = placed.block->name->text;
    if (!parent) {
        m_config = part.is(Role::Config) ? part.kind : nullptr;
        m_holder = nullptr;
    }
    part.usable = fits(part, parent);
    part.isInWorld = part.isRepeat() && !m_config;
    const Kind* around = m_holder;
    if (!part.isRepeat()) m_holder = part.kind;
    if (part.kind) fill(part, placed.file);
    m_holder = around;
    return part;
}

void PartBuilder::fill(Part& part, FileId file) {
    BlockView view = viewOf(m_texts, part.block->items, file, m_diagnostics);
    part.assignments = std::move(view.assignments);
    part.params = std::move(view.params);
    if (!part.usable) return; // no kind to check against: diagnostics about its contents would be misleading
    part.parts.reserve(view.blocks.size());
    for (const SourceBlock& inner : view.blocks) {
        const Kind* kind = m_registry.find(inner.block->type.text);
        const bool imported = inner.file != file;
        if (imported && kind &&
            (kind->role == Role::Material || kind->role == Role::Surface || kind->role == Role::Pattern ||
             kind->role == Role::Config)) {
            continue; // Outline::build adds it to the top level
        }
        part.parts.push_back(build(inner, &part, part.order));
    }
    if (part.isRepeat() && part.parts.empty())
        m_diagnostics.warning(Code::MissingRequired, part.nameRange(), part.title() + " has no blocks, so nothing is repeated");
    if (part.is(Role::Config)) checkParams(part);
    if (part.isRepeat() || part.is(Role::Layout))
        for (const SourceParam& param : part.params)
            if (param.name->text == "index" || param.name->text == "index2")
                m_diagnostics.error(Code::DuplicateName, param.nameRange(),
                                    param.name->text + " is the number of the member in $( ); give the Param another name");
    if (part.block->type.text == "RobotConfig") looseGeoms(part);
    nameParts(part);
}

/// An instance has Config, Pos ... itself: it could not set a Param of that name.
void PartBuilder::checkParams(const Part& config) {
    const std::string& type = config.block->type.text;
    const std::string user = userOfConfig(type);
    const Kind* instance = m_registry.find(user);
    for (const SourceParam& param : config.params)
        if (instance && instance->find(param.name->text))
            m_diagnostics.error(Code::DuplicateName, param.nameRange(),
                                "a Param cannot be named " + param.name->text + ": every " + user + " has that property itself");
}

void PartBuilder::nameParts(Part& part) {
    PartNames names(m_diagnostics);
    if (part.is(Role::Config)) {
        for (const SourceParam& p : part.params) names.take(p.name->text, p.nameRange());
    }
    for (const Part& inner : part.parts) {
        if (inner.block->name) names.reserve(inner.name); // generated names avoid names given further down
    }
    for (Part& inner : part.parts) {
        if (!names.name(inner)) inner.usable = false;
    }
    part.makeIndex();
    for (Part& inner : part.parts) {
        const std::optional<MemberName> member = memberName(inner.name);
        const Part* repeat = member ? part.find(member->stem) : nullptr;
        if (!repeat || !repeat->isRepeat() || !repeat->usable) continue;
        Diagnostic& d = m_diagnostics.error(Code::DuplicateName, inner.nameRange(),
                                            "the name " + inner.name + " belongs to a member of " + repeat->title());
        d.notes.push_back({"defined here", repeat->nameRange()});
        inner.usable = false;
    }
}

/// What is in a Repeat is in the config or body that holds it, or at the top level, too.
bool PartBuilder::allows(const Part* parent, const Kind& kind) const {
    const bool isInRepeat = parent && parent->isRepeat();
    const std::string_view around = m_holder ? std::string_view(m_holder->name) : std::string_view();
    return isAllowedInside(kind, kindIn(parent)) && (!isInRepeat || isAllowedInside(kind, around));
}

std::string PartBuilder::placeOf(const Part* parent) const {
    if (!parent) return "at the top level";
    const bool isInRepeat = parent->isRepeat() && m_holder;
    const std::string around = isInRepeat ? " of " + withArticle(m_holder->name) : parent->isRepeat() ? " at the top level" : "";
    return "in " + withArticle(kindIn(parent)) + around;
}

bool PartBuilder::fits(Part& part, const Part* parent) {
    if (!part.kind) {
        unknownKind(part, parent);
        return false;
    }
    const bool isOfFragment =
        !parent && m_isFragment && part.file == 0 && (part.is(Role::Joint) || part.isRepeat()); // joins what is beside it there
    if (!isOfFragment && allows(parent, *part.kind)) return true;
    const bool loose = part.is(Role::Geom) && kindIn(parent) == "RobotConfig" && isAllowedInside(*part.kind, "Body");
    if (!loose) misplaced(part, parent); // loose geoms get a message of their own, with a fix
    return false;
}

/// `left { r = 0.06 }` for `left.r = 0.06` of an instance or a variant.
bool PartBuilder::isMeantAsPath(const Part& part, const Part* parent) {
    const std::string& word = part.block->type.text;
    const bool hasConfig = parent && parent->kind && parent->kind->find("Config") && parent->assignments.find("Config");
    const bool canBe = hasConfig && !part.block->name && word[0] >= 'a' && word[0] <= 'z';
    if (!canBe || part.block->items.empty()) return false;
    std::string paths;
    for (const Item& item : part.block->items) {
        const auto* a = item.as<AssignmentItem>();
        if (!a) return false;
        paths += (paths.empty() ? "" : " ") + word + "." + std::string(m_texts.slice({part.file, item.range}));
    }
    constexpr std::size_t kShort = 60;
    Diagnostic& d = m_diagnostics.error(Code::UnknownKind, part.typeRange(),
                                        "there is no kind " + word + "; values of what is in a config are set by path: " +
                                            (paths.size() < kShort ? paths : word + ". ... = ..."));
    if (paths.find('\n') == std::string::npos) d.fixes.push_back({"set them by path", {{part.range, paths}}});
    return true;
}

/// `Wheel left {` for `Part left { Config=Wheel`.
bool PartBuilder::isConfigName(const Part& part, const Part* parent) {
    const std::string& word = part.block->type.text;
    const auto names = [&](const SourceBlock& each) { return each.block->name && each.block->name->text == word; };
    if (!m_top || manyAlready(m_diagnostics)) return false;
    const auto found = std::ranges::find_if(m_top->blocks, names);
    if (found == m_top->blocks.end()) return false;
    const std::string& type = found->block->type.text;
    const std::string user = userOfConfig(type);
    const Kind* kind = m_registry.find(user);
    if (!kind) return false;
    const std::string name = part.block->name ? " " + part.name : "";
    const bool isHere = allows(parent, *kind);
    std::string text = word + " is " + withArticle(type) + ", not a kind; " + withArticle(user) + " uses it: `" + user +
                       (name.empty() ? " name" : name) + " { Config=" + word + "`";
    if (!isHere) text += user == "Part" ? ", in a config" : ", at the top level";
    Diagnostic& d = m_diagnostics.error(Code::UnknownKind, part.typeRange(), text);
    if (!isHere || part.block->open.size() == 0) return true;
    const auto behind = part.block->open.end;
    d.fixes.push_back(
        {user + name + " { Config=" + word, {{part.typeRange(), user}, {{part.file, {behind, behind}}, " Config=" + word}}});
    return true;
}

void PartBuilder::unknownKind(const Part& part, const Part* parent) {
    const auto& name = part.block->name;
    if (name && name->range.begin < part.typeRange().range.begin) return; // `left = Wheel {`, which was reported as a whole
    if (isMeantAsPath(part, parent) || isConfigName(part, parent)) return;
    const std::string& word = part.block->type.text;
    std::vector<std::string> candidates;
    for (const Kind* kind : m_registry.all()) {
        if (allows(parent, *kind)) candidates.push_back(kind->name);
    }
    const bool isWorldInstance = parent && (parent->is(Role::Instance) || parent->is(Role::Layout)) && !parent->isPartUse();
    const bool holdsModuleKinds = isWorldInstance || (parent && m_config);
    std::vector<std::string> near = manyAlready(m_diagnostics) ? std::vector<std::string>() : meantWords(word, candidates);
    for (const Kind* kind : m_registry.all()) // `cylinder` is Cylinder, in the wrong place as well
        if (spellingDistance(word, kind->name) < 1 && (near.empty() || near[0] != kind->name))
            near.insert(near.begin(), kind->name);
    if (m_texts.openModules && holdsModuleKinds && (near.empty() || isWorldInstance)) return;
    if (near.empty() && !manyAlready(m_diagnostics)) {
        std::vector<std::string> others;
        for (const Kind* kind : m_registry.all()) {
            if (kind->role != Role::Settings) others.push_back(kind->name);
        }
        near = meantWords(word, others);
    }
    Diagnostic& d = m_diagnostics.error(Code::UnknownKind, part.typeRange(), "there is no kind " + word);
    if (near.empty()) {
        d.message += parent ? "; " + withArticle(kindIn(parent)) +
                                  (candidates.empty() ? " holds no blocks" : " may hold " + listText(candidates))
                            : "; allowed at the top level: " + listText(candidates, "and");
        if (isWorldInstance && candidates.empty()) {
            d.message = "there is no kind " + word + "; a controller's kind comes from the module that #loadModule names";
        }
    }
    suggestWords(d, std::move(near), part.typeRange());
}

void PartBuilder::misplaced(const Part& part, const Part* parent) {
    const std::string here = placeOf(parent);
    const std::vector<std::string> legal = allowedParents(*part.kind);
    if (part.is(Role::Settings)) {
        m_diagnostics.error(Code::WrongPlace, part.typeRange(),
                            "settings are written at the top level without a block: Tick = 0.01");
        return;
    }
    if (!parent && m_isFragment && part.file == 0) {
        if (!std::exchange(m_fragmentReported, true))
            m_diagnostics.hint(Code::WrongPlace, part.typeRange(),
                               "this file is a part for import in " + placeText(legal) +
                                   "; what is in it is checked with the file that imports it there");
        return;
    }
    const bool top = std::ranges::all_of(
        legal, [](const std::string& place) { return place.empty() || place == "Repeat" || place == "Ring"; });
    std::string text =
        part.block->type.text + " is allowed " + (top ? "at the top level" : "in " + placeText(legal)) + ", not " + here;
    if (!parent && part.kind->name == "Gear") text += ": it couples two joints of one robot, not of two";
    m_diagnostics.error(Code::WrongPlace, part.typeRange(), text);
}

void PartBuilder::looseGeoms(const Part& config) {
    for (std::size_t i = 0; i < config.parts.size(); ++i) {
        const auto loose = [&](std::size_t k) {
            return k < config.parts.size() && config.parts[k].is(Role::Geom) && !config.parts[k].usable &&
                   isAllowedInside(*config.parts[k].kind, "Body");
        };
        if (!loose(i)) continue;
        std::size_t last = i;
        while (loose(last + 1) && config.parts[last + 1].file == config.parts[i].file) ++last;
        const Part& first = config.parts[i];
        Diagnostic& d = m_diagnostics.error(Code::LooseGeom, first.typeRange(),
                                            withArticle(first.block->type.text) + " of a RobotConfig belongs in a Body");
        const TextRange from = first.range.range, to = config.parts[last].range.range;
        std::string name = "chassis";
        for (int n = 2; config.find(name); ++n) name = "body" + std::to_string(n);
        d.fixes.push_back(
            {"Body " + name + " { ... }",
             {{{first.file, {from.begin, from.begin}}, "Body " + name + " { "}, {{first.file, {to.end, to.end}}, " }"}}});
        i = last;
    }
}

bool PartNames::name(Part& part) {
    if (!part.block->name) {
        if (part.kind && !part.kind->nameOptional) {
            if (!part.usable) return false;
            Diagnostic& d =
                m_diagnostics.error(Code::MissingName, part.typeRange(), "this " + part.block->type.text + " needs a name");
            std::string name = lowerFirst(part.block->type.text);
            for (int n = 2; m_taken.count(name); ++n) name = lowerFirst(part.block->type.text) + std::to_string(n);
            const std::uint32_t at = part.block->type.range.end;
            d.fixes.push_back({part.block->type.text + " " + name, {{{part.file, {at, at}}, " " + name}}});
            return false;
        }
        const std::string base = lowerFirst(part.block->type.text);
        do {
            const int n = ++m_counts[base];
            part.name = n == 1 ? base : base + std::to_string(n);
        } while (m_taken.count(part.name) || m_reserved.count(part.name));
        m_taken.emplace(part.name, part.nameRange());
        return true;
    }
    const auto [it, fresh] = m_taken.emplace(part.name, part.nameRange());
    if (fresh) return true;
    Diagnostic& d = m_diagnostics.error(Code::DuplicateName, part.nameRange(), "the name " + part.name + " is taken already");
    if (it->second.known()) d.notes.push_back({"first defined here", it->second});
    if (it->second.file == d.range.file && it->second.range.begin > d.range.range.begin)
        std::swap(d.range, d.notes.back().second);
    return false;
}

} // namespace trundle
