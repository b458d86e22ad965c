// Needs: blocks of a config. Gives: edits that put them into a part or a Repeat, and that write mirror images of parts.
// Method: the text of the blocks is moved; only names that lead in or out of it change. A Part gets the place of its first body, where the
// text shows it; its mirror image is that of the config, or of the body that it counts from.
#include "project/edits/plan_wrap.h"

#include <algorithm>
#include <cctype>

#include "base/spelling.h"
#include "lang/characters.h"
#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "model/dotted_path.h"
#include "project/edits/mirrored_text.h"
#include "project/edits/wrapped_blocks.h"
#include "project/edits/wrapped_frame.h"
#include "project/edits/wrapped_place.h"
#include "project/objects/object_names.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

std::string upperFirst(std::string word) {
    if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    return word;
}

/// "Kind name {", the lines indented by one step, "}".
std::string blockOfLines(const std::string& head, const std::string& lines, const std::string& step) {
    std::string text = head + " {\n" + step;
    for (const char c : lines) text += c == '\n' ? "\n" + step : std::string(1, c);
    return text + "\n}";
}

/// The common name of the blocks; a block of that name is inside of what is around them now.
std::string nameAround(const WrappedBlocks& blocks, UsedNames& names) {
    const std::string common = blocks.commonName();
    const bool isOwn = std::ranges::find(blocks.blocks(), common, &Part::name) != blocks.blocks().end();
    return isOwn ? common : names.take(common);
}

/// Makes the PartConfig and the text of its use.
class PartMaker {
public:
    PartMaker(const LoadedProject& loaded, WrappedBlocks blocks)
        : m_loaded(loaded), m_texts(loaded.outline->texts()), m_blocks(std::move(blocks)), m_references(referencesIn(loaded)),
          m_names(loaded, &m_blocks.config(), loaded.registry->find("Part")) {}

    /// With an axis also its mirror image.
    Result<EditPlan> plan(std::optional<char> axis) {
        const Result<std::string> in = takeIn(m_loaded, m_blocks, m_references);
        if (!in.ok()) return in.error();
        const std::string place = takePlace(m_loaded, m_blocks, m_references);
        m_blocks.shortenNames(m_references);
        for (const NameReference& reference : m_references)
            if (m_blocks.contains(reference.name) && !m_blocks.isRemoved(reference.name)) bringIn(reference);
        for (const Part* block : m_blocks.blocks()) takeParamsOf(block->block->items);
        const Part& config = m_blocks.config();
        const std::string step = editStyle(*m_loaded.trees[config.file]).step;
        const std::string common = m_blocks.commonName();
        const std::string name = nameAround(m_blocks, m_names);
        const std::string type = UsedNames(m_loaded, nullptr, m_loaded.registry->find("PartConfig")).take(upperFirst(common));
        std::string lines;
        declareAlikeNames();
        for (const std::string& param : m_declared) lines += param + "\n";
        addBefore(m_loaded, &config, config.file, blockOfLines("PartConfig " + type, lines + m_blocks.text(), step), m_sheet);
        std::string use = "Part " + name + " { Config=" + type;
        if (!in.value().empty()) use += " In=" + in.value();
        if (!place.empty()) use += " Pos=" + place;
        for (const std::string& given : m_given) use += " " + given;
        use += " }";
        std::vector<std::string> selects{pathInside(m_blocks.parentPath(), name)};
        if (axis) {
            const std::string image = m_names.take(mirroredName(name));
            const Result<std::string> text = mirroredPart(use, image, *axis);
            if (!text.ok()) return text.error();
            use += "\n" + text.value();
            selects.push_back(pathInside(m_blocks.parentPath(), image));
        }
        m_blocks.replaceBy(use, m_sheet);
        keepOtherNames();
        if (Status status = m_blocks.prefixNames(m_references, name + ".", name + ".", m_sheet); !status.ok())
            return status.error();
        return m_sheet.plan(std::move(selects));
    }

private:
    /// Makes a Param of what a name inside the blocks leads to outside.
    void bringIn(const NameReference& reference) {
        if (!reference.target || m_blocks.find(reference.target) || reference.before.known() || isTop(reference.target)) return;
        const SourceText& source = m_loaded.trees[reference.name.file]->source();
        const std::string_view bytes = source.bytes();
        TextRange word = reference.name.range;
        while (word.end < bytes.size() && (isIdent(bytes[word.end]) || bytes[word.end] == '.')) ++word.end;
        const std::string path(source.slice(word));
        const bool isQuoted = word.begin > 0 && bytes[word.begin - 1] == '"';
        if (isQuoted) word = {word.begin - 1, word.end + 1};
        m_blocks.change({{reference.name.file, word}, "$" + paramFor(path)});
    }
    bool isTop(const BlockItem* block) const {
        return std::ranges::any_of(m_loaded.outline->parts, [&](const auto& part) { return part->block == block; });
    }

