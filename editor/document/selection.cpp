#include "editor/document/selection.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace trundle {

bool Selection::contains(const std::string& path) const { return std::ranges::find(m_paths, path) != m_paths.end(); }

void Selection::set(std::vector<std::string> paths) {
    std::vector<std::string> once;
    once.reserve(paths.size());
    std::set<std::string_view> seen;
    for (std::string& path : paths) {
        if (seen.contains(path)) continue;
        once.push_back(std::move(path));
        seen.insert(once.back());
    }
    if (once == m_paths) return;
    m_paths = std::move(once);
    Q_EMIT changed();
}

void Selection::toggle(const std::string& path) {
    std::vector<std::string> paths = m_paths;
    if (std::erase(paths, path) == 0) paths.push_back(path);
    set(std::move(paths));
}

} // namespace trundle
