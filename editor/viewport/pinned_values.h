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

class View;

/// One object whose values are read out over the 3D view.
struct Pin {
    std::string path; ///< "robot0.leftMotor"; "" is the run itself
    /// Where its plate was dragged to: the middle of it, as a share of the view's width and height. Nothing: in the column on the left.
    std::optional<QPointF> position;

    bool operator==(const Pin&) const = default;
};

/// The pins of a panel, in the order in which they were made.
class PinnedValues final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] const std::vector<Pin>& pins() const { return m_pins; }
    [[nodiscard]] std::vector<std::string> paths() const;
    [[nodiscard]] bool contains(const std::string& path) const;
    void set(const std::vector<std::string>& paths, bool pinned);
    /// In place of those that there are.
    void setPins(std::vector<Pin> pins);
    /// Moves a plate; `position` as in Pin.
    void move(const std::string& path, const std::optional<QPointF>& position);
    /// Leaves out those of which this says no.
    template <class Exists> void keepIf(const Exists& exists) {
        if (std::erase_if(m_pins, [&](const Pin& pin) { return !exists(pin.path); }) > 0) Q_EMIT changed();
    }

Q_SIGNALS:
    void changed();

private:
    std::vector<Pin> m_pins;
};

/// A plate as it is on the screen.
struct PinnedPlate {
    std::string path;
    QRectF rect;
    QRectF close; ///< the cross that unpins it
};

/// The plates of the current view, the topmost last; none in another view.
[[nodiscard]] std::vector<PinnedPlate> pinnedPlates(const View& view);

/// Each with a line to its object. Plates that nobody moved are in a column below the corner; those that it has no room for are counted.
void paintPinnedValues(QPainter& painter, const View& view);

} // namespace trundle