    /// The Param of the part that stands for a path of the config.
    std::string paramFor(const std::string& path) {
        const auto [it, isNew] = m_paramOf.try_emplace(path);
        if (isNew) {
            it->second = freeParam(std::string(lastWord(path)));
            m_given.push_back(it->second + "=" + path);
            m_named.emplace(it->second, path);
        }
        return it->second;
    }
    std::string freeParam(const std::string& preferred) {
        const auto isTaken = [&](const std::string& name) {
            const auto& globals = m_loaded.outline->params;
            const Kind* kinds[] = {m_loaded.registry->find("Part"), m_loaded.registry->find("PartConfig")};
            return m_params.contains(name) || paramOf(name) ||
                   std::ranges::any_of(kinds, [&](const Kind* kind) { return kind->find(name); }) ||
                   std::ranges::any_of(globals, [&](const SourceParam& p) { return p.name->text == name; }) ||
                   std::ranges::any_of(m_blocks.blocks(), [&](const Part* block) { return m_blocks.nameOf(*block) == name; });
        };
        std::string name = preferred;
        for (int i = 2; isTaken(name); ++i) name = preferred + std::to_string(i);
        m_params.insert(name);
        return name;
    }

    /// A Param of the config, or of what that is a variant of.
    const SourceParam* paramOf(const std::string& name) const {
        for (const Part* at = &m_blocks.config(); at; at = at->config)
            if (const SourceParam* param = at->param(name)) return param;
        return nullptr;
    }
    void takeParamsOf(const std::vector<Item>& items) {
        for (const Item& item : items) {
            if (m_blocks.isRemoved({m_blocks.config().file, item.range})) continue;
            if (const auto* block = item.as<BlockItem>()) takeParamsOf(block->items);
            if (const auto* a = item.as<AssignmentItem>()) takeParamsOf(a->value);
            if (const auto* param = item.as<ParamItem>()) takeParamsOf(param->value);
        }
    }
    void takeParamsOf(const Value& value) {
        for (const Element& e : value.elements) {
            if (e.kind == Element::Kind::ParamRef) takeParam(e.text);
            if (e.expression) takeParamsOf(*e.expression);
        }
    }
    void takeParamsOf(const Expression& e) {
        if (e.op == Expression::Op::Name) takeParam(e.name);
        for (const Expression& argument : e.arguments) takeParamsOf(argument);
    }
    /// A Param of the config that the blocks use, and those that its value uses. One that names a block has no value in the part.
    void takeParam(const std::string& name) {
        const SourceParam* param = paramOf(name);
        if (!param || !m_params.insert(name).second) return;
        m_given.push_back(name + "=$" + name);
        const SourceRange value{param->valueFile, param->value->range};
        if (value.range.size() == 0) return;
        const std::string text(m_texts.slice(value));
        const auto namesBlock = [&](const NameReference& m) { return m.target && !isTop(m.target) && isWithin(m.name, value); };
        if (std::ranges::any_of(m_references, namesBlock)) {
            m_named.emplace(name, text);
            return;
        }
        takeParamsOf(*param->value);
        m_declared.push_back("Param " + name + " = " + text + descriptionOf(*param));
    }
    /// Names of blocks are given by the Part, and `$chassis` is enough in the part, unless it looks like another Param misspelt.
    void declareAlikeNames() {
        for (const auto& [name, path] : m_named) {
            std::vector<std::string> others(m_params.begin(), m_params.end());
            std::erase(others, name);
            if (!nearestWords(name, others).empty()) m_declared.push_back("Param " + name + " = " + path);
        }
    }
    /// Limits and help of a Param, in their braces.
    std::string descriptionOf(const SourceParam& param) const {
        if (!param.item || param.item->close.size() == 0) return {};
        return std::string(m_texts.slice({param.file, {param.item->value.range.end, param.item->close.end}}));
    }

    void keepOtherNames() {
        for (const Part* block : m_blocks.blocks())
            if (!block->block->name)
                keepNames(m_blocks.config().parts, block->block->type.text, m_references, m_blocks.blocks(), m_sheet);
    }

    const LoadedProject& m_loaded;
    const TextSet& m_texts;
    WrappedBlocks m_blocks;
    const std::vector<NameReference> m_references;
    UsedNames m_names;
    EditBuilder m_sheet{m_loaded};
    std::set<std::string> m_params;               ///< of the PartConfig
    std::map<std::string, std::string> m_paramOf; ///< by path in the config
    std::map<std::string, std::string> m_named;   ///< Params that stand for blocks outside, with their paths
    std::vector<std::string> m_declared, m_given; ///< "Param r = 0.05"; "r=$r"
};

