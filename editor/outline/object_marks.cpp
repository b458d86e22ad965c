#include "editor/outline/object_marks.h"

#include "model/dotted_path.h"

namespace trundle {
namespace {

bool set(ObjectMarks::Paths& marks, const std::vector<std::string>& paths, bool on) {
    bool changed = false;
    for (const std::string& path : paths) changed |= on ? marks.insert(path).second : marks.erase(path) > 0;
    return changed;
}

bool renamed(ObjectMarks::Paths& marks, const std::string& from, const std::string& to) {
    ObjectMarks::Paths kept;
    bool changed = false;
    for (const std::string& path : marks) {
        const bool goes = startsWithPath(path, from);
        kept.insert(goes ? to + path.substr(from.size()) : path);
        changed |= goes;
    }
    if (changed) marks = std::move(kept);
    return changed;
}

} // namespace

bool ObjectMarks::holds(const Paths& marks, std::string_view path) {
    if (marks.empty() || path.empty()) return false;
    for (std::size_t end = path.size(); end != std::string_view::npos; end = path.rfind('.', end - 1)) {
        if (marks.contains(path.substr(0, end))) return true;
        if (end == 0) break;
    }
    return false;
}

void ObjectMarks::setHidden(const std::vector<std::string>& paths, bool hidden) {
    if (set(m_hidden, paths, hidden)) Q_EMIT hiddenChanged();
}

void ObjectMarks::setLocked(const std::vector<std::string>& paths, bool locked) {
    if (set(m_locked, paths, locked)) Q_EMIT lockedChanged();
}

void ObjectMarks::showAll() {
    if (m_hidden.empty()) return;
    m_hidden.clear();
    Q_EMIT hiddenChanged();
}

void ObjectMarks::rename(const std::string& from, const std::string& to) {
    if (renamed(m_hidden, from, to)) Q_EMIT hiddenChanged();
    if (renamed(m_locked, from, to)) Q_EMIT lockedChanged();
}

void ObjectMarks::clear() {
    showAll();
    if (m_locked.empty()) return;
    m_locked.clear();
    Q_EMIT lockedChanged();
}

} // namespace trundle
