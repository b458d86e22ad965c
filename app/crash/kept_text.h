#pragma once
#include <cstddef>
#include <string_view>

namespace trundle {

/// A text for a report of a crash, on pages of its own between pages that cannot be written: code that writes past the end of its
/// data does not reach it.
class KeptText {
public:
    KeptText() = default;
    explicit KeptText(std::string_view text);
    ~KeptText();
    KeptText(KeptText&& other) noexcept { swap(other); }
    KeptText& operator=(KeptText&& other) noexcept {
        swap(other);
        return *this;
    }

    [[nodiscard]] std::string_view text() const { return {m_text, m_size}; }

private:
    void swap(KeptText& other) noexcept;

    const char* m_text = "";
    std::size_t m_size = 0, m_mapped = 0; ///< bytes of the text and of all its pages; 0: none
};

} // namespace trundle
