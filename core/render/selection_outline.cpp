#include "render/selection_outline.h"

#include <cstring>

namespace trundle {
namespace {

/// A round brush: coverage of the surrounding pixels when it is centred on one.
struct Pen {
    explicit Pen(float width) : reach(static_cast<int>(std::ceil(width)) + 1) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                const float cover = std::clamp(width + 0.5f - std::hypot(float(x), float(y)), 0.f, 1.f);
                weights.push_back(static_cast<std::uint8_t>(std::lround(255 * cover)));
            }
        }
    }
    int reach;
    std::vector<std::uint8_t> weights;
};

/// Outline of one channel of the coverage.
class Outline {
public:
    Outline(const std::vector<std::uint8_t>& coverage, int channel, int width, int height)
        : m_coverage(coverage), m_channel(channel), m_width(width), m_height(height) {}

    void draw(Image& image, const Pen& pen, const std::array<std::uint8_t, 3>& colour) {
        trace(pen);
        if (m_line.empty()) return;
        for (int y = m_top; y <= m_bottom; ++y) {
            std::uint8_t* pixel = image.pixels.data() + (std::size_t(y) * std::size_t(m_width) + std::size_t(m_left)) * 3;
            for (int x = m_left; x <= m_right; ++x, pixel += 3) {
                const unsigned line = m_line[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
                if (!line) continue;
                const unsigned alpha = line * (255u - at(x, y)) / 255u;
                for (int k = 0; k < 3; ++k)
                    pixel[k] = static_cast<std::uint8_t>((pixel[k] * (255 - alpha) + colour[std::size_t(k)] * alpha) / 255);
            }
        }
    }

private:
    [[nodiscard]] unsigned at(int x, int y) const {
        return m_coverage[(std::size_t(y) * std::size_t(m_width) + std::size_t(x)) * 4 + std::size_t(m_channel)];
    }
    [[nodiscard]] bool isEdge(int x, int y) const {
        const unsigned here = at(x, y);
        const auto less = [&](int u, int v) { return u >= 0 && v >= 0 && u < m_width && v < m_height && at(u, v) < here; };
        return less(x - 1, y) || less(x + 1, y) || less(x, y - 1) || less(x, y + 1);
    }
    void trace(const Pen& pen) {
        const std::size_t row = std::size_t(m_width) * 4;
        std::vector<std::uint8_t> nothing(row, 0);
        for (int y = 0; y < m_height; ++y) {
            // Skips empty rows, which are most rows of most images.
            if (std::memcmp(m_coverage.data() + std::size_t(y) * row, nothing.data(), row) == 0) continue;
            for (int x = 0; x < m_width; ++x)
                if (at(x, y) && isEdge(x, y)) press(pen, x, y, at(x, y));
        }
    }
    void press(const Pen& pen, int x, int y, unsigned strength) {
        if (m_line.empty()) m_line.assign(std::size_t(m_width) * std::size_t(m_height), 0);
        const int left = std::max(0, x - pen.reach), right = std::min(m_width - 1, x + pen.reach);
        const int top = std::max(0, y - pen.reach), bottom = std::min(m_height - 1, y + pen.reach);
        m_left = std::min(m_left, left), m_right = std::max(m_right, right);
        m_top = std::min(m_top, top), m_bottom = std::max(m_bottom, bottom);
        for (int v = top; v <= bottom; ++v) {
            const std::uint8_t* weight = pen.weights.data() + (v - y + pen.reach) * (2 * pen.reach + 1) + (left - x + pen.reach);
            std::uint8_t* line = m_line.data() + std::size_t(v) * std::size_t(m_width) + std::size_t(left);
            for (int u = left; u <= right; ++u, ++weight, ++line)
                *line = std::max(*line, static_cast<std::uint8_t>(*weight * strength / 255));
        }
    }

    const std::vector<std::uint8_t>& m_coverage;
    int m_channel, m_width, m_height;
    int m_left = 1 << 30, m_right = -1, m_top = 1 << 30, m_bottom = -1;
    std::vector<std::uint8_t> m_line;
};

} // namespace

void drawOutlines(Image& image, const std::vector<std::uint8_t>& coverage, const OutlineStyle& style) {
    const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
    if (coverage.size() != std::size_t(image.width) * image.height * 4) return;
    const Pen pen(std::clamp(style.width, 0.5f, 16.f)), thin(std::clamp(0.6f * style.width, 0.5f, 16.f));
    Outline(coverage, 1, width, height).draw(image, thin, style.hovered);
    Outline(coverage, 0, width, height).draw(image, pen, style.selected);
}

} // namespace trundle
