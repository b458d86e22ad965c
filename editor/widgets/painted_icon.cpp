#include "editor/widgets/painted_icon.h"

#include <QIconEngine>

namespace trundle {
namespace {

class PaintedIcon final : public QIconEngine {
public:
    explicit PaintedIcon(IconPainting paint) : m_paint(std::move(paint)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        m_paint(*painter, QRectF(rect), mode);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        m_paint(painter, QRectF(pixmap.rect()), mode);
        return pixmap;
    }
    QIconEngine* clone() const override { return new PaintedIcon(m_paint); }

private:
    IconPainting m_paint;
};

} // namespace

QIcon paintedIcon(IconPainting paint) { return QIcon(new PaintedIcon(std::move(paint))); }

} // namespace trundle
