#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/source_range.h"
#include "project/loading/loaded_project.h"

namespace trundle {

/// The texts of a project, and sources in its folder that problems are in.
class TextsWithCode {
public:
    explicit TextsWithCode(const LoadedProject& project) : m_all(std::make_shared<LoadedProject>(project)) {}

    /// The text of a line of a source, from 1, without the blanks around it; nothing if it cannot be shown.
    [[nodiscard]] std::optional<SourceRange> lineAt(const std::string& file, int line);
    [[nodiscard]] std::shared_ptr<const LoadedProject> all() const { return m_all; }

private:
    [[nodiscard]] std::optional<FileId> idOf(const std::string& path);

    std::shared_ptr<LoadedProject> m_all;
};

} // namespace trundle
