#pragma once
// Fixture: a visible Scene tree over a document in a temporary folder, with the real application.

#include <QFile>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/application.h"
#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_panel.h"
#include "editor/outline/outline_view.h"
#include "eventually.h"

namespace trundle {

struct OutlineFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;
    ObjectMarks marks;
    ObjectEdits edits{document, selection, marks};
    std::unique_ptr<OutlinePanel> panel = std::make_unique<OutlinePanel>(document, selection, marks, edits);
    QStringList refusals;

    OutlineFixture() {
        QObject::connect(&document, &Document::selectionRequested, &selection, &Selection::set);
        document.edits().restoreSelection(selection);
        QObject::connect(&document, &Document::refused, &selection, [this](const QString& reason) { refusals.append(reason); });
        panel->resize(320, 700);
        panel->show();
        (void)QTest::qWaitForWindowExposed(panel.get(), kTimeoutMs);
    }

    bool write(const char* name, const QByteArray& text) const {
        QFile file(folder.filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    }
    bool open(const QByteArray& text, const char* name = "trial.sim") {
        return write(name, text) && document.opening().open(folder.filePath(QLatin1String(name)).toStdString()).ok();
    }
    bool openSample(const char* name) {
        return document.opening().open(std::string(TRUNDLE_SOURCE_DIR "/configs/experiments/") + name).ok();
    }

    OutlineModel& model() { return panel->model(); }
    OutlineView& tree() { return panel->tree(); }
    QLineEdit& filter() { return *panel->findChild<QLineEdit*>(QStringLiteral("outlineFilter")); }
    QModelIndex at(const char* path) { return model().indexOf(path); }
    /// The text of the opened file, or of the n-th file.
    QByteArray text(std::size_t file = 0) const {
        return QByteArray::fromStdString(*document.texts().text(document.texts().files().at(file)));
    }
    QString errors() const {
        QStringList all;
        for (const Diagnostic& d : document.loaded()->diagnostics.all())
            if (d.severity != Severity::Hint) all.append(QString::fromStdString(d.message));
        return all.join(QLatin1Char('\n'));
    }
    QString selected() const {
        QStringList all;
        for (const std::string& path : selection.paths()) all.append(QString::fromStdString(path));
        return all.join(QLatin1Char(' '));
    }
    /// The rows selected in the tree widget.
    QString marked() {
        QStringList all;
        for (const QModelIndex& index : tree().selectionModel()->selectedRows())
            all.append(QString::fromStdString(model().rowAt(index)->path));
        all.sort();
        return all.join(QLatin1Char(' '));
    }
    /// The visible rows, indented: "Robots
    ///  robot0
    /// ".
    QString rows(const QModelIndex& parent = {}, int depth = 0) {
        QString text;
        for (int row = 0; row < model().rowCount(parent); ++row) {
            const QModelIndex index = model().index(row, 0, parent);
            text += QString(depth, QLatin1Char(' ')) + index.data().toString() + QLatin1Char('\n');
            if (tree().isExpanded(index)) text += rows(index, depth + 1);
        }
        return text;
    }
    void click(const QModelIndex& index, Qt::KeyboardModifiers keys = {}, int column = 0) {
        tree().scrollTo(index);
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, keys, tree().visualRect(index.siblingAtColumn(column)).center());
    }
    /// Presses F2, types the new name and presses Return.
    void rename(const QModelIndex& index, const char* name) {
        click(index);
        QTest::keyClick(&tree(), Qt::Key_F2);
        auto* line = tree().findChild<QLineEdit*>(QStringLiteral("renameEditor"));
        if (!line) return;
        line->selectAll();
        QTest::keyClicks(line, QLatin1String(name));
        QTest::keyClick(line, Qt::Key_Return);
        QCoreApplication::processEvents(); // the delegate commits its text through the event loop
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
};

/// A rover whose names are used by joints and devices, and two instances of it.
inline const QByteArray kRovers = R"(Tick = 0.01
RobotConfig Rover {
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 }
    Box bumper { Size=0.02,0.2,0.04 Pos=0.16,0,0.07 Mass=0.05 }
  }
  Body leftWheel  { Pos=0,0.1,0.05  Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Body rightWheel { Pos=0,-0.1,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge leftAxle  { Parent=chassis Child=leftWheel  Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 }
  Encoder count   { Joint=leftAxle }
}
StaticConfig Floor { Plane floor { } }
Static arena { Config=Floor }
Robot robot0 { Config=Rover Pos=0,0,0 }   // the first
Robot robot1 { Config=Rover Pos=1,0,0 }
PoseLog path { Robot=robot0 Interval=0.1 }
)";

} // namespace trundle
