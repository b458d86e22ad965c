#include "editor/document/document_state.h"

#include <filesystem>

#include "project/journal/state_folder.h"
#include "project/loading/search.h"

namespace trundle {

bool DocumentState::isSample(const std::string& file) const {
    const std::string& folder = application.locations().configs;
    return !folder.empty() && canonicalPath(file).starts_with(canonicalPath(folder) + "/");
}

std::string DocumentState::shown(const std::string& file) const {
    if (isNew() && file == opened) return name;
    return loaded ? shownInProject(file, loaded->projectFolder) : file;
}

// Samples and new texts have their journals in the user's state folder, independent of the program folder and the working
// directory.
std::string DocumentState::journalFolder() const {
    if (!isOpen() || isNew()) return userStateFolder() + "/new";
    return isSample(opened) ? userStateFolder() + "/samples" : loaded->projectFolder;
}

Status DocumentState::report(Status status) {
    if (!status) Q_EMIT messages.refused(QString::fromStdString(status.error().message));
    return status;
}

void DocumentState::updateWatchedFiles() {
    std::vector<std::string> paths;
    for (const auto& [path, file] : files.all())
        if (!isNew() || path != opened) paths.push_back(path);
    for (const auto& [use, file] : loaded->named) {
        if (!file.path.empty()) paths.push_back(file.path);
        else if (use.first < loaded->paths.size()) // the first place where it is searched for
            paths.push_back((std::filesystem::path(loaded->paths[use.first]).parent_path() / use.second).string());
    }
    watch.watch(paths);
}

} // namespace trundle
