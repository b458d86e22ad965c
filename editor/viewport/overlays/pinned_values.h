#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QObject>
#include <QPointF>
#include <QRectF>

class QPainter;

namespace trundle {

class ToolView;

/// An object whose values are displayed over the 3D view.
struct Pin {
    std::string path; ///< "robot0.leftMotor"; "" is the run itself
    /// Position of its label's centre after a drag, as fractions of the view's width and height; nullopt: in the column on the
    /// left.
    std::optional<QPointF> position;

    bool operator==(const Pin&) const = default;
};

/// The pins of a panel, in the order of creation.
class PinnedValues final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Pin>& pins() const { return m_pins; }
    [[nodiscard]] std::vector<std::string> paths() const;
    [[nodiscard]] bool contains(const std::string& path) const;
    void set(const std::vector<std::string>& paths, bool pinned);
    /// Replaces all pins.
    void setPins(std::vector<Pin> pins);
    /// Moves a label; `position` as in Pin.
    void move(const std::string& path, const std::optional<QPointF>& position);
    /// Gives each pin the path that `pathNow` returns for its own, and removes those for which it returns nothing.
    template <class PathNow> void follow(const PathNow& pathNow) {
        std::vector<Pin> pins;
        for (const Pin& pin : m_pins)
            if (const std::optional<std::string> path = pathNow(pin.path)) pins.push_back({*path, pin.position});
        setPins(std::move(pins));
    }

Q_SIGNALS:
    void changed();

private:
    std::vector<Pin> m_pins;
};

/// The label of a pin on the screen.
struct PinnedLabel {
    std::string path;
    QRectF rect;
    QRectF close; ///< the cross that unpins it
};

/// The labels of the current view, the topmost last; empty for other views.
[[nodiscard]] std::vector<PinnedLabel> pinnedLabels(const ToolView& view);

/// Paints the labels with leader lines to their objects. Labels not moved by the user are in a column; those that do not fit are
/// counted.
void paintPinnedValues(QPainter& painter, const ToolView& view);

} // namespace trundle
