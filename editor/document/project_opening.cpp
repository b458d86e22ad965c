#include "editor/document/project_opening.h"

#include <QFileInfo>
#include <QSet>

#include "editor/document/document_edits.h"
#include "editor/document/document_loading.h"
#include "editor/document/document_state.h"
#include "editor/document/document_texts.h"
#include "editor/document/project_access.h"
#include "editor/widgets/strings.h"
#include "project/journal/state_folder.h"
#include "project/loading/search.h"

namespace trundle {
namespace {

/// Whether a file is one of those that an experiment uses, and no experiment itself: a program, a mesh, a picture, a table. Other
/// suffixes than .sim are allowed.
bool isOfOtherFormat(const QString& path) {
    static const QSet<QString> suffixes{
        u"py"_qs,  u"c"_qs,   u"cc"_qs,  u"cpp"_qs,  u"cxx"_qs, u"h"_qs,   u"hh"_qs,  u"hpp"_qs,  u"so"_qs,   u"dylib"_qs,
        u"md"_qs,  u"csv"_qs, u"log"_qs, u"json"_qs, u"xml"_qs, u"zip"_qs, u"pdf"_qs, u"urdf"_qs, u"stl"_qs,  u"obj"_qs,
        u"ply"_qs, u"dae"_qs, u"glb"_qs, u"gltf"_qs, u"png"_qs, u"jpg"_qs, u"svg"_qs, u"mp4"_qs,  u"jpeg"_qs, u"webp"_qs};
    const QFileInfo file(path);
    return file.isFile() && suffixes.contains(file.suffix().toLower());
}

} // namespace

ProjectOpening::ProjectOpening(DocumentState& state, DocumentTexts& texts, DocumentLoading& loading, ProjectAccess& access,
                               DocumentEdits& edits)
    : m_state(state), m_texts(texts), m_loading(loading), m_access(access), m_edits(edits) {
    connect(&m_state.reader, &ProjectReader::aboutToOpen, this, &ProjectOpening::aboutToOpen);
}

Status ProjectOpening::open(const std::string& path) {
    OpenOptions options = m_state.options;
    options.shownFromProject = true;
    const std::string absolute = canonicalPath(path);
    Result<std::shared_ptr<const LoadedProject>> loaded = m_state.application.open(absolute, options);
    if (!loaded) return loaded.error();
    start(absolute, {}, std::move(loaded).value());
    return {};
}

void ProjectOpening::openLater(const std::string& path) {
    const std::string absolute = canonicalPath(path);
    if (const QString file = toQString(absolute); isOfOtherFormat(file)) {
        m_state.reader.cancel();
        const QString reason =
            tr("%1 is not an experiment, a robot or an arena: those are texts in files named *.sim or *.txt.").arg(file);
        QMetaObject::invokeMethod(
            this, [this, file, reason] { Q_EMIT failed(file, reason); }, Qt::QueuedConnection);
        return;
    }
    OpenOptions options = m_state.options;
    options.shownFromProject = true;
    m_state.reader.open(absolute, options, [this, absolute](const ProjectReader::Loaded& loaded) {
        if (loaded) start(absolute, {}, loaded.value());
        else Q_EMIT failed(QString::fromStdString(absolute), QString::fromStdString(loaded.error().message));
    });
}

bool ProjectOpening::isOpening() const { return m_state.reader.isOpening(); }

void ProjectOpening::cancel() {
    m_state.reader.cancel();
    Q_EMIT cancelled();
}

Status ProjectOpening::openNew(const std::string& name, const std::string& text) {
    if (name.empty() || name.find('/') != std::string::npos)
        return Error{Code::EditRefused, "a new text needs a plain file name"};
    const std::string path = canonicalPath(userStateFolder() + "/new/" + name);
    OpenOptions options = m_state.options;
    options.shownFromProject = true;
    options.texts.emplace(path, std::make_shared<const std::string>(text));
    Result<std::shared_ptr<const LoadedProject>> loaded = m_state.application.open(path, options);
    if (!loaded) return loaded.error();
    start(path, name, std::move(loaded).value());
    return {};
}

Status ProjectOpening::openMissing(const std::string& path, const std::string& text) {
    OpenOptions options = m_state.options;
    options.shownFromProject = true;
    options.texts.emplace(path, std::make_shared<const std::string>(text));
    Result<std::shared_ptr<const LoadedProject>> loaded = m_state.application.open(path, options);
    if (!loaded) return loaded.error();
    start(path, {}, std::move(loaded).value());
    m_state.files.find(path)->gone = true;
    return {};
}

void ProjectOpening::close() { start({}, {}, nullptr); }

void ProjectOpening::start(const std::string& path, const std::string& name, std::shared_ptr<const LoadedProject> loaded) {
    m_state.reader.cancel();
    m_state.journal.stop();
    m_state.opened = path;
    m_state.name = name;
    m_state.files.clear();
    m_state.history.clear();
    m_state.lastValid = nullptr;
    m_state.loaded = nullptr;
    ++m_state.revision;
    m_state.changes = ChangeSet(nullptr, loaded);
    if (loaded) m_loading.adopt(std::move(loaded));
    m_texts.forgetReport();
    if (m_state.isOpen()) m_state.journal.start(m_state.journalFolder(), {m_state.opened, m_state.name});
    m_access.lock();
    Q_EMIT opened();
    m_loading.notifyChanged();
    Q_EMIT m_edits.historyChanged();
    Q_EMIT m_texts.modifiedChanged();
}

} // namespace trundle
