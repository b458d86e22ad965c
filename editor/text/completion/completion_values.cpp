#include "editor/text/completion/completion_values.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "editor/text/symbols/property_text.h"
#include "model/name_walk.h"
#include "model/port_kinds.h"
#include "project/objects/name_references.h"
#include "project/objects/object_location.h"
#include "project/objects/reference_space.h"

namespace trundle {
namespace {

class Values {
public:
    Values(const LoadedProject& loaded, const TextLocation& place, const Property& property, const std::string& before,
           std::string_view typed, bool isOwn)
        : m_loaded(loaded), m_place(place), m_property(property), m_before(before), m_isOwn(isOwn),
          m_path(typed.substr(0, typed.rfind('.') + 1)) {}

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
        if (!m_labels.insert(rest).second) return;
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
        bool isLocal = false;
        for (const std::string& choice : m_property.choices) {
            const Kind* kind = m_loaded.registry->find(choice);
            if (const NameSpace* space = kind ? referenceSpace(*m_loaded.outline, *kind) : nullptr) {
                for (const Part* part : space->all())
                    if (part->kind == kind) named(*part);
                if (kind->role == Role::Material || kind->role == Role::Surface)
                    add(CompletionSort::Value, "default", "", "The default where none is named.");
            } else if (choice == "world") {
                add(CompletionSort::Value, "world", "", "The ground that nothing moves.");
            } else if (!std::exchange(isLocal, true)) {
                if (!m_place.config && m_place.kind && m_place.kind->role == Role::Joint) bodiesOfRobots();
                else local();
            }
        }
    }

    /// Of a joint at the top level.
    void bodiesOfRobots() {
        for (const auto& [part, name] : firstMembers(*m_loaded.outline))
            if (const Part* config = isPlaced(*part) ? configOf(m_loaded, *part) : nullptr) namesIn(*config, name + ".");
    }

    [[nodiscard]] bool fits(const Part& part) const {
        if (!part.kind) return false;
        const bool isPort = m_property.type == PropertyType::Text; // one without choices uses any device
        if (isPort && m_property.choices.empty()) return part.is(Role::Device);
        return std::ranges::any_of(m_property.choices, [&](const std::string& choice) {
            return (isPort && portFits(choice, part.kind->name)) || part.kind->name == choice ||
                   roleName(part.kind->role) == choice;
        });
    }

    /// Names in a config; those in a Repeat without the member in front only from inside it. What a Part names is beside it, in an
    /// override also in its config.
    void local() {
        const Part* beside = nullptr;
        for (auto it = m_place.parts.rbegin(); it != m_place.parts.rend() && !beside; ++it) {
            if ((*it)->is(Role::Config)) beside = *it;
            else if (*it != own() && (*it)->isRepeat() && !(*it)->isInWorld) namesIn(**it, {});
        }
        if (beside) namesIn(*beside, {});
        const bool isOfPart = own() && own()->isPartUse() && m_isOwn;
        if (m_place.config && m_place.config != beside && !isOfPart) namesIn(*m_place.config, {});
    }
    void namesIn(const Part& holder, const std::string& prefix) {
        walk(holder, prefix, [&](const Part& part, const std::string& before) {
            if (&part == own()) return false;
            if (part.isRepeat()) return std::ranges::find(m_place.parts, &part) == m_place.parts.end();
            if (fits(part)) named(part, before);
            return true;
        });
    }
    [[nodiscard]] const Part* own() const { return m_place.parts.empty() ? nullptr : m_place.parts.back(); }

    /// Visits what is inside of `holder`, first that of the Part that was typed: of very many Parts the others are not all visited.
    template <class Visit> void walk(const Part& holder, const std::string& prefix, const Visit& visit) {
        if (m_path.size() > prefix.size() && m_path.starts_with(prefix)) {
            const std::string_view inner = std::string_view(m_path).substr(prefix.size(), m_path.size() - prefix.size() - 1);
            if (const Part* part = holder.findPath(inner)) NameWalk(kMostInParts).inside(*part, m_path, visit);
        }
        if (prefix.starts_with(m_before) || m_before.starts_with(prefix)) m_walk.inside(holder, prefix, visit);
    }

    void texts() {
        if (!m_place.kind) return;
        if (namesWorld(*m_place.kind, m_property)) return world();
        if (m_place.kind->role == Role::Controller && m_place.config) local(); // the devices that it uses
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
    void signalsOf(const Part& owner, Role role, const std::string& prefix) {
        walk(owner, prefix, [&](const Part& part, const std::string& before) {
            if (part.is(role))
                for (const SignalDescription& signal : part.kind->signals)
                    add(CompletionSort::Reference, before + part.name + "/" + signal.name, signal.unit, signal.help);
            return !part.is(Role::Body);
        });
    }

    static constexpr std::size_t kMostInParts = 2000;
    const LoadedProject& m_loaded;
    const TextLocation& m_place;
    const Property& m_property;
    const std::string& m_before;
    const bool m_isOwn;
    std::string m_path; ///< what is typed, to its last dot
    NameWalk m_walk{kMostInParts};
    std::unordered_set<std::string> m_labels;
    std::vector<Completion> m_out;
};

} // namespace

std::vector<Completion> valuesOf(const LoadedProject& loaded, const TextLocation& place, const Property& property,
                                 const std::string& before, std::string_view typed, bool isOwn) {
    return Values(loaded, place, property, before, typed, isOwn).list();
}

} // namespace trundle
