#include "editor/widgets/plain_text.h"

#include <algorithm>

#include <QApplication>
#include <QCursor>
#include <QEvent>
#include <QLabel>
#include <QMessageBox>
#include <QScreen>
#include <QToolTip>

#include "base/clean_text.h"

namespace trundle {
namespace {

constexpr int kMaxTipColumns = 80; ///< of average characters, in a tool tip

bool g_htmlTip = false; // the tool tip being created is HTML

/// The current tool tip label, if there is one; Qt has no API for it.
QLabel* toolTip() {
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->inherits("QTipLabel")) return static_cast<QLabel*>(widget);
    return nullptr;
}

/// Hides a visible HTML tool tip: Qt would reuse it with its text format.
void dropHtmlToolTip() {
    if (QLabel* tip = toolTip(); tip && tip->textFormat() == Qt::RichText) tip->hide();
}

/// Qt wraps the lines of a plain tool tip only where they are wider than the screen.
void wrapToolTip(QObject* watched) {
    auto* tip = qobject_cast<QLabel*>(watched);
    if (!tip || !tip->inherits("QTipLabel") || tip->textFormat() != Qt::PlainText) return;
    const int widest = kMaxTipColumns * tip->fontMetrics().averageCharWidth();
    if (tip->width() <= widest) return;
    tip->setWordWrap(true);
    tip->resize(widest, tip->heightForWidth(widest));
    if (!tip->isVisible() || !tip->screen()) return; // QToolTip moves it
    const QRect screen = tip->screen()->availableGeometry();
    const int right = std::min(QCursor::pos().x() + 2, screen.right() - widest); // it was moved to the left to fit
    tip->move(std::max({tip->x(), right, screen.left()}), std::min(tip->y(), screen.bottom() - tip->height()));
}

class PlainText final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::ToolTip) dropHtmlToolTip();
        if (event->type() == QEvent::Resize) wrapToolTip(watched);
        if (event->type() == QEvent::Polish)
            if (auto* label = qobject_cast<QLabel*>(watched); label && label->textFormat() == Qt::AutoText)
                label->setTextFormat(g_htmlTip && label->inherits("QTipLabel") ? Qt::RichText : Qt::PlainText);
        return false;
    }
};

} // namespace

void showTextPlainly(QApplication& application) {
    if (application.findChild<PlainText*>(QStringLiteral("plainText"), Qt::FindDirectChildrenOnly)) return;
    auto* filter = new PlainText(&application);
    filter->setObjectName(QStringLiteral("plainText"));
    application.installEventFilter(filter);
}

QString shownLine(const std::string& text) { return QString::fromStdString(cleanLine(text)); }

QString withoutMnemonics(QString text) { return text.replace(u'&', QStringLiteral("&&")); }

void showToolTip(const QPoint& at, const QString& text, QWidget* of, const QRect& room) {
    dropHtmlToolTip();
    QToolTip::showText(at, text, of, room);
}

void showHtmlToolTip(const QPoint& at, const QString& html, QWidget* of, const QRect& room) {
    if (QLabel* tip = toolTip(); tip && tip->textFormat() != Qt::RichText) tip->hide(); // once hidden, it is created again
    g_htmlTip = true;
    QToolTip::showText(at, html, of, room);
    g_htmlTip = false;
}

void setHtmlInformation(QMessageBox& box, const QString& html) {
    box.setInformativeText(html);
    if (auto* label = box.findChild<QLabel*>(QStringLiteral("qt_msgbox_informativelabel"))) label->setTextFormat(Qt::RichText);
}

} // namespace trundle
