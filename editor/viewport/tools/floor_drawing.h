#pragma once
// The path of walls or of a line that is being drawn on the floor, shared by all views of a panel.

#include <vector>

#include <QObject>

#include "editor/viewport/tools/floor_snap.h"
#include "editor/viewport/tools/scenery_target.h"
#include "editor/viewport/tools/typed_numbers.h"

namespace trundle {

class Document;
class ViewSettings;
class ViewportScene;

class FloorDrawing final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object. A path ends without a result when another tool is chosen or another file is opened.
    FloorDrawing(Document& document, const ViewportScene& world, const ViewSettings& settings);

    [[nodiscard]] bool isOn() const; ///< the tool is chosen
    [[nodiscard]] FloorPathStyle style() const;
    [[nodiscard]] const std::vector<FloorPoint>& corners() const { return m_corners; } ///< in W
    [[nodiscard]] double floor() const { return m_target.X_WP.position.z(); }          ///< m, z in W
    [[nodiscard]] const std::vector<FloorPoint>& ends() const { return m_ends; }       ///< to snap to
    /// Finds where the path is written to. False, and the reason reported, if it can be nowhere.
    [[nodiscard]] bool begin();

    /// A corner; two at the same place are one.
    void add(const FloorPoint& corner);
    void removeLast();
    void clear();
    /// Writes what was drawn as one entry of the history and starts anew.
    void finish();

    /// The length in m and the angle in degrees, typed for the piece under way.
    [[nodiscard]] bool type(int key, const QString& text);
    [[nodiscard]] const TypedNumbers& typed() const { return m_typed; }
    [[nodiscard]] std::optional<double> typedLength() const;
    [[nodiscard]] std::optional<double> typedAngle() const;

Q_SIGNALS:
    void changed();

private:
    Document& m_document;
    const ViewportScene& m_world;
    const ViewSettings& m_settings;
    std::vector<FloorPoint> m_corners, m_ends;
    SceneryTarget m_target;
    TypedNumbers m_typed{true};
};

} // namespace trundle
