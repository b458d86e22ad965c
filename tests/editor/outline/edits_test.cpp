// Editing in the Scene tree: rename, delete, clipboard and order.

#include <QClipboard>
#include <QDropEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>

#include "eventually.h"
#include "outline_fixture.h"

using namespace trundle;

class EditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aNewNameReachesEveryReference();
    void rejectsDuplicateName();
    void deletesWhatIsSelected();
    void keepsReferencedObjects();
    void deletesDependentsOnRequest();
    void doesNotAskInReadOnlyWindow();
    void reportsInvalidNameWhileTyping();
    void copyAndPasteGiveTheBlockBack();
    void pastesWhereItFits();
    void rejectsTextWithoutBlocks_data();
    void rejectsTextWithoutBlocks();
    void duplicatesDoNotOverlapOriginals();
    void aDropPutsRowsInAnotherOrder();
    void dropsBesideRowThatCannotContainIt();
    void aDropMovesAGeomToAnotherBody();
    void dropsIntoFile();
    void rejectsMisfittingDrop();
    void theMenuOfAGridWritesItOut();
    void menuOpensTextAndConfig();
    void undoGivesTheSameBytes();
    void undoKeepsTheSelection();
};

void EditsTest::aNewNameReachesEveryReference() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.rename(o.at("robot0"), "scout");
    QVERIFY2(o.text().contains("Robot scout { Config=Rover Pos=0,0,0 }   // the first"), o.text());
    QVERIFY(o.text().contains("PoseLog path { Robot=scout Interval"));
    QCOMPARE(o.selected(), QStringLiteral("scout"));
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Rename robot0 to scout"));

    o.selection.select("scout.leftAxle"); // selected through the robot, but the axle belongs to the config
    o.rename(o.at("scout.leftAxle"), "port");
    QVERIFY2(o.text().contains("Hinge port  {"), o.text() + qPrintable(o.refusals.join(QLatin1Char(' '))));
    QVERIFY(o.text().contains("Encoder count   { Joint=port }"));
    QCOMPARE(o.selected(), QStringLiteral("scout.port"));
    QCOMPARE(o.errors(), QString());
    o.document.edits().undo();
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::rejectsDuplicateName() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.rename(o.at("robot0"), "robot1");
    QCOMPARE(o.text(), kRovers);
    QCOMPARE(o.refusals.size(), 1);
    QVERIFY2(o.refusals[0].contains(QStringLiteral("robot1")), qPrintable(o.refusals[0]));
    o.rename(o.at("robot0"), "robot0"); // an unchanged name makes no edit
    QVERIFY(o.document.edits().history().entries().empty());
    QVERIFY(!o.edits.rename("robot0", "9 lives").ok());
    QVERIFY(!o.edits.rename("robot0", "").ok());
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::deletesWhatIsSelected() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.click(o.at("robot1"));
    QTest::keyClick(&o.tree(), Qt::Key_Delete);
    QVERIFY(!o.text().contains("robot1"));
    QVERIFY(!o.at("robot1").isValid());
    QVERIFY(o.selection.empty());
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Delete robot1"));
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
    o.selection.set({"robot1", "arena", "path"});
    o.edits.removeSelected();
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Delete 3 objects"));
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::keepsReferencedObjects() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    QVERIFY(!o.edits.remove({"robot0"}).ok());
    QCOMPARE(o.text(), kRovers);
    QCOMPARE(o.refusals.size(), 1);
    QVERIFY2(o.refusals[0].contains(QStringLiteral("path")), qPrintable(o.refusals[0]));
    o.selection.select("");
    QTest::keyClick(&o.tree(), Qt::Key_Delete);
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::deletesDependentsOnRequest() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    const auto askFor = [&](const char* path) {
        o.click(o.at(path));
        QTest::keyClick(&o.tree(), Qt::Key_Delete);
        QWidget* asked = QApplication::activeModalWidget();
        return asked && asked->objectName() == QStringLiteral("deleteQuestion") ? qobject_cast<QMessageBox*>(asked) : nullptr;
    };
    QMessageBox* question = askFor("robot0");
    QVERIFY(question);
    QVERIFY2(question->text().contains(QStringLiteral("path")), qPrintable(question->text()));
    question->button(QMessageBox::Cancel)->click();
    QCOMPARE(o.text(), kRovers);
    question = askFor("robot0");
    QVERIFY(question);
    QTest::keyClick(question, Qt::Key_Return);
    QVERIFY2(!o.text().contains("robot0") && !o.text().contains("PoseLog"), o.text().constData());
    QCOMPARE(o.errors(), QString());
    QCOMPARE(o.document.edits().history().entries().size(), std::size_t(1));
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);

    // Cut asks the same question, and puts both on the clipboard.
    o.selection.select("robot0");
    o.edits.cutSelected();
    question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    QVERIFY(question);
    QTest::keyClick(question, Qt::Key_Return);
    QVERIFY2(!o.text().contains("robot0") && !o.text().contains("PoseLog"), o.text().constData());
    QVERIFY(o.edits.paste({}).ok());
    QVERIFY2(o.text().contains("Robot robot0") && o.text().contains("PoseLog path"), o.text().constData());
    QCOMPARE(o.errors(), QString());
}

