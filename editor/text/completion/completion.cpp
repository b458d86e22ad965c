// Needs: a loaded project, an offset. Returns: the possible completions. Method: the tokens before the caret give the position
// in the statement, the syntax tree gives the enclosing block; outline and registry list the existing names.
#include "editor/text/completion/completion.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/units.h"
#include "editor/text/completion/completion_context.h"
#include "editor/text/completion/completion_values.h"
#include "editor/text/symbols/property_text.h"
#include "editor/text/symbols/text_location.h"
#include "lang/characters.h"
#include "lang/edit_style.h"
#include "model/config_blocks.h"
#include "model/param_reference.h"
#include "schema/allowed_parents.h"

namespace trundle {
namespace {

using Where = CompletionContext::Where;

class Completer {
public:
    Completer(const LoadedProject& loaded, FileId file, std::uint32_t offset, const FileFolders& folders)
        : m_loaded(loaded), m_tree(*loaded.trees[file]), m_text(m_tree.source().bytes()), m_folders(folders),
          m_context(completionContext(m_tree, offset)), m_offset(offset), m_place(placeAt(loaded, file, m_context.word.begin)) {}

    Completions complete() {
        m_out.word = m_context.word;
        switch (m_context.where) {
        case Where::Nowhere: break;
        case Where::DirectiveName: directiveNames(); break;
        case Where::Import: files(folders(m_folders.texts), {"sim", "txt"}); break;
        case Where::Module: modules(); break;
        case Where::Statement: statement(); break;
        case Where::Override: override(); break;
        case Where::Value: value(); break;
        case Where::Number: number(); break;
        case Where::Expression: expression(); break;
        case Where::ParamUse: params("$"); break;
        }
        return std::move(m_out);
    }

private:
    Completion& add(CompletionSort sort, std::string label, std::string insert, std::string detail, std::string help) {
        const std::size_t end = insert.size();
        m_out.items.push_back({sort, std::move(label), std::move(insert), end, end, std::move(detail), std::move(help), false});
        return m_out.items.back();
    }

    // --- directives and files ---

    void directiveNames() {
        add(CompletionSort::Word, "#import", "#import ", "", "Imports everything from another file.").hasMore = true;
        add(CompletionSort::Word, "#loadModule", "#loadModule ", "", "Loads the controllers and components of a library.")
            .hasMore = true;
    }

