// needs        a plan, and the objects that it was requested for
// method       the plan is made; for each config that it changes, either the config itself or a copy is changed; a copy is
//              made in texts in memory, which are loaded, and the plan is made again for them; finally all becomes one edit
//              of the document

#include "editor/document/structure_edits.h"

#include <algorithm>
#include <set>

#include "editor/document/document.h"
#include "editor/document/project_rename.h"
#include "editor/widgets/strings.h"
#include "lang/text_splice.h"
#include "lang/tree_edit.h"
#include "model/dotted_path.h"

namespace trundle {

namespace {

constexpr int kMaxCopies = 100;

std::string keyOf(const LoadedProject& loaded, const Part& config) { return loaded.paths[config.file] + "#" + config.name; }

/// Why the values that an edit set are invalid; empty if they are valid.
std::string reasonAgainst(const ChangeSet& changes) {
    for (const Diagnostic* error : changes.valueErrors()) {
        const bool isUnread = changes.after()->pending && error->code == Code::MeshUnreadable; // reported once it is read
        if (!isUnread) return error->message;
    }
    return {};
}

/// The instances that will use a copy of a config: those through which it is edited, if they are in its file, else all instances
/// of the file. `edited`: paths of the edited objects.
std::vector<const Part*> instancesForCopy(const LoadedProject& loaded, const std::vector<std::string>& edited,
                                          const Part& config) {
    std::vector<const Part*> through;
    for (const std::string& path : edited) {
        const auto place = placeOf(loaded, path);
        const Part* instance = place ? place->instance : nullptr;
        if (instance && configOf(loaded, *instance) == &config && std::ranges::find(through, instance) == through.end())
            through.push_back(instance);
    }
    const FileId home = through.empty() ? FileId{0} : through.front()->file;
    std::vector<const Part*> all = instancesOf(loaded, config);
    std::erase_if(all, [&](const Part* p) {
        return p->file != home || (config.file == home && !through.empty() && std::ranges::find(through, p) == through.end());
    });
    return all;
}

/// The path of what would be copied; empty if the target is not in a shipped file.
std::string shippedPath(const EditTarget& target) {
    if (!target.isShipped) return {};
    return target.definition.empty() ? pathOfConfig(*target.config) : target.definition;
}

QString noticeOfCopy(const std::string& definition, const std::string& copy, const QString& file, const QStringList& others) {
    const QString made = QObject::tr("%1 came with Trundle and is read-only: %2 is a copy of it in %3")
                             .arg(toQString(std::string(lastWord(definition))), toQString(std::string(lastWord(copy))), file);
    return others.isEmpty() ? made : made + QObject::tr(", which %1 does not use").arg(others.join(QStringLiteral(", ")));
}

} // namespace

struct StructureEdits::PendingEdit {
    QString name;
    std::vector<std::string> paths;
    Plan plan;
    std::string mergeKey;
    std::uint64_t revision = 0;                  ///< of the document when `loaded` was taken
    std::shared_ptr<const LoadedProject> loaded; ///< including the copies made so far
    FileTexts texts;                             ///< texts that differ from the document's
    std::map<std::string, std::string> copies;   ///< path of a config -> path of its copy
    std::set<std::string> decided;               ///< keys of configs that are changed themselves
    std::set<std::string> changed;               ///< files that the plan changes; configs imported from them are copied too
    std::function<Status()> applyWithoutCopies;  ///< used instead of the plan if no text was changed for it; may be empty
    QStringList notices;
    Status status;
    bool answered = false;