Result<EditPlan> makePart(const LoadedProject& loaded, const std::vector<std::string>& paths, std::optional<char> axis) {
    Result<WrappedBlocks> blocks = WrappedBlocks::of(loaded, paths, "PartConfig");
    if (!blocks.ok()) return blocks.error();
    return PartMaker(loaded, std::move(blocks).value()).plan(axis);
}

Result<EditPlan> mirrorBlocks(const LoadedProject& loaded, const std::vector<std::string>& paths, const std::vector<Chosen>& all,
                              char axis) {
    const auto hasPlace = [](const Chosen& c) { return !c.place.part->is(Role::Device) || c.place.part->kind->find("Pos"); };
    if (std::ranges::none_of(all, hasPlace))
        return Error{Code::WrongPlace, all.front().place.part->title() +
                                           " has no pose, so its mirror image would be the same; select what it belongs to along "
                                           "with it"};
    if (Status status = checkMirrorImage(loaded, all, axis); !status.ok()) return status.error();
    return makePart(loaded, paths, axis);
}

} // namespace

Result<EditPlan> planMakePart(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    return makePart(loaded, paths, std::nullopt);
}

Result<EditPlan> planMirror(const LoadedProject& loaded, const std::vector<std::string>& paths, char axis) {
    const Result<std::vector<Chosen>> all = chosen(loaded, paths);
    if (!all.ok()) return all.error();
    if (std::ranges::any_of(all.value(), [](const Chosen& c) { return !c.place.part->isPartUse(); }))
        return mirrorBlocks(loaded, paths, all.value(), axis);
    EditBuilder sheet(loaded);
    std::map<const Part*, UsedNames> names;
    std::vector<std::string> selects;
    for (const Chosen& c : all.value()) {
        const Part& part = *c.place.part;
        const Part* holder = c.place.above.empty() ? nullptr : c.place.above.back();
        if (!holder || !holder->is(Role::Config))
            return Error{Code::WrongPlace, part.title() + " is in " + (holder ? holder->title() : "no config") +
                                               "; what is directly in a config can be mirrored"};
        if (Status status = checkMirrorImage(loaded, {c}, axis); !status.ok()) return status.error();
        const std::string name = names.try_emplace(holder, loaded, holder, part.kind).first->second.take(mirroredName(part.name));
        const Result<std::string> text = mirroredPart(blockText(loaded, part.range), name, axis);
        if (!text.ok()) return text.error();
        sheet.add(copyBehind(*loaded.trees[part.file], part.range.range, text.value()));
        selects.push_back(pathInside(withoutLastWord(c.path), name));
    }
    return sheet.plan(std::move(selects));
}

Result<EditPlan> planRepeat(const LoadedProject& loaded, const std::vector<std::string>& paths, int count, const Vec3& step) {
    if (count < 1 || count > static_cast<int>(kMaxObjects))
        return Error{Code::OutOfRange, "a Repeat has from 1 to " + std::to_string(kMaxObjects) + " members"};
    Result<WrappedBlocks> read = WrappedBlocks::of(loaded, paths, "Repeat");
    if (!read.ok()) return read.error();
    WrappedBlocks& blocks = read.value();
    UsedNames names(loaded, blocks.holder(), loaded.registry->find("Repeat"));
    const std::string name = nameAround(blocks, names); // that of one member, as foot_0 and foot_1
    std::string pos;
    for (int i = 0; i < 3; ++i) pos += (i ? "," : "") + (step[i] == 0 ? "0" : "$(" + shortNumber(step[i]) + "*index)");
    const std::vector<NameReference> references = referencesIn(loaded);
    const Result<std::string> in = takeIn(loaded, blocks, references);
    if (!in.ok()) return in.error();
    const std::string frame = in.value().empty() ? "" : " In=" + in.value();
    const std::string head = "Count=" + std::to_string(count) + frame + (step == Vec3::Zero() ? "" : " Pos=" + pos);
    EditBuilder sheet(loaded);
    blocks.replaceBy(blockOfLines("Repeat " + name, head + "\n" + blocks.text(), editStyle(*loaded.trees[blocks.file()]).step),
                     sheet);
    for (const Part* block : blocks.blocks())
        if (!block->block->name && blocks.holder())
            keepNames(blocks.holder()->parts, block->block->type.text, references, blocks.blocks(), sheet);
    if (Status status = blocks.prefixNames(references, name + "_0.", name + ".", sheet); !status.ok()) return status.error();
    return sheet.plan({pathInside(blocks.parentPath(), name)});
}

} // namespace trundle
