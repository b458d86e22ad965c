#pragma once
// Texts that are too large for the text editor to show at once: what they are shown as instead.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <QWidget>

class QLabel;
class QPushButton;

namespace trundle {

/// Of more text than this the editor shows nothing until it is asked to, and then without colours and folds: those take a byte or more
/// for each byte of the text, and the tokens for them several.
inline constexpr std::size_t kLargestFullText = std::size_t(4) << 20; // bytes
/// A line that is longer is not shown at all: the place of each of its characters would be computed with each change of its height.
inline constexpr std::size_t kLongestShownLine = std::size_t(256) << 10; // bytes

struct TextSize {
    std::size_t bytes = 0;
    std::size_t longestLine = 0;  ///< bytes
    std::uint32_t longestAt = 1;  ///< its number
    [[nodiscard]] bool isLarge() const { return bytes > kLargestFullText; }
    [[nodiscard]] bool isShowable() const { return longestLine <= kLongestShownLine; }
};
[[nodiscard]] TextSize sizeOf(std::string_view text);

/// Stands in the place of the text, says why, and offers to open it where that is possible.
class LargeTextNotice final : public QWidget {
    Q_OBJECT
public:
    explicit LargeTextNotice(QWidget* parent = nullptr);
    void setSize(const QString& file, const TextSize& size);

Q_SIGNALS:
    void openRequested();

private:
    QLabel* m_words;
    QPushButton* m_open;
};

} // namespace trundle
