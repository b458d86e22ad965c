#pragma once
// Helpers that run trundle-cli and collect its exit code and output.

#include <QStringDecoder>
#include <QtTest>

#include "base/platform/process.h"

struct Outcome {
    int code = -1; ///< -2: it crashed or timed out
    QByteArray out, err;
};

inline QString programPath() { return QStringLiteral(TRUNDLE_BINARY_DIR "/bin/trundle-cli"); }
inline QString configPath(const QString& name) { return QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/") + name; }

/// A sanitizer's runtime handles crashes before the program does, unless these options are set.
inline const QString kOwnHandlers = QStringLiteral("handle_segv=0:handle_abort=0:handle_sigill=0:handle_sigbus=0:handle_sigfpe=0:"
                                                   "use_sigaltstack=0:detect_leaks=0:allocator_may_return_null=1");

/// Runs `program` (a path, or a name searched in PATH) until it ends, in `folder` if given. Does not use QProcess: that starts
/// programs with clone(), which crashes ThreadSanitizer of clang 14.
inline Outcome callProgram(const QString& program, const QStringList& arguments, const QString& folder = {},
                           double seconds = 120) {
    trundle::ProcessRequest request;
    const bool isPath = program.contains('/');
    request.program = isPath ? program.toStdString() : "/usr/bin/env";
    if (!isPath) request.arguments.push_back(program.toStdString());
    for (const QString& argument : arguments) request.arguments.push_back(argument.toStdString());
    request.folder = folder.toStdString();
    request.seconds = seconds;
    request.errorBytes = request.outputBytes;
    const auto result = trundle::runProcess(request);
    if (!result) return {-2, {}, QByteArray::fromStdString(result.error().message)};
    const trundle::ProcessResult& r = result.value();
    return {r.end == trundle::ProcessEnd::Exited ? r.exitCode : -2, QByteArray::fromStdString(r.output),
            QByteArray::fromStdString(r.errors)};
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

/// Every text file under configs/.
inline QStringList allConfigs() {
    QStringList files;
    QDirIterator at(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs"), {"*.sim", "*.txt"}, QDir::Files, QDirIterator::Subdirectories);
    while (at.hasNext()) files << at.next();
    files.sort();
    return files;
}

/// Exit code and output, as the message of a failed comparison.
inline QByteArray shown(const Outcome& outcome) {
    return "exit code " + QByteArray::number(outcome.code) + "\n--- stdout\n" + outcome.out + "\n--- stderr\n" + outcome.err;
}

/// A file name that contains terminal control sequences.
inline const QByteArray kHostileName = "\x1b]0;mine\x07\xc2\x9b"
                                       "2J\xe2\x80\xae"
                                       "mis.sim";

/// The first control character that a terminal would obey, described; empty if there is none.
inline QByteArray controlCharacters(const QByteArray& bytes) {
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString text = decoder(bytes);
    if (decoder.hasError()) return "no UTF-8";
    for (const QChar c : text) {
        const bool control = (c.category() == QChar::Other_Control && c != u'\n' && c != u'\t') ||
                             (c >= QChar(0x202a) && c <= QChar(0x202e)) || (c >= QChar(0x2066) && c <= QChar(0x2069));
        if (control) return "U+" + QByteArray::number(c.unicode(), 16);
    }
    return {};
}
inline QByteArray controlCharacters(const Outcome& outcome) {
    return controlCharacters(outcome.err) + controlCharacters(outcome.out);
}
