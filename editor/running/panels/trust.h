#pragma once
#include <string>

#include <QStringList>

namespace trundle {

/// Folders whose modules may run inside the program, saved in QSettings under "trustedFolders". The program's own modules are
/// always trusted.
class TrustedFolders {
public:
    [[nodiscard]] static QStringList all();
    /// Whether a folder is one of them or below one.
    [[nodiscard]] static bool covers(const QString& folder);
    static void add(const QString& folder);
    static void remove(const QString& folder);
};

} // namespace trundle
