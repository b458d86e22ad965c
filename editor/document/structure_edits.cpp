// needs        a plan, and the objects that it was requested for
// method       the plan is made; for each config that it changes, either the config itself or a copy is changed; after a copy the
//              plan is made again for the project with the copy (prepared_edit.h); finally all becomes one edit of the document

#include "editor/document/structure_edits.h"

#include <algorithm>
#include <array>
#include <optional>

#include <QRegularExpression>

#include "editor/document/document.h"
#include "editor/document/prepared_edit.h"
#include "editor/document/project_rename.h"
#include "editor/widgets/strings.h"
#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "project/loading/import_path.h"

namespace trundle {

namespace {

/// Why the values that an edit set are invalid; empty if they are valid.
std::string reasonAgainst(const ChangeSet& changes) {
    for (const Diagnostic* error : changes.valueErrors()) {
        const bool isUnread = changes.after()->pending && error->code == Code::MeshUnreadable; // reported once it is read
        if (!isUnread) return error->message;
    }
    return {};
}

/// The selection after an edit that does not choose one: what was selected in a config is selected in its copy. Empty if that changes
/// nothing.
std::vector<std::string> selectedInCopies(const PreparedEdit& prepared, const std::vector<std::string>& selected) {
    std::vector<std::string> paths;
    for (const std::string& path : selected)
        if (std::string there = prepared.renamed(path); placeOf(prepared.loaded(), there)) paths.push_back(std::move(there));
    return paths == selected ? std::vector<std::string>() : paths;
}

/// The path of what would be copied; empty if the target is not in a shipped file.
std::string shippedPath(const EditTarget& target) {
    if (!target.isShipped) return {};
    return target.definition.empty() ? pathOfConfig(*target.config) : target.definition;
}

/// Whether no file but the opened one uses a config. Of a config in another file at most once, and in the project: what uses a file
/// elsewhere is not known.
bool isOnlyInOpened(const LoadedProject& loaded, const Part& config, const EditTarget& target) {
    if (std::ranges::any_of(target.users, [&](const std::string& user) { return user != loaded.paths[0]; })) return false;
    return config.file == 0 || (target.instances <= 1 && pathBelow(loaded.paths[config.file], std::array{loaded.projectFolder}));
}

} // namespace

struct StructureEdits::PendingEdit {
    QString name;
    Plan plan;
    std::string mergeKey;
    PreparedEdit prepared;
    QString value = {};                               ///< the value that is all it changes; empty: the structure
    std::pair<std::string, std::string> renamed = {}; ///< path and new name of the object that it renames
    std::function<Status()> applyWithoutCopies = {};  ///< used instead of the plan if no text was changed for it; may be empty
    Status status = {};
    bool answered = false;
};

/// Which copies were made. One that the edit renames has its new name.
QString StructureEdits::noticeOf(const PendingEdit& work) {
    QString notice = work.prepared.notice();
    const auto& [path, name] = work.renamed;
    if (path.empty() || !work.prepared.isCopied(path)) return notice;
    const QString copy = toQString(std::string(lastWord(work.prepared.copyOf(path))));
    const QRegularExpression word(QStringLiteral("\\b%1\\b(?![./])").arg(QRegularExpression::escape(copy))); // no path of a file
    return notice.replace(word, toQString(name));
}

Status StructureEdits::refuse(const Error& error) { return m_document.edits().apply({}, error); }

QString StructureEdits::shown(const std::string& file) const { return toQString(m_document.texts().shown(file)); }

Status StructureEdits::apply(const QString& name, const std::vector<std::string>& paths, Plan plan, const std::string& mergeKey) {
    if (!m_document.isOpen() || m_document.access().isReadOnly()) return m_document.edits().edit({}, {}); // reports why
    return advance(startEdit(name, paths, std::move(plan), mergeKey));
}

std::shared_ptr<StructureEdits::PendingEdit> StructureEdits::startEdit(const QString& name, const std::vector<std::string>& paths,
                                                                       Plan plan, const std::string& mergeKey) const {
    return std::make_shared<PendingEdit>(PendingEdit{name, std::move(plan), mergeKey, PreparedEdit(m_document, paths)});
}

Status StructureEdits::pushOverride(const QString& name, const std::string& propertyPath) {
    if (!m_document.isOpen() || m_document.access().isReadOnly()) return m_document.edits().edit({}, {}); // reports why
    const auto work = startEdit(name, {std::string(withoutLastWord(propertyPath))},
                                [propertyPath](const LoadedProject& loaded, const PathMapping& renamed) {
                                    return planPushOverride(loaded, renamed(propertyPath));
                                },
                                {});
    work->value = toQString(std::string(lastWord(propertyPath)));
    return advance(work);
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
    const auto work = startEdit(
        name, {path},
        [path, to](const LoadedProject& loaded, const PathMapping& renamed) { return planRename(loaded, renamed(path), to); },
        {});
    work->renamed = {path, to};
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
    PreparedEdit& prepared = work->prepared;
    for (int copies = 0; copies < PreparedEdit::kMaxCopies; ++copies) {
        const LoadedProject& loaded = prepared.loaded();
        Result<EditPlan> plan = work->plan(loaded, [&prepared](const std::string& path) { return prepared.renamed(path); });
        if (!plan) return m_document.edits().apply(work->name, plan);
        if (const std::vector<std::string> shipped = definitionsChangedBy(loaded, plan.value()); !shipped.empty()) {
            if (prepared.isCopied(shipped.front()))
                return refuse({Code::WrongPlace, shipped.front() + " is changed by this as well as its copy"});
            if (Status done = prepared.copyDefinition(shipped.front()); !done) return refuse(done.error());
            continue;
        }
        const Part* next = nullptr;
        for (const Part* config : configsChangedBy(loaded, plan.value()))
            if (!next && !prepared.isDecided(*config)) next = config;
        if (!next) {
            const Status done = finish(*work, plan.value());
            if (const QString notice = noticeOf(*work); done && !notice.isEmpty()) Q_EMIT m_document.notice(notice);
            return done;
        }
        prepared.changesFilesOf(plan.value());
        if (prepared.isCopied(pathOfConfig(*next)))
            return refuse(
                {Code::WrongPlace, next->title() + " is changed by this as well as its copy; change it for all instead"});
        if (const std::optional<Status> ended = decide(work, *next)) return *ended;
    }
    return refuse(Error{Code::EditRefused, "this changes too many configs at once"});
}

/// Whether a config itself or a copy of it is changed. Returns a value if the edit cannot continue now: it is refused, or the user
/// is asked. A shipped config is always copied; where a value is moved into it, the user is asked for which instances. `copyForAll`:
/// for all, since that was chosen for what it has.
std::optional<Status> StructureEdits::decide(const std::shared_ptr<PendingEdit>& work, const Part& config, bool copyForAll) {
    PreparedEdit& prepared = work->prepared;
    const LoadedProject& loaded = prepared.loaded();
    const EditTarget target = targetOfStructure(loaded, config, nullptr, m_users);
    const bool isOwn =
        isOnlyInOpened(loaded, config, target) && (config.file != 0 || prepared.copyUsers(config).size() == target.instances);
    const auto known = m_chosen.find(prepared.keyOf(config));
    if (target.isShipped || (known != m_chosen.end() && known->second == ShareChoice::MakeCopy && !isOwn)) {
        const bool isChosen = known != m_chosen.end();
        const bool isShared = prepared.usersInUse(config).size() > prepared.editedThrough(config).size();
        const bool isAsked = !work->value.isEmpty() && isShared && !prepared.editedThrough(config).empty() && m_questionHandler;
        if (target.isShipped && (copyForAll || (isChosen && known->second == ShareChoice::ChangeForAll)))
            prepared.copyForAll(config);
        else if (target.isShipped && isChosen) prepared.copyForEdited(config);
        else if (target.isShipped && isAsked) return ask(work, config);
        if (const Part* holder = prepared.holderToDecide(config)) // its Part would use the copy
            return decide(work, *holder, target.isShipped && prepared.isCopiedForAll(config));
        if (Status done = prepared.copy(config); !done) return refuse(done.error());
        return std::nullopt;
    }
    if (!isOwn && known == m_chosen.end() && m_questionHandler) return ask(work, config);
    const std::string key = prepared.keyOf(config); // expand() loads the project again
    const Result<bool> expanded = prepared.expand(config);
    if (!expanded) return refuse(expanded.error());
    if (!expanded.value()) prepared.changeItself(key);
    return std::nullopt;
}

Status StructureEdits::ask(const std::shared_ptr<PendingEdit>& work, const Part& config) {
    const LoadedProject& loaded = work->prepared.loaded();
    ShareQuestion question;
    question.isShipped = isShippedFile(loaded, config.file);
    const std::vector<const Part*> instances =
        question.isShipped ? work->prepared.editedThrough(config) : work->prepared.copyUsers(config);
    question.config = toQString(config.name);
    question.file = shown(loaded.paths[config.file]);
    const bool isForOpened = instances.empty() || question.isShipped; // what has a shipped Part is copied too
    const FileId copyFile = isForOpened ? FileId{0} : instances.front()->file;
    question.copyFile = shown(loaded.paths[copyFile]);
    question.copyIsForOpened = copyFile == 0;
    if (!question.isShipped)
        for (const std::string& user : m_users.of(loaded, config)) question.users += shown(user);
    for (const Part* instance : instances) question.copyFor += toQString(instance->name);
    question.instances = question.isShipped ? work->prepared.usersInUse(config).size() : instancesOf(loaded, config).size();
    question.value = work->value;
    const std::string key = work->prepared.keyOf(config);
    m_questionHandler(question, [this, work, key](ShareChoice choice) {
        if (std::exchange(work->answered, true)) return;
        if (choice == ShareChoice::Cancel) return;
        m_chosen[key] = choice;
        work->prepared.restartIfChanged();
        work->answered = false;
        work->status = m_document.isOpen() ? advance(work) : Status();
    });
    return work->status;
}

Status StructureEdits::finish(PendingEdit& work, const EditPlan& plan) {
    if (!work.prepared.hasTexts() && work.applyWithoutCopies) return work.applyWithoutCopies();
    if (!work.prepared.hasTexts()) return m_document.edits().apply(work.name, plan, work.mergeKey);
    Result<EditPlan> all = work.prepared.withCopies(plan);
    if (!all) return refuse(all.error());
    if (plan.selects.empty()) all.value().selects = selectedInCopies(work.prepared, m_document.edits().selectedPaths());
    return m_document.edits().apply(work.name, all.value(), work.mergeKey);
}

Status StructureEdits::setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey) {
    if (const Status may = m_document.access().checkEditable(); !may) return m_document.edits().apply(name, may.error());
    std::vector<std::string> asked;
    for (const ValueEdit& value : values) asked.push_back(value.path.text());
    // All steps of a drag use the copy made under its merge key.
    const bool copies =
        mergeKey.empty() && std::ranges::any_of(asked, [&](const std::string& path) { return targetOf(path).isShipped; });
    const std::string key = copies ? "copy " + std::to_string(m_document.revision()) : mergeKey;
    const auto closed = [&](const Status& done) { // copies stay only with the values that they were made for
        if (key == mergeKey) return done;
        if (!done) m_document.edits().discardMerge(key);
        m_document.edits().endMerge();
        return done;
    };
    const Result<std::vector<std::string>> paths = pathsForValues(asked, key);
    if (!paths) return closed(m_document.edits().apply(name, paths.error()));
    std::vector<ValueEdit> targets;
    for (std::size_t i = 0; i < values.size(); ++i) targets.push_back({paths.value()[i], values[i].value});
    const Result<FileEdits> edits = editsForValues(*m_document.loaded(), targets);
    // Loads once, with the values applied: a drag does this on every step.
    const Status done = edits ? m_document.edits().edit(name, edits.value(), key, reasonAgainst) : refuse(edits.error());
    if (done && !m_notice.isEmpty()) Q_EMIT m_document.notice(m_notice); // after each step of a drag, since a change removes it
    (void)closed(done);
    if (done && key != mergeKey) Q_EMIT m_document.selectionRequested({std::string(withoutLastWord(paths.value()[0]))});
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
                Result<std::string> copy = target.definition.empty()
                                               ? copyConfig(std::string(withoutLastWord(target.path)), mergeKey)
                                               : copyDefinition(target.definition, mergeKey);
                if (!copy) return copy.error();
                m_copies.emplace(shipped, std::move(copy).value());
            }
            m_targets.emplace(path, target.isShipped ? m_copies.at(shipped) + target.path.substr(shipped.size()) : target.path);
        }
        paths.push_back(m_targets.at(path));
    }
    return paths;
}

