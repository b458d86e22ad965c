// method       a copy is made in texts in memory, which are loaded; finally all texts that differ from the document's become one edit

#include "editor/document/prepared_edit.h"

#include <algorithm>

#include "editor/document/document.h"
#include "editor/widgets/strings.h"
#include "lang/text_splice.h"
#include "lang/tree_edit.h"
#include "model/dotted_path.h"
#include "project/edits/edit_target.h"

namespace trundle {
namespace {

/// The instances of a config through which it is edited. `edited`: paths of the edited objects.
std::vector<const Part*> instancesThrough(const LoadedProject& loaded, const std::vector<std::string>& edited,
                                          const Part& config) {
    std::vector<const Part*> through;
    for (const std::string& path : edited) {
        const auto place = placeOf(loaded, path);
        const Part* instance = place ? place->instance : nullptr;
        if (place) // an inner Part may be what uses it
            for (const Part* part : place->above)
                if (part->config == &config) instance = part;
        if (instance && configOf(loaded, *instance) == &config && std::ranges::find(through, instance) == through.end())
            through.push_back(instance);
    }
    return through;
}

/// The instances that will use a copy of a config: those through which it is edited, if they are in its file, else all instances
/// of the file.
std::vector<const Part*> instancesForCopy(const LoadedProject& loaded, const std::vector<std::string>& edited,
                                          const Part& config) {
    const std::vector<const Part*> through = instancesThrough(loaded, edited, config);
    const FileId home = through.empty() ? FileId{0} : through.front()->file;
    std::vector<const Part*> all = instancesOf(loaded, config);
    std::erase_if(all, [&](const Part* p) {
        return p->file != home || (config.file == home && !through.empty() && std::ranges::find(through, p) == through.end());
    });
    return all;
}

QString noticeOfCopy(const std::string& definition, const std::string& copy, const QString& file, const QStringList& others) {
    const QString made = QObject::tr("%1 came with Trundle and is read-only: %2 is a copy of it in %3")
                             .arg(toQString(std::string(lastWord(definition))), toQString(std::string(lastWord(copy))), file);
    return others.isEmpty() ? made : made + QObject::tr(", which %1 does not use").arg(others.join(QStringLiteral(", ")));
}

} // namespace

PreparedEdit::PreparedEdit(Document& document, std::vector<std::string> paths)
    : m_document(&document), m_paths(std::move(paths)), m_revision(document.revision()), m_loaded(document.loaded()) {}

void PreparedEdit::restartIfChanged() {
    if (m_revision != m_document->revision()) *this = PreparedEdit(*m_document, m_paths);
}

std::string PreparedEdit::keyOf(const Part& config) const { return m_loaded->paths[config.file] + "#" + config.name; }

std::string PreparedEdit::renamed(const std::string& path) const {
    for (const auto& [from, to] : m_copies)
        if (startsWithPath(path, from)) return to + path.substr(from.size());
    return path;
}

std::vector<std::string> PreparedEdit::editedPaths() const {
    std::vector<std::string> edited;
    for (const std::string& path : m_paths) edited.push_back(renamed(path));
    return edited;
}

std::vector<const Part*> PreparedEdit::copyUsers(const Part& config) const {
    const std::vector<std::string> edited = isCopiedForAll(config) ? std::vector<std::string>() : editedPaths();
    return copyForAllOr(config, true) ? instancesForCopy(*m_loaded, edited, config) : editedThrough(config);
}

std::vector<const Part*> PreparedEdit::editedThrough(const Part& config) const {
    return instancesThrough(*m_loaded, editedPaths(), config);
}

std::vector<const Part*> PreparedEdit::usersInUse(const Part& config) const {
    std::vector<const Part*> users = instancesOf(*m_loaded, config);
    std::erase_if(users, [&](const Part* user) {
        const Part* holder = isShippedFile(*m_loaded, user->file) ? holderOf(*m_loaded, *user) : nullptr;
        return holder && !isUsedByOwnTexts(*m_loaded, *holder);
    });
    return users;
}

bool PreparedEdit::copyForAllOr(const Part& config, bool undecided) const {
    const auto chosen = m_copyForAll.find(keyOf(config));
    return chosen == m_copyForAll.end() ? undecided : chosen->second;
}

const Part* PreparedEdit::holderToDecide(const Part& config) const {
    std::vector<const Part*> users = copyUsers(config);
    const bool isAll = isCopiedForAll(config) || editedThrough(config).empty();
    if (isAll) // also what shipped configs have of it
        for (const Part* user : instancesOf(*m_loaded, config))
            if (isShippedFile(*m_loaded, user->file)) users.push_back(user);
    for (const Part* user : users) {
        const Part* holder = holderOf(*m_loaded, *user);
        if (!holder || isDecided(*holder)) continue;
        if (!isAll || !isShippedFile(*m_loaded, holder->file) || isUsedByOwnTexts(*m_loaded, *holder)) return holder;
    }
    return nullptr;
}

void PreparedEdit::changesFilesOf(const EditPlan& plan) {
    for (const auto& [file, edits] : plan.edits) changesFile(m_loaded->paths[file]);
}

QString PreparedEdit::shown(const std::string& file) const { return toQString(m_document->texts().shown(file)); }

Status PreparedEdit::copy(const Part& config) {
    const std::string name = config.name;
    const Part* now = &config; // each copy loads the project again
    for (int copies = 0; copies < kMaxCopies; ++copies) {
        const Part* holder = holderToDecide(*now);
        if (!holder || !isShippedFile(*m_loaded, holder->file)) return copyItself(*now);
        if (Status done = copy(*holder); !done) return done;
        now = m_loaded->outline->configs.find(name);
        if (!now) return Error{Code::EditRefused, name + " could not be copied"};
    }
    return Error{Code::EditRefused, name + " is used by too many configs at once"};
}

Status PreparedEdit::copyItself(const Part& config) {
    const LoadedProject& loaded = *m_loaded;
    const std::vector<const Part*> instances = copyUsers(config);
    const bool isShipped = isShippedFile(loaded, config.file);
    const Result<EditPlan> plan = planCopyConfig(loaded, config, instances, m_changed);
    if (!plan) return plan.error();
    const std::string from = pathOfConfig(config), to = plan.value().selects.front();
    const QString copyName = toQString(std::string(lastWord(to)));
    const QString file = shown(loaded.paths[instances.empty() ? FileId{0} : instances.front()->file]);
    const QString name = toQString(config.name);
    const bool isFirst = m_notices.empty(); // the others have the same reason and the same file
    const QString what = isFirst ? QObject::tr("a copy of it in %1").arg(file) : QObject::tr("a copy of %1").arg(name);
    const QString made = instances.empty() ? QObject::tr("%1 is %2").arg(copyName, what)
                         : instances.size() == 1
                             ? QObject::tr("%1 uses %2, %3").arg(toQString(instances[0]->name), copyName, what)
                             : QObject::tr("%1 instances use %2, %3").arg(instances.size()).arg(copyName, what);
    m_notices += !isFirst    ? made
                 : isShipped ? QObject::tr("%1 came with Trundle and is read-only: %2").arg(name, made)
                             : QObject::tr("%1 is unchanged: %2").arg(name, made);
    if (Status read = reload(plan.value()); !read) return read;
    m_copies[from] = to;
    const auto copied = placeOf(*m_loaded, to);
    if (!copied || !copied->part) return Error{Code::EditRefused, from + " could not be copied"};
    m_decided.insert(keyOf(*copied->part));
    return {};
}

Status PreparedEdit::copyDefinition(const std::string& definition) {
    const std::vector<FileId> others = otherFilesUsing(*m_loaded, definition);
    for (int configs = 0; configs < kMaxCopies; ++configs) {
        const LoadedProject& loaded = *m_loaded;
        const Result<EditPlan> plan = planCopyDefinition(loaded, definition);
        if (!plan) return plan.error();
        const std::vector<const Part*> changed = configsChangedBy(loaded, plan.value());
        const auto shipped =
            std::ranges::find_if(changed, [&](const Part* config) { return isShippedFile(loaded, config->file); });
        if (shipped != changed.end()) {
            if (Status done = copy(**shipped); !done) return done;
            continue;
        }
        const std::string to = plan.value().selects.front();
        QStringList files;
        for (const FileId file : others) files += shown(loaded.paths[file]);
        m_notices.prepend(noticeOfCopy(definition, to, shown(loaded.paths[0]), files));
        if (Status read = reload(plan.value()); !read) return read;
        m_copies[definition] = to;
        return {};
    }
    return Error{Code::EditRefused, definition + " is used by too many configs at once"};
}

Result<bool> PreparedEdit::expand(const Part& config) {
    const LoadedProject& loaded = *m_loaded;
    std::set<std::string> shipped;
    QStringList names;
    for (FileId file = 0; file < loaded.paths.size(); ++file)
        if (isShippedFile(loaded, file) && m_changed.contains(loaded.paths[file])) {
            shipped.insert(loaded.paths[file]);
            names += shown(loaded.paths[file]);
        }
    if (shipped.empty()) return false;
    const Result<EditPlan> plan = planExpandImports(loaded, config, shipped);
    if (!plan) return plan.error();
    if (plan.value().edits.empty()) return false;
    m_notices += QObject::tr("%1 came with Trundle and is read-only: %2 has its text instead of the import")
                     .arg(names.join(QStringLiteral(", ")), toQString(config.name));
    if (Status read = reload(plan.value()); !read) return read.error();
    return true;
}

Status PreparedEdit::reload(const EditPlan& plan) {
    for (const auto& [file, edits] : plan.edits) {
        Result<std::string> bytes = applyEdits(m_loaded->trees[file]->source().bytes(), edits);
        if (!bytes) return bytes.error();
        m_texts.insert_or_assign(m_loaded->paths[file], std::make_shared<const std::string>(std::move(bytes).value()));
    }
    Result<std::shared_ptr<const LoadedProject>> loaded = m_document->loading().with(m_texts);
    if (!loaded) return loaded.error();
    m_loaded = std::move(loaded).value();
    return {};
}

Result<EditPlan> PreparedEdit::withCopies(const EditPlan& plan) {
    if (Status read = reload(plan); !read) return read.error();
    EditPlan all{{}, plan.selects};
    const std::vector<std::string>& paths = m_document->loaded()->paths;
    for (const auto& [path, after] : m_texts) {
        const auto file = static_cast<FileId>(std::ranges::find(paths, path) - paths.begin());
        if (file == paths.size()) return Error{Code::EditRefused, path + " is no file of this project"};
        const TextSplice splice = spliceBetween(*m_document->texts().text(path), *after);
        const auto begin = static_cast<std::uint32_t>(splice.at), end = begin + static_cast<std::uint32_t>(splice.removed.size());
        if (!splice.empty()) all.edits[file].push_back({{file, {begin, end}}, splice.inserted});
    }
    return all;
}

} // namespace trundle
