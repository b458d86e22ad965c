#pragma once
// The document of the window: one experiment (or robot, or arena) and every file that it imports, as texts. Texts change only
// here: every panel edits through edit() or one of the functions that call it.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/application.h"
#include "base/result.h"
#include "base/text_edit.h"
#include "editor/document/history.h"
#include "project/edits/change_set.h"
#include "project/edits/plans.h"
#include "project/edits/value_edits.h"
#include "project/journal/journal.h"
#include "project/loading/project.h"
#include "project/saving/companions.h"

namespace trundle {

struct DocumentState;
struct SaveEnvironment;
struct SavePlan;
class StructureEdits;

class Document final : public QObject {
    Q_OBJECT
public:
    explicit Document(Application& application, QObject* parent = nullptr);
    ~Document() override;

    /// Replaces the open project and clears its history; the caller has asked about unsaved edits. Fails and changes nothing
    /// if the file cannot be read. A text with errors opens.
    [[nodiscard]] Status open(const std::string& path);
    /// Like open(), but reads in a worker thread; opened() or openFailed() follows. Edits are refused until then. A later
    /// open, new or close replaces this request.
    void openLater(const std::string& path);
    [[nodiscard]] bool isOpening() const;
    void cancelOpening(); ///< the current project stays open
    /// Opens a new, unsaved text, shown as `name`. It counts as modified once it differs from `text`.
    [[nodiscard]] Status openNew(const std::string& name, const std::string& text);
    void close();
    [[nodiscard]] bool isOpen() const { return m_loaded != nullptr; }

    /// Sets the trusted modules and the search folders for imports, also for later projects. Reloads the open project.
    void setOptions(const OpenOptions& options);
    [[nodiscard]] const OpenOptions& options() const { return m_options; }
    /// Reloads the same texts, for example after a module or a mesh changed on disk.
    void readAgain();

    /// The project as loaded from the current texts; never null while open. Immutable: callers may keep it.
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& loaded() const { return m_loaded; }
    /// The newest version of the experiment without errors; null if there was none.
    [[nodiscard]] const std::shared_ptr<const LoadedProject>& lastValid() const { return m_lastValid; }
    [[nodiscard]] std::uint64_t revision() const { return m_revision; } ///< increases with every change of any text

    [[nodiscard]] std::string path() const; ///< absolute path of the opened file; a name while it is new; "" if nothing is open
    [[nodiscard]] bool isNew() const;       ///< not saved to a file yet
    /// Absolute paths of the project's files in the order of FileId; the first is the opened one.
    [[nodiscard]] std::vector<std::string> files() const;
    [[nodiscard]] std::shared_ptr<const std::string> text(const std::string& file) const; ///< null if it is not of this project
    [[nodiscard]] bool isRemoved(const std::string& file) const; ///< an edit created it and was undone: the next save removes it
    [[nodiscard]] Status addText(const std::string& file);       ///< adds a file of the project's folder that nothing imports
    /// Loads another file of the project with the current texts.
    [[nodiscard]] Result<std::shared_ptr<const LoadedProject>> loadedFrom(const std::string& file) const;
    /// Path for display, relative to the project's folder.
    [[nodiscard]] std::string shown(const std::string& file) const;
    /// Whether the file was installed with Trundle. Such a file can be edited here, but only saveAs() writes it.
    [[nodiscard]] bool isSample(const std::string& file) const;

    // --- edits: each adds one entry to the history, or extends the last one if that has the same merge key ---
    /// Returns why the changes are rejected; empty if they are accepted.
    using Validator = std::function<std::string(const ChangeSet& changes)>;
    /// Changes texts. Fails, emits refused() and changes nothing if the edits do not apply, change an imported sample file, or are
    /// rejected.
    Status edit(const QString& name, const FileEdits& edits, const std::string& mergeKey = {}, const Validator& validate = {});
    /// Replaces the whole text of a file, or of several files as one entry, including files added by addText().
    Status replaceText(const QString& name, const std::string& file, std::string bytes, const std::string& mergeKey = {});
    Status replaceTexts(const QString& name, const FileTexts& texts, const std::vector<std::string>& selects = {});
    /// Applies a plan and selects the blocks that it created.
    Status apply(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey = {});
    /// Sets values at the paths that StructureEdits::pathsForValues() returns; refused as a whole if one is invalid.
    Status setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey = {});
    /// Edits that insert, remove, move or rename blocks; also decides in which block a value is written.
    [[nodiscard]] StructureEdits& structure();
    /// Loads the project with these texts in place of the current ones. The document does not change.
    [[nodiscard]] Result<std::shared_ptr<const LoadedProject>> loadedWith(const FileTexts& texts) const;
    void endMerge(); ///< ends a drag: the next edit gets its own entry whatever its merge key
    /// Discards the edits made under this key since the last entry with another key, and restores what could be redone before
    /// them. Does nothing after endMerge().
    void discardMerge(const std::string& mergeKey);

    [[nodiscard]] const History& history() const { return m_history; }
    void undo();
    void redo();
    void moveTo(std::size_t position); ///< position in the history

