#include "scene/nodes/geom_nodes.h"

#include <osg/LOD>
#include <osgUtil/CullVisitor>

#include "scene/nodes/geom_pieces.h"
#include "scene/nodes/masks.h"
#include "scene/nodes/osg_types.h"

namespace trundle {
namespace {

/// Level of detail for objects up to `pixels` in diameter on the screen.
struct Degree {
    float pixels;
    int segments;
    bool bevel;
};
constexpr float kAnyPixels = 1e9f;
constexpr std::array<Degree, 6> kDegrees{
    {{kAnyPixels, 96, true}, {1600, 36, true}, {170, 18, true}, {64, 14, false}, {20, 8, false}, {8, 6, false}}};
constexpr Fineness kFine{36, true}, kOutline{10, false};

constexpr unsigned kClearMask = ~unsigned(kMaskSolid | kMaskFloor); // these two masks are always used together

/// User data that ShadowTransform passes to the visitor for the nodes below it.
struct Casting : osg::Referenced {
    explicit Casting(bool openOnes) : openOnes(openOnes) {}
    bool openOnes; ///< without the convex ones
};

/// The finest level also where the middle is in the plane of the eye, where the size on the screen is infinite: no range has that.
class DetailLevels final : public osg::LOD {
public:
    DetailLevels() { setRangeMode(PIXEL_SIZE_ON_SCREEN); }
    void traverse(osg::NodeVisitor& visitor) override {
        osg::CullStack* view = visitor.asCullStack();
        const bool byPlace = view && visitor.getTraversalMode() == osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN;
        if (byPlace && !(view->clampedPixelSize(getBound()) / view->getLODScale() < kAnyPixels)) getChild(0)->accept(visitor);
        else osg::LOD::traverse(visitor);
    }
};

/// All levels of detail from one on; null if `make` gives nothing.
template <class Make> osg::ref_ptr<osg::LOD> detailOf(std::size_t first, Make make) {
    const osg::ref_ptr<osg::Geometry> fine = make({kDegrees[first].segments, kDegrees[first].bevel});
    if (!fine) return nullptr;
    const double across = 2 * fine->getBound().radius();
    osg::ref_ptr<osg::LOD> detail = new DetailLevels;
    for (std::size_t i = first; i < kDegrees.size(); ++i) {
        const Degree& degree = kDegrees[i];
        const float least = i + 1 < kDegrees.size() ? kDegrees[i + 1].pixels : 0;
        detail->addChild(i == first ? fine : make({degree.segments, degree.bevel, across > 0 ? degree.pixels / across : 0}),
                         least, i == first ? kAnyPixels : degree.pixels);
    }
    return detail;
}

/// About the number of vertices of a shape.
std::size_t pointsOf(const GeomSpec& geom, std::size_t segments) {
    switch (geom.shape) {
    case GeomShape::Sphere:
    case GeomShape::Capsule: return segments * segments / 2;
    case GeomShape::Cylinder: return 20 * segments;
    default: return 100; // meshes have one level only
    }
}

osg::ref_ptr<osg::Geometry> partOf(const osg::Geometry& whole, const std::function<bool(std::uint32_t)>& keep) {
    osg::ref_ptr<osg::Geometry> part = new osg::Geometry(whole, osg::CopyOp::SHALLOW_COPY);
    part->removePrimitiveSet(0, part->getNumPrimitiveSets());
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    const auto* ranges = dynamic_cast<const GeomRanges*>(whole.getUserData());
    const auto* all =
        whole.getNumPrimitiveSets() ? dynamic_cast<const osg::DrawElementsUInt*>(whole.getPrimitiveSet(0)) : nullptr;
    if (ranges && all) {
        for (std::size_t i = 0; i + 2 < all->size(); i += 3) {
            if (keep(ranges->geomOf((*all)[i])))
                triangles->insert(triangles->end(), all->begin() + long(i), all->begin() + long(i) + 3);
        }
    }
    part->addPrimitiveSet(triangles);
    return part;
}

} // namespace

bool castsShadows(const osg::NodeVisitor& visitor) { return dynamic_cast<const Casting*>(visitor.getUserData()); }

bool hasClearParts(const osg::Group& geomNode) {
    for (unsigned i = 0; i < geomNode.getNumChildren(); ++i)
        if (geomNode.getChild(i)->getNodeMask() == kClearMask) return true;
    return false;
}

bool hasOpenCasters(osg::Node& node) {
    if (const auto* shapes = dynamic_cast<const GeomNode*>(&node)) return bool(shapes->openCaster);
    const osg::Group* group = node.asGroup();
    for (unsigned i = 0; group && i < group->getNumChildren(); ++i)
        if (hasOpenCasters(const_cast<osg::Node&>(*group->getChild(i)))) return true;
    return false;
}

void GeomNode::traverse(osg::NodeVisitor& visitor) {
    const auto* casting = dynamic_cast<const Casting*>(visitor.getUserData());
    if (!casting) return osg::Group::traverse(visitor);
    if (const auto& casts = casting->openOnes ? openCaster : caster) casts->accept(visitor);
}

void GeomNode::releaseGLObjects(osg::State* state) const {
    osg::Group::releaseGLObjects(state);
    for (const auto& casts : {caster, openCaster})
        if (casts) casts->releaseGLObjects(state);
}

void ShadowTransform::traverse(osg::NodeVisitor& visitor) {
    static const osg::ref_ptr<Casting> all = new Casting(false), open = new Casting(true);
    const osg::ref_ptr<osg::Referenced> before = visitor.getUserData();
    visitor.setUserData(m_openOnes ? open : all);
    if (auto* cull = m_everywhere ? visitor.asCullVisitor() : nullptr) {
        // Transforms below inherit the culling set of the projection; this transform's own set is already active.
        osg::CullingSet& seen = cull->getProjectionCullingStack().back();
        const osg::CullingSet::Mask mask = seen.getCullingMask();
        seen.setCullingMask(osg::CullingSet::NO_CULLING);
        cull->getCurrentCullingSet().setCullingMask(osg::CullingSet::NO_CULLING);
        osg::MatrixTransform::traverse(visitor);
        seen.setCullingMask(mask);
    } else {
        osg::MatrixTransform::traverse(visitor);
    }
    visitor.setUserData(before);
}

GeomDetail detailWithin(std::span<const GeomSpec> geoms, std::size_t points) {
    GeomDetail detail;
    for (;; ++detail.level) {
        detail.points = 0;
        for (const GeomSpec& geom : geoms) detail.points += pointsOf(geom, std::size_t(kDegrees[detail.level].segments));
        if (detail.points <= points || detail.level + 1 == kDegrees.size()) return detail;
    }
}

osg::ref_ptr<osg::Group> makeGeomNode(std::span<const GeomSpec> geoms, const std::vector<MaterialSpec>& materials,
                                      std::span<const SpokePattern> spokes, const SceneShading& look, Pictures& pictures,
                                      std::size_t level) {
    osg::ref_ptr<GeomNode> group = new GeomNode;
    osg::ref_ptr<GeomNames> names = new GeomNames;
    for (const GeomSpec& geom : geoms) names->names.push_back(geom.name);
    group->setUserData(names);
    const auto isClear = [](const MaterialSpec& m) { return m.opacity < 1; };
    GeomPieces pieces(geoms, materials, spokes);
    const auto addWhole = [&](const osg::ref_ptr<osg::Node>& drawable, bool clear = false) {
        if (!drawable) return;
        if (clear) drawable->setNodeMask(kClearMask);
        group->addChild(drawable);
    };
    addWhole(detailOf(level, [&](Fineness fineness) {
        return pieces.merged(fineness, look.bodies,
                             [&](const GeomSpec& g, const MaterialSpec& m) { return !m.picture && !isClear(m) && isRound(g); });
    }));
    addWhole(pieces.merged(kFine, look.surfaces,
                           [&](const GeomSpec& g, const MaterialSpec& m) { return !m.picture && !isClear(m) && !isRound(g); }));
    addWhole(pieces.merged(kFine, look.clear, [&](const GeomSpec&, const MaterialSpec& m) { return !m.picture && isClear(m); }),
             true);
    for (const auto& [picture, clearOnes] : pieces.pictures()) {
        const osg::ref_ptr<osg::StateSet> state = pictures.stateFor(picture, clearOnes, look);
        const auto wears = [&, picture = picture, clearOnes = clearOnes](const MaterialSpec& m) {
            return m.picture == picture && isClear(m) == clearOnes;
        };
        addWhole(detailOf(level,
                          [&](Fineness fineness) {
                              return pieces.merged(fineness, state, [&](const GeomSpec& g, const MaterialSpec& m) {
                                  return wears(m) && isRound(g);
                              });
                          }),
                 clearOnes);
        addWhole(pieces.merged(kFine, state, [&](const GeomSpec& g, const MaterialSpec& m) { return wears(m) && !isRound(g); }),
                 clearOnes);
    }
    group->caster = detailOf(level, [&](Fineness fineness) { return pieces.bare(fineness, look, {}); });
    group->solids = pieces.solids();
    group->openCaster = group->caster;
    if (!group->solids.empty())
        group->openCaster = detailOf(level, [&](Fineness fineness) { return pieces.bare(fineness, look, group->solids); });
    return group;
}

osg::ref_ptr<osg::Group> makeOutlineNode(std::span<const GeomSpec> geoms) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    GeomPieces pieces(geoms, {});
    if (const auto lines = pieces.merged(kOutline, nullptr, [](const GeomSpec&, const MaterialSpec&) { return true; }))
        group->addChild(lines);
    return group;
}