    [[nodiscard]] std::string renamed(const std::string& path) const {
        for (const auto& [from, to] : copies)
            if (startsWithPath(path, from)) return to + path.substr(from.size());
        return path;
    }
    [[nodiscard]] std::vector<const Part*> copyUsers(const Part& config) const {
        std::vector<std::string> edited;
        for (const std::string& path : paths) edited.push_back(renamed(path));
        return instancesForCopy(*loaded, edited, config);
    }
};

Status StructureEdits::refuse(const Error& error) { return m_document.edits().apply({}, error); }

QString StructureEdits::shown(const std::string& file) const { return toQString(m_document.texts().shown(file)); }

Status StructureEdits::apply(const QString& name, const std::vector<std::string>& paths, Plan plan, const std::string& mergeKey) {
    if (!m_document.isOpen() || m_document.access().isReadOnly()) return m_document.edits().edit({}, {}); // reports why
    const auto work = startEdit(name, paths, std::move(plan));
    work->mergeKey = mergeKey;
    return advance(work);
}

std::shared_ptr<StructureEdits::PendingEdit> StructureEdits::startEdit(const QString& name, const std::vector<std::string>& paths,
                                                                       Plan plan) const {
    auto work = std::make_shared<PendingEdit>();
    work->name = name;
    work->paths = paths;
    work->plan = std::move(plan);
    work->loaded = m_document.loaded();
    work->revision = m_document.revision();
    return work;
}

Status StructureEdits::applyFix(const Fix& fix) {
    const QString name = QObject::tr("Fix: %1").arg(QString::fromStdString(fix.title));
    const auto found = m_document.loaded();
    const auto isShipped = [&](const TextEdit& edit) { return isShippedFile(*found, edit.range.file); };
    if (!m_document.isOpen() || std::ranges::none_of(fix.edits, isShipped)) return m_document.edits().edit(name, editsOf(fix));
    return apply(name, {}, [found, fix](const LoadedProject& loaded, const PathMapping& renamed) {
        return planFix(*found, fix, loaded, renamed);
    });
}

Status StructureEdits::rename(const QString& name, const std::string& path, const std::string& to) {
    if (!m_document.isOpen()) return m_document.edits().edit({}, {}); // reports why it is refused
    const auto place = placeOf(*m_document.loaded(), path);
    const Part* top = !place || !place->part ? nullptr : place->above.empty() ? place->part : place->above.front();
    const bool isCopied = (top && top->is(Role::Config)) || !shippedDefinitionAt(*m_document.loaded(), path).empty();
    if (m_document.access().isReadOnly() || !isCopied) return renameEverywhere(name, path, to);
    auto work = startEdit(name, {path}, [path, to](const LoadedProject& loaded, const PathMapping& renamed) {
        return planRename(loaded, renamed(path), to);
    });
    // The uses of a copy are all in the texts that it was made in.
    work->applyWithoutCopies = [this, name, path, to] { return renameEverywhere(name, path, to); };
    return advance(work);
}

Status StructureEdits::renameEverywhere(const QString& name, const std::string& path, const std::string& to) {
    if (m_document.access().isReadOnly()) return m_document.edits().edit({}, {}); // reports who has the project
    const LoadedProject& loaded = *m_document.loaded();
    std::string declared = path; // other texts may not have the instance that the path leads through
    if (auto place = placeOf(loaded, path); place && place->part) {
        place->above.push_back(place->part);
        declared = pathOf(loaded, place->above);
    }
    ProjectRename rename(m_document, declared, std::string(lastWord(declared)));
    const std::vector<ProjectRename::Use> uses = rename.usesOutside();
    if (uses.empty()) return m_document.edits().apply(name, planRename(loaded, path, to));
    if (Status done = rename.apply(name, to, true); !done) return done;
    QStringList files;
    for (const ProjectRename::Use& use : uses) files += QObject::tr("%1 (%2)").arg(shown(use.file), QString::number(use.count));
    QString text = QObject::tr("Also renamed in %1").arg(files.join(QStringLiteral(", ")));
    if (!rename.isComplete())
        text += QObject::tr("; the project has more than %1 texts that import it, and the others were not read")
                    .arg(ProjectRename::kMaxTexts);
    Q_EMIT m_document.notice(text);
    return {};
}

Status StructureEdits::advance(const std::shared_ptr<PendingEdit>& work) {
    for (int copies = 0; copies < kMaxCopies; ++copies) {
        const LoadedProject& loaded = *work->loaded;
        Result<EditPlan> plan = work->plan(loaded, [&work](const std::string& path) { return work->renamed(path); });
        if (!plan) return m_document.edits().apply(work->name, plan);
        if (const std::vector<std::string> shipped = definitionsChangedBy(loaded, plan.value()); !shipped.empty()) {
            if (work->copies.contains(shipped.front()))
                return refuse({Code::WrongPlace, shipped.front() + " is changed by this as well as its copy"});
            if (Status done = copyDefinition(*work, shipped.front()); !done) return refuse(done.error());
            continue;
        }
        const Part* next = nullptr;
        for (const Part* config : configsChangedBy(loaded, plan.value()))
            if (!next && !work->decided.contains(keyOf(loaded, *config))) next = config;
        if (!next) {
            const Status done = finish(*work, plan.value());
            if (done && !work->notices.isEmpty()) Q_EMIT m_document.notice(work->notices.join(u"; "_qs));
            return done;
        }
        for (const auto& [file, edits] : plan.value().edits) work->changed.insert(loaded.paths[file]);
        const std::string key = keyOf(loaded, *next);
        if (work->copies.contains(pathOfConfig(*next)))
            return refuse(
                {Code::WrongPlace, next->title() + " is changed by this as well as its copy; change it for all instead"});
        const EditTarget target = targetOfStructure(loaded, *next, nullptr, m_users);
        const bool isOwn = std::ranges::none_of(target.users, [&](const std::string& user) { return user != loaded.paths[0]; }) &&
                           next->file == 0 && work->copyUsers(*next).size() == target.instances;
        const auto known = m_chosen.find(key);
        if (target.isShipped || (known != m_chosen.end() && known->second == ShareChoice::MakeCopy && !isOwn)) {
            if (Status done = copy(*work, *next); !done) return refuse(done.error());
        } else if (isOwn || known != m_chosen.end() || !m_questionHandler) {
            const Result<bool> expanded = expand(*work, *next);
            if (!expanded) return refuse(expanded.error());
            if (!expanded.value()) work->decided.insert(key);
        } else {
            return ask(work, *next);
        }
    }
    return refuse(Error{Code::EditRefused, "this changes too many configs at once"});
}

Status StructureEdits::ask(const std::shared_ptr<PendingEdit>& work, const Part& config) {
    const LoadedProject& loaded = *work->loaded;
    const std::vector<const Part*> instances = work->copyUsers(config);
    ShareQuestion question;
    question.config = toQString(config.name);
    question.file = shown(loaded.paths[config.file]);
    const FileId copyFile = instances.empty() ? FileId{0} : instances.front()->file;
    question.copyFile = shown(loaded.paths[copyFile]);
    question.copyIsForOpened = copyFile == 0;
    for (const std::string& user : m_users.of(loaded, config)) question.users += shown(user);
    for (const Part* instance : instances) question.copyFor += toQString(instance->name);
    question.instances = instancesOf(loaded, config).size();
    const std::string key = keyOf(loaded, config);
    m_questionHandler(question, [this, work, key](ShareChoice choice) {
        if (std::exchange(work->answered, true)) return;
        if (choice == ShareChoice::Cancel) return;
        m_chosen[key] = choice;
        if (work->revision != m_document.revision()) { // the document changed meanwhile: start again with its current state
            work->loaded = m_document.loaded();
            work->revision = m_document.revision();
            work->texts.clear(), work->copies.clear(), work->decided.clear(), work->changed.clear(), work->notices.clear();
        }
        work->answered = false;
        work->status = m_document.isOpen() ? advance(work) : Status();
    });
    return work->status;
}

Status StructureEdits::copy(PendingEdit& work, const Part& config) {
    const LoadedProject& loaded = *work.loaded;
    const std::vector<const Part*> instances = work.copyUsers(config);
    const bool isShipped = isShippedFile(loaded, config.file);
    const Result<EditPlan> plan = planCopyConfig(loaded, config, instances, work.changed);
    if (!plan) return plan.error();
    const std::string from = pathOfConfig(config), to = plan.value().selects.front();
    const QString copyName = toQString(std::string(lastWord(to)));
    const QString file = shown(loaded.paths[instances.empty() ? FileId{0} : instances.front()->file]);
    const QString made = instances.empty() ? QObject::tr("%1 is a copy of it in %2").arg(copyName, file)
                         : instances.size() == 1
                             ? QObject::tr("%1 uses %2, a copy of it in %3").arg(toQString(instances[0]->name), copyName, file)
                             : QObject::tr("%1 instances use %2, a copy of it in %3").arg(instances.size()).arg(copyName, file);
    work.notices += (isShipped ? QObject::tr("%1 came with Trundle and is read-only: %2") : QObject::tr("%1 is unchanged: %2"))
                        .arg(toQString(config.name), made);
    if (Status read = reload(work, plan.value()); !read) return read;
    work.copies[from] = to;
    const auto copied = placeOf(*work.loaded, to);
    if (!copied || !copied->part) return Error{Code::EditRefused, from + " could not be copied"};
    work.decided.insert(keyOf(*work.loaded, *copied->part));
    return {};
}

Status StructureEdits::copyDefinition(PendingEdit& work, const std::string& definition) {
    const std::vector<FileId> others = otherFilesUsing(*work.loaded, definition);
    for (int configs = 0; configs < kMaxCopies; ++configs) {
        const LoadedProject& loaded = *work.loaded;
        const Result<EditPlan> plan = planCopyDefinition(loaded, definition);
        if (!plan) return plan.error();
        const std::vector<const Part*> changed = configsChangedBy(loaded, plan.value());
        const auto shipped =
            std::ranges::find_if(changed, [&](const Part* config) { return isShippedFile(loaded, config->file); });
        if (shipped != changed.end()) {
            if (Status done = copy(work, **shipped); !done) return done;
            continue;
        }
        const std::string to = plan.value().selects.front();
        QStringList files;
        for (const FileId file : others) files += shown(loaded.paths[file]);
        work.notices.prepend(noticeOfCopy(definition, to, shown(loaded.paths[0]), files));
        if (Status read = reload(work, plan.value()); !read) return read;
        work.copies[definition] = to;
        return {};
    }
    return Error{Code::EditRefused, definition + " is used by too many configs at once"};
}

/// A config of the user's own that imports shipped files inside its block: what is changed in them is written into the block.
/// False if there is nothing of this kind.
Result<bool> StructureEdits::expand(PendingEdit& work, const Part& config) {
    const LoadedProject& loaded = *work.loaded;
    std::set<std::string> shipped;
    QStringList names;
    for (FileId file = 0; file < loaded.paths.size(); ++file)
        if (isShippedFile(loaded, file) && work.changed.contains(loaded.paths[file])) {
            shipped.insert(loaded.paths[file]);
            names += shown(loaded.paths[file]);
        }
    if (shipped.empty()) return false;
    const Result<EditPlan> plan = planExpandImports(loaded, config, shipped);
    if (!plan) return plan.error();
    if (plan.value().edits.empty()) return false;
    work.notices += QObject::tr("%1 came with Trundle and is read-only: %2 has its text instead of the import")
                        .arg(names.join(QStringLiteral(", ")), toQString(config.name));
    if (Status read = reload(work, plan.value()); !read) return read.error();
    return true;
}

Status StructureEdits::reload(PendingEdit& work, const EditPlan& plan) {
    for (const auto& [file, edits] : plan.edits) {
        Result<std::string> bytes = applyEdits(work.loaded->trees[file]->source().bytes(), edits);
        if (!bytes) return bytes.error();
        work.texts.insert_or_assign(work.loaded->paths[file], std::make_shared<const std::string>(std::move(bytes).value()));
    }
    Result<std::shared_ptr<const LoadedProject>> loaded = m_document.loading().with(work.texts);
    if (!loaded) return loaded.error();
    work.loaded = std::move(loaded).value();
    return {};
}

Status StructureEdits::finish(PendingEdit& work, const EditPlan& plan) {
    if (work.texts.empty() && work.applyWithoutCopies) return work.applyWithoutCopies();
    if (work.texts.empty()) return m_document.edits().apply(work.name, plan, work.mergeKey);
    if (Status read = reload(work, plan); !read) return refuse(read.error());
    EditPlan all{{}, plan.selects};
    const std::vector<std::string>& paths = m_document.loaded()->paths;
    for (const auto& [path, after] : work.texts) {
        const auto file = static_cast<FileId>(std::ranges::find(paths, path) - paths.begin());
        if (file == paths.size()) return refuse(Error{Code::EditRefused, path + " is no file of this project"});
        const TextSplice splice = spliceBetween(*m_document.texts().text(path), *after);
        const auto begin = static_cast<std::uint32_t>(splice.at), end = begin + static_cast<std::uint32_t>(splice.removed.size());
        if (!splice.empty()) all.edits[file].push_back({{file, {begin, end}}, splice.inserted});
    }
    return m_document.edits().apply(work.name, all, work.mergeKey);
}

Status StructureEdits::setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey) {
    if (const Status may = m_document.access().checkEditable(); !may) return m_document.edits().apply(name, may.error());
    std::vector<std::string> asked;
    for (const ValueEdit& value : values) asked.push_back(value.path.text());
    // All steps of a drag use the copy made under its merge key.
    const bool copies =
        mergeKey.empty() && std::ranges::any_of(asked, [&](const std::string& path) { return targetOf(path).isShipped; });
    const std::string key = copies ? "copy " + std::to_string(m_document.revision()) : mergeKey;
    const Result<std::vector<std::string>> paths = pathsForValues(asked, key);
    if (!paths) return m_document.edits().apply(name, paths.error());
    std::vector<ValueEdit> targets;
    for (std::size_t i = 0; i < values.size(); ++i) targets.push_back({paths.value()[i], values[i].value});
    const Result<FileEdits> edits = editsForValues(*m_document.loaded(), targets);
    // Loads once, with the values applied: a drag does this on every step.
    const Status done = edits ? m_document.edits().edit(name, edits.value(), key, reasonAgainst) : refuse(edits.error());
    if (done && !m_notice.isEmpty()) Q_EMIT m_document.notice(m_notice); // after each step of a drag, since a change removes it
    if (key == mergeKey) return done;
    if (!done) m_document.edits().discardMerge(key);
    m_document.edits().endMerge();
    if (done) Q_EMIT m_document.selectionRequested({std::string(withoutLastWord(paths.value()[0]))});
    return done;
}

