// Contents of the library: configs and snippets found in folders by a worker thread, kinds from the registry, and configs of the
// open project.

#include <algorithm>
#include <filesystem>

#include <QFileInfo>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/library_items.h"
#include "editor/outline/library_model.h"
#include "editor/outline/library_panel.h"
#include "editor/outline/library_pictures.h"
#include "editor/outline/object_edits.h"
#include "model/passive_objects.h"
#include "project/edits/insert_positions.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

void append(std::vector<LibraryItem>& all, std::vector<LibraryItem> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The config that robot parts would be inserted into: the one that contains the selection, or the only one.
const Part* robotConfigFor(const LoadedProject& loaded, const std::string& selected) {
    for (const std::string& path : placesAround(loaded, selected))
        if (const auto place = placeOf(loaded, path); place && place->part && place->part->is(Role::Config)) return place->part;
    std::vector<const Part*> robots = loaded.outline->configs.all();
    std::erase_if(robots, [](const Part* config) { return config->kind->name != "RobotConfig"; });
    return robots.size() == 1 ? robots.front() : nullptr;
}

} // namespace

void LibraryPanel::readFolders() {
    const bool open = m_document.isOpen();
    const std::string project = open ? canonicalPath(m_document.loaded()->projectFolder) : std::string();
    const std::string opened = open ? canonicalPath(m_document.loaded()->paths[0]) : std::string();
    m_readOf = lastWritten();
    m_ownPictures.clear(); // renewed by ownConfigs()
    ++m_reading;
    m_pool.start(
        [this, reading = ++m_readings, project, opened, configs = m_configs, resources = m_resources, modules = m_modules] {
            std::vector<LibraryItem> items;
            for (const char* folder : {"robots", "arenas", "objects"})
                append(items, configItems({configs + "/" + folder, std::string(folder) + "/"}, opened));
            append(items, snippetItems(resources + "/library"));
            if (!project.empty() && project != canonicalPath(configs)) {
                append(items, configItems({project, ""}, opened));
                append(items, snippetItems(project + "/library"));
            }
            std::vector<Kind> kinds = m_application.moduleKinds({});
            QMetaObject::invokeMethod(
                this,
                [this, reading, items = std::move(items), kinds = std::move(kinds)] {
                    --m_reading;
                    if (reading != m_readings) return;
                    m_found = items;
                    m_moduleKinds = kinds;
                    m_registry = nullptr;
                    showItems();
                },
                Qt::QueuedConnection);
        });
}

QDateTime LibraryPanel::lastWritten() const {
    QDateTime last;
    if (m_document.isOpen())
        for (const std::string& path : m_document.loaded()->paths)
            last = std::max(last, QFileInfo(QString::fromStdString(path)).lastModified());
    return last;
}

/// Configs of the opened file, and of files not saved yet: they need no import.
std::vector<LibraryItem> LibraryPanel::ownConfigs() {
    std::vector<LibraryItem> items;
    if (!m_document.isOpen()) return items;
    for (const Part* config : m_document.loaded()->outline->configs.all()) {
        if (config->kind->name == "PartConfig") continue; // placed in a robot, by Insert
        const QString file = QString::fromStdString(m_document.loaded()->paths.at(config->file));
        if (config->file != 0 && QFileInfo::exists(file)) continue;
        const bool robot = config->kind->name == "RobotConfig", movable = isPassiveConfig(*config);
        LibraryItem item;
        item.section = movable ? LibrarySection::Objects : robot ? LibrarySection::Robots : LibrarySection::Arenas;
        item.title = QString::fromStdString(config->name);
        item.help = config->file == 0 ? tr("Described in this file")
                                      : tr("Described in %1, which is not saved yet").arg(QFileInfo(file).fileName());
        item.icon = QString::fromLatin1(movable ? "kind-object" : robot ? "kind-robot" : "kind-static");
        item.kind = robot ? "Robot" : "Static";
        item.text = item.kind + " " + (robot && !movable ? "robot0" : nameFor(config->name)) + " { Config=" + config->name +
                    " Pos=0,0,0 }";
        if (config->file == 0 && config->block->name && !m_ownPictures.contains(config->name))
            m_ownPictures.emplace(config->name, pictureOfConfig(*m_document.loaded()->trees[0], *config->block));
        if (const auto picture = m_ownPictures.find(config->name); picture != m_ownPictures.end()) item.picture = picture->second;
        item.folder = std::filesystem::path(m_document.loaded()->paths[0]).parent_path().string();
        items.push_back(std::move(item));
    }
    return items;
}

