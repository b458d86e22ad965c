#pragma once
// What the dialogs of arenas share: lengths, and a picture of what will be inserted.

#include <QLabel>

#include "base/triangle_mesh.h"
#include "project/wizard/obstacle_field.h"
#include "project/wizard/room_plan.h"

namespace trundle {

class AmountField;

/// A length in m. `title` begins the sentence that says what is wrong with it.
[[nodiscard]] AmountField* makeLengthField(const char* name, const QString& title, double least, double most, double value);

/// A square picture from above.
class PlanPreview final : public QLabel {
    Q_OBJECT
public:
    explicit PlanPreview(const char* name);

    void showWalls(const RoomPlan& plan);
    void showHeights(const HeightMap& map);
    /// With what is there already in a paler colour.
    void showObstacles(const ObstacleField& field, const std::vector<FieldObstacle>& obstacles);
};

} // namespace trundle
