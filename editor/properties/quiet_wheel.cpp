#include "editor/properties/quiet_wheel.h"

#include <QEvent>
#include <QWidget>

namespace trundle {
namespace {

class QuietWheel final : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

} // namespace

void quietWheel(QWidget& widget) {
    widget.setFocusPolicy(Qt::StrongFocus);
    widget.installEventFilter(new QuietWheel(&widget));
}

} // namespace trundle