EditTarget StructureEdits::targetOf(const std::string& propertyPath) {
    return targetOfValue(*m_document.loaded(), propertyPath, m_users);
}

Result<std::vector<std::string>> StructureEdits::pathsForValues(const std::vector<std::string>& asked,
                                                                const std::string& mergeKey) {
    if (m_gesture != mergeKey || !m_document.edits().history().canDiscardMerge(mergeKey))
        m_targets.clear(), m_copies.clear(), m_notice.clear();
    m_gesture = mergeKey;
    std::vector<std::string> paths;
    for (const std::string& path : asked) {
        if (!m_targets.contains(path)) {
            const EditTarget target = targetOf(path);
            const std::string shipped = shippedPath(target);
            if (target.isShipped && !m_copies.contains(shipped)) {
                Result<std::string> copy = target.definition.empty() ? copyConfig(std::string(withoutLastWord(path)), mergeKey)
                                                                     : copyDefinition(target.definition, mergeKey);
                if (!copy) return copy.error();
                m_copies.emplace(shipped, std::move(copy).value());
            }
            m_targets.emplace(path, target.isShipped ? m_copies.at(shipped) + path.substr(shipped.size()) : target.path);
        }
        paths.push_back(m_targets.at(path));
    }
    return paths;
}

Result<std::string> StructureEdits::copyDefinition(const std::string& definition, const std::string& mergeKey) {
    PendingEdit work;
    work.name = QObject::tr("Copy %1").arg(toQString(std::string(lastWord(definition))));
    work.mergeKey = mergeKey;
    work.loaded = m_document.loaded();
    if (Status done = copyDefinition(work, definition); !done) return done.error();
    if (Status done = finish(work, {}); !done) return done.error();
    m_notice = work.notices.join(u"; "_qs);
    return work.copies.at(definition);
}