void EditsTest::doesNotAskInReadOnlyWindow() {
    OutlineFixture first, o;
    QVERIFY(first.open(kRovers));
    QVERIFY(o.document.opening().open(first.document.path()).ok());
    QVERIFY(o.document.access().isReadOnly());
    o.click(o.at("robot0"));
    QTest::keyClick(&o.tree(), Qt::Key_Delete);
    o.edits.cutSelected();
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(o.refusals.size(), 2);
    for (const QString& reason : o.refusals) QVERIFY2(reason.contains(QStringLiteral("has it read-only")), qPrintable(reason));
}

void EditsTest::reportsInvalidNameWhileTyping() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.click(o.at("robot1"));
    QTest::keyClick(&o.tree(), Qt::Key_F2);
    auto* line = o.tree().findChild<QLineEdit*>(QStringLiteral("renameEditor"));
    QVERIFY(line);
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("Runner"));
    QCOMPARE(line->toolTip(), QString());
    QTest::keyClicks(line, QStringLiteral(" 1"));
    QCOMPARE(line->text(), QStringLiteral("Runner 1"));
    QVERIFY2(line->toolTip().contains(QStringLiteral("cannot be a name")), qPrintable(line->toolTip()));
    QTest::keyClick(line, Qt::Key_Return);
    EVENTUALLY_EQUAL(o.refusals.size(), 1);
    QVERIFY2(o.refusals[0].contains(QStringLiteral("cannot be a name")), qPrintable(o.refusals[0]));
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::copyAndPasteGiveTheBlockBack() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.selection.select("robot1");
    o.edits.copySelected();
    QCOMPARE(QGuiApplication::clipboard()->text().trimmed(), QStringLiteral("Robot robot1 { Config=Rover Pos=1,0,0 }"));
    o.edits.pasteAtSelected();
    QCOMPARE(o.selected(), QStringLiteral("robot2"));
    QVERIFY2(o.text().contains("Robot robot2 { Config=Rover Pos="), o.text());
    const Vec3 at = o.document.loaded()->experiment->robots.back().pose.position; // beside the original, on the floor
    QVERIFY(at != Vec3(1, 0, 0) && (at - Vec3(1, 0, 0)).norm() < 0.5 && at.z() == 0);
    QCOMPARE(o.document.edits().history().entries().size(), std::size_t(1));
    QCOMPARE(o.errors(), QString());
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);

    o.selection.select("robot1");
    o.edits.cutSelected();
    QVERIFY(!o.text().contains("robot1"));
    o.edits.pasteAtSelected();
    QVERIFY(o.text().contains("Robot robot1 { Config=Rover Pos=1,0,0 }"));
    QCOMPARE(o.errors(), QString());
}

