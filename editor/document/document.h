#pragma once
// What the window has open: one experiment (or robot, or arena) and every file it imports, as texts. The only place that
// changes a text: every part of the window edits through edit() or one of the calls that end in it.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "base/result.h"
#include "base/text_edit.h"
#include "editor/document/companions.h"
#include "editor/document/history.h"
#include "parts/parts.h"
#include "project/journal.h"
#include "project/plans.h"
#include "project/project.h"

namespace trundle {

struct SavePlan;
class StructureEdits;

/// A value to set: dotted path of the property ("robot0.leftMotor.Resistance", "Tick") and its new text ("3", "12 cm").
struct ValueEdit {
    std::string path, text;
};

class Document final : public QObject {
    Q_OBJECT
public:
    explicit Document(Parts& parts, QObject* parent = nullptr);
    ~Document() override;

    /// Replaces what is open, and forgets its edits: who calls has asked. Fails, and leaves all as it was, where the file cannot be read. A text with errors opens.
    [[nodiscard]] Status open(const std::string& path);
    /// The same in a thread, then opened() or openFailed(); until then edits are refused. A later open, new or close takes its place.
    void openLater(const std::string& path);
    [[nodiscard]] bool isOpening() const { return !m_opening.empty(); }
    void cancelOpening(); ///< what is open stays so
    /// A new text that no file holds yet, shown under `name`. It counts as modified once it differs from `text`.
    [[nodiscard]] Status openNew(const std::string& name, const std::string& text);
    void close();
    [[nodiscard]] bool isOpen() const { return m_loaded != nullptr; }

    /// Which modules are trusted and where imports are looked for, in this project and the next ones. Reads again what is open.
    void setOptions(const OpenOptions& options);
    [[nodiscard]] const OpenOptions& options() const { return m_options; }
    /// Means the same texts anew: a module or a mesh on the disk is another one.
    void readAgain();

    /// What the texts mean now; never null while open. Immutable: keep it as long as needed.
    [[nodiscard]] const std::shared_ptr<const Loaded>& loaded() const { return m_loaded; }
    /// The newest version of the experiment that had no errors; null before there was one.
    [[nodiscard]] const std::shared_ptr<const Loaded>& lastGood() const { return m_lastGood; }
    [[nodiscard]] std::uint64_t revision() const { return m_revision; } ///< goes up with every change of any text

    [[nodiscard]] std::string path() const; ///< absolute, of the opened file; a name while it is new; "" where nothing is open
    [[nodiscard]] bool isNew() const;       ///< no file holds it yet
    /// Files of the project in order of FileId, absolute; the first is the opened one.
    [[nodiscard]] std::vector<std::string> files() const;
    /// Null for a file that is not of this project.
    [[nodiscard]] std::shared_ptr<const std::string> text(const std::string& file) const;
    [[nodiscard]] Status addText(const std::string& file); ///< takes in one of the project's folder that nothing imports
    [[nodiscard]] Result<std::shared_ptr<const Loaded>> loadedFrom(const std::string& file) const; ///< another text, with these
    /// As people know it: relative to the project's folder.
    [[nodiscard]] std::string shown(const std::string& file) const;
    /// One of those that came with the program. It can be edited here, and is kept by saveAs() only.
    [[nodiscard]] bool isSample(const std::string& file) const;

    // --- edits: each is one entry of the history, or joins the last one under the same merge key ---

    /// Changes texts. Fails, says refused() and changes nothing where the edits do not fit, or one is of an imported file of the program.
    Status edit(const QString& name, const FileEdits& edits, const std::string& mergeKey = {});
    /// Puts whole texts in place of a file's, or of several as one entry, addText() included; the text editor's way in.
    Status replaceText(const QString& name, const std::string& file, std::string bytes, const std::string& mergeKey = {});
    Status replaceTexts(const QString& name, const FileTexts& texts, const std::vector<std::string>& selects = {});
    /// Carries out a plan, and selects what it made.
    Status carryOut(const QString& name, const Result<EditPlan>& plan, const std::string& mergeKey = {});
    /// Sets values, all or none, where StructureEdits says. One that does not fit is refused with the reason, and the texts stay.
    Status setValues(const QString& name, const std::vector<ValueEdit>& values, const std::string& mergeKey = {});
    /// Edits that insert, remove, move or rename blocks, and where values go.
    [[nodiscard]] StructureEdits& structure() const;
    /// What the texts would mean with these in their place. Nothing is changed.
    [[nodiscard]] Result<std::shared_ptr<const Loaded>> loadedWith(const FileTexts& texts) const;
    void endMerge(); ///< ends a drag: the next edit is an entry of its own whatever its merge key
    /// Takes back what was edited under this key since the last entry of another one, as if it had never been: no entry is left, and
    /// what could be redone before can be redone again. Does nothing after endMerge().
    void withdraw(const std::string& mergeKey);

    [[nodiscard]] const History& history() const { return m_history; }
    void undo();
    void redo();
    void moveTo(std::size_t position); ///< of the history

