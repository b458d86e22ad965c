#pragma once
// The selected objects during a transformation: their original poses, and the edits that move or resize them.

#include <map>
#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "editor/document/document.h"
#include "editor/viewport/gizmo/layout_extent.h"
#include "editor/viewport/gizmo/param_sizes.h"
#include "project/objects/part_values.h"
#include "scene/queries/object_index.h"

namespace trundle {

struct ViewContext;

/// Rounding steps of written numbers.
struct DragFineness {
    double lengthM = 1e-6, degrees = 1e-4;
};

class TransformSelection {
public:
    enum class Operation { Move, Scale };
    /// Collects the selected objects that can be moved, except those that move with another selected object. During a run these
    /// are the running robots, and moves act on the running world; otherwise all objects with a Pos, and moves edit the text. For
    /// Scale, an instance whose config has one shape and no Param for its size stands for that shape.
    explicit TransformSelection(const ViewContext& context, Operation purpose = Operation::Move);

    [[nodiscard]] bool empty() const { return m_items.empty(); }
    /// The reason why a non-empty selection cannot be moved; empty if there is none.
    [[nodiscard]] const QString& refusal() const { return m_refusal; }
    /// The Grid or Scatter whose member is selected, which prevents the move; empty: none.
    [[nodiscard]] const std::string& blockingLayout() const { return m_layout; }
    /// World pose of the object selected last.
    [[nodiscard]] const Pose& pivot() const { return m_items.back().world; }
    [[nodiscard]] const Pose& pivotFrame() const { return m_items.back().frame; }
    /// Name for messages: "robot0", "3 objects".
    [[nodiscard]] QString title() const;

    /// Moves every object to motion * its original pose. All calls with one merge key form one undo entry.
    Status move(const Pose& motion, const QString& name, const std::string& mergeKey, DragFineness fineness = {});
    /// Moves each object by its own offset (m, world), in the order of paths().
    Status moveEach(const std::vector<Vec3>& offsets, const QString& name);
    [[nodiscard]] std::vector<std::string> paths() const;
    [[nodiscard]] Bounds boundsOf(std::size_t item) const;

    /// Half the extent of the pivot object along each of its own axes (m); 0: that axis cannot be scaled. A box has three sizes,
    /// a sphere one, a cylinder radius and length, an instance those that Params of its config set.
    [[nodiscard]] Vec3 halfExtent() const;
    [[nodiscard]] std::array<SizeName, 3> sizeNames() const; ///< names of those sizes
    [[nodiscard]] Vec3 sizeCentre() const;                   ///< centre of those sizes, in world coordinates
    /// Why the pivot object, an instance, cannot be scaled along some axis; empty if it can.
    [[nodiscard]] QString sizeRefusal() const;
    /// Grows the shapes along their own axes: side-to-side sizes by twice `growth`, radii and heights by `growth` (m). `side` is
    /// the side that moves: 1 the positive one, -1 the negative one, 0 both; Pos is adjusted so that the other side stays. For
    /// instances, the Params that set the extents are changed.
    Status resize(const Vec3& growth, int side, const QString& name, const std::string& mergeKey, DragFineness fineness);

    /// The extent of the Grid or Scatter selected last, for Scale; nullptr without one.
    [[nodiscard]] const LayoutExtent* layoutExtent() const { return m_layoutExtent ? &*m_layoutExtent : nullptr; }
    [[nodiscard]] double memberReach() const { return m_memberReach; } ///< m, of a member from its centre, in the plane
    /// Grows that extent: Spacing and, so that the other side stays, Pos; or Area. Arguments as for resize().
    Status resizeLayout(const Vec3& growth, int side, const QString& name, const std::string& mergeKey, DragFineness fineness);

    [[nodiscard]] bool isRunning() const { return m_running; }

private:
    struct Item {
        std::string path;
        std::optional<ObjectRef> object; ///< nullopt: a Grid, Scatter, Part or Region
        Pose world, frame, local;        ///< local: Pos and HPR of the text
        DescribedFrame described;        ///< of the Parts that it is in; `frame` has its pose already
        std::string posText, hprText;    ///< as written where they are edited; empty: not written
        Vec3 hpr = Vec3::Zero();         ///< rad, of the text
        bool posEdited = false, hprEdited = false;
        std::optional<ParamSizes> sizes; ///< only for an instance to be scaled
        int sizedAxis = -1;              ///< axis of the last scaling
        std::optional<GeomSpec> shape;   ///< instead of that of `object`: the box of a Region, or with the sizes of its config
    };
    void addSizes(const std::string& path);
    void take(const std::string& path);
    void takePart(const std::string& path, const ObjectLocation& place, const ObjectRef& inside);
    void takeRegion(const std::string& path);
    void add(Item item, const ObjectLocation& place);              ///< with its texts
    [[nodiscard]] const GeomSpec* shapeOf(const Item& item) const; ///< whose sizes a drag changes; nullptr: it has none
    [[nodiscard]] std::string textOf(const std::string& property) const;
    /// The edits that resize an instance: its Param, and Pos if the opposite side is to stay.
    void resizeByParam(Item& item, const Vec3& growth, int side, double fineness, std::vector<ValueEdit>& edits);
    /// The same for a geom of the text: its size. `fineness`: m.
    void resizeGeom(Item& item, const GeomSpec& geom, const Vec3& growth, int side, double fineness,
                    std::vector<ValueEdit>& edits);
    /// Adds the edit of Pos that keeps the opposite side in place after side-to-side sizes changed from `before` to `after`.
    void follow(Item& item, const Vec3& before, const Vec3& after, int side, std::vector<ValueEdit>& edits) const;
    [[nodiscard]] std::vector<ValueEdit> editsOf(Item& item, const Pose& local, DragFineness fineness) const;
    Status apply(const std::vector<ValueEdit>& edits, const QString& name, const std::string& mergeKey);

    const ViewContext& m_context;
    std::shared_ptr<const ObjectIndex> m_objects;
    std::vector<Item> m_items;
    std::optional<LayoutExtent> m_layoutExtent;
    double m_memberReach = 0;
    std::vector<Item> m_layoutItem;             // its Grid or Scatter, one element
    std::vector<ValueEdit> m_last;              // edits of the last successful call
    std::map<std::string, std::string> m_texts; // of values, by path, as written before the first change
    QString m_refusal;
    std::string m_layout;
    bool m_running = false;
};

} // namespace trundle
