#pragma once
#include <QMap>
#include <QSet>
#include <QString>
#include <QStringList>

namespace trundle {

/// The includes that one row of the table in core/README.md allows.
struct FolderRule {
    QStringList mayInclude; ///< folders of core, or single headers "project/loading/sources.h"
    QSet<QString> foreign;  ///< "std", "qt", ...
};

/// The table "Who may include whom" of core/README.md, by folder.
class IncludeRules {
public:
    /// Reads the rows whose first cell begins with core/, app/ or plugins.
    [[nodiscard]] static IncludeRules fromMarkdown(const QString& text);

    [[nodiscard]] bool isEmpty() const { return m_rules.isEmpty(); }
    [[nodiscard]] QStringList folders() const { return m_rules.keys(); }
    /// The longest folder of the table that contains the file; empty if there is none.
    [[nodiscard]] QString folderOf(const QString& path) const;
    /// Why `file` must not have this #include line; empty if it may.
    [[nodiscard]] QString violation(const QString& file, const QString& included, bool inAngles) const;
    /// Why the library of core/<folder> must not link trundle::<library>; empty if it may.
    [[nodiscard]] QString linkViolation(const QString& folder, const QString& library) const;

private:
    QMap<QString, FolderRule> m_rules;
};

/// "std", "posix", "qt" ... for an #include from outside the project; "sdk" for <trundle/...>; empty if unknown.
[[nodiscard]] QString libraryOf(const QString& header);

struct IncludeLine {
    int line = 0;
    QString header;
    bool inAngles = false;
};
[[nodiscard]] QList<IncludeLine> includesOf(const QString& text);

} // namespace trundle
