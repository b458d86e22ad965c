#pragma once
#include "editor/properties/numbers_editor.h"

class QToolButton;

namespace trundle {

/// Three shares with a swatch that opens the colour dialog. While the dialog is open the document follows it; Cancel takes it
/// back.
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
    void takeBack();
    [[nodiscard]] QColor colour() const;

    QToolButton* m_swatch;
    std::map<std::string, std::string> m_before; ///< texts by path when the dialog opened; empty: was not given
};

} // namespace trundle
