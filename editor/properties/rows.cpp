// Builds the rows of a selection. Needs: the selected objects and the schema. Method: each object lists its fields under ids
// that do not depend on its name; a row is an id that all objects have with the same type.
#include "editor/properties/rows.h"

#include <algorithm>
#include <numbers>
#include <unordered_map>

#include <QDir>
#include <QFileInfo>

#include "editor/document/structure_edits.h"
#include "editor/properties/fitting_names.h"
#include "editor/properties/sections.h"
#include "editor/running/session.h"
#include "editor/widgets/strings.h"
#include "model/dotted_path.h"
#include "model/param_reference.h"
#include "project/edits/plans.h"
#include "project/objects/name_references.h"
#include "project/objects/value_text.h"

namespace trundle {
namespace {

struct ListedRow {
    std::string id;
    QString label, section;
    FieldValue value;
    const Kind* kind = nullptr; ///< nullptr: a Param
    const Part* config = nullptr;
};

constexpr std::size_t kMaxOfSection = 200; // limit, since each row has several widgets

/// Lists the fields of one object, in order.
class PropertyRowBuilder {
public:
    PropertyRowBuilder(ObjectValues& object, std::shared_ptr<const LoadedProject> loaded)
        : m_object(object), m_loaded(std::move(loaded)) {}

    std::vector<ListedRow> list() {
        addProperties(m_object, {}, {});
        const QString config = m_object.config() ? toQString(m_object.config()->name) : QString();
        if (m_object.isInstance()) {
            for (FieldValue& v : m_object.configProperties())
                add("config." + v.property->name, config, std::move(v), m_object.config()->kind);
            addParams(QObject::tr("Params of %1").arg(config));
            addControllers();
            addOverrides(QObject::tr("Overrides in %1").arg(config));
        } else addParams(QObject::tr("Params"));
        return std::move(m_listed);
    }

private:
    void add(std::string id, const QString& section, FieldValue value, const Kind* kind) {
        const std::string name = value.property ? value.property->name : std::string(lastWord(value.path));
        m_listed.push_back({std::move(id), toQString(name), section, std::move(value), kind, m_object.config()});
    }

    void addProperties(ObjectValues& object, const std::string& prefix, const QString& section) {
        for (FieldValue& v : object.properties()) {
            const bool isIn = isBodyToCountFrom(*object.kind(), *v.property);
            if (isIn && !v.given() && !bodiesForIn(*m_loaded, object.path())) continue; // it would be refused
            const QString own = section.isEmpty() ? sectionOf(*object.kind(), *v.property) : section;
            const std::string id = prefix + v.property->name;
            add(id, own, std::move(v), object.kind());
        }
    }

    void addParams(const QString& title) {
        std::vector<FieldValue> params = m_object.params(kMaxOfSection + 1);
        const bool more = params.size() > kMaxOfSection;
        if (more) params.pop_back();
        const QString section =
            more ? QObject::tr("%1: the first %2, the others are in the text").arg(title, QString::number(kMaxOfSection)) : title;
        for (FieldValue& v : params) {
            const std::string id = pathInside("param", lastWord(v.path));
            add(id, section, std::move(v), nullptr);
        }
    }

    void addControllers() {
        bool isFirst = true;
        for (const Part& part : m_object.part()->parts) {
            if (!part.is(Role::Controller) || !part.usable) continue;
            ObjectValues controller(m_loaded, m_object.path() + "." + part.name);
            const std::string id = "controller." + part.kind->name + "." + (std::exchange(isFirst, false) ? "" : part.name + ".");
            addProperties(controller, id, QObject::tr("Controller %1").arg(toQString(part.title())));
        }
    }

    void addOverrides(const QString& section) {
        std::size_t shown = 0;
        for (const std::string& key : m_object.overrides()) {
            if (++shown > kMaxOfSection) break;
            ObjectValues inner(m_loaded, pathInside(m_object.path(), withoutLastWord(key)));
            std::optional<FieldValue> value = inner.property(std::string(lastWord(key)));
            if (!value) continue; // an unresolved path; the diagnostics report it
            add("override." + key, section, std::move(*value), inner.kind());
            m_listed.back().label = toQString(key);
        }
    }

