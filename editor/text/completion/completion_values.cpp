#include "editor/text/completion/completion_values.h"

#include <algorithm>

#include "editor/text/symbols/property_text.h"
#include "model/config_blocks.h"
#include "model/port_kinds.h"
#include "project/objects/name_references.h"
#include "project/objects/object_location.h"
#include "project/objects/reference_space.h"

namespace trundle {
namespace {

class Values {
public:
    Values(const LoadedProject& loaded, const TextLocation& place, const Property& property, const std::string& before)
        : m_loaded(loaded), m_place(place), m_property(property), m_before(before) {}

    std::vector<Completion> list() {
        switch (m_property.type) {
        case PropertyType::Boolean: words({"true", "false"}); break;
        case PropertyType::Choice: words(m_property.choices); break;
        case PropertyType::Reference: references(); break;
        case PropertyType::Text: texts(); break;
        case PropertyType::Number:
        case PropertyType::Integer:
            if (const std::string usual = defaultText(m_property); !usual.empty()) words({usual});
            break;
        case PropertyType::File: break;
        }
        return std::move(m_out);
    }

private:
    void add(CompletionSort sort, const std::string& full, std::string detail, std::string help) {
        if (!full.starts_with(m_before)) return;
        std::string rest = full.substr(m_before.size());
        if (rest.empty()) return;
        const bool there = std::any_of(m_out.begin(), m_out.end(), [&](const Completion& c) { return c.label == rest; });
        if (there) return;
        m_out.push_back({sort, rest, rest, 0, 0, std::move(detail), std::move(help), false});
    }

    void words(const std::vector<std::string>& words) {
        const std::string usual = defaultText(m_property);
        for (const std::string& word : words) add(CompletionSort::Value, word, word == usual ? "default" : "", m_property.help);
    }

    void named(const Part& part, const std::string& prefix = {}) {
        if (part.name.empty()) return;
        add(CompletionSort::Reference, prefix + part.name, part.kind ? part.kind->name : std::string(), firstLine(part));
    }

    /// The first line of its definition.
    [[nodiscard]] std::string firstLine(const Part& part) const {
        std::string text(m_loaded.outline->texts().slice(part.range));
        if (const std::size_t end = text.find_first_of("\r\n"); end != std::string::npos) text.resize(end);
        return text;
    }

    void references() {
        for (const std::string& choice : m_property.choices) {
            const Kind* kind = m_loaded.registry->find(choice);
            if (const NameSpace* space = kind ? referenceSpace(*m_loaded.outline, *kind) : nullptr) {
                for (const Part* part : space->all())
                    if (part->kind == kind) named(*part);
                if (kind->role == Role::Material || kind->role == Role::Surface)
                    add(CompletionSort::Value, "default", "", "The default where none is named.");
            } else if (choice == "world") {
                add(CompletionSort::Value, "world", "", "The ground that nothing moves.");
            } else if (m_place.config) {
                local(*m_place.config, choice);
            } else if (m_place.kind && m_place.kind->role == Role::Joint) {
                bodiesOfRobots(choice);
            }
        }
    }

    /// Of a joint at the top level.
    void bodiesOfRobots(const std::string& choice) {
        for (const auto& [part, name] : firstMembers(*m_loaded.outline))
            if (const Part* config = isPlaced(*part) ? configOf(m_loaded, *part) : nullptr) local(*config, choice, name + ".");
    }

    [[nodiscard]] bool fits(const Part& part, const std::string& choice) const {
        if (!part.kind) return false;
        if (m_property.type == PropertyType::Text && portFits(choice, part.kind->name)) return true;
        return part.kind->name == choice || roleName(part.kind->role) == choice;
    }
    /// Names in a config; those in a Repeat without the member in front only from inside it.
    void local(const Part& config, const std::string& choice, const std::string& prefix = {}) {
        if (isVariant(config)) local(*config.config, choice, prefix);
        for (const Part& part : config.parts) {
            if (&part == own()) continue;
            if (fits(part, choice)) named(part, prefix);
            for (const Part& geom : part.parts)
                if (part.is(Role::Body) && fits(geom, choice)) named(geom, prefix + part.name + ".");
            if (!part.isRepeat()) continue;
            const bool isAround = std::ranges::find(m_place.parts, &part) != m_place.parts.end();
            local(part, choice, isAround ? prefix : prefix + part.name + "_0.");
        }
    }
    [[nodiscard]] const Part* own() const { return m_place.parts.empty() ? nullptr : m_place.parts.back(); }

    void texts() {
        if (!m_place.kind) return;
        if (namesWorld(*m_place.kind, m_property)) return world();
        if (m_place.kind->role != Role::Controller || !m_place.config) return;
        if (m_property.choices.empty()) return local(*m_place.config, roleName(Role::Device)); // those that it uses
        for (const std::string& needed : m_property.choices) local(*m_place.config, needed);
    }

    /// Robots and, for a log of signals, their signals.
    void world() {
        for (const auto& [part, name] : firstMembers(*m_loaded.outline)) {
            if (!isPlaced(*part)) continue;
            const bool robots = m_property.name == "Robot";
            if (robots) named(*part, part->is(Role::Layout) ? std::string() : name.substr(0, name.size() - part->name.size()));
            const Part* config = robots ? nullptr : configOf(m_loaded, *part);
            if (!config) continue;
            signalsOf(*config, Role::Device, name + "/");
            signalsOf(*part, Role::Controller, name + "/");
        }
    }
    /// Signals of a config's devices or a robot's controller.
    void signalsOf(const Part& owner, Role role, const std::string& before) {
        if (isVariant(owner)) signalsOf(*owner.config, role, before);
        for (const Part& part : owner.parts) {
            if (part.isRepeat()) signalsOf(part, role, before + part.name + "_0.");
            if (!part.is(role)) continue;
            for (const SignalDescription& signal : part.kind->signals)
                add(CompletionSort::Reference, before + part.name + "/" + signal.name, signal.unit, signal.help);
        }
    }

    const LoadedProject& m_loaded;
    const TextLocation& m_place;
    const Property& m_property;
    const std::string& m_before;
    std::vector<Completion> m_out;
};

} // namespace

std::vector<Completion> valuesOf(const LoadedProject& loaded, const TextLocation& place, const Property& property,
                                 const std::string& before) {
    return Values(loaded, place, property, before).list();
}

} // namespace trundle
