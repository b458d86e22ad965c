#pragma once
// What Run would run: the document's experiment, or a preview of the edited model or of a text without instances.

#include <memory>
#include <string>
#include <vector>

#include <QObject>

#include "editor/document/document.h"
#include "editor/running/preview_scene.h"

namespace trundle {

class RunSource final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    RunSource(Document& document, Application& application, QObject* parent = nullptr);

    [[nodiscard]] Application& application() const { return m_application; }
    [[nodiscard]] bool isOpen() const { return m_document.isOpen(); }
    /// Why run() would be refused; empty if it would not.
    [[nodiscard]] QString refusal() const;
    /// The text is valid, but has no instances that could run.
    [[nodiscard]] bool describesOnly() const;
    /// The document's project; of an edited model, or if it has no instances, a PreviewScene. Null if nothing is open.
    [[nodiscard]] std::shared_ptr<const LoadedProject> project() const { return m_preview.show(m_document); }
    /// The experiment of project(); null if nothing is open.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> shown() const;
    /// The same for the newest text without errors; null if there was none.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> lastValid() const { return m_preview.lastValid(m_document); }
    /// PreviewScene::setRamp().
    void setRamp(double slope) { m_preview.setRamp(slope); }
    /// Loads the text again if a module has another description than it was checked with, or did not load: one that was rebuilt or
    /// corrected may accept other values.
    void readChangedModules();
    /// Python files with edits that are not on disk. A run executes what is on disk.
    [[nodiscard]] std::vector<std::string> unsavedModules() const;
    /// That modules in C++ of the project were built before a source of theirs was changed, here or on disk; empty: none was.
    [[nodiscard]] QString outdatedModules() const;

Q_SIGNALS:
    void changed(); ///< the document or the edited model changed: refusal() may differ

private:
    [[nodiscard]] QString nothingToRun() const;

    Document& m_document;
    Application& m_application;
    mutable PreviewScene m_preview; // caches its last result
};

} // namespace trundle
