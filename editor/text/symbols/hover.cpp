#include "editor/text/symbols/hover.h"

#include <algorithm>
#include <memory>

#include "base/units.h"
#include "editor/text/symbols/property_text.h"
#include "editor/text/symbols/text_location.h"
#include "editor/text/symbols/text_navigation.h"
#include "model/params.h"
#include "schema/allowed_parents.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

bool isOn(TextRange range, std::uint32_t offset) {
    return range.begin <= offset && offset < std::max(range.end, range.begin + 1);
}

class HoverProvider {
public:
    HoverProvider(const LoadedProject& loaded, FileId file, std::uint32_t offset)
        : m_loaded(loaded), m_place(placeAt(loaded, file, offset)), m_at(offset) {}

    std::optional<Hover> showMessage() {
        if (!m_place.item) return std::nullopt;
        if (const auto* a = m_place.item->as<AssignmentItem>()) return assignment(*a);
        if (const auto* block = m_place.item->as<BlockItem>()) return blockHead(*block);
        if (const auto* param = m_place.item->as<ParamItem>()) return this->param(*param);
        if (const auto* import = m_place.item->as<ImportItem>()) return imported(*import);
        if (const auto* module = m_place.item->as<ModuleItem>()) return this->module(*module);
        return std::nullopt;
    }

private:
    [[nodiscard]] std::string slice(TextRange r) const { return std::string(m_loaded.trees[m_place.file]->source().slice(r)); }

    std::optional<Hover> assignment(const AssignmentItem& a) {
        const std::vector<std::string> key = keyOf(a);
        for (std::size_t i = 0; i < a.path.size(); ++i) {
            if (!isOn(a.path[i].range, m_at)) continue;
            if (i + 1 < a.path.size()) return named();
            if (const Property* p = propertyOf(m_place, key)) return property(*p, a.path[i].range);
            if (const std::string use = givenByParts(paramOf(key)); !use.empty())
                return Hover{a.path[i].range, "Param " + key.back(), {use}};
            return named();
        }
        return value(a.value, propertyOf(m_place, key));
    }

    /// The Param of its config that an instance sets by a key there; nullptr: it is none.
    [[nodiscard]] const SourceParam* paramOf(const std::vector<std::string>& key) const {
        const Part* config = m_place.instance ? m_place.config : nullptr;
        for (std::size_t i = 0; config && i + 1 < key.size(); ++i) {
            config = config->find(key[i]);
            if (config && i + 2 == key.size()) config = config->config;
        }
        return config ? config->param(key.back()) : nullptr;
    }

    /// What is said about a Param that no text declares; empty: it is none.
    [[nodiscard]] static std::string givenByParts(const SourceParam* param) {
        return param && param->required ? "Every Part gives it; it has no default." : std::string();
    }

    std::optional<Hover> property(const Property& p, TextRange word) const {
        Hover hover{word, p.name, {p.help, factsText(p)}};
        if (p.live) hover.lines.emplace_back("Applies at once in a run.");
        return hover;
    }

    std::optional<Hover> value(const Value& value, const Property* p) {
        for (const Element& e : value.elements) {
            if (!isOn(e.range, m_at)) continue;
            if (e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression) return evaluated(e);
            if (auto hover = named()) return hover;
            if (e.kind == Element::Kind::Number && !e.unit.empty() && p) {
                const std::optional<double> plain = convertUnit(e.number, e.unit, p->unit);
                if (plain && e.unit != p->unit)
                    return Hover{e.range, slice(e.range), {"= " + numberText(*plain) + " " + p->unit}};
            }
            if (p && (p->type == PropertyType::Choice || p->type == PropertyType::Boolean)) return property(*p, e.range);
        }
        return std::nullopt;
    }

    /// The value of `$name` or `$( )` here, using the Params of the enclosing config.
    std::optional<Hover> evaluated(const Element& e) {
        Hover hover{e.range, slice(e.range), {}};
        const std::string result = resultOf({e.range, {e}, false});
        const std::string use = e.kind == Element::Kind::ParamRef ? givenByParts(paramNamed(e.text)) : std::string();
        if (!use.empty()) hover.lines.push_back(use);
        else hover.lines.push_back(result.empty() ? "has no value" : "= " + result);
        const auto given = use.empty() ? definitionAt(m_loaded, m_place.file, m_at) : std::nullopt;
        if (given && given->place.known()) {
            const SourceText& text = m_loaded.trees[given->place.file]->source();
            hover.lines.push_back("set in " + text.path() + ", line " +
                                  std::to_string(text.position(given->place.range.begin).line));
        }
        return hover;
    }

    [[nodiscard]] const SourceParam* paramNamed(const std::string& name) const {
        for (const SourceParam* param : paramsAt(m_loaded, m_place))
            if (param->name->text == name) return param;
        return nullptr;
    }

    [[nodiscard]] std::string resultOf(const Value& value) const {
        Diagnostics silent;
        Evaluator evaluator(m_loaded.outline->texts(), silent);
        std::vector<std::unique_ptr<ParamScope>> scopes;
        scopes.push_back(std::make_unique<ParamScope>());
        scopes.back()->declare(m_loaded.outline->params);
        for (const Part* part : m_place.parts) {
            scopes.push_back(std::make_unique<ParamScope>(scopes.back().get()));
            scopes.back()->declare(part->params);
        }
        const std::optional<GivenValue> given = evaluator.evaluate(value, m_place.file, *scopes.back());
        std::string text;
        if (given)
            for (const GivenElement& e : given->elements) text += (text.empty() ? "" : ", ") + elementText(e);
        return text;
    }

