#pragma once
#include <string>
#include <unordered_map>

#include "editor/outline/outline_node.h"

namespace trundle {

/// The rows that exist: how many, and those of objects by path.
class OutlineIndex {
public:
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] const OutlineNode* find(const std::string& path) const {
        const auto it = m_byPath.find(path);
        return it == m_byPath.end() ? nullptr : it->second;
    }

    void clear() { *this = {}; }
    void add(const OutlineNode& node) {
        ++m_size;
        if (node.row.selectable) m_byPath.try_emplace(node.row.path, &node);
    }
    /// With the rows below it.
    void remove(const OutlineNode& node) {
        --m_size;
        forget(node, node.row.path);
        for (const auto& child : node.children) remove(*child);
    }
    /// The node has another row now.
    void update(const OutlineNode& node, const OutlineRow& old) {
        if (old.path == node.row.path && old.selectable == node.row.selectable) return;
        forget(node, old.path);
        if (node.row.selectable) m_byPath.insert_or_assign(node.row.path, &node);
    }

private:
    void forget(const OutlineNode& node, const std::string& path) {
        if (const auto it = m_byPath.find(path); it != m_byPath.end() && it->second == &node) m_byPath.erase(it);
    }

    std::unordered_map<std::string, const OutlineNode*> m_byPath;
    std::size_t m_size = 0;
};

} // namespace trundle
