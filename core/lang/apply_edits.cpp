#include <algorithm>

#include "lang/tree_edit.h"

namespace trundle {

Result<std::string> applyEdits(std::string_view bytes, std::span<const TextEdit> edits) {
    std::vector<const TextEdit*> ordered;
    for (const TextEdit& edit : edits) ordered.push_back(&edit);
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const TextEdit* a, const TextEdit* b) { return a->range.range < b->range.range; });
    std::string out;
    std::uint32_t done = 0;
    for (const TextEdit* edit : ordered) {
        const TextRange r = edit->range.range;
        if (r.end < r.begin || r.end > bytes.size()) return Error{Code::Internal, "an edit lies outside the text"};
        if (r.begin < done) return Error{Code::Internal, "two edits of one text overlap"};
        out += bytes.substr(done, r.begin - done);
        out += edit->text;
        done = r.end;
    }
    return out.append(bytes.substr(done));
}

Result<std::shared_ptr<const Tree>> applyEdits(const Tree& tree, std::span<const TextEdit> edits) {
    for (const TextEdit& edit : edits)
        if (edit.range.file != tree.file()) return Error{Code::Internal, "an edit of another file"};
    Result<std::string> bytes = applyEdits(tree.source().bytes(), edits);
    if (!bytes) return bytes.error();
    return parse(std::make_shared<const SourceText>(tree.source().path(), std::move(bytes).value()), tree.file());
}

} // namespace trundle