    /// For a reference: the definition of its target.
    std::optional<Hover> named() const {
        const auto given = definitionAt(m_loaded, m_place.file, m_at);
        if (!given || !given->place.known()) return std::nullopt;
        const SourceText& text = m_loaded.trees[given->place.file]->source();
        const std::uint32_t line = text.position(given->place.range.begin).line;
        std::string shown(text.line(line));
        shown.erase(0, std::min(shown.size(), shown.find_first_not_of(" \t")));
        return Hover{given->word.range, given->name, {shown, text.path() + ", line " + std::to_string(line)}};
    }

    std::optional<Hover> blockHead(const BlockItem& block) const {
        const bool onName = block.name && isOn(block.name->range, m_at);
        if (!onName && !isOn(block.type.range, m_at)) return std::nullopt;
        const Kind* kind = m_loaded.registry->find(block.type.text);
        if (!kind) return std::nullopt;
        Hover hover{onName ? block.name->range : block.type.range,
                    onName ? block.name->text + ", " + withArticle(kind->name) : kind->name,
                    {kind->help}};
        std::vector<std::string> needed;
        for (const Property& p : kind->properties)
            if (p.required) needed.push_back(p.name);
        if (!needed.empty()) hover.lines.push_back("Needs " + listText(needed, "and") + ".");
        if (const std::string places = placesText(*kind); !places.empty()) hover.lines.push_back(places);
        if (!kind->module.empty()) hover.lines.push_back("From " + kind->module);
        return hover;
    }

    [[nodiscard]] static std::string placesText(const Kind& kind) {
        std::vector<std::string> parents = allowedParents(kind);
        if (parents.empty()) return {};
        const bool top = std::erase(parents, std::string()) > 0;
        if (parents.empty()) return "Allowed at the top level.";
        return "Allowed in " + listText(parents) + (top ? ", and at the top level." : ".");
    }

    std::optional<Hover> param(const ParamItem& p) {
        if (!isOn(p.name.range, m_at)) return value(p.value, nullptr);
        const std::string result = resultOf(p.value);
        Hover hover{p.name.range, "Param " + p.name.text, {result.empty() ? "has no value" : "= " + result}};
        Diagnostics silent;
        if (const auto said = descriptionOf(p, m_place.file, silent)) {
            if (!said->property.help.empty()) hover.lines.push_back(said->property.help);
            if (const std::string limits = said->limits(); !limits.empty()) hover.lines.push_back(limits);
        }
        return hover;
    }

    std::optional<Hover> imported(const ImportItem& import) const {
        const auto given = definitionAt(m_loaded, m_place.file, m_at);
        if (!given) return std::nullopt;
        return Hover{import.pathRange, import.path, {m_loaded.paths[given->place.file]}};
    }

    std::optional<Hover> module(const ModuleItem& module) const {
        Hover hover{module.pathRange, module.path, {}};
        for (const ModuleSpec& spec : m_loaded.experiment->modules)
            if (spec.written == module.path) hover.lines.push_back(spec.library);
        std::vector<std::string> kinds;
        for (const Kind* kind : m_loaded.registry->all())
            if (!hover.lines.empty() && kind->module == hover.lines.front()) kinds.push_back(kind->name);
        if (!kinds.empty()) hover.lines.push_back("Defines " + listText(kinds, "and") + ".");
        if (hover.lines.empty()) return std::nullopt;
        return hover;
    }

    const LoadedProject& m_loaded;
    TextLocation m_place;
    std::uint32_t m_at;
};

std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : text) {
        if (c == '<') html += "&lt;";
        else if (c == '>') html += "&gt;";
        else if (c == '&') html += "&amp;";
        else if (c == '"') html += "&quot;";
        else if (c == '\n') html += "<br>";
        else html += c;
    }
    return html;
}

} // namespace

std::optional<Hover> hoverAt(const LoadedProject& loaded, FileId file, std::uint32_t offset) {
    if (file >= loaded.trees.size()) return std::nullopt;
    return HoverProvider(loaded, file, offset).showMessage();
}

/// Semibold, as used by the window's fonts.
static std::string strong(const std::string& html) { return "<span style='font-weight:600'>" + html + "</span>"; }

std::string hoverHtml(const std::optional<Hover>& hover, const std::vector<const Diagnostic*>& problems) {
    std::string html;
    for (const Diagnostic* problem : problems) {
        const char* sort = problem->severity == Severity::Error     ? "Error"
                           : problem->severity == Severity::Warning ? "Warning"
                                                                    : "Hint";
        html += "<p>" + strong(std::string(sort) + " " + codeName(problem->code)) + " " + escaped(problem->message);
        if (!problem->suggestions.empty()) html += "<br>Did you mean " + escaped(listText(problem->suggestions)) + "?";
        for (const Fix& fix : problem->fixes) html += "<br>Alt+Enter: " + escaped(fix.title);
        html += "</p>";
    }
    if (hover) {
        html += "<p>" + strong(escaped(hover->title));
        for (const std::string& line : hover->lines)
            if (!line.empty()) html += "<br>" + escaped(line);
        html += "</p>";
    }
    return html;
}

} // namespace trundle
