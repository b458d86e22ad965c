#include "house/include_rules.h"

#include <QRegularExpression>

namespace trundle {
namespace {

QStringList words(const QString& cell) {
    QStringList all = cell.split(QRegularExpression("[\\s,]+"), Qt::SkipEmptyParts);
    all.removeAll("-");
    return all;
}

bool isWithin(const QString& folder, const QString& outer) { return folder == outer || folder.startsWith(outer + '/'); }

/// The path of a header that is included by its path below `core`, or below `app`.
QString pathOf(const QString& file, const QString& included, const QStringList& mayInclude) {
    const QString first = included.section('/', 0, 0);
    const bool ofPrograms = file.startsWith("app/") && (first == file.section('/', 1, 1) || mayInclude.contains("app/" + first));
    return (ofPrograms ? "app/" : "core/") + included;
}

} // namespace

IncludeRules IncludeRules::fromMarkdown(const QString& text) {
    IncludeRules rules;
    static const QRegularExpression row("^\\|\\s*((?:core|app|editor)/[\\w/]+|plugins)\\s*\\|([^|]*)\\|([^|]*)\\|\\s*$",
                                        QRegularExpression::MultilineOption);
    for (auto match = row.globalMatch(text); match.hasNext();) {
        const auto cells = match.next();
        const QStringList foreign = words(cells.captured(3));
        rules.m_rules[cells.captured(1)] = {words(cells.captured(2)), QSet<QString>(foreign.begin(), foreign.end())};
    }
    return rules;
}

QString IncludeRules::folderOf(const QString& path) const {
    QString best;
    for (auto rule = m_rules.begin(); rule != m_rules.end(); ++rule)
        if (path.startsWith(rule.key() + '/') && rule.key().size() > best.size()) best = rule.key();
    return best;
}

QString IncludeRules::violation(const QString& file, const QString& included, bool inAngles) const {
    const QString folder = folderOf(file);
    if (folder.isEmpty()) return "no row of the table holds this file";
    const FolderRule rule = m_rules.value(folder);
    const QString from = inAngles ? libraryOf(included) : QString();
    if (inAngles && from != "sdk") {
        if (from.isEmpty()) return "<" + included + "> is of no library that the table knows";
        return rule.foreign.contains(from) ? QString() : folder + " must not use " + from;
    }
    // An include without a folder refers to a file in the same folder.
    if (!inAngles && !included.contains('/')) return {};
    const QString path = inAngles                         ? QString("core/sdk/x.h")
                         : included.startsWith("editor/") ? included
                                                          : pathOf(file, included, rule.mayInclude);
    const QString target = folderOf(path);
    if (isWithin(target, folder)) return {};
    for (const QString& allowed : rule.mayInclude) {
        if (allowed == included || isWithin(target, allowed) || isWithin(target, "core/" + allowed)) return {};
    }
    return folder + " must not use " + (inAngles ? "sdk" : included);
}

QString IncludeRules::linkViolation(const QString& folder, const QString& library) const {
    for (auto rule = m_rules.begin(); rule != m_rules.end(); ++rule) {
        // A library contains all folders below its own, so it may link what any of them may include.
        if (rule.key() != "core/" + folder && !rule.key().startsWith("core/" + folder + '/')) continue;
        for (const QString& allowed : rule.value().mayInclude)
            if (allowed.section('/', 0, 0) == library) return {};
    }
    return library == folder ? QString() : "core/" + folder + " must not link trundle::" + library;
}

QString libraryOf(const QString& header) {
    static const QRegularExpression qt("^Q[A-Z]\\w*|^Qt\\w+(/.*)?$");
    static const QRegularExpression cHeader(
        "^(sys/.+|linux/.+|netinet/.+|arpa/"
        ".+|malloc\\.h|unistd\\.h|semaphore\\.h|fcntl\\.h|dlfcn\\.h|execinfo\\.h|poll\\.h|signal\\.h|"
        "pthread\\.h|sched\\.h|spawn\\.h|elf\\.h|link\\.h|termios\\.h|dirent\\.h|pwd\\.h)$");
    if (header.startsWith("trundle/")) return "sdk";
    if (header.startsWith("Eigen/")) return "eigen";
    if (header.startsWith("ode/")) return "ode";
    if (header.startsWith("assimp/")) return "assimp";
    if (header.startsWith("nlohmann/")) return "json";
    if (header.startsWith("CLI/")) return "cli11";
    if (header.startsWith("osg")) return "osg";
    if (header.startsWith("Qsci/")) return "qscintilla";
    if (header == "png.h" || header == "turbojpeg.h") return "pictures";
    if (header.startsWith("EGL/") || header.startsWith("GL/")) return "gl";
    if (qt.match(header).hasMatch()) return "qt";
    if (cHeader.match(header).hasMatch()) return "posix";
    if (header == "stdint.h" || header == "stddef.h" || !header.contains(QRegularExpression("[./]"))) return "std";
    return {};
}

QList<IncludeLine> includesOf(const QString& text) {
    static const QRegularExpression include("^[ \\t]*#[ \\t]*include[ \\t]*(?:<([^>\\n]+)>|\"([^\"\\n]+)\")",
                                            QRegularExpression::MultilineOption);
    QList<IncludeLine> found;
    for (auto match = include.globalMatch(text); match.hasNext();) {
        const auto hit = match.next();
        const bool inAngles = hit.hasCaptured(1);
        found.append(
            {int(text.left(hit.capturedStart()).count('\n')) + 1, inAngles ? hit.captured(1) : hit.captured(2), inAngles});
    }
    return found;
}

} // namespace trundle
