#pragma once
// Limits beyond which the text editor does not show a text, and the notice shown instead.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <QWidget>

class QLabel;
class QPushButton;

namespace trundle {

/// A longer text is shown only on request, without colours and folds: these take at least one byte per byte of text, and the
/// tokens several.
inline constexpr std::size_t kLargestFullText = std::size_t(4) << 20; // bytes
/// A text with a longer line is not shown at all: each change of the line's height would lay out all of its characters again.
inline constexpr std::size_t kLongestShownLine = std::size_t(256) << 10; // bytes

struct TextSize {
    std::size_t bytes = 0;
    std::size_t longestLine = 0; ///< bytes
    std::uint32_t longestAt = 1; ///< line number
    [[nodiscard]] bool isLarge() const { return bytes > kLargestFullText; }
    [[nodiscard]] bool isShowable() const { return longestLine <= kLongestShownLine; }
};
[[nodiscard]] TextSize sizeOf(std::string_view text);

/// Shown instead of a text: gives the reason, and offers to show the text anyway if possible.
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