    ObjectValues& m_object;
    std::shared_ptr<const LoadedProject> m_loaded;
    std::vector<ListedRow> m_listed;
};

bool alike(const ListedRow& a, const ListedRow& b) {
    const Property *p = a.value.property, *q = b.value.property;
    if (!p || !q) return p == q;
    return p == q || (p->type == q->type && p->unit == q->unit && p->choices == q->choices && p->minCount == q->minCount &&
                      p->maxCount == q->maxCount);
}

/// The heading of a row whose objects have different ones, for example since they have different configs.
QString commonSection(const ListedRow& row) {
    const std::string group = std::string(firstWord(row.id));
    if (group == "param") return QObject::tr("Params");
    if (group == "config") return QObject::tr("Config");
    if (group == "controller") return QObject::tr("Controller");
    return group == "override" ? QObject::tr("Overrides") : row.section;
}

Status setAll(Document& document, const std::vector<FieldValue>& values, const Change& change, const std::string& mergeKey) {
    std::vector<ValueEdit> edits;
    std::vector<std::string> resets;
    for (const FieldValue& v : values) {
        ParsedValue wanted = change(v);
        if (wanted.empty()) {
            if (v.given()) resets.push_back(v.path);
            continue;
        }
        if (v.isLong) return Error{Code::EditRefused, "the value is too long to be replaced here; edit it in the text"};
        if (v.given() && wanted.text() == v.text) continue;
        if (!wanted.status()) return wanted.status();
        edits.push_back({v.path, std::move(wanted)});
    }
    const QString what = values.size() == 1
                             ? shortName(values[0].path)
                             : QObject::tr("%1 of %2 objects")
                                   .arg(toQString(std::string(lastWord(values[0].path))), QString::number(values.size()));
    if (!resets.empty()) {
        if (const Result<EditPlan> plan = planReset(*document.loaded(), resets); !plan) return plan.error(); // shown in the row
        const bool copies =
            std::ranges::any_of(resets, [&](const auto& path) { return document.structure().targetOf(path).isShipped; });
        const auto plan = [resets](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
            std::vector<std::string> paths;
            for (const std::string& path : resets) paths.push_back(renamed(path));
            return planReset(loaded, paths);
        };
        if (copies) return document.structure().apply(QObject::tr("Reset %1").arg(what), {}, plan, mergeKey);
        return document.edits().edit(QObject::tr("Reset %1").arg(what), planReset(*document.loaded(), resets).value().edits,
                                     mergeKey);
    }
    if (edits.empty()) return {};
    const QString value = values.size() == 1 ? toQString(edits[0].value.text()).simplified() : QString();
    constexpr int kLongest = 24;
    const QString name = value.isEmpty() || value.size() > kLongest ? QObject::tr("Set %1").arg(what)
                                                                    : QObject::tr("Set %1 to %2").arg(what, value);
    return document.structure().setValues(name, edits, mergeKey);
}

QString nowText(const RunSession& session, const std::string& robot, bool position) {
    if (!session.edits().isOfRun(robot)) return {};
    const std::optional<Pose> pose = session.robots().pose(robot);
    if (!pose) return {};
    const Vec3 v = position ? pose->position : Vec3(hprFromRotation(pose->rotation) * (180 / std::numbers::pi));
    const int digits = position ? 3 : 1;
    const auto number = [&](double x) {
        const QString shown = QString::number(x, 'f', digits);
        return (shown.toDouble() == 0 ? QString::number(0.0, 'f', digits) : shown).rightJustified(7); // avoids -0.000
    };
    return QObject::tr("now %1 %2 %3").arg(number(v.x()), number(v.y()), number(v.z()));
}

std::string folderOf(const LoadedProject& loaded, const ListedRow& listed, const ObjectValues& object) {
    FileId file = listed.value.place.file;
    if (!listed.value.given() && object.instance()) file = object.instance()->file;
    if (file >= loaded.paths.size()) file = 0;
    return file < loaded.paths.size() ? QFileInfo(toQString(loaded.paths[file])).absolutePath().toStdString() : std::string();
}

void complete(Row& row, const ListedRow& listed, const ObjectValues& object, Document& document, const RunSession* session) {
    const std::shared_ptr<const LoadedProject> loaded = row.loaded;
    if (const Property* p = listed.value.property) {
        const Part* config = listed.config;
        if (listed.kind && isBodyToCountFrom(*listed.kind, *p))
            row.candidates = [loaded, path = std::string(withoutLastWord(listed.value.path))] {
                return bodiesForIn(*loaded, path).value_or(std::vector<std::string>());
            };
        else if (p->type == PropertyType::Reference)
            row.candidates = [loaded, p, config] { return fittingNames(*loaded, *p, config); };
        else if (listed.kind && p->name == "Robot" && namesWorld(*listed.kind, *p))
            row.candidates = [loaded] { return robotNames(*loaded); };
        if (p->type == PropertyType::File) row.folder = folderOf(*loaded, listed, object);
    } else if (object.isInstance() && object.config()) {
        const Property* named = propertyNamedBy(*object.config(), lastWord(listed.value.path));
        if (named)
            row.candidates = [loaded, named, path = object.path()] {
                return fittingNames(*loaded, *named, ObjectValues(loaded, path));
            };
    }
    if (session) {
        row.afterReset = std::any_of(row.values.begin(), row.values.end(),
                                     [&](const FieldValue& v) { return session->edits().waitsForReset(v.path); });
        if (row.values.size() == 1 && object.isInstance() && (row.id == "Pos" || row.id == "HPR"))
            row.now = [session, robot = object.shownPath(), position = row.id == "Pos"] {
                return nowText(*session, robot, position);
            };
    }
    row.set = [&document, values = row.values, loaded](const Change& change, const std::string& mergeKey) {
        return setAll(document, values, change, mergeKey);
    };
}

} // namespace

QString shortName(const std::string& path) { return toQString(pathInside(lastWord(withoutLastWord(path)), lastWord(path))); }

Status pushOverride(Document& document, const std::string& propertyPath) {
    return document.structure().pushOverride(QObject::tr("Push %1 into the config").arg(shortName(propertyPath)), propertyPath);
}

Status pullOverride(Document& document, const std::string& propertyPath) {
    const QString name = QObject::tr("Override %1").arg(shortName(propertyPath));
    const Result<EditPlan> pulled = planPullOverride(*document.loaded(), propertyPath);
    if (!pulled) return pulled.error(); // shown in the row
    if (!document.structure().targetOf(propertyPath).isShipped) return document.edits().edit(name, pulled.value().edits);
    const auto plan = [propertyPath](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
        return planPullOverride(loaded, renamed(propertyPath));
    };
    return document.structure().apply(name, {}, plan);
}

bool canReset(const Row& row) {
    std::vector<std::string> paths;
    for (const FieldValue& v : row.values)
        if (v.given()) paths.push_back(v.path);
    return planReset(*row.loaded, paths).ok();
}

Objects objectsAt(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<std::string>& paths) {
    Objects objects;
    for (const std::string& path : paths) {
        auto object = std::make_unique<ObjectValues>(loaded, path);
        if (object->exists()) objects.push_back(std::move(object));
    }
    if (paths.empty()) objects.push_back(std::make_unique<ObjectValues>(loaded, std::string()));
    // members of one Grid are one object
    std::vector<std::string> seen;
    std::erase_if(objects, [&](const auto& object) {
        if (std::find(seen.begin(), seen.end(), object->path()) != seen.end()) return true;
        seen.push_back(object->path());
        return false;
    });
    return objects;
}

std::vector<Row> rowsOf(const Objects& objects, Document& document, const RunSession* session) {
    const std::shared_ptr<const LoadedProject>& loaded = objects[0]->sharedLoaded(); // keeps the Property pointers valid
    std::vector<std::vector<ListedRow>> lists;
    std::vector<std::unordered_map<std::string, std::size_t>> places(objects.size());
    for (const auto& object : objects) {
        lists.push_back(PropertyRowBuilder(*object, loaded).list());
        for (std::size_t i = 0; i < lists.back().size(); ++i) places[lists.size() - 1].emplace(lists.back()[i].id, i);
    }
    std::vector<Row> rows;
    for (const ListedRow& first : lists[0]) {
        Row row{first.id, first.label, first.section, {}, loaded, false, {}, {}, {}, {}};
        for (std::size_t i = 0; i < lists.size(); ++i) {
            const auto it = places[i].find(first.id);
            if (it == places[i].end() || !alike(first, lists[i][it->second])) break;
            row.values.push_back(lists[i][it->second].value);
            if (lists[i][it->second].section != first.section) row.section = commonSection(first);
        }
        if (row.values.size() != objects.size()) continue;
        complete(row, first, *objects[0], document, session);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace trundle
