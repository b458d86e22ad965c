#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/platform/read_file.h"

namespace trundle {

/// The text files in a project's folder as the disk has them; one is read again only after it has changed.
class ProjectTexts {
public:
    struct Text {
        std::string path; ///< absolute, canonical
        std::shared_ptr<const std::string> bytes;
    };
    /// Experiments, texts, sources of controllers: in alphabetical order. Not what is hidden, in `logs` or `build`, reached by a link that
    /// leaves the folder, no text, or larger than kLargest. No more than kMostBytes together; left() counts what was left out for size.
    [[nodiscard]] std::vector<Text> in(const std::string& folder);
    [[nodiscard]] std::size_t left() const { return m_left; }

    static constexpr std::size_t kLargest = std::size_t(4) << 20, kMostBytes = std::size_t(32) << 20;

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
