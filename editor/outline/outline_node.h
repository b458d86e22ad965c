#pragma once
#include <memory>
#include <vector>

#include "editor/outline/outline_rows.h"

namespace trundle {

/// A row that a view has accessed, with its children once they are fetched.
struct OutlineNode {
    OutlineNode* parent = nullptr;
    int place = 0; ///< index among the parent's children
    OutlineRow row;
    std::vector<std::unique_ptr<OutlineNode>> children;
    bool fetched = false;

    void number(std::size_t from = 0) {
        for (std::size_t i = from; i < children.size(); ++i) children[i]->place = static_cast<int>(i);
    }
};

} // namespace trundle
