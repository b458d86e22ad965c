#pragma once
// Operations on objects for all callers: outline, menus, viewport and shortcuts. Each call is one named edit of the document; a
// failure is reported by Document::refused() and changes nothing.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include <trundle/geometry.h>

#include "base/result.h"
#include "project/edits/plans.h"

class QMimeData;

namespace trundle {

class Document;
class ObjectMarks;
class Selection;
struct Blocks;

class ObjectEdits final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object. Objects locked in `marks` are neither moved nor removed.
    ObjectEdits(Document& document, Selection& selection, const ObjectMarks& marks, QObject* parent = nullptr);

    /// Whether the object has its own name that can be changed.
    [[nodiscard]] bool canRename(const std::string& path) const;
    /// Why the object cannot have this name; empty if it can.
    [[nodiscard]] QString nameProblem(const std::string& path, const std::string& name) const;
    Status rename(const std::string& path, const std::string& name);

    Status remove(const std::vector<std::string>& paths);
    Status duplicate(const std::vector<std::string>& paths);
    Status copy(const std::vector<std::string>& paths);
    Status cut(const std::vector<std::string>& paths);
    /// Pastes into `place`, or into its nearest enclosing block that can contain all pasted blocks.
    Status paste(const std::string& place);
    [[nodiscard]] bool canPaste() const; ///< the clipboard has text; whether it contains blocks is checked on paste

    /// Objects moved within `parent` stay in their files unless `file` is another one.
    Status move(const std::vector<std::string>& paths, const std::string& parent, const std::string& before,
                FileId file = kNoFile);
    // New robots and statics, also those of a Repeat, that would stand inside something move to the nearest free place on the
    // floor, in the same edit. Those inserted without a position of their own are put near the insertion point.
    using InsertionPoint = std::function<std::optional<Vec3>()>; ///< in W
    void setInsertionPoint(InsertionPoint point) { m_insertionPoint = std::move(point); }
    /// Inserts a new block of a kind in or around `place`.
    Status insertKind(const Kind& kind, const std::string& place);
    /// Inserts a movable object of one shape, see objectTemplateOf().
    Status insertObject(const Kind& geom);
    Status insert(const Blocks& blocks, const std::string& place, const QString& name = {}, FileId file = 0);
    Status insertAtPoint(const Blocks& blocks, const std::string& place, const QString& name);
    Status insertFrom(const QMimeData& mime, const std::string& place, FileId file = 0); ///< inserts a drop
    Status replaceBySingles(const std::string& path);

    // The same for the selected objects.
    void removeSelected(); ///< asks first if other blocks refer to them and would be removed or changed too
    void cutSelected();    ///< also asks
    void duplicateSelected();
    void copySelected();
    void pasteAtSelected(); ///< a Repeat or Ring beside a selected one

private:
    [[nodiscard]] Result<Blocks> read(const QMimeData& mime) const;
    [[nodiscard]] Status checkChangeable(const std::vector<std::string>& paths, const QString& verb);
    Status refuse(const QString& reason);
    [[nodiscard]] std::optional<Vec3> insertionPoint() const { return m_insertionPoint ? m_insertionPoint() : std::nullopt; }
    Status insertBlocks(const Blocks& blocks, const std::string& place, const QString& name, FileId file,
                        const std::optional<Vec3>& near);
    /// Runs `insert`, then moves what it has inserted to a free place.
    Status insertFree(const QString& name, const std::optional<Vec3>& near,
                      const std::function<Status(const std::string& mergeKey)>& insert);
    Status remove(const QString& name, const std::vector<std::string>& objects);
    /// Removes the selected objects; asks first if blocks that refer to them would be removed or changed too.
    void removeObjects(const QString& verb, const QString& title, const QString& all, const QString& done,
                       Status (ObjectEdits::*take)(const std::vector<std::string>&));

    Document& m_document;
    Selection& m_selection;
    const ObjectMarks& m_marks;
    InsertionPoint m_insertionPoint;
};

} // namespace trundle
