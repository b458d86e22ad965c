#pragma once
#include <QToolButton>

#include "project/objects/object_values.h"

namespace trundle {

/// An icon for the origin of a value: a ring for a default, a dot for the object's own text, an arrow for a config, a diamond
/// for an override. A circular arrow if the run uses another value until reset.
class OriginMark final : public QToolButton {
    Q_OBJECT
public:
    explicit OriginMark(QWidget* parent);
    void display(ValueOrigin origin, bool formula, bool waits);
    [[nodiscard]] QSize sizeHint() const override { return {20, 26}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintSign(QPainter& painter) const;
    ValueOrigin m_origin = ValueOrigin::Default;
    bool m_formula = false, m_waits = false;
};

} // namespace trundle
