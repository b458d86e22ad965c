#include "editor/outline/object_edits.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/free_places.h"
#include "editor/outline/object_marks.h"
#include "editor/widgets/strings.h"
#include "lang/characters.h"
#include "model/dotted_path.h"
#include "project/edits/duplicate_offset.h"
#include "project/edits/insert_positions.h"
#include "project/edits/plan_dependents.h"

namespace trundle {
namespace {

/// The last component of a path: "hull" of "robot0.chassis.hull".
std::string lastName(const std::string& path) { return std::string(lastWord(path)); }

/// How the history names objects: "robot0", "3 objects".
QString named(const std::vector<std::string>& paths) {
    return paths.size() == 1 ? toQString(lastName(paths.front())) : ObjectEdits::tr("%1 objects").arg(paths.size());
}

/// How the history names pasted blocks: "Box box", "3 objects".
QString named(const Blocks& blocks) {
    if (blocks.kinds.size() != 1) return ObjectEdits::tr("%1 objects").arg(blocks.kinds.size());
    return toQString(blocks.names[0].empty() ? blocks.kinds[0] : blocks.kinds[0] + " " + blocks.names[0]);
}

/// The first five, and how many more: "Region goal, PoseLog way, 2 more".
QString someOf(const QStringList& names) {
    constexpr qsizetype kMaxNamed = 5;
    const QStringList shown = names.mid(0, kMaxNamed);
    return (names.size() > kMaxNamed ? shown + QStringList(ObjectEdits::tr("%1 more").arg(names.size() - kMaxNamed)) : shown)
        .join(QStringLiteral(", "));
}

std::string blankless(std::string text) {
    std::erase_if(text, [](char c) { return isBlank(c) || c == '\n' || c == '\r'; });
    return text;
}

/// Whether the project has the Param that a text like "Param side = 3" defines.
bool isParam(const LoadedProject& loaded, const std::string& text) {
    return std::ranges::any_of(loaded.outline->params,
                               [&](const SourceParam& p) { return text.starts_with("Param " + p.name->text + " "); });
}

using PathMapping = StructureEdits::PathMapping;

std::vector<std::string> renamedAll(std::vector<std::string> paths, const PathMapping& renamed) {
    for (std::string& path : paths) path = renamed(path);
    return paths;
}

/// Without "": the experiment itself is not a block.
std::vector<std::string> objectsOf(const std::vector<std::string>& paths) {
    std::vector<std::string> objects = paths;
    std::erase(objects, std::string());
    return objects;
}

} // namespace

ObjectEdits::ObjectEdits(Document& document, Selection& selection, const ObjectMarks& marks, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_marks(marks) {}

Status ObjectEdits::refuse(const QString& reason) {
    Q_EMIT m_document.refused(reason);
    return Error{Code::EditRefused, reason.toStdString()};
}

Status ObjectEdits::checkChangeable(const std::vector<std::string>& paths, const QString& verb) {
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    if (m_document.access().isReadOnly()) return m_document.edits().edit({}, {}); // reports who has the project
    if (paths.empty()) return refuse(tr("select an object to %1 first").arg(verb));
    for (const std::string& path : paths)
        if (m_marks.isLocked(path)) return refuse(tr("%1 is locked; unlock it to %2 it").arg(toQString(path), verb));
    return {};
}

bool ObjectEdits::canRename(const std::string& path) const {
    if (!m_document.isOpen() || path.empty()) return false;
    const auto place = placeOf(*m_document.loaded(), path);
    return place && place->part && !(place->member && place->within.empty());
}

QString ObjectEdits::nameProblem(const std::string& path, const std::string& name) const {
    if (!m_document.isOpen() || name.empty()) return {};
    const Result<EditPlan> plan = planRename(*m_document.loaded(), path, name);
    return plan ? QString() : toQString(plan.error().message);
}

Status ObjectEdits::rename(const std::string& path, const std::string& name) {
    if (Status may = checkChangeable({path}, tr("rename")); !may) return may;
    return m_document.structure().rename(tr("Rename %1 to %2").arg(toQString(lastName(path)), toQString(name)), path, name);
}

Status ObjectEdits::remove(const std::vector<std::string>& paths) {
    const std::vector<std::string> objects = objectsOf(paths);
    if (Status may = checkChangeable(objects, tr("delete")); !may) return may;
    return remove(tr("Delete %1").arg(named(objects)), objects);
}

Status ObjectEdits::remove(const QString& name, const std::vector<std::string>& objects) {
    return m_document.structure().apply(name, objects, [objects](const LoadedProject& loaded, const PathMapping& renamed) {
        return planRemove(loaded, renamedAll(objects, renamed));
    });
}

Status ObjectEdits::duplicate(const std::vector<std::string>& paths) {
    const std::vector<std::string> objects = objectsOf(paths);
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    if (objects.empty()) return refuse(tr("select an object to duplicate first"));
    const QString title = tr("Duplicate %1").arg(named(objects));
    return m_document.structure().apply(title, objects, [objects](const LoadedProject& loaded, const PathMapping& renamed) {
        const std::vector<std::string> paths = renamedAll(objects, renamed);
        return planDuplicate(loaded, paths, duplicateOffset(loaded, paths));
    });
}

Status ObjectEdits::copy(const std::vector<std::string>& paths) {
    const std::vector<std::string> objects = objectsOf(paths);
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    if (objects.empty()) return refuse(tr("select an object to copy first"));
    QGuiApplication::clipboard()->setMimeData(mimeOf(*m_document.loaded(), objects));
    return {};
}

Status ObjectEdits::cut(const std::vector<std::string>& paths) {
    const std::vector<std::string> objects = objectsOf(paths);
    if (Status may = checkChangeable(objects, tr("cut")); !may) return may;
    std::unique_ptr<QMimeData> mime(mimeOf(*m_document.loaded(), objects));
    const Status removed = remove(tr("Cut %1").arg(named(objects)), objects);
    if (removed) QGuiApplication::clipboard()->setMimeData(mime.release());
    return removed;
}

bool ObjectEdits::canPaste() const {
    const QMimeData* mime = QGuiApplication::clipboard()->mimeData();
    return m_document.isOpen() && mime && mime->hasText();
}

Result<Blocks> ObjectEdits::read(const QMimeData& mime) const {
    const std::string& folder = m_document.loaded()->projectFolder;
    return blocksIn(mime, [&](const std::string& file) {
        return m_document.texts().isSample(file) || (!folder.empty() && file.starts_with(folder + "/"));
    });
}

Status ObjectEdits::paste(const std::string& place) {
    const QMimeData* mime = QGuiApplication::clipboard()->mimeData();
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    if (!mime) return refuse(tr("there is no text to insert"));
    const Result<Blocks> blocks = read(*mime);
    if (!blocks) return refuse(toQString(blocks.error().message));
    return insert(blocks.value(), place, tr("Paste %1").arg(named(blocks.value())));
}

Status ObjectEdits::insert(const Blocks& blocks, const std::string& place, const QString& name, FileId file) {
    return insertBlocks(blocks, place, name, file, std::nullopt);
}

Status ObjectEdits::insertAtPoint(const Blocks& blocks, const std::string& place, const QString& name) {
    return insertBlocks(blocks, place, name, 0, insertionPoint());
}

Status ObjectEdits::insertBlocks(const Blocks& blocks, const std::string& place, const QString& name, FileId file,
                                 const std::optional<Vec3>& near) {
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    const LoadedProject& loaded = *m_document.loaded();
    std::string needed;
    const bool atHome = blocks.from == loaded.paths[0]; // pasted into the file it was copied from: current Params are used
    for (const std::string& param : blocks.params)
        if (!atHome || !isParam(loaded, param)) needed += param + "\n"; // planInsert() skips what exists
    std::ptrdiff_t count = 0;
    for (const NeededBlock& block : blocks.needs) {
        if (const auto there = placeOf(loaded, block.path); there && there->part) {
            if (atHome || blankless(textOf(loaded, {block.path})) == blankless(block.text)) continue;
            return refuse(
                tr("%1 differs here from the source; rename one of the two first").arg(toQString(there->part->title())));
        }
        needed += block.text + "\n";
        ++count;
    }
    const std::string inFile = file < loaded.paths.size() ? loaded.paths[file] : std::string();
    const auto plan = [=, text = needed + blocks.text, imports = blocks.imports](const LoadedProject& now,
                                                                                 const PathMapping& renamed) {
        const auto at = std::ranges::find(now.paths, inFile); // copying a config may have changed the file numbers
        const FileId to = at == now.paths.end() ? FileId{0} : static_cast<FileId>(at - now.paths.begin());
        Result<EditPlan> plan = planInsert(now, renamed(place), text, imports, to);
        if (!plan) return plan;
        std::vector<std::string>& selects = plan.value().selects; // select the requested blocks
        selects.erase(selects.begin(), selects.begin() + std::min(count, std::ptrdiff_t(selects.size())));
        return plan;
    };
    const QString title = name.isEmpty() ? tr("Add %1").arg(named(blocks)) : name;
    return insertFree(title, near,
                      [&](const std::string& key) { return m_document.structure().apply(title, {place}, plan, key); });
}

Status ObjectEdits::insertFree(const QString& name, const std::optional<Vec3>& near,
                               const std::function<Status(const std::string& mergeKey)>& insert) {
    const std::shared_ptr<const LoadedProject> before = m_document.loaded();
    const std::string key = "insert " + std::to_string(m_document.revision());
    const Status done = insert(key);
    if (done)
        if (const std::vector<ValueEdit> edits = freePlaces(*before, *m_document.loaded(), near); !edits.empty())
            (void)m_document.structure().setValues(name, edits, key);
    m_document.edits().endMerge();
    return done;
}

Status ObjectEdits::insertFrom(const QMimeData& mime, const std::string& place, FileId file) {
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    const Result<Blocks> blocks = read(mime);
    return blocks ? insert(blocks.value(), place, {}, file) : refuse(toQString(blocks.error().message));
}

Status ObjectEdits::insertKind(const Kind& kind, const std::string& place) {
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    const Kind* one[] = {&kind};
    const std::optional<std::string> parent = placeFor(*m_document.loaded(), place, one);
    if (!parent) return refuse(tr("%1 belongs in %2; select one first").arg(toQString(kind.name), toQString(placesOf(kind))));
    const auto plan = [place, name = kind.name](const LoadedProject& loaded, const PathMapping& renamed) -> Result<EditPlan> {
        const Kind* kind = loaded.registry->find(name);
        const Kind* one[] = {kind};
        const std::optional<std::string> parent = kind ? placeFor(loaded, renamed(place), one) : std::nullopt;
        if (!parent) return Error{Code::WrongPlace, name + " can no longer be inserted there"};
        const Result<Blocks> blocks = blocksFrom(templateOf(loaded, *kind, *parent));
        if (!blocks) return blocks.error();
        Result<EditPlan> plan = planInsert(loaded, renamed(place), blocks.value().text);
        if (!plan) return plan;
        // A joint may come with a body for its other end: select the requested block.
        std::vector<std::string>& selects = plan.value().selects;
        const std::vector<std::string>& kinds = blocks.value().kinds;
        for (std::size_t i = selects.size(); i-- > 0;)
            if (i < kinds.size() && kinds[i] != name) selects.erase(selects.begin() + std::ptrdiff_t(i));
        return plan;
    };
    const QString title = tr("Add %1").arg(toQString(kind.name));
    return insertFree(title, insertionPoint(),
                      [&](const std::string& key) { return m_document.structure().apply(title, {place}, plan, key); });
}

Status ObjectEdits::insertObject(const Kind& geom) {
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    const Result<Blocks> blocks = blocksFrom(objectTemplateOf(*m_document.loaded(), geom));
    if (!blocks) return refuse(toQString(blocks.error().message));
    Result<EditPlan> plan = planInsert(*m_document.loaded(), {}, blocks.value().text);
    if (plan) plan.value().selects.erase(plan.value().selects.begin(), plan.value().selects.end() - 1); // not the config
    const QString title = tr("Add %1 Object").arg(toQString(geom.name));
    return insertFree(title, insertionPoint(),
                      [&](const std::string& key) { return m_document.edits().apply(title, plan, key); });
}

Status ObjectEdits::move(const std::vector<std::string>& paths, const std::string& parent, const std::string& before,
                         FileId file) {
    const std::vector<std::string> objects = objectsOf(paths);
    if (Status may = checkChangeable(objects, tr("move")); !may) return may;
    const LoadedProject& loaded = *m_document.loaded();
    const bool stays = std::all_of(objects.begin(), objects.end(), [&](const std::string& path) {
        return parentOf(loaded, path) == parent && (file == kNoFile || blockOf(loaded, path).file == file);
    });
    const QString where = !parent.empty()   ? toQString(lastName(parent))
                          : file != kNoFile ? toQString(m_document.texts().shown(loaded.paths.at(file)))
                                            : tr("the top level");
    const QString title = stays ? tr("Reorder %1").arg(named(objects)) : tr("Move %1 to %2").arg(named(objects), where);
    std::vector<std::string> touched = objects;
    touched.push_back(parent);
    const std::string inFile = file == kNoFile ? std::string() : loaded.paths.at(file);
    return m_document.structure().apply(title, touched, [=](const LoadedProject& now, const PathMapping& renamed) {
        const auto at = std::ranges::find(now.paths, inFile);
        const FileId to = inFile.empty() || at == now.paths.end() ? kNoFile : static_cast<FileId>(at - now.paths.begin());
        return planMove(now, renamedAll(objects, renamed), renamed(parent), renamed(before), to);
    });
}

Status ObjectEdits::replaceBySingles(const std::string& path) {
    if (!m_document.isOpen()) return refuse(tr("nothing is open"));
    const auto place = placeOf(*m_document.loaded(), path);
    const std::string layout = place && place->instance ? place->instance->name : path;
    return m_document.edits().apply(tr("Replace %1 by single instances").arg(toQString(layout)),
                                    planReplaceBySingles(*m_document.loaded(), layout));
}

void ObjectEdits::removeSelected() {
    removeObjects(tr("delete"), tr("Delete"), tr("Delete All"), tr("deleted"), &ObjectEdits::remove);
}
void ObjectEdits::cutSelected() { removeObjects(tr("cut"), tr("Cut"), tr("Cut All"), tr("cut"), &ObjectEdits::cut); }

void ObjectEdits::removeObjects(const QString& verb, const QString& title, const QString& all, const QString& done,
                                Status (ObjectEdits::*take)(const std::vector<std::string>&)) {
    const std::vector<std::string> paths = objectsOf(m_selection.paths());
    if (!checkChangeable(paths, verb)) return;
    const Dependents users = dependentsOf(*m_document.loaded(), paths);
    if (users.removed.empty() && users.shortened.empty()) return (void)(this->*take)(paths);
    QStringList removed;
    for (const std::string& user : users.removed)
        if (const auto place = placeOf(*m_document.loaded(), user); place && place->part)
            removed.append(toQString(place->part->title()));
    QStringList shortened;
    for (const std::string& user : users.shortened) shortened.append(toQString(user));
    auto* question = new QMessageBox(
        QMessageBox::Question, title,
        (paths.size() == 1 ? tr("%1 is used by %2.") : tr("%1 are used by %2.")).arg(named(paths), someOf(removed + shortened)),
        QMessageBox::Cancel, QApplication::activeWindow());
    question->setObjectName(QStringLiteral("deleteQuestion"));
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setInformativeText(
        shortened.empty() ? tr("They can only be %1 together. Undo restores all of them.").arg(done)
        : removed.empty() ? tr("Others are named there too: these lists are only shortened. Undo restores them.")
                          : tr("Also %1: %2. Only shortened, since others are named there too: %3. Undo restores all of them.")
                                .arg(done, someOf(removed), someOf(shortened)));
    QPushButton* together = question->addButton(removed.empty() ? title : all, QMessageBox::AcceptRole);
    question->setDefaultButton(together);
    connect(together, &QPushButton::clicked, this, [this, paths, users, take] {
        std::vector<std::string> both = paths;
        both.insert(both.end(), users.removed.begin(), users.removed.end());
        (void)(this->*take)(both);
    });
    question->open();
}

void ObjectEdits::duplicateSelected() { (void)duplicate(m_selection.paths()); }
void ObjectEdits::copySelected() { (void)copy(m_selection.paths()); }

void ObjectEdits::pasteAtSelected() {
    std::string place = m_document.editedModel().insertionPlace(m_selection);
    const QMimeData* mime = QGuiApplication::clipboard()->mimeData();
    const Kind* kind = m_document.isOpen() ? kindAt(*m_document.loaded(), place) : nullptr;
    if (mime && kind && kind->role == Role::Repeat) // it may hold its like; what is pasted most likely is a copy of it
        if (const auto blocks = read(*mime); blocks && std::ranges::count(blocks.value().kinds, kind->name) > 0)
            place = parentOf(*m_document.loaded(), place);
    (void)paste(place);
}

} // namespace trundle