void EditsTest::pastesWhereItFits() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    QGuiApplication::clipboard()->setText(QStringLiteral("Sphere knob { Radius=0.01 Mass=0.01 }"));
    o.selection.select("robot0.chassis.bumper"); // a geom has no children: the body around it is the parent
    o.edits.pasteAtSelected();
    QCOMPARE(o.selected(), QStringLiteral("robot0.chassis.knob"));
    QVERIFY(o.at("RobotConfig.Rover.chassis.knob").isValid());
    o.selection.select("RobotConfig.Rover.leftWheel");
    o.edits.pasteAtSelected();
    QVERIFY(o.at("RobotConfig.Rover.leftWheel.knob").isValid());
    o.selection.clear();
    o.edits.pasteAtSelected();
    QVERIFY2(o.refusals.last().contains(QStringLiteral("Body")), qPrintable(o.refusals.last()));

    QGuiApplication::clipboard()->setText(
        QStringLiteral("Robot other { Config=Rover Pos=3,0,0 }\nRobot another { Config=Rover Pos=4,0,0 }"));
    o.selection.select("robot0.chassis");
    o.edits.pasteAtSelected();
    QCOMPARE(o.selected(), QStringLiteral("other another"));
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Paste 2 objects"));
    QCOMPARE(o.errors(), QString());
}

void EditsTest::rejectsTextWithoutBlocks_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    QTest::newRow("prose") << "Dear all, the meeting is at ten."
                           << "cannot be inserted";
    QTest::newRow("setting") << "Tick = 0.02"
                             << "setting";
    QTest::newRow("open block") << "Robot robot9 {"
                                << "line 1";
    QTest::newRow("nothing") << " \n\t"
                             << "no text";
    QTest::newRow("comment") << "// only this"
                             << "no block";
    QTest::newRow("no place") << "Tick { }"
                              << "Tick";
}

void EditsTest::rejectsTextWithoutBlocks() {
    QFETCH(QString, text);
    QFETCH(QString, reason);
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    QGuiApplication::clipboard()->setText(text);
    o.selection.select("robot0");
    o.edits.pasteAtSelected();
    if (o.refusals.isEmpty()) { // accepted as a block of an unknown kind, which is a problem of the text
        QVERIFY2(o.errors().contains(reason), qPrintable(o.errors()));
        return;
    }
    QCOMPARE(o.text(), kRovers);
    QVERIFY2(o.refusals[0].contains(reason), qPrintable(o.refusals[0]));
}

void EditsTest::duplicatesDoNotOverlapOriginals() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.selection.set({"robot0", "robot1"});
    o.edits.duplicateSelected();
    QCOMPARE(o.selection.paths().size(), std::size_t(2));
    QCOMPARE(o.errors(), QString());
    const auto& robots = o.document.loaded()->experiment->robots;
    QCOMPARE(robots.size(), std::size_t(4));
    for (const RobotSpec& a : robots)
        for (const RobotSpec& b : robots)
            if (&a != &b)
                QVERIFY2((a.pose.position - b.pose.position).norm() > 0.3,
                         qPrintable(QString::fromStdString(a.name + " " + b.name)));
}

