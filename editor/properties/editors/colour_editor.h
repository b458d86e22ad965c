#pragma once
#include "editor/properties/editors/numbers_editor.h"

class QToolButton;

namespace trundle {

/// Three colour components with a swatch that opens the colour dialog. While the dialog is open its colour is applied to the
/// document; Cancel restores the previous one.
class ColourEditor final : public NumbersEditor {
    Q_OBJECT
public:
    explicit ColourEditor(QWidget* parent);

protected:
    void refresh() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void choose();
    void set(const QColor& colour);
    [[nodiscard]] QColor colour() const;

    QToolButton* m_swatch;
};

} // namespace trundle
