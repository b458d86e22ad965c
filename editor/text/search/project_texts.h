#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/platform/read_file.h"

namespace trundle {

/// The text files in a project's folder as they are on disk. A cache: a file is read again only after it has changed.
class ProjectTexts {
public:
    struct Text {
        std::string path; ///< absolute, canonical
        std::shared_ptr<const std::string> bytes;
    };
    /// Experiments, texts, sources of controllers, in alphabetical order. Skips hidden files, `logs`, `build`, links that lead
    /// out of the folder, binary files, and files larger than kLargest. At most kMaxBytes together; left() is the number of
    /// files skipped for size.
    [[nodiscard]] std::vector<Text> in(const std::string& folder);
    [[nodiscard]] std::size_t left() const { return m_left; }

    static constexpr std::size_t kLargest = std::size_t(4) << 20, kMaxBytes = std::size_t(32) << 20;

private:
    struct Known {
        FileStamp stamp;
        std::shared_ptr<const std::string> bytes;
    };
    [[nodiscard]] std::shared_ptr<const std::string> read(const std::string& path);

    std::map<std::string, Known> m_known;
    std::size_t m_left = 0;
};

} // namespace trundle
