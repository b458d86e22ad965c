#pragma once
#include <QToolButton>

#include "editor/properties/object_values.h"

namespace trundle {

/// A small sign for where a value comes from: a ring for a default, a dot for the own text, an arrow for a config, a diamond for
/// an override. An arrow that goes round where what runs has another value until reset.
class OriginMark final : public QToolButton {
    Q_OBJECT
public:
    explicit OriginMark(QWidget* parent);
    void display(Standing standing, bool formula, bool waits);
    [[nodiscard]] QSize sizeHint() const override { return {20, 26}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintSign(QPainter& painter) const;
    Standing m_standing = Standing::Default;
    bool m_formula = false, m_waits = false;
};

} // namespace trundle