void EditsTest::aDropPutsRowsInAnotherOrder() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    const std::unique_ptr<QMimeData> mime(o.model().mimeData({o.at("robot1")}));
    QCOMPARE(mime->text().trimmed(), QStringLiteral("Robot robot1 { Config=Rover Pos=1,0,0 }"));
    QVERIFY(o.model().canDropMimeData(mime.get(), Qt::MoveAction, 0, 0, o.at("robot0").parent()));
    QVERIFY(o.model().dropMimeData(mime.get(), Qt::MoveAction, 0, 0, o.at("robot0").parent()));
    QCOMPARE(o.at("robot1").row(), 0);
    QVERIFY(o.text().indexOf("Robot robot1") < o.text().indexOf("Robot robot0"));
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Reorder robot1"));
    QCOMPARE(o.errors(), QString());
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::dropsBesideRowThatCannotContainIt() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    o.tree().reveal(o.at("robot0"));
    const QRect first = o.tree().visualRect(o.at("robot0"));
    const std::unique_ptr<QMimeData> mime(o.model().mimeData({o.at("robot1")}));
    const auto dropAt = [&](int y) {
        const QPoint at(first.center().x(), y);
        QDragEnterEvent enter(at, Qt::MoveAction | Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(o.tree().viewport(), &enter);
        QDragMoveEvent move(at, Qt::MoveAction | Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
        move.setDropAction(Qt::MoveAction);
        QCoreApplication::sendEvent(o.tree().viewport(), &move);
        QVERIFY(move.isAccepted());
        QDropEvent drop(at, Qt::MoveAction | Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
        drop.setDropAction(Qt::MoveAction);
        QCoreApplication::sendEvent(o.tree().viewport(), &drop);
        QVERIFY(drop.isAccepted());
    };
    dropAt(first.center().y() - 2);
    QCOMPARE(o.at("robot1").row(), 0);
    dropAt(o.tree().visualRect(o.at("robot0")).center().y() + 2);
    QCOMPARE(o.at("robot1").row(), 1);
    QCOMPARE(o.errors(), QString());
}

void EditsTest::aDropMovesAGeomToAnotherBody() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    const std::unique_ptr<QMimeData> mime(o.model().mimeData({o.at("RobotConfig.Rover.chassis.bumper")}));
    QVERIFY(o.model().dropMimeData(mime.get(), Qt::MoveAction, -1, -1, o.at("RobotConfig.Rover.leftWheel")));
    QVERIFY(o.at("RobotConfig.Rover.leftWheel.bumper").isValid());
    QVERIFY(!o.at("RobotConfig.Rover.chassis.bumper").isValid());
    QCOMPARE(o.errors(), QString());
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Move bumper to leftWheel"));
    // Its pose in the world is unchanged: leftWheel is at 0,0.1,0.05.
    const auto& wheel = o.document.loaded()->experiment->robots[0].config->bodies[1];
    const Vec3 place = wheel.pose.position + wheel.geoms[1].pose.position;
    QVERIFY((place - Vec3(0.16, 0, 0.07)).norm() < 1e-9);
}

void EditsTest::dropsIntoFile() {
    OutlineFixture o, other;
    QVERIFY(o.write("paints.sim", "Material red { ColorRGB=1,0,0 }\n"));
    QVERIFY(o.open("#import paints.sim\nMaterial blue { ColorRGB=0,0,1 }\n"));
    const std::unique_ptr<QMimeData> red(o.model().mimeData({o.at("Material.red")}));
    QVERIFY(o.model().dropMimeData(red.get(), Qt::MoveAction, 2, 0, o.at("Material.red").parent())); // below blue
    QCOMPARE(o.document.edits().history().entries().size(), std::size_t(0));
    o.model().setMode(OutlineMode::ByFile);
    const std::unique_ptr<QMimeData> blue(o.model().mimeData({o.at("Material.blue")}));
    QVERIFY(o.model().dropMimeData(blue.get(), Qt::MoveAction, -1, -1, o.model().index(1, 0)));
    QCOMPARE(o.text(1), QByteArray("Material red { ColorRGB=1,0,0 }\nMaterial blue { ColorRGB=0,0,1 }\n"));
    QCOMPARE(o.text(), QByteArray("#import paints.sim\n"));
    QCOMPARE(o.document.edits().history().entries().back().name, QStringLiteral("Move blue to paints.sim"));
    QVERIFY(other.open("Material green { ColorRGB=0,1,0 }\n"));
    const std::unique_ptr<QMimeData> green(other.model().mimeData({other.at("Material.green")}));
    QVERIFY(o.model().dropMimeData(green.get(), Qt::CopyAction, -1, -1, o.model().index(1, 0)));
    QVERIFY2(o.text(1).endsWith("Material green { ColorRGB=0,1,0 }\n"), o.text(1));
    QCOMPARE(o.errors(), QString());
}

void EditsTest::rejectsMisfittingDrop() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    const std::unique_ptr<QMimeData> mime(o.model().mimeData({o.at("RobotConfig.Rover.leftAxle")}));
    QVERIFY(!o.model().canDropMimeData(mime.get(), Qt::MoveAction, -1, -1, o.at("RobotConfig.Rover.chassis")));
    QVERIFY(!o.model().dropMimeData(mime.get(), Qt::MoveAction, -1, -1, o.at("arena")));
    const std::unique_ptr<QMimeData> body(o.model().mimeData({o.at("RobotConfig.Rover.chassis")}));
    QVERIFY(!o.model().canDropMimeData(body.get(), Qt::MoveAction, -1, -1, o.at("RobotConfig.Rover.chassis")));
    QCOMPARE(o.text(), kRovers);
}

