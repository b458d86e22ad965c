#include "editor/document/edited_model.h"

#include <algorithm>

#include "editor/document/document_loading.h"
#include "editor/document/document_state.h"
#include "editor/document/project_opening.h"
#include "editor/document/selection.h"
#include "model/dotted_path.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

bool isModel(const Part* part) {
    return part && part->usable && part->kind && (part->kind->name == "RobotConfig" || part->kind->name == "StaticConfig");
}

/// Whether it is the name of a copy: "RobotConfig.Rover1" of "RobotConfig.Rover".
bool isCopyOf(const std::string& path, const std::string& original) {
    return path.size() > original.size() && path.starts_with(original) &&
           std::all_of(path.begin() + std::ptrdiff_t(original.size()), path.end(), [](char c) { return c >= '0' && c <= '9'; });
}

} // namespace

EditedModel::EditedModel(const DocumentState& state, const DocumentLoading& loading, const ProjectOpening& opening)
    : m_state(state) {
    connect(&opening, &ProjectOpening::opened, this, &EditedModel::close);
    connect(&loading, &DocumentLoading::changed, this, &EditedModel::follow);
}

const Part* EditedModel::config() const {
    if (m_path.empty() || !m_state.loaded) return nullptr;
    const auto place = placeOf(*m_state.loaded, m_path);
    return place && isModel(place->part) ? place->part : nullptr;
}

std::string EditedModel::modelOf(const std::string& path) const {
    if (!m_state.loaded) return {};
    const LoadedProject& loaded = *m_state.loaded;
    const auto place = placeOf(loaded, path);
    const Part* top = place ? topOf(*place) : nullptr;
    const Part* config = top && isPlaced(*top) ? configOf(loaded, *top) : top;
    return isModel(config) ? pathOfConfig(*config) : std::string();
}

std::string EditedModel::insertionPlace(const Selection& selection) const {
    std::string selected = selection.current(); // which an undo may have removed
    while (!selected.empty() && m_state.loaded && !placeOf(*m_state.loaded, selected)) {
        const std::size_t dot = selected.rfind('.');
        selected.erase(dot == std::string::npos ? 0 : dot);
    }
    return m_path.empty() || startsWithPath(selected, m_path) ? selected : m_path;
}

void EditedModel::open(const std::string& path) {
    m_before.clear();
    remember();
    if (path == m_path) return;
    m_path = path;
    Q_EMIT changed();
}

void EditedModel::remember() {
    m_configs.clear();
    if (!m_state.loaded) return;
    for (const Part* config : m_state.loaded->outline->configs.all())
        if (isModel(config)) m_configs.insert(pathOfConfig(*config));
}

/// The path of the model after a change of the document; empty if it was removed.
std::string EditedModel::followed() const {
    const bool isThere = config() != nullptr;
    std::vector<std::string> made;
    for (const Part* config : m_state.loaded->outline->configs.all())
        if (const std::string path = pathOfConfig(*config);
            isModel(config) && !m_configs.contains(path) && firstWord(path) == firstWord(m_path))
            made.push_back(path);
    if (made.size() == 1 && (!isThere || isCopyOf(made.front(), m_path))) return made.front();
    if (isThere || m_state.loaded->diagnostics.hasErrors()) return m_path; // typing may have hidden it
    const auto before = std::ranges::find_if(m_before, [&](const std::string& path) { return m_configs.contains(path); });
    return before == m_before.end() ? std::string() : *before;
}

void EditedModel::follow() {
    if (m_path.empty() || !m_state.loaded) return;
    std::string now = followed();
    remember();
    if (now == m_path) return;
    if (now.empty()) return close();
    m_before.insert(m_before.begin(), m_path);
    m_path = std::move(now);
    Q_EMIT changed();
}

} // namespace trundle
