#include "editor/widgets/actions.h"

#include <QSettings>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

QString settingOf(const char* id) { return QStringLiteral("shortcuts/") + QLatin1String(id); }

} // namespace

Actions::Actions(std::span<const ActionRow> table, QObject* parent) : QObject(parent), m_table(table) {
    const QSettings settings;
    for (const ActionRow& row : m_table) {
        auto* action = new QAction(tr(row.text), this);
        action->setObjectName(QLatin1String(row.id));
        action->setCheckable(row.checkable);
        action->setIcon(themedIcon(QLatin1String(row.icon)));
        const QVariant own = settings.value(settingOf(row.id));
        action->setShortcut(own.isValid() ? QKeySequence(own.toString(), QKeySequence::PortableText)
                                          : QKeySequence(QLatin1String(row.shortcut), QKeySequence::PortableText));
        action->setStatusTip(tr(row.help));
        m_actions.emplace(row.id, action);
        connect(action, &QAction::changed, this, [action, help = tr(row.help)] {
            QString tip = action->text().remove(QLatin1Char('&')).remove(QStringLiteral("…"));
            if (!action->shortcut().isEmpty())
                tip += QStringLiteral("  ") + action->shortcut().toString(QKeySequence::NativeText);
            tip += QLatin1Char('\n') + help;
            if (action->toolTip() != tip) action->setToolTip(tip);
        });
        Q_EMIT action->changed();
    }
}

QAction& Actions::at(const char* id) const {
    const auto it = m_actions.find(std::string_view(id));
    if (it == m_actions.end()) qFatal("no action %s", id);
    return *it->second;
}

void Actions::setShortcut(const char* id, const QKeySequence& keys) {
    at(id).setShortcut(keys);
    QSettings().setValue(settingOf(id), keys.toString(QKeySequence::PortableText));
}

void Actions::resetShortcut(const char* id) {
    QSettings().remove(settingOf(id));
    for (const ActionRow& row : m_table)
        if (std::string_view(row.id) == id)
            at(id).setShortcut(QKeySequence(QLatin1String(row.shortcut), QKeySequence::PortableText));
}

} // namespace trundle
