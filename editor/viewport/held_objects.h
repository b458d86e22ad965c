#pragma once
// Objects of the selection taken in hand: where they stood, and the edits that put them elsewhere or make them larger.

#include <map>
#include <string>
#include <vector>

#include <QString>

#include "base/result.h"
#include "editor/document/document.h"
#include "editor/viewport/param_sizes.h"
#include "scene/object_index.h"

namespace trundle {

struct ViewParts;

/// Steps to which numbers are written.
struct Fineness {
    double lengthM = 1e-6, degrees = 1e-4;
};

class HeldObjects {
public:
    enum class Purpose { Move, Scale };
    /// What of the selection can be moved, without what moves along with something else in it. While a world runs these are
    /// its robots, and they are placed there; else everything with a Pos, and the text is edited. To Scale, an instance whose config has
    /// one shape and no Param for it means that shape.
    explicit HeldObjects(const ViewParts& parts, Purpose purpose = Purpose::Move);

    [[nodiscard]] bool empty() const { return m_items.empty(); }
    /// Why there is nothing to move although something is selected; empty where there is no such reason.
    [[nodiscard]] const QString& refusal() const { return m_refusal; }
    /// The Grid or Scatter whose member is selected, and so in the way; empty: none.
    [[nodiscard]] const std::string& layoutInTheWay() const { return m_layout; }
    /// Of the object selected last: where it stands, and the frame that its Pos is written in.
    [[nodiscard]] const Pose& pivot() const { return m_items.back().world; }
    [[nodiscard]] const Pose& pivotFrame() const { return m_items.back().frame; }
    /// "robot0", "3 objects".
    [[nodiscard]] QString title() const;

    /// Puts every object to motion * where it stood. One entry of the history for each merge key.
    Status move(const Pose& motion, const QString& name, const std::string& mergeKey, Fineness fineness = {});
    /// Each to a place of its own, in the order of paths().
    Status moveEach(const std::vector<Vec3>& offsets, const QString& name);
    [[nodiscard]] std::vector<std::string> paths() const;
    [[nodiscard]] Bounds boundsOf(std::size_t item) const;

    /// Lengths of the pivot object that can be dragged: a box has three, a ball one, a cylinder radius and length, an instance those
    /// that Params of its config set; else none. Half the extent along each of its own axes; 0: not there.
    [[nodiscard]] Vec3 halfExtent() const;
    [[nodiscard]] std::array<SizeName, 3> sizeNames() const; ///< of those lengths
    [[nodiscard]] Vec3 sizeCentre() const;                   ///< from where they extend, in the world
    /// Why the pivot object, an instance, cannot be sized along some axis; empty where it can.
    [[nodiscard]] QString sizeRefusal() const;
    /// Grows the shapes by twice so much from side to side, radii and heights by so much, along their own axes. `side` says which
    /// side goes: 1 where the axis points, -1 the other one, 0 both. The Pos follows, so that the other one stays. Instances get other
    /// values for the Params that set their extents.
    Status resize(const Vec3& growth, int side, const QString& name, const std::string& mergeKey, Fineness fineness);

    [[nodiscard]] bool movesWorld() const { return m_running; }

private:
    struct Item {
        std::string path;
        std::optional<ObjectRef> object; ///< none: a Grid or Scatter
        Pose world, frame, local;        ///< local: as in the text
        std::string posText, hprText;    ///< as written where it is to be edited; empty: not there
        bool posEdited = false, hprEdited = false;
        std::optional<ParamSizes> sizes; ///< of an instance that is held to be scaled
        int sizedAxis = -1;              ///< along which it was sized last
    };
    void takeSizes(const std::string& path);
    void take(const std::string& path);
    void takeLayout(const std::string& path);
    [[nodiscard]] std::string textOf(const std::string& property) const;
    /// The edits that size an instance: of the Param, and of the Pos where the side across stays.
    void resizeByParam(Item& item, const Vec3& growth, int side, double fineness, std::vector<ValueEdit>& edits) const;
    /// Lengths from side to side became others: the edit of the Pos that keeps the other side.
    void follow(Item& item, const Vec3& before, const Vec3& after, int side, std::vector<ValueEdit>& edits) const;
    [[nodiscard]] std::vector<ValueEdit> editsOf(Item& item, const Pose& local, Fineness fineness) const;
    Status carryOut(const std::vector<ValueEdit>& edits, const QString& name, const std::string& mergeKey);

    const ViewParts& m_parts;
    std::shared_ptr<const ObjectIndex> m_objects;
    std::vector<Item> m_items;
    std::vector<ValueEdit> m_last;                  // carried out
    std::map<std::string, std::string> m_sizeTexts; // by path, as written before the first resize()
    QString m_refusal;
    std::string m_layout;
    bool m_running = false;
};

} // namespace trundle
