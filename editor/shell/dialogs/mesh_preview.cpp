#include "editor/shell/dialogs/mesh_preview.h"

#include <algorithm>
#include <cmath>

#include <QLineF>
#include <QPainter>

#include "editor/widgets/theme.h"
#include "scene/shapes/bounds.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

constexpr int kMeshSide = 220, kMeshMargin = 12; // pixels
constexpr std::size_t kMostDrawn = 40000;        // triangles; of larger meshes every second, third ...
constexpr double kShadeDark = 0.35;              // of a face that is seen from its side

/// Right, up and towards the viewer, who is at +x, -y, +z.
Mat3 viewAxes() {
    const Vec3 back = Vec3(0.55, -0.65, 0.5).normalized(), right = Vec3::UnitZ().cross(back).normalized();
    Mat3 axes;
    axes << right.transpose(), back.cross(right).transpose(), back.transpose();
    return axes;
}

struct DrawnFace {
    QPolygonF corners;
    double depth = 0, light = 0;
};

std::vector<DrawnFace> facesOf(const TriangleMesh& mesh, const Mat3& axes) {
    std::vector<DrawnFace> faces;
    const std::size_t step = mesh.triangles.size() / kMostDrawn + 1;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += step) {
        Vec3 at[3];
        DrawnFace face;
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = axes * Vec3(mesh.points[mesh.triangles[i][k]].data());
            face.corners << QPointF(at[k].x(), -at[k].y());
            face.depth += at[k].z() / 3;
        }
        const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]);
        if (normal.norm() <= 0) continue;
        face.light = kShadeDark + (1 - kShadeDark) * std::abs(normal.normalized().dot(Vec3(-0.3, 0.5, 0.8).normalized()));
        faces.push_back(std::move(face));
    }
    std::ranges::sort(faces, {}, &DrawnFace::depth);
    return faces;
}

} // namespace

MeshPreview::MeshPreview(const char* name) {
    setObjectName(QLatin1String(name));
    setFixedSize(scaledToFont(kMeshSide), scaledToFont(kMeshSide));
    setAlignment(Qt::AlignCenter);
    setFrameShape(QFrame::StyledPanel);
    setWordWrap(true);
}

void MeshPreview::show(const TriangleMesh& mesh, const std::vector<GeomSpec>& shapes) {
    const Mat3 axes = viewAxes();
    Bounds seen;
    for (const auto& point : mesh.points) seen.add(axes * Vec3(point.data()));
    QList<QLineF> edges;
    for (const GeomSpec& shape : shapes) {
        const ShapeMesh around = bareShapeOf(shape, {});
        std::vector<QPointF> corners;
        for (const Eigen::Vector3f& point : around.points) {
            const Vec3 at = axes * (shape.pose * Vec3(point.cast<double>()));
            seen.add(at);
            corners.emplace_back(at.x(), -at.y());
        }
        for (std::size_t i = 0; i + 2 < around.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                if (const auto a = around.indices[i + k], b = around.indices[i + (k + 1) % 3]; a < b)
                    edges << QLineF(corners[a], corners[b]);
    }
    if (seen.empty()) return;
    QPixmap picture(size() - QSize(kMeshMargin, kMeshMargin));
    picture.fill(themePalette().color(QPalette::Base));
    const double scale = (picture.width() - 2. * kMeshMargin) / std::max({seen.size().x(), seen.size().y(), 1e-9});
    QPainter p(&picture);
    p.setRenderHint(QPainter::Antialiasing);
    p.translate(picture.width() / 2., picture.height() / 2.);
    p.scale(scale, scale);
    p.translate(-seen.centre().x(), seen.centre().y());
    const auto pen = [&](const QColor& colour, double pixels) { return QPen(colour, pixels / scale); };
    for (const DrawnFace& face : facesOf(mesh, axes)) {
        const QColor colour = QColor::fromHsvF(0.6f, 0.08f, float(face.light) * 0.9f);
        p.setPen(pen(colour, 0.6));
        p.setBrush(colour);
        p.drawPolygon(face.corners);
    }
    QColor line = ink(Ink::Accent);
    line.setAlphaF(0.7f);
    p.setPen(pen(line, 1));
    p.drawLines(edges);
    p.end();
    setPixmap(picture);
}

} // namespace trundle
