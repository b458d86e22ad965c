#include "editor/document/found_journals.h"

#include "editor/document/document.h"
#include "editor/widgets/plain_text.h"
#include "project/journal/journal.h"
#include "project/journal/state_folder.h"

namespace trundle {

QString journalsNotRead(const Document& document) {
    if (!document.isOpen() || document.isNew() || document.texts().isSample(document.path())) return {};
    const std::string& project = document.loaded()->projectFolder;
    if (journalsInProject(project).empty()) return {};
    return Document::tr(
               "%1 holds journals of unsaved edits, which an earlier version of Trundle left there, or which came with this "
               "folder. They are not restored, since a journal of another user could change any file of yours. If they "
               "are your own, move them to %2 and open this file again; if not, delete them.")
        .arg(shownLine(project + "/.trundle/journal"), shownLine(projectStateFolder(project) + "/journal"));
}

} // namespace trundle