    // --- files ---
    [[nodiscard]] bool isModified() const; ///< whether any file differs from the disk
    [[nodiscard]] bool isModified(const std::string& file) const;
    [[nodiscard]] std::vector<std::string> modifiedFiles() const; ///< absolute, the opened one first
    /// Writes every modified file atomically, or none if one of them cannot be written. The error gives the file and the
    /// reason: a sample, a read-only file, or a file whose content on disk was not loaded here.
    [[nodiscard]] Status save();
    /// Writes the opened file to another path and continues with it there; the history is kept. Imported files that would not
    /// be found from the new location, and edited samples, are written next to it, where its imports find them; meshes,
    /// images and modules are copied likewise. notice() lists them. Fails, having written nothing, if one of those files
    /// would overwrite another. For the current path it equals save(), except that edited samples are copied.
    [[nodiscard]] Status saveAs(const std::string& path, ModuleCopies modules = ModuleCopies::Make);
    [[nodiscard]] Result<Companions> companionsAt(const std::string& path) const; ///< what saveAs() would copy

    /// Checks whether another program changed one of the files. Also called when the file watcher reports a change.
    void checkExternalChanges();
    enum class Resolution { Mine, Theirs };
    /// Content on disk of the files that were edited both here and by another program and cannot be merged.
    [[nodiscard]] FileTexts diskChanges() const;
    /// Mine: the text stays, and the next save writes it. Theirs: the content on disk replaces it, as one history entry.
    Status resolveDiskChange(const std::string& file, Resolution resolution);

    // --- one window per project; recovery after a crash ---
    /// Another window has the project open: edits are refused until editAnyway().
    [[nodiscard]] bool isReadOnly() const;
    void editAnyway();
    /// Fails with the reason if nothing can be edited now. Tries again to lock a project that another window had open.
    [[nodiscard]] Status checkEditable();
    /// Journals of the open project, or of new texts if nothing is open, with edits that are not on disk; newest first.
    [[nodiscard]] std::vector<Recovery> recoveries() const;
    /// Whether recover() would close the project that is open now.
    [[nodiscard]] bool isReplacedBy(const Recovery& recovery) const;
    /// The text that recover() would restore for a file, given its current content on disk.
    [[nodiscard]] static std::string recoveredText(const std::string& path, const RecoveredText& kept);
    /// Opens the project of a journal and restores its texts as one history entry, except of files outside foldersOf().
    Status recover(const Recovery& recovery);
    [[nodiscard]] std::vector<std::string> foldersOf(const std::string& project) const; ///< whose files may be written

Q_SIGNALS:
    void aboutToOpen(); ///< the file is read; opened() follows in a separate event, so that neither handler delays the other
    void openingCancelled();
    void opened(); ///< another project, or none; changed() follows
    void openFailed(const QString& path, const QString& reason);
    /// loaded() returns another object. If a slot edits, all slots get the later changes first and these after them: then
    /// changes.after() is not loaded() any more.
    void changed(const ChangeSet& changes);
    void historyChanged();
    void modifiedChanged();
    void selectionRequested(const std::vector<std::string>& paths); ///< an edit created or renamed these
    void refused(const QString& reason);                            ///< an edit was refused
    void notice(const QString& text);                               ///< information for the user; no decision is needed
    void diskChanged(const QString& file);       ///< diskChanges() has one more; it is not saved until resolveDiskChange()
    void readOnlyChanged(const QString& holder); ///< describes the window that has the project; empty: editable

private:
    [[nodiscard]] OpenOptions optionsNow() const;
    void start(const std::string& path, const std::string& name, std::shared_ptr<const LoadedProject> loaded);
    void adopt(std::shared_ptr<const LoadedProject> loaded);
    void readNamed();
    [[nodiscard]] bool isNamedStale() const;
    /// Replaces texts and reloads. On failure nothing changes.
    [[nodiscard]] Status put(const FileTexts& texts, const Validator& validate = {});
    /// Like put(), and adds an entry to the history.
    [[nodiscard]] Status enter(const QString& name, FileTexts after, const std::string& mergeKey, const Validator& validate = {});
    [[nodiscard]] Result<FileTexts> textsAfter(const FileEdits& edits) const;
    [[nodiscard]] Status mayChange(const FileEdits& edits) const; ///< fails if one edit changes an imported sample file
    Status reportFailure(Status status);                          ///< emits refused() if the status is a failure
    void notifyEdited();
    void notifyChanged();
    void notifyModified();

    [[nodiscard]] std::vector<std::string> modifiedSamples() const;
    [[nodiscard]] Status checkSaveTarget(const std::string& target) const;
    [[nodiscard]] Result<SavePlan> planFor(const std::string& target, ModuleCopies modules) const;
    [[nodiscard]] SaveEnvironment saveEnvironment();
    [[nodiscard]] Status followMoves(const SavePlan& plan); ///< continues with the files at their new paths
    /// Handles a changed file: loads it if it was not edited here, merges if possible, else emits diskChanged().
    void applyExternalChange(const std::string& path, std::shared_ptr<const std::string> bytes);
    void notifyMoved(const SavePlan& save);
    void lock();
    void requestProject(); ///< tries again to lock a project that another window had open
    [[nodiscard]] std::string readOnlyMessage() const;
    [[nodiscard]] Status openFor(const Recovery& recovery);
    void updateWatchedFiles();
    [[nodiscard]] std::string journalFolder() const;

    Application& m_application;
    OpenOptions m_options;
    std::unique_ptr<DocumentState> m_state;
    std::shared_ptr<const LoadedProject> m_loaded, m_lastValid;
    ChangeSet m_changes; // of the last load
    History m_history;
    std::uint64_t m_revision = 0;
};

} // namespace trundle
