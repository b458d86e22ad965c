#pragma once
// trundle-cli as a test calls it.

#include <QtTest>

struct Outcome {
    int code = -1; ///< -2: it crashed or did not end
    QByteArray out, err;
};

inline QString programPath() { return QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle-cli"); }
inline QString configPath(const QString& name) { return QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/") + name; }

/// With no modifier Qt begins a program by vfork, which ThreadSanitizer of clang 14 does not survive.
struct Program : QProcess {
    Program() { setChildProcessModifier([] {}); }
};

/// Runs `program` to its end, in `folder` where one is given.
inline Outcome callProgram(const QString& program, const QStringList& arguments, const QString& folder = {}) {
    Program process;
    if (!folder.isEmpty()) process.setWorkingDirectory(folder);
    process.start(program, arguments);
    Outcome outcome;
    if (!process.waitForFinished(120'000)) {
        process.kill();
        process.waitForFinished();
        return {-2, process.readAllStandardOutput(), process.readAllStandardError()};
    }
    outcome.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2;
    outcome.out = process.readAllStandardOutput();
    outcome.err = process.readAllStandardError();
    return outcome;
}

inline Outcome cli(const QStringList& arguments, const QString& folder = {}) {
    return callProgram(programPath(), arguments, folder);
}

inline QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot read " + path.toUtf8() + ")");
}

inline bool writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

/// Every text under configs/.
inline QStringList allConfigs() {
    QStringList files;
    QDirIterator at(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs"), {"*.sim", "*.txt"}, QDir::Files, QDirIterator::Subdirectories);
    while (at.hasNext()) files << at.next();
    files.sort();
    return files;
}

/// What a failed comparison should show.
inline QByteArray shown(const Outcome& outcome) {
    return "exit code " + QByteArray::number(outcome.code) + "\n--- stdout\n" + outcome.out + "\n--- stderr\n" + outcome.err;
}
