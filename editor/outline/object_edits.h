#pragma once
// What can be done to objects, whoever asks for it: tree, menu, view or a key. Each call is one named edit of the document;
// what cannot be done is said through Document::refused, and nothing has changed.

#include <string>
#include <vector>

#include <QObject>

#include "base/result.h"
#include "project/plans.h"

class QMimeData;

namespace trundle {

class Document;
class ObjectMarks;
class Selection;
struct Blocks;

class ObjectEdits final : public QObject {
    Q_OBJECT
public:
    /// All outlive this. What `marks` locks is neither moved nor removed.
    ObjectEdits(Document& document, Selection& selection, const ObjectMarks& marks, QObject* parent = nullptr);

    /// Objects that have a name of their own to change.
    [[nodiscard]] bool canRename(const std::string& path) const;
    /// Why it cannot be called so; empty where it can.
    [[nodiscard]] QString nameRefusal(const std::string& path, const std::string& name) const;
    Status rename(const std::string& path, const std::string& name);

    Status remove(const std::vector<std::string>& paths);
    Status duplicate(const std::vector<std::string>& paths);
    Status copy(const std::vector<std::string>& paths);
    Status cut(const std::vector<std::string>& paths);
    /// Into `place`, or into the nearest block around it that takes them all.
    Status paste(const std::string& place);
    [[nodiscard]] bool canPaste() const; ///< there is a text on the clipboard; whether it holds blocks shows when it is pasted

    /// Within `parent` objects stay in their files, unless `file` is another one.
    Status move(const std::vector<std::string>& paths, const std::string& parent, const std::string& before,
                FileId file = kNoFile);
    /// A new block of a kind, in or around `place`.
    Status insertKind(const Kind& kind, const std::string& place);
    /// A movable object of one shape, see objectTemplateOf().
    Status insertObject(const Kind& geom);
    Status insert(const Blocks& blocks, const std::string& place, const QString& name = {}, FileId file = 0);
    Status insertFrom(const QMimeData& mime, const std::string& place, FileId file = 0); ///< what a drop brings
    Status replaceBySingles(const std::string& path);

    // The same for what is selected.
    void removeSelected(); ///< asks where something else refers to it and would have to go along
    void cutSelected();    ///< so does this one
    void duplicateSelected();
    void copySelected();
    void pasteAtSelected();

private:
    [[nodiscard]] Result<Blocks> read(const QMimeData& mime) const;
    [[nodiscard]] Status mayChange(const std::vector<std::string>& paths, const QString& deed);
    Status refuse(const QString& reason);
    Status remove(const QString& name, const std::vector<std::string>& objects);
    /// Takes away what is selected, and asks before what refers to it goes along.
    void takeAway(const QString& deed, const QString& title, const QString& all, const QString& done,
                  Status (ObjectEdits::*take)(const std::vector<std::string>&));

    Document& m_document;
    Selection& m_selection;
    const ObjectMarks& m_marks;
};

} // namespace trundle
