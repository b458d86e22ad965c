#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QObject>
#include <QPointF>
#include <QRectF>

class QPainter;

namespace trundle {

struct LoadedProject;
class ChangeSet;
class Document;
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
    /// Follows the renames of the document, which must outlive this object; another project starts without pins.
    explicit PinnedValues(Document& document);

    [[nodiscard]] const std::vector<Pin>& pins() const { return m_pins; }
    [[nodiscard]] std::vector<std::string> paths() const;
    [[nodiscard]] bool contains(const std::string& path) const;
    void set(const std::vector<std::string>& paths, bool pinned);
    /// Replaces all pins.
    void setPins(std::vector<Pin> pins);
    /// Moves a label; `position` as in Pin.
    void move(const std::string& path, const std::optional<QPointF>& position);

Q_SIGNALS:
    void changed();

private:
    void follow(const ChangeSet& changes);

    Document& m_document;
    std::vector<Pin> m_pins;
    std::shared_ptr<const LoadedProject> m_valid; // texts without errors in which the paths were last valid
    bool m_isOtherProject = false;                // another experiment was opened, but is not displayed yet
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