void LibraryPanel::showItems() {
    std::vector<LibraryItem> all = ownConfigs();
    std::vector<std::string> names;
    for (const LibraryItem& item : all) names.push_back(item.text);
    const std::shared_ptr<const Registry> registry =
        m_document.isOpen() ? m_document.loaded()->registry : m_application.builtIn();
    const auto kindNames = [](const Registry& r) {
        std::vector<std::string> names;
        for (const Kind* kind : r.all()) names.push_back(kind->name);
        return names;
    };
    if (m_registry && names == m_ownNames && kindNames(*registry) == kindNames(*m_registry)) return;
    m_ownNames = std::move(names);
    m_registry = registry;
    append(all, m_found);
    append(all, kindItems(registry->all()));
    std::vector<Kind> others = m_moduleKinds;
    std::erase_if(others, [&](const Kind& kind) { return registry->find(kind.name) != nullptr; });
    append(all, moduleItems(others, m_modules));
    m_model->setItems(std::move(all));
    for (const LibraryItem& item : m_model->items())
        if (!item.picture.empty() && !m_model->hasPicture(item.picture)) {
            m_model->setPicture(item.picture, {}); // marks it as requested
            m_pictures->want(item.picture, item.folder.empty() ? m_configs : item.folder);
        }
    fitSections();
}

const Kind* LibraryPanel::kindOf(const std::string& name) const {
    if (const Kind* kind = m_registry ? m_registry->find(name) : nullptr) return kind;
    const auto it = std::find_if(m_moduleKinds.begin(), m_moduleKinds.end(), [&](const Kind& kind) { return kind.name == name; });
    return it == m_moduleKinds.end() ? nullptr : &*it;
}

std::string LibraryPanel::textOf(const LibraryItem& item) const {
    if (!m_document.isOpen()) return item.text;
    if (!item.text.empty()) return item.section == LibrarySection::RobotParts ? fittedTo(item) : item.text;
    const Kind* kind = kindOf(item.kind);
    if (!kind) return {};
    const Kind* one[] = {kind};
    const std::optional<std::string> parent = placeFor(*m_document.loaded(), m_document.editedModel().insertionPlace(m_selection), one);
    return templateOf(*m_document.loaded(), *kind, parent.value_or(std::string()));
}

/// The item's text, with its parent body replaced by the robot's first body if the robot has no body named chassis.
std::string LibraryPanel::fittedTo(const LibraryItem& item) const {
    static const std::string kParent = "Parent=chassis";
    const Part* config = robotConfigFor(*m_document.loaded(), m_document.editedModel().insertionPlace(m_selection));
    if (!config || config->find("chassis")) return item.text;
    const auto body =
        std::find_if(config->parts.begin(), config->parts.end(), [](const Part& p) { return p.is(Role::Body) && p.usable; });
    if (body == config->parts.end()) return item.text;
    std::string text = item.text;
    for (std::size_t at = text.find(kParent); at != std::string::npos; at = text.find(kParent, at + 1))
        text.replace(at, kParent.size(), "Parent=" + body->name);
    return text;
}

void LibraryPanel::insert(const LibraryItem& item) {
    if (!m_document.isOpen()) {
        Q_EMIT m_document.refused(tr("open or create an experiment first"));
        return;
    }
    Result<Blocks> blocks = blocksFrom(textOf(item));
    if (!blocks) {
        Q_EMIT m_document.refused(QString::fromStdString(blocks.error().message));
        return;
    }
    Blocks wanted = std::move(blocks).value();
    wanted.imports.insert(wanted.imports.end(), item.imports.begin(), item.imports.end());
    (void)m_edits->insertAtPoint(wanted, m_document.editedModel().insertionPlace(m_selection), tr("Add %1").arg(item.title));
}

} // namespace trundle