Result<std::string> StructureEdits::copyDefinition(const std::string& definition, const std::string& mergeKey) {
    const QString name = QObject::tr("Copy %1").arg(toQString(std::string(lastWord(definition))));
    PendingEdit work{name, {}, mergeKey, PreparedEdit(m_document, {})};
    if (Status done = work.prepared.copyDefinition(definition); !done) return done.error();
    if (Status done = finish(work, {}); !done) return done.error();
    m_notice = work.prepared.notice();
    return work.prepared.copyOf(definition);
}

Result<std::string> StructureEdits::copyConfig(const std::string& path, const std::string& mergeKey) {
    PendingEdit work{{}, {}, mergeKey, PreparedEdit(m_document, {path})};
    PreparedEdit& prepared = work.prepared;
    const LoadedProject& loaded = prepared.loaded();
    const auto place = placeOf(loaded, path);
    const Part* top = !place || !place->part ? nullptr : place->above.empty() ? place->part : place->above.front();
    const Part* instance = place ? place->instance : nullptr;
    const bool isInConfig = instance && (instance->isPartUse() || isVariant(*instance)); // what has the Part is copied
    const Part* config = instance && !isInConfig ? configOf(loaded, *instance) : top;
    if (!config || !config->is(Role::Config)) return Error{Code::NoSuchPath, path + " is no part of a config"};
    const std::string from = pathOfConfig(*config);
    const QString configName = toQString(std::string(lastWord(from)));
    prepared.changesFile(loaded.paths[isInConfig ? instance->file : place->part->file]);
    const bool isOwn = !isShippedFile(loaded, config->file);
    work.name = isOwn ? QObject::tr("Expand imports of %1").arg(configName) : QObject::tr("Copy %1").arg(configName);
    if (isOwn) {
        if (const Result<bool> expanded = prepared.expand(*config); !expanded) return expanded.error();
    } else if (Status done = prepared.copy(*config); !done) {
        return done.error();
    }
    const std::string copy = isOwn ? from : prepared.copyOf(from);
    EditPlan none;
    if (mergeKey.empty()) none.selects = {copy};
    if (Status done = finish(work, none); !done) return done.error();
    m_notice = prepared.notice();
    return copy;
}

} // namespace trundle
