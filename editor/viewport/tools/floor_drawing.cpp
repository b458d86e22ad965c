#include "editor/viewport/tools/floor_drawing.h"

#include <cmath>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "project/edits/plans.h"

namespace trundle {
namespace {

constexpr double kSameCorner = 1e-4; // m

} // namespace

FloorDrawing::FloorDrawing(Document& document, const ViewportScene& world, const ViewSettings& settings)
    : m_document(document), m_world(world), m_settings(settings) {
    connect(&settings, &ViewSettings::changed, this, [this] {
        if (!isOn()) clear();
    });
    connect(&document, &Document::opened, this, &FloorDrawing::clear);
    connect(&document.editedModel(), &EditedModel::changed, this, &FloorDrawing::clear);
    connect(&world, &ViewportScene::replaced, this, [this] { m_ends = wallEnds(*m_world.objects()); });
}

bool FloorDrawing::isOn() const { return m_settings.tool() == Tool::DrawWalls || m_settings.tool() == Tool::DrawLine; }

FloorPathStyle FloorDrawing::style() const { return m_settings.tool() == Tool::DrawLine ? linePath() : wallPath(); }

bool FloorDrawing::begin() {
    if (!canHaveScenery(m_document)) return false;
    m_target = sceneryTarget(m_document, m_world);
    m_ends = wallEnds(*m_world.objects());
    return true;
}

void FloorDrawing::add(const FloorPoint& corner) {
    m_typed.clear();
    const bool isSame =
        !m_corners.empty() && std::hypot(corner[0] - m_corners.back()[0], corner[1] - m_corners.back()[1]) < kSameCorner;
    if (!isSame) m_corners.push_back(corner);
    Q_EMIT changed();
}

void FloorDrawing::removeLast() {
    if (m_corners.empty()) return;
    m_corners.pop_back();
    Q_EMIT changed();
}

void FloorDrawing::clear() {
    m_corners.clear();
    m_typed.clear();
    Q_EMIT changed();
}

void FloorDrawing::finish() {
    std::vector<FloorPoint> corners;
    for (const FloorPoint& corner : m_corners) {
        const Vec3 inParent = m_target.X_WP.inverse() * Vec3(corner[0], corner[1], floor());
        corners.push_back({inParent.x(), inParent.y()});
    }
    clear();
    const FloorPathStyle style = this->style();
    const std::vector<FloorPiece> pieces = piecesAlong(corners, style.thickness);
    if (pieces.empty() || !m_document.isOpen()) return;
    const bool isWall = m_settings.tool() == Tool::DrawWalls;
    const QString name =
        isWall ? (pieces.size() == 1 ? tr("Draw Wall") : tr("Draw %1 Walls").arg(pieces.size())) : tr("Draw Line");
    const std::string text = m_target.path.empty() ? staticsText(pieces, style) : boxesText(pieces, style);
    const std::vector<std::string> imports =
        m_target.path.empty() ? std::vector<std::string>{isWall ? "objects/wall.sim" : "objects/floor_line.sim"}
                              : std::vector<std::string>{"common/materials.sim", "common/surfaces.sim"};
    const auto plan = [parent = m_target.path, text, imports](const LoadedProject& loaded,
                                                              const StructureEdits::PathMapping& renamed) {
        return planInsert(loaded, renamed(parent), text, imports);
    };
    (void)m_document.structure().apply(name, {m_target.path}, plan);
}

bool FloorDrawing::type(int key, const QString& text) {
    if (!m_typed.type(key, text)) return false;
    Q_EMIT changed();
    return true;
}

std::optional<double> FloorDrawing::typedLength() const {
    const auto length = m_typed.number(false, "m");
    return length && *length > 0 && *length <= 1000 ? length : std::nullopt;
}

std::optional<double> FloorDrawing::typedAngle() const {
    const auto angle = m_typed.number(true, "deg");
    return angle && std::abs(*angle) <= 360 ? angle : std::nullopt;
}

} // namespace trundle