    [[nodiscard]] std::vector<std::string> folders(const std::vector<std::string>& more) const {
        std::vector<std::string> all{std::filesystem::path(m_loaded.paths[m_place.file]).parent_path().string(),
                                     m_loaded.projectFolder};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    void files(const std::vector<std::string>& folders, const std::vector<std::string>& endings) {
        const std::string own = std::filesystem::path(m_loaded.paths[m_place.file]).filename().string();
        std::set<std::string> there;
        for (const Item& item : m_place.items(m_loaded)) {
            const auto* import = item.as<ImportItem>();
            if (import && !(import->pathRange.begin <= m_place.offset && m_place.offset <= import->pathRange.end))
                there.insert(import->path);
        }
        for (const std::string& file : filesBelow(folders, endings))
            if (file != own && !there.contains(file)) add(CompletionSort::File, file, asWord(file), "", "");
    }

    void modules() {
        for (const std::string& module : modulesBelow(folders(m_folders.modules)))
            add(CompletionSort::File, module, module, "", "");
    }

    /// In quotes if the language requires them.
    [[nodiscard]] std::string asWord(const std::string& text) const {
        const bool plain = m_context.quoted || m_context.where == Where::Import ||
                           (!text.empty() && isIdentStart(text[0]) && std::all_of(text.begin(), text.end(), isWordChar));
        return plain ? text : '"' + text + '"';
    }

    // --- statements ---

    void statement() {
        if (const ParamItem* param = m_place.described()) return descriptionWords(*param);
        if (m_place.kind) {
            keys(*m_place.kind, {});
            if (m_place.instance && m_place.config) configKeys(*m_place.config);
        }
        kinds();
        if (atStatement("=")) return;
        Completion& param = add(CompletionSort::Word, "Param", "Param name = ", "", "A value with a name, for use as $name.");
        param.select = 6;
        param.caret = 10;
        if (atLineBegin()) directiveNames();
    }

    /// Between the braces behind a Param.
    void descriptionWords(const ParamItem& param) {
        const auto isThere = [&](const std::string& key) {
            return std::ranges::any_of(param.items, [&](const Item& item) {
                const auto* a = item.as<AssignmentItem>();
                return a && !touches(item.range, m_place.offset) && a->path.front().text == key;
            });
        };
        for (const auto& [key, help] : descriptionKeys())
            if (!isThere(key)) add(CompletionSort::Key, key, key + equals(), "", help);
    }

    [[nodiscard]] bool atLineBegin() const {
        const std::size_t begin = m_text.find_last_of("\r\n", m_context.word.begin > 0 ? m_context.word.begin - 1 : 0);
        const std::string_view line = m_text.substr(begin == std::string_view::npos || m_context.word.begin == 0 ? 0 : begin + 1);
        return line.find_first_not_of(" \t") + static_cast<std::size_t>(line.data() - m_text.data()) >= m_context.word.begin;
    }

    /// The first non-blank character after the word on its line.
    [[nodiscard]] char nextSign() const {
        std::size_t at = m_context.word.end;
        while (at < m_text.size() && isBlank(m_text[at])) ++at;
        return at < m_text.size() ? m_text[at] : '\0';
    }
    [[nodiscard]] bool atStatement(std::string_view signs) const {
        return nextSign() != '\0' && signs.find(nextSign()) != std::string_view::npos;
    }

    /// Keys already set in this block, except the one at the caret.
    [[nodiscard]] std::set<std::string> given(std::string_view before) const {
        std::set<std::string> keys;
        for (const Item& item : m_place.items(m_loaded)) {
            const auto* a = item.as<AssignmentItem>();
            if (!a) continue;
            const bool own =
                m_context.word.size() > 0 && a->pathRange.begin <= m_context.word.begin && m_context.word.end <= a->pathRange.end;
            if (own) continue;
            std::string key;
            for (const Name& word : a->path) key += (key.empty() ? "" : ".") + word.text;
            if (key.starts_with(before)) keys.insert(key.substr(before.size()));
        }
        return keys;
    }

    [[nodiscard]] std::string equals() const {
        if (atStatement("=")) return {};
        return spacedEquals(m_tree, m_place.block(), editStyle(m_tree)) ? " = " : "=";
    }

    void keys(const Kind& kind, std::string_view before) {
        const std::set<std::string> there = given(before);
        std::set<std::string> shut; // keys excluded because an alternative of them is set
        for (const Alternatives& a : kind.alternatives) {
            const bool one = std::any_of(a.names.begin(), a.names.end(), [&](const std::string& n) { return there.contains(n); });
            if (one) shut.insert(a.names.begin(), a.names.end());
        }
        for (const bool required : {true, false}) {
            for (const Property& p : kind.properties) {
                if (p.required != required || there.contains(p.name) || shut.contains(p.name)) continue;
                add(CompletionSort::Key, p.name, p.name + equals(), typeText(p), p.help + "\n" + factsText(p)).hasMore =
                    hasChoices(p);
            }
        }
    }

    [[nodiscard]] static bool hasChoices(const Property& p) {
        return p.type != PropertyType::Number && p.type != PropertyType::Integer && p.type != PropertyType::Text;
    }

    /// Params of the config, and its parts for overrides.
    void configKeys(const Part& config) {
        const std::set<std::string> there = given({});
        for (const SourceParam& p : config.params) {
            if (there.contains(p.name->text)) continue;
            const std::string value(
                m_loaded.outline->texts().slice(p.valueFile == kNoFile ? p.file : p.valueFile, p.value->range));
            add(CompletionSort::Param, p.name->text, p.name->text + equals(), "Param",
                paramText(p) + "Param of " + config.name + ", " + value + " where it is not given.");
        }
        parts(config);
    }

    /// What is said about a Param, a line each.
    [[nodiscard]] static std::string paramText(const SourceParam& param) {
        if (!param.description) return {};
        const std::string help = param.description->property.help, limits = param.description->limits();
        return help + (help.empty() ? "" : "\n") + limits + (limits.empty() ? "" : "\n");
    }

    void parts(const Part& owner) {
        eachBlock(owner, [&](const Part& part) {
            if (!part.kind || part.name.empty()) return;
            add(CompletionSort::Reference, part.name, part.name + ".", part.kind->name,
                "Set a property of " + part.title() + " for this one only.")
                .hasMore = true;
        });
    }

    void override() {
        const Part* at = m_place.instance ? m_place.config : nullptr;
        std::string before;
        for (const std::string& word : m_context.path) {
            at = at ? at->find(word) : nullptr;
            before += word + ".";
        }
        if (!at || !at->kind) return;
        keys(*at->kind, before);
        if (at->config) configKeys(*at->config);
        parts(at->config ? *at->config : *at);
    }

    // --- blocks ---

    void kinds() {
        const std::string parent = m_place.block() ? m_place.block()->type.text : std::string();
        const Part* own = m_place.parts.empty() ? nullptr : m_place.parts.back();
        const bool isInRepeat = own && own->isRepeat();
        const std::string around = m_place.config ? m_place.config->kind->name : std::string(); // a Repeat
        for (const Kind* kind : m_loaded.registry->inside(parent)) {
            if (isInRepeat && !isAllowedInside(*kind, around)) continue;
            block(*kind);
        }
    }

    void block(const Kind& kind) {
        Completion& c = add(CompletionSort::Kind, kind.name, kind.name, "", kind.help);
        if (restFollows()) return;
        const auto first =
            std::find_if(kind.properties.begin(), kind.properties.end(), [](const Property& p) { return p.required; });
        const bool spaced = spacedEquals(m_tree, m_place.block(), editStyle(m_tree));
        const std::string key = first == kind.properties.end() ? std::string() : first->name + (spaced ? " = " : "=");
        if (kind.nameOptional) {
            c.insert = kind.name + " { " + key;
            c.select = c.caret = c.insert.size();
            c.insert += key.empty() ? "}" : " }";
            return;
        }
        const std::string name = freeName(kind);
        c.insert = kind.name + " " + name;
        c.select = kind.name.size() + 1;
        c.caret = c.insert.size();
        const bool large = kind.role == Role::Config || kind.role == Role::Instance || kind.role == Role::Layout ||
                           kind.role == Role::Repeat || kind.role == Role::Body;
        if (!large) {
            c.insert += " { " + key + (key.empty() ? "}" : " }");
            return;
        }
        const EditStyle style = editStyle(m_tree);
        const std::string indent = indentOfLine(m_text, m_context.word.begin);
        c.insert += " {" + style.lineEnd + indent + style.step + key + style.lineEnd + indent + "}";
    }

    /// Whether a name and a brace, or a brace alone, follow the caret.
    [[nodiscard]] bool restFollows() const {
        std::size_t at = m_context.word.end;
        const auto skip = [&](auto what) {
            while (at < m_text.size() && what(m_text[at])) ++at;
        };
        skip(isBlank);
        skip(isIdent);
        skip(isBlank);
        return at < m_text.size() && m_text[at] == '{';
    }

    /// A name not used in the block: "body", "body2".
    [[nodiscard]] std::string freeName(const Kind& kind) const {
        std::set<std::string> taken;
        for (const Item& item : m_place.items(m_loaded))
            if (const auto* block = item.as<BlockItem>(); block && block->name) taken.insert(block->name->text);
        if (!m_place.block())
            for (const auto& part : m_loaded.outline->parts) taken.insert(part->name);
        std::string stem = kind.name;
        std::size_t capitals = 0;
        while (capitals < stem.size() && stem[capitals] >= 'A' && stem[capitals] <= 'Z') ++capitals;
        for (std::size_t i = 0; i < std::max<std::size_t>(1, capitals > 1 ? capitals - 1 : 1) && i < stem.size(); ++i)
            if (stem[i] >= 'A' && stem[i] <= 'Z') stem[i] = static_cast<char>(stem[i] - 'A' + 'a');
        std::string name = stem;
        for (int i = 2; taken.contains(name); ++i) name = stem + std::to_string(i);
        return name;
    }

    // --- values ---

    [[nodiscard]] const Property* property() const { return m_context.ofParam ? nullptr : propertyOf(m_place, m_context.path); }

    void value() {
        const Property* own = property();
        const ParamDescription* said = own ? nullptr : description();
        const bool hasChoices = said && !said->property.choices.empty();
        const Property* p = own || hasChoices ? own : named();
        const std::string_view typed =
            m_context.quoted ? m_text.substr(m_context.word.begin, m_offset - m_context.word.begin) : m_context.before;
        if (p && p->type == PropertyType::File) files(folders(m_folders.assets), p->choices);
        else if (p)
            for (Completion& c : valuesOf(m_loaded, m_place, *p, m_context.before, typed, m_context.path.size() == 1)) {
                c.insert = m_context.before.empty() ? asWord(c.insert) : c.insert;
                c.select = c.caret = c.insert.size();
                m_out.items.push_back(std::move(c));
            }
        else if (hasChoices)
            for (const std::string& word : said->property.choices) add(CompletionSort::Value, word, asWord(word), "", "");
        if (!m_context.quoted && m_context.before.empty() && !m_place.described()) params("$");
    }

    /// Whether the value is that of a Param of an instance.
    [[nodiscard]] bool isOfInstance() const {
        return m_place.instance && m_place.config && m_context.path.size() == 1 && !m_context.ofParam;
    }
    /// What is said about that Param.
    [[nodiscard]] const ParamDescription* description() const {
        const SourceParam* param = isOfInstance() ? m_place.config->param(m_context.path[0]) : nullptr;
        return param ? param->description.get() : nullptr;
    }
    /// The property for which it names something; nullptr: for none.
    [[nodiscard]] const Property* named() const {
        return isOfInstance() ? propertyNamedBy(*m_place.config, m_context.path[0]) : nullptr;
    }

    void number() {
        const Property* p = property();
        if (p && !p->unit.empty()) {
            const UnitInfo* own = findUnit(p->unit);
            std::vector<std::string> names{p->unit};
            if (own)
                std::ranges::copy_if(allUnitNames(), std::back_inserter(names), [&](const std::string& name) {
                    return name != p->unit && findUnit(name)->dimension == own->dimension;
                });
            for (const std::string& name : names) {
                add(CompletionSort::Unit, name, name, own ? std::string(own->dimension) : std::string(),
                    name == p->unit ? "As a plain number is read." : "");
            }
        }
        if (m_context.blank) statement();
    }

    void params(const std::string& sign) {
        for (const SourceParam* p : paramsAt(m_loaded, m_place)) {
            const std::string value(
                m_loaded.outline->texts().slice(p->valueFile == kNoFile ? p->file : p->valueFile, p->value->range));
            if (p->name->range.begin <= m_place.offset && p->value->range.end >= m_place.offset && p->file == m_place.file)
                continue; // not the block itself
            add(CompletionSort::Param, sign + p->name->text, sign + p->name->text, value,
                paramText(*p) + "Param " + p->name->text + " = " + value);
        }
        const auto hasMembers = [](const Part* part) { return part->isRepeat() || part->is(Role::Layout); };
        if (std::ranges::none_of(m_place.parts, hasMembers)) return;
        add(CompletionSort::Param, sign + "index", sign + "index", "", "The number of the member, from 0.");
        add(CompletionSort::Param, sign + "index2", sign + "index2", "",
            "Of two counts: the number along the second one, from 0.");
    }

    void expression() {
        params({});
        for (const char* name :
             {"abs", "acos", "asin", "atan2", "ceil", "cos", "element", "floor", "if", "max", "min", "mod", "round", "sin", "sqrt", "tan"})
            add(CompletionSort::Word, name, std::string(name) + "(", "",
                std::string(name) == "cos" || std::string(name) == "sin" || std::string(name) == "tan" ? "Of an angle in degrees."
                                                                                                       : "");
        add(CompletionSort::Word, "pi", "pi", "3.14159…", "");
    }

    const LoadedProject& m_loaded;
    const Tree& m_tree;
    std::string_view m_text;
    const FileFolders& m_folders;
    CompletionContext m_context;
    std::uint32_t m_offset;
    TextLocation m_place;
    Completions m_out;
};

} // namespace

Completions completionsAt(const LoadedProject& loaded, FileId file, std::uint32_t offset, const FileFolders& folders) {
    if (file >= loaded.trees.size() || offset > loaded.trees[file]->source().bytes().size()) return {};
    return Completer(loaded, file, offset, folders).complete();
}

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// 0: no match; smaller is better.
int fit(std::string_view label, std::string_view typed) {
    if (label.starts_with(typed)) return 1;
    const auto same = [](char a, char b) { return lower(a) == lower(b); };
    if (typed.size() <= label.size() && std::equal(typed.begin(), typed.end(), label.begin(), same)) return 2;
    const auto found = std::search(label.begin(), label.end(), typed.begin(), typed.end(), same);
    if (found != label.end()) return 3;
    std::size_t at = 0; // subsequence match whose first letter matches the start
    if (!same(label.empty() ? '\0' : label[0], typed[0])) return 0;
    for (const char c : label)
        if (at < typed.size() && same(c, typed[at])) ++at;
    return at == typed.size() ? 4 : 0;
}

} // namespace

std::vector<const Completion*> fitting(const std::vector<Completion>& items, std::string_view typed) {
    std::vector<std::pair<int, const Completion*>> found;
    for (const Completion& item : items) {
        const int how = typed.empty() ? 1 : fit(item.label, typed);
        if (how > 0) found.emplace_back(how, &item);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const Completion*> sorted;
    for (const auto& [how, item] : found) sorted.push_back(item);
    return sorted;
}

} // namespace trundle
