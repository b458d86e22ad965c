#include "editor/shell/commands/help_commands.h"

#include <QApplication>
#include <QMessageBox>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/shell/help_panel.h"
#include "editor/shell/layouts.h"
#include "editor/text/text_panel.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/theme.h"
#include "project/objects/object_location.h"

namespace trundle {

HelpCommands::HelpCommands(QWidget& window, Actions& actions, const Targets& targets)
    : QObject(&window), m_window(window), m_targets(targets) {
    connect(&actions.at("help.guide"), &QAction::triggered, this, &HelpCommands::showHelp);
    connect(&actions.at("help.about"), &QAction::triggered, this, &HelpCommands::showAbout);
}

/// Of the block at the caret if a text has the focus, else of the selection.
const Kind* HelpCommands::kindForHelp() const {
    if (!m_targets.document.isOpen() || !m_targets.document.loaded() || m_targets.help.hasFocus()) return nullptr;
    if (m_targets.text.hasKeyboard()) return m_targets.text.kindAtCaret();
    if (m_targets.selection.empty()) return nullptr;
    const LoadedProject& loaded = *m_targets.document.loaded();
    const std::string path = m_targets.selection.current();
    if (path.empty()) return loaded.registry->find("settings");
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place) return nullptr;
    const Part* part = place->part ? place->part : place->instance;
    return part ? part->kind : nullptr;
}

void HelpCommands::showHelp() {
    // Before the dock can take the focus.
    const QString construct =
        m_targets.document.isOpen() && m_targets.text.hasKeyboard() ? m_targets.text.constructAtCaret() : QString();
    const Kind* kind = kindForHelp();
    m_targets.layouts.raise(QStringLiteral("guide"));
    if (construct.isEmpty()) m_targets.help.showKind(kind);
    else m_targets.help.showConstruct(construct);
}

void HelpCommands::showAbout() {
    QMessageBox about(&m_window);
    about.setObjectName(QStringLiteral("about"));
    about.setWindowTitle(tr("About Trundle"));
    about.setTextFormat(Qt::RichText);
    about.setText(tr("<p style='font-size:%1px; font-weight:600'>Trundle %2</p>")
                      .arg(QString::number(scaledToFont(18)), QApplication::applicationVersion()));
    setHtmlInformation(
        about,
        tr("<p>Describe robots, run them in 3D, measure, repeat.</p>"
           "<p>Free software under the GNU General Public License, version 3 or later. The headers for controllers "
           "(<i>core/sdk</i>) are under the 2-clause BSD licence.</p>"
           "<p>With Qt %1, QScintilla, the Open Dynamics Engine, OpenSceneGraph, assimp and Eigen. Fonts: Inter and JetBrains "
           "Mono, SIL Open Font License.</p>"
           "<p>Implements and extends the simulator of James Ashcraft’s thesis <i>Design and Development of an Expandable "
           "Robot Simulation Framework</i> (2011).</p>")
            .arg(QLatin1String(qVersion())));
    about.exec();
}

} // namespace trundle
