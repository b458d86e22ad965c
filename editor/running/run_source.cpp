#include "editor/running/run_source.h"

#include <QDateTime>
#include <QFileInfo>

#include "app/module_build.h"
#include "control/module_store.h"
#include "control/python_kinds.h"
#include "editor/running/module_list.h"
#include "editor/running/python_watch.h"
#include "editor/widgets/name_list.h"
#include "project/loading/modules.h"
#include "project/objects/unplaced_configs.h"

namespace trundle {
namespace {

constexpr qsizetype kMostSources = 3;

} // namespace

RunSource::RunSource(Document& document, Application& application, QObject* parent)
    : QObject(parent), m_document(document), m_application(application), m_preview(application) {
    connect(&document, &Document::changed, this, &RunSource::changed);
    connect(&document.editedModel(), &EditedModel::changed, this, &RunSource::changed);
    connect(new PythonWatch(document, application, this), &PythonWatch::changed, this, &RunSource::readChangedModules);
}

std::shared_ptr<const ExperimentSpec> RunSource::shown() const {
    const std::shared_ptr<const LoadedProject> loaded = project();
    return loaded ? loaded->experiment : nullptr;
}

/// An arena alone has nothing that moves.
QString RunSource::nothingToRun() const {
    if (const Part* model = m_document.editedModel().config())
        return model->kind->name == "RobotConfig"
                   ? QString()
                   : tr("There is nothing to run: %1 has nothing that moves. Done, above the 3D view, shows the experiment.")
                         .arg(QString::fromStdString(model->name));
    QStringList names;
    for (const Part* config : configsWithoutInstances(*m_document.loaded())) {
        if (config->kind && config->kind->name == "RobotConfig") return {}; // the preview runs it on a floor
        names.append(QString::fromStdString(config->name));
    }
    if (names.isEmpty()) return {};
    const QString why = tr("There is nothing to run: this file describes %1 and places nothing. To run it, import the file in an "
                           "experiment and drag it in from the Library.")
                            .arg(names.join(QStringLiteral(", ")));
    return m_document.texts().isSample(m_document.path()) ? why + tr(" Its card on the Welcome page does that.") : why;
}

QString RunSource::refusal() const {
    const std::shared_ptr<const LoadedProject>& loaded = m_document.loaded();
    if (!loaded) return tr("Nothing is open.");
    std::size_t errors = 0;
    const Diagnostic *error = nullptr, *module = nullptr; // the first of each
    for (const Diagnostic& d : loaded->diagnostics.all()) {
        if (isUnavailableModule(d.code) && !module) module = &d;
        if (d.severity != Severity::Error) continue;
        ++errors;
        if (!error) error = &d;
    }
    if (module && module->code == Code::ModuleNotTrusted) { // its message advises options of the command line
        for (const ModuleInfo& info : modulesOf(*loaded, m_document.options(), m_application.locations()))
            if (!info.trusted)
                return tr("the module %1 is %2, in a folder that is not trusted. To run it, trust the folder in the Controllers "
                          "panel.")
                    .arg(QString::fromStdString(info.written), QString::fromStdString(info.library));
    }
    if (error) {
        const QString why = QString::fromStdString(error->message);
        return errors == 1 ? tr("The text has an error: %1").arg(why)
                           : tr("The text has %1 errors, the first: %2").arg(errors).arg(why);
    }
    return module ? QString::fromStdString(module->message) + u'.' : nothingToRun();
}

bool RunSource::describesOnly() const {
    const QString why = refusal();
    return !why.isEmpty() && m_document.loaded() && why == nothingToRun();
}

void RunSource::readChangedModules() {
    if (const auto& loaded = m_document.loaded(); loaded && descriptionChanged(*loaded->experiment, *loaded->registry))
        m_document.loading().readAgain();
}

/// Not those that are to be created or were deleted: only Save makes a file.
std::vector<std::string> RunSource::unsavedModules() const {
    std::vector<std::string> files = m_document.texts().modifiedFiles();
    std::erase_if(files, [this](const std::string& file) {
        return !isPythonModule(file) || m_document.texts().isRemoved(file) || !QFileInfo::exists(QString::fromStdString(file));
    });
    return files;
}

QString RunSource::outdatedModules() const {
    const LoadedProject& loaded = *m_document.loaded();
    QStringList sources;
    for (const ModuleSpec& module : loaded.experiment->modules) {
        if (module.library.empty() || isPythonModule(module.library)) continue;
        const QDateTime built = QFileInfo(QString::fromStdString(module.library)).lastModified();
        for (const std::string& source : sourcesOfModule(module.library, loaded.projectFolder))
            if (m_document.texts().isModified(source) || QFileInfo(QString::fromStdString(source)).lastModified() > built)
                sources += QString::fromStdString(m_document.texts().shown(source));
    }
    if (sources.empty()) return {};
    return tr("Runs a module that was built before %1 was changed; Ctrl+B builds it").arg(listed(sources, kMostSources));
}

} // namespace trundle
