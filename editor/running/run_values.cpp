#include "editor/running/run_values.h"

#include "editor/running/run_edits.h"
#include "editor/widgets/theme.h"
#include "model/robot_path.h"

namespace trundle {
namespace {

constexpr int kPauseMs = 100;

} // namespace

RunValues::RunValues(const RunResults& results, const RunEdits& edits, QObject* parent)
    : QObject(parent), m_results(results), m_edits(edits) {
    m_pause.setInterval(kPauseMs);
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_waits) stateChanged();
    });
}

void RunValues::begin() {
    m_objects = std::make_unique<LiveObjects>(m_results.built->experiment, m_results.layout, m_results.built->registry);
}

const std::vector<LiveValue>& RunValues::of(const std::string& path) const {
    static const std::vector<LiveValue> kNone;
    if (!m_objects || !m_results.snapshot) return kNone;
    const bool here = path.empty() || m_edits.isOfRun(robotNameIn(*m_results.built->experiment, path));
    return here ? m_objects->read(path, *m_results.snapshot) : kNone;
}

QString RunValues::tip(const std::string& path) const {
    QString rows;
    for (const LiveValue& value : of(path))
        rows +=
            QStringLiteral("<tr><td style='color:%1'>%2&nbsp;&nbsp;</td><td align='right' style='font-family:\"%3\"'>%4</td>"
                           "<td>&nbsp;%5</td></tr>")
                .arg(ink(Ink::Faint).name(), QString::fromStdString(value.name).toHtmlEscaped(), monospaceFont().family(),
                     QString::fromStdString(value.text()).toHtmlEscaped(), QString::fromStdString(value.unit).toHtmlEscaped());
    return rows.isEmpty() ? rows : QStringLiteral("<table cellspacing='0' cellpadding='0'>") + rows + QStringLiteral("</table>");
}

/// Starts the minimum interval before the next update.
void RunValues::stateChanged() {
    m_waits = false;
    m_pause.start();
    Q_EMIT changed();
}

void RunValues::advanced() {
    m_waits = true;
    if (!m_pause.isActive()) stateChanged();
}

} // namespace trundle
