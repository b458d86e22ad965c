#pragma once
// Records what a painter draws, so that a test can compare it with computed places.

#include <algorithm>
#include <vector>

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>

namespace trundle {

struct PaintedShape {
    enum class Kind { Line, Polyline, Polygon, Ellipse, Text };
    Kind kind = Kind::Line;
    QPolygonF points; ///< of an ellipse its box, of a text the start of its baseline
    QPen pen;
    QBrush brush;
    QString text;
};

/// Of this size, in pixels.
class PaintRecord final : public QPaintDevice {
public:
    explicit PaintRecord(const QSize& size) : m_size(size), m_engine(m_shapes) {}
    PaintRecord(const PaintRecord& other) : QPaintDevice(), m_size(other.m_size), m_shapes(other.m_shapes), m_engine(m_shapes) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }

    [[nodiscard]] std::vector<PaintedShape> of(PaintedShape::Kind kind) const {
        std::vector<PaintedShape> found;
        std::ranges::copy_if(m_shapes, std::back_inserter(found), [kind](const PaintedShape& s) { return s.kind == kind; });
        return found;
    }
    /// Those with a pen of this colour; alpha counts too.
    [[nodiscard]] std::vector<PaintedShape> of(PaintedShape::Kind kind, const QColor& pen) const {
        std::vector<PaintedShape> found = of(kind);
        std::erase_if(found, [&](const PaintedShape& s) { return s.pen.color() != pen; });
        return found;
    }
    /// Whether a line of this colour joins two points, in either direction.
    [[nodiscard]] bool hasLine(const QPointF& a, const QPointF& b, const QColor& pen, double reach = 0.01) const {
        const auto near = [reach](const QPointF& p, const QPointF& q) { return (p - q).manhattanLength() < reach; };
        return std::ranges::any_of(of(PaintedShape::Kind::Line, pen), [&](const PaintedShape& s) {
            return (near(s.points[0], a) && near(s.points[1], b)) || (near(s.points[0], b) && near(s.points[1], a));
        });
    }
    [[nodiscard]] QStringList texts() const {
        QStringList all;
        for (const PaintedShape& shape : of(PaintedShape::Kind::Text)) all << shape.text;
        return all;
    }

protected:
    int metric(PaintDeviceMetric which) const override {
        switch (which) {
        case PdmWidth:
        case PdmWidthMM: return m_size.width();
        case PdmHeight:
        case PdmHeightMM: return m_size.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return 96;
        case PdmDepth: return 32;
        case PdmDevicePixelRatio: return 1;
        default: return QPaintDevice::metric(which);
        }
    }

private:
    class Engine final : public QPaintEngine {
    public:
        explicit Engine(std::vector<PaintedShape>& shapes) : QPaintEngine(AllFeatures), m_shapes(shapes) {}
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        Type type() const override { return User; }
        void updateState(const QPaintEngineState& state) override {
            if (state.state() & DirtyPen) m_pen = state.pen();
            if (state.state() & DirtyBrush) m_brush = state.brush();
        }
        void drawLines(const QLineF* lines, int count) override {
            for (int i = 0; i < count; ++i) add(PaintedShape::Kind::Line, {lines[i].p1(), lines[i].p2()});
        }
        void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
            add(mode == PolylineMode ? PaintedShape::Kind::Polyline : PaintedShape::Kind::Polygon,
                QPolygonF(QList<QPointF>(points, points + count)));
        }
        void drawRects(const QRectF* rects, int count) override {
            for (int i = 0; i < count; ++i) add(PaintedShape::Kind::Polygon, QPolygonF(rects[i]));
        }
        void drawPath(const QPainterPath& path) override { add(PaintedShape::Kind::Polygon, QPolygonF(path.boundingRect())); }
        void drawEllipse(const QRectF& rect) override { add(PaintedShape::Kind::Ellipse, QPolygonF(rect)); }
        void drawTextItem(const QPointF& at, const QTextItem& item) override { add(PaintedShape::Kind::Text, {at}, item.text()); }
        void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}

    private:
        void add(PaintedShape::Kind kind, const QPolygonF& points, const QString& text = {}) {
            m_shapes.push_back({kind, points, m_pen, m_brush, text});
        }
        std::vector<PaintedShape>& m_shapes;
        QPen m_pen;
        QBrush m_brush;
    };

    QSize m_size;
    std::vector<PaintedShape> m_shapes;
    mutable Engine m_engine;
};

} // namespace trundle