    // --- files ---
    [[nodiscard]] bool isModified() const; ///< some file's bytes differ from the disk's
    [[nodiscard]] bool isModified(const std::string& file) const;
    [[nodiscard]] std::vector<std::string> modifiedFiles() const; ///< absolute, the opened one first
    /// Every modified file, each atomically; none where one of them cannot be. Says which and why: a sample, one that may not be
    /// written, one whose bytes on the disk have not been seen here.
    [[nodiscard]] Status save();
    /// Writes the opened file to another path and goes on with it there; the history stays. Imported files that would not be found
    /// from there, and samples that were edited, are written beside it, where its imports find them, and so are copies of meshes,
    /// pictures and modules; notice() says which. Fails, having written nothing, where one of those would take the place of another.
    /// Under its own path it is save(), but for the samples.
    [[nodiscard]] Status saveAs(const std::string& path, ModuleCopies modules = ModuleCopies::Make);
    [[nodiscard]] Result<Companions> companionsAt(const std::string& path) const; ///< what saveAs() would copy

    /// Looks whether another program wrote one of the files. Called by itself when the system tells of it.
    void lookAtDisk();
    enum class Keep { Mine, Theirs };
    /// Files that another program wrote over edits made here, where the two cannot be merged, and what it wrote.
    [[nodiscard]] FileTexts diskChanges() const;
    /// Mine: the text stays, and the next save writes it. Theirs: the disk's bytes take its place, as one entry of the history.
    Status resolveDiskChange(const std::string& file, Keep keep);

    // --- one window for each project, and what a window that ended badly left ---

    /// Another window has the project: edits are refused until editAnyway().
    [[nodiscard]] bool isReadOnly() const;
    void editAnyway();
    /// Asks once more for a project that another window had. Called by itself before an edit and by lookAtDisk().
    void askForProject();
    /// Journals of the open project, or of new texts where nothing is open, that hold something the disk does not; newest first.
    [[nodiscard]] std::vector<Recovery> recoveries() const;
    /// Whether that would take the place of what is open.
    [[nodiscard]] bool isReplacedBy(const Recovery& recovery) const;
    /// What recover() makes of a file as the disk has it now.
    [[nodiscard]] static std::string recoveredText(const std::string& path, const RecoveredText& kept);
    /// Puts a journal's texts in place as one entry of the history, opening what it had open; but no file outside foldersOf().
    Status recover(const Recovery& recovery);
    [[nodiscard]] std::vector<std::string> foldersOf(const std::string& project) const; ///< whose files may be written

Q_SIGNALS:
    void aboutToOpen(); ///< it is read; opened() follows in an event of its own, so that neither makes the other wait
    void openingCancelled();
    void opened(); ///< another project, or none; changed() follows
    void openFailed(const QString& path, const QString& reason);
    void changed(); ///< loaded() is another one
    void historyChanged();
    void modifiedChanged();
    void selectionWanted(const std::vector<std::string>& paths); ///< an edit made or renamed these
    void refused(const QString& reason);                         ///< an edit was not done
    void notice(const QString& text);                            ///< something a person should know, and nothing to decide
    /// Another program wrote a file that has edits here, and both cannot be had. Until resolveDiskChange() it is not saved.
    void diskChanged(const QString& file);
    void readOnlyChanged(const QString& holder); ///< who has the project; empty: it can be edited

private:
    struct State;

    [[nodiscard]] OpenOptions optionsNow() const;
    void start(const std::string& path, const std::string& name, std::shared_ptr<const Loaded> loaded);
    void adopt(std::shared_ptr<const Loaded> loaded);
    void readNamed();
    [[nodiscard]] bool isNamedStale() const;
    /// Says why texts cannot be taken that have been read; empty where they can.
    using Judge = std::function<std::string(const Loaded& loaded)>;
    /// Puts texts in place and reads them. On failure all is as before.
    [[nodiscard]] Status put(const FileTexts& texts, const Judge& judge = {});
    /// put() as an entry of the history.
    [[nodiscard]] Status enter(const QString& name, FileTexts after, const std::string& mergeKey, const Judge& judge = {});
    [[nodiscard]] Result<FileTexts> textsAfter(const FileEdits& edits) const;
    [[nodiscard]] Status enterSets(const QString& name, const std::vector<std::string>& sets, const std::string& mergeKey);
    [[nodiscard]] Status mayEdit();
    [[nodiscard]] Status mayChange(const FileEdits& edits) const; ///< none of them is of an imported file that came with the program
    Status answer(Status status); ///< says refused() where it failed
    void sayEdited();
    void sayModified();

    /// Whether every one of these can be written where it is; what another program wrote is taken in.
    [[nodiscard]] Status mayWrite(const std::vector<std::string>& files);
    [[nodiscard]] std::vector<std::string> modifiedSamples() const;
    [[nodiscard]] Status mayBecome(const std::string& target) const;
    [[nodiscard]] Result<SavePlan> planFor(const std::string& target, ModuleCopies modules) const;
    void moveFile(const std::string& from, const std::string& to);
    /// Takes in what the disk holds: at once where nothing was edited here, merged where that goes, else diskChanged().
    void noteDisk(const std::string& path, std::shared_ptr<const std::string> bytes);
    void sayMoved(const SavePlan& save);
    void lock();
    [[nodiscard]] std::string readOnlyReason() const;
    [[nodiscard]] Status openFor(const Recovery& recovery);
    void sayWatched();
    [[nodiscard]] std::string workPlace() const;

    Parts& m_parts;
    OpenOptions m_options;
    std::unique_ptr<State> m_state;
    std::shared_ptr<const Loaded> m_loaded, m_lastGood;
    History m_history;
    std::uint64_t m_revision = 0;
    std::string m_opening; // path that a thread reads
};

} // namespace trundle
