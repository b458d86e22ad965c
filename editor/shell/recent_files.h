#pragma once
#include <QStringList>

namespace trundle {

/// Recently opened files, newest first, saved in the settings. Files that do not exist are left out.
[[nodiscard]] QStringList recentFiles();
void addRecentFile(const QString& path);

/// Where files of the user's own are saved at first: Documents, else the home folder.
[[nodiscard]] QString documentsFolder();

/// The sample experiments installed with Trundle, in a recommended order for newcomers.
struct Sample {
    QString path, title, description, picture;
};
[[nodiscard]] QList<Sample> sampleExperiments(const QString& configs);
/// Robots and arenas installed with Trundle.
[[nodiscard]] QList<Sample> sampleParts(const QString& configs);

} // namespace trundle
