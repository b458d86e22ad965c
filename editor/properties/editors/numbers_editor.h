#pragma once
#include <map>

#include "editor/properties/editors/row_editor.h"

class QGridLayout;

namespace trundle {

class ScrubLabel;

/// One field per number: x y z of a position, heading pitch roll, a single length.
class NumbersEditor : public RowEditor {
    Q_OBJECT
public:
    explicit NumbersEditor(QWidget* parent);
    [[nodiscard]] QWidget* focusField() const override;
    [[nodiscard]] bool canScrub() const override;
    void scrub(double steps) override { scrubField(0, steps); }
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void refresh() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void addFields(std::size_t count);
    void arrange();
    [[nodiscard]] bool fit(std::size_t columns) const; ///< whether no number would be elided
    void enter(std::size_t i, const QString& typed);
    void scrubField(std::size_t i, double steps);
    void showField(std::size_t i);

    QGridLayout* m_grid;
    std::vector<ValueField*> m_fields;
    std::vector<ScrubLabel*> m_labels;         ///< empty if there is one field
    std::map<std::string, FieldValue> m_start; ///< by path, when the drag began
    std::size_t m_columns = 0;
    bool m_sized = false;
    std::string m_stacked; ///< path of the value whose numbers did not fit side by side
};

} // namespace trundle
