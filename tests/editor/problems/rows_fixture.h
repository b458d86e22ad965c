#pragma once
// A document, problems, and the rows of a list of them; for the tests of that list.

#include <filesystem>
#include <fstream>

#include <QAbstractItemModel>
#include <QTemporaryDir>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/problems/problems_model.h"

namespace trundle {

/// A document of an experiment in a folder of its own.
struct RowsFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;

    [[nodiscard]] std::string path(const char* name) const {
        return (std::filesystem::path(folder.path().toStdString()) / name).string();
    }
    bool open(const std::string& text) {
        std::filesystem::create_directories(path("configs"));
        std::ofstream(path("configs/main.sim"), std::ios::binary) << text;
        return document.opening().open(path("configs/main.sim")).ok();
    }
};

inline Diagnostic problem(const char* message, SourceRange range, Severity severity = Severity::Error) {
    Diagnostic d;
    d.severity = severity;
    d.code = Code::OddInertia;
    d.message = message;
    d.range = range;
    return d;
}

inline QByteArray messagesOf(const QAbstractItemModel& model) {
    QStringList all;
    for (int i = 0; i < model.rowCount(); ++i) all << model.index(i, ProblemsModel::Message).data().toString();
    return all.join(QStringLiteral(", ")).toUtf8();
}

} // namespace trundle
