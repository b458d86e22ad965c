#include "editor/properties/editors/line_editor.h"

#include "editor/properties/editors/scrub.h"
#include "editor/properties/editors/value_field.h"

namespace trundle {

LineEditor::LineEditor(QWidget* parent) : FieldEditor(parent) {
    connect(m_field, &ValueField::stepped, this, [this](int steps) {
        if (!canScrub()) return;
        scrub(steps);
        m_start.clear();
        Q_EMIT scrubEnded();
    });
    connect(this, &RowEditor::scrubEnded, this, [this] { m_start.clear(); });
}

bool LineEditor::canScrub() const { return !m_row.values.empty() && !m_row.property() && Scrub::of(m_row.first().text, nullptr); }

void LineEditor::scrub(double steps) {
    if (m_start.empty())
        for (const FieldValue& v : m_row.values) m_start[v.path] = v.text;
    const auto start = m_start;
    commit(
        m_field,
        [start, steps](const FieldValue& v) {
            const auto it = start.find(v.path);
            const auto scrub = it == start.end() ? std::nullopt : Scrub::of(it->second, nullptr);
            return scrub ? scrub->after(steps) : v.text;
        },
        "scrub " + m_row.first().path);
}

} // namespace trundle