Result<std::string> StructureEdits::copyConfig(const std::string& path, const std::string& mergeKey) {
    PendingEdit work;
    work.paths = {path};
    work.loaded = m_document.loaded();
    const auto place = placeOf(*work.loaded, path);
    const Part* top = !place || !place->part ? nullptr : place->above.empty() ? place->part : place->above.front();
    const Part* config = place && place->instance ? configOf(*work.loaded, *place->instance) : top;
    if (!config || !config->is(Role::Config)) return Error{Code::NoSuchPath, path + " is no part of a config"};
    const std::string from = pathOfConfig(*config);
    work.changed = {work.loaded->paths[place->part->file]};
    const bool isOwn = !isShippedFile(*work.loaded, config->file);
    if (isOwn) {
        if (const Result<bool> expanded = expand(work, *config); !expanded) return expanded.error();
        work.copies[from] = from;
    } else if (Status done = copy(work, *config); !done) {
        return done.error();
    }
    EditPlan none;
    const QString configName = toQString(std::string(lastWord(from)));
    work.name = isOwn ? QObject::tr("Expand imports of %1").arg(configName) : QObject::tr("Copy %1").arg(configName);
    work.mergeKey = mergeKey;
    if (mergeKey.empty()) none.selects = {work.copies.at(from)};
    if (Status done = finish(work, none); !done) return done.error();
    m_notice = work.notices.join(u"; "_qs);
    return work.copies.at(from);
}

} // namespace trundle