std::optional<std::uint32_t> geomNamed(const osg::Group& geomNode, std::string_view name) {
    const auto* names = dynamic_cast<const GeomNames*>(geomNode.getUserData());
    if (!names) return std::nullopt;
    const auto it = std::find(names->names.begin(), names->names.end(), name);
    if (it == names->names.end()) return std::nullopt;
    return static_cast<std::uint32_t>(it - names->names.begin());
}

osg::ref_ptr<osg::Group> partOf(const osg::Group& geomNode, const std::function<bool(std::uint32_t)>& keep) {
    osg::ref_ptr<osg::Group> part;
    if (const auto* detail = dynamic_cast<const osg::LOD*>(&geomNode)) {
        osg::ref_ptr<osg::LOD> copy = new DetailLevels;
        copy->setRangeList(detail->getRangeList());
        part = copy;
    } else if (const auto* node = dynamic_cast<const GeomNode*>(&geomNode); node && node->caster) {
        osg::ref_ptr<GeomNode> copy = new GeomNode;
        copy->caster = partOf(*node->caster, keep);
        if (node->openCaster) copy->openCaster = partOf(*node->openCaster, keep);
        std::copy_if(node->solids.begin(), node->solids.end(), std::back_inserter(copy->solids),
                     [&](const ShadowSolid& solid) { return keep(solid.geom); });
        part = copy;
    } else {
        part = new osg::Group;
    }
    part->setUserData(const_cast<osg::Referenced*>(geomNode.getUserData()));
    part->setNodeMask(geomNode.getNodeMask());
    for (unsigned i = 0; i < geomNode.getNumChildren(); ++i) {
        const osg::Node* child = geomNode.getChild(i);
        if (const auto* geometry = dynamic_cast<const osg::Geometry*>(child)) {
            part->osg::Group::addChild(partOf(*geometry, keep));
        } else if (const auto* group = dynamic_cast<const osg::Group*>(child)) {
            part->osg::Group::addChild(partOf(*group, keep));
        }
    }
    return part;
}

} // namespace trundle
