#pragma once
// What a widget writes while it paints itself, where no label has the text.

#include <QPaintEngine>
#include <QStringList>
#include <QWidget>

namespace trundle {

/// Takes the place of the screen and keeps the texts alone.
class TextDevice final : public QPaintDevice {
public:
    explicit TextDevice(const QWidget& like) : m_like(like) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }
    [[nodiscard]] const QStringList& texts() const { return m_engine.texts; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth: return m_like.width();
        case PdmHeight: return m_like.height();
        case PdmDpiX:
        case PdmPhysicalDpiX: return m_like.logicalDpiX();
        case PdmDpiY:
        case PdmPhysicalDpiY: return m_like.logicalDpiY();
        default: return QPaintDevice::metric(metric);
        }
    }

private:
    struct Engine final : QPaintEngine {
        Engine() : QPaintEngine(AllFeatures) {}
        bool begin(QPaintDevice*) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState&) override {}
        void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
        void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}
        void drawPath(const QPainterPath&) override {}
        void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
        void drawTextItem(const QPointF&, const QTextItem& item) override { texts << item.text(); }
        Type type() const override { return User; }
        QStringList texts;
    };
    const QWidget& m_like;
    mutable Engine m_engine;
};

/// In the order of painting, those of its children too.
inline QStringList paintedTexts(QWidget& widget) {
    TextDevice device(widget);
    widget.render(&device);
    return device.texts();
}

} // namespace trundle
