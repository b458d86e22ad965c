#pragma once
#include <QStringList>

namespace trundle {

/// Files opened lately, newest first, kept in the settings. Files that are gone are left out.
[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);

/// The sample experiments that come with the program, in the order in which a newcomer should meet them.
struct Sample {
    QString path, title, description, picture;
};
[[nodiscard]] QList<Sample> sampleExperiments(const QString& configs);
/// Robots and arenas that come with the program.
[[nodiscard]] QList<Sample> sampleParts(const QString& configs);

} // namespace trundle
