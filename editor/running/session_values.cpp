// RunSession: live values of the objects.
#include "editor/running/session.h"
#include "editor/widgets/theme.h"

namespace trundle {

const std::vector<LiveValue>& RunSession::liveValues(const std::string& path) const {
    static const std::vector<LiveValue> kNone;
    if (!m_live || !m_snapshot) return kNone;
    return path.empty() || isOfRun(path.substr(0, path.find('.'))) ? m_live->read(path, *m_snapshot) : kNone;
}

QString RunSession::liveTip(const std::string& path) const {
    QString rows;
    for (const LiveValue& value : liveValues(path))
        rows +=
            QStringLiteral("<tr><td style='color:%1'>%2&nbsp;&nbsp;</td><td align='right' style='font-family:\"%3\"'>%4</td>"
                           "<td>&nbsp;%5</td></tr>")
                .arg(ink(Ink::Faint).name(), QString::fromStdString(value.name).toHtmlEscaped(), monospaceFont().family(),
                     QString::fromStdString(value.text()).toHtmlEscaped(), QString::fromStdString(value.unit).toHtmlEscaped());
    return rows.isEmpty() ? rows : QStringLiteral("<table cellspacing='0' cellpadding='0'>") + rows + QStringLiteral("</table>");
}

/// Starts the minimum interval before the next update.
void RunSession::showValues() {
    m_valuesWait = false;
    m_valuesPause.start();
    Q_EMIT valuesChanged();
}

} // namespace trundle
