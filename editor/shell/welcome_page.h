#pragma once
#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>

#include "editor/widgets/actions.h"

namespace trundle {

/// What the window shows while nothing is open: samples as pictures, new things from templates, files opened lately.
class WelcomePage final : public QWidget {
    Q_OBJECT
public:
    WelcomePage(const Actions& actions, const QString& configs, QWidget* parent = nullptr);

    void refresh(); ///< the list of recent files

Q_SIGNALS:
    void openWanted(const QString& path);
    void tryWanted(const QString& path); ///< a robot or an arena

private:
    QWidget* makeStart(const Actions& actions);
    QWidget* makeSamples(const QString& configs);

    QVBoxLayout* m_recent = nullptr;
};

} // namespace trundle