void EditsTest::theMenuOfAGridWritesItOut() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers + "Grid swarm { Config=Rover Pos=5,5,0 Count=2,2 Spacing=1 }\n"));
    o.selection.select("swarm");
    const std::unique_ptr<QMenu> menu(o.panel->contextMenu());
    auto* singles = menu->findChild<QAction*>(QStringLiteral("outline.singles"));
    QVERIFY(singles);
    singles->trigger();
    QCOMPARE(o.errors(), QString());
    QCOMPARE(o.document.loaded()->experiment->robots.size(), std::size_t(6));
    QVERIFY(!o.text().contains("Grid"));
    o.selection.select("robot0");
    const std::unique_ptr<QMenu> robots(o.panel->contextMenu());
    QVERIFY(!robots->findChild<QAction*>(QStringLiteral("outline.singles")));
}

void EditsTest::menuOpensTextAndConfig() {
    OutlineFixture o;
    QVERIFY(o.openSample("linear_motion.sim"));
    QSignalSpy jumps(o.panel.get(), &OutlinePanel::jumpTo);
    o.selection.select("robot0");
    const std::unique_ptr<QMenu> menu(o.panel->contextMenu());
    menu->findChild<QAction*>(QStringLiteral("outline.jump"))->trigger();
    QCOMPARE(jumps.count(), 1);
    QVERIFY(jumps[0][0].value<std::string>().ends_with("linear_motion.sim"));
    const TextRange range = jumps[0][1].value<TextRange>();
    QVERIFY(o.text().mid(range.begin, range.size()).startsWith("Robot robot0 {"));
    menu->findChild<QAction*>(QStringLiteral("outline.config"))->trigger();
    QCOMPARE(o.selected(), QStringLiteral("RobotConfig.SimpleRobot"));
    QVERIFY(jumps[1][0].value<std::string>().ends_with("simple_robot.sim"));
    QTest::keyClick(&o.tree(), Qt::Key_Return);
    QCOMPARE(jumps.count(), 3);
}

void EditsTest::undoGivesTheSameBytes() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    QVERIFY(o.edits.rename("robot0.chassis", "base").ok());
    QVERIFY(o.edits.duplicate({"robot1"}).ok());
    QVERIFY(o.edits.copy({"robot1", "arena"}).ok());
    QVERIFY(o.edits.paste("").ok());
    QVERIFY(o.edits.move({"robot1"}, "", "arena").ok());
    QVERIFY(o.edits.remove({"path"}).ok());
    QCOMPARE(o.errors(), QString());
    const QByteArray end = o.text();
    o.document.edits().moveTo(0);
    QCOMPARE(o.text(), kRovers);
    o.document.edits().moveTo(o.document.edits().history().entries().size());
    QCOMPARE(o.text(), end);
}

/// Under the other name or in the other place; and what undo brings back is selected as before.
void EditsTest::undoKeepsTheSelection() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    DocumentEdits& edits = o.document.edits();
    const auto moved = [&o](void (DocumentEdits::*step)()) {
        (o.document.edits().*step)();
        return o.selected();
    };
    o.selection.select("RobotConfig.Rover.chassis");
    QVERIFY(o.edits.rename("RobotConfig.Rover.chassis", "base").ok());
    QCOMPARE(o.selected(), QStringLiteral("RobotConfig.Rover.base"));
    QCOMPARE(moved(&DocumentEdits::undo), QStringLiteral("RobotConfig.Rover.chassis"));
    QCOMPARE(moved(&DocumentEdits::redo), QStringLiteral("RobotConfig.Rover.base"));
    o.selection.select("robot1"); // something else: undo leaves it
    QCOMPARE(moved(&DocumentEdits::undo), QStringLiteral("robot1"));
    o.selection.set({"robot0", "robot1"});
    QVERIFY(o.edits.remove({"path", "robot0", "robot1"}).ok());
    o.selection.clear();
    QCOMPARE(moved(&DocumentEdits::undo), QStringLiteral("robot0 robot1"));
    o.selection.clear(); // nothing appears or disappears
    QVERIFY(o.document.structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "0,0,1"}}).ok());
    QCOMPARE(moved(&DocumentEdits::undo), QString());
    o.selection.select("robot0");
    QVERIFY(o.edits.rename("robot0", "first").ok());
    QVERIFY(o.edits.rename("first", "second").ok());
    edits.moveTo(edits.history().position() - 2); // in the History panel
    QCOMPARE(o.selected(), QStringLiteral("robot0"));
}

QTEST_MAIN(EditsTest)
#include "edits_test.moc"
