#include "editor/shell/random_user.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScrollArea>
#include <QTest>

#include "editor/outline/library_model.h"
#include "editor/outline/library_panel.h"
#include "editor/outline/outline_model.h"
#include "editor/outline/outline_panel.h"
#include "editor/outline/outline_view.h"
#include "editor/properties/editors/scrub_label.h"
#include "editor/properties/editors/value_field.h"
#include "editor/properties/properties_panel.h"
#include "editor/properties/property_row.h"
#include "editor/shell/main_window.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxRows = 400;

/// All rows, including those in collapsed parents.
void listRows(OutlineModel& model, const QModelIndex& parent, std::vector<QModelIndex>& out) {
    if (model.canFetchMore(parent)) model.fetchMore(parent);
    for (int row = 0; row < model.rowCount(parent) && out.size() < kMaxRows; ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        const OutlineRow* at = model.rowAt(index);
        if (at && at->selectable && !at->path.empty()) out.push_back(index);
        listRows(model, index, out);
    }
}

template <class T> std::vector<T*> shown(QWidget& in) {
    std::vector<T*> all;
    for (T* child : in.findChildren<T*>())
        if (child->isVisible() && child->isEnabled()) all.push_back(child);
    return all;
}

/// Sends the events of a drop as a window system does.
void drop(QWidget& on, const QPointF& at, const QMimeData& mime, Qt::DropAction action) {
    QDragEnterEvent enter(at.toPoint(), action, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &enter);
    QDragMoveEvent over(at.toPoint(), action, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &over);
    QDropEvent there(at, action, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &there);
}

} // namespace

RandomUser::RandomUser(MainWindow& window, unsigned seed) : m_window(window), m_seed(seed), m_random(seed) {}

const std::vector<RandomUser::UserAction> RandomUser::kActions{
    {3, "rename", &RandomUser::rename},
    {2, "remove an object", &RandomUser::removeObject},
    {3, "duplicate", &RandomUser::duplicateObject},
    {2, "cut", &RandomUser::cutObject},
    {2, "copy", &RandomUser::copyObject},
    {3, "paste objects", &RandomUser::pasteObject},
    {4, "drag a row", &RandomUser::dragRow},
    {4, "make parts", &RandomUser::useParts},
    {3, "insert from the menu", &RandomUser::insertKind},
    {2, "insert from the Library", &RandomUser::insertFromLibrary},
    {3, "drop from the Library", &RandomUser::dropFromLibrary},
    {9, "type into a row", &RandomUser::typeValue},
    {5, "use a row's menu", &RandomUser::openRowMenu},
    {2, "turn a choice", &RandomUser::rotateChoice},
    {4, "scrub a row", &RandomUser::scrubRow},
    {6, "move by the gizmo", &RandomUser::moveByGizmo},
    {3, "turn by the gizmo", &RandomUser::rotateByGizmo},
    {2, "size by the gizmo", &RandomUser::sizeByGizmo},
    {2, "nudge", &RandomUser::nudge},
    {1, "drop to the floor", &RandomUser::dropToFloor},
    {8, "type in the text", &RandomUser::typeText},
    {3, "paste into the text", &RandomUser::pasteText},
    {3, "delete in the text", &RandomUser::deleteText},
    {3, "a command of the text", &RandomUser::commandText},
    {3, "run a while", &RandomUser::runAWhile},
    {3, "one tick", &RandomUser::stepOnce},
    {2, "run and pause", &RandomUser::runAndPause},
    {2, "push a robot", &RandomUser::pushRobot},
    {3, "keep poses", &RandomUser::keepPoses},
    {4, "reset", &RandomUser::resetRun},
    {6, "undo", &RandomUser::undo},
    {4, "redo", &RandomUser::redo},
    {1, "leap in the history", &RandomUser::leap},
    {3, "save", &RandomUser::save},
};

void RandomUser::step() {
    std::size_t all = 0;
    for (const UserAction& userAction : kActions) all += std::size_t(userAction.share);
    std::size_t at = below(all);
    for (const UserAction& userAction : kActions) {
        if (at < std::size_t(userAction.share)) {
            m_doing = userAction.name;
            (this->*userAction.go)();
            const auto isOver = [this] { // one answer may lead to the next question
                answerQuestion();
                answerDialogs();
                return QApplication::activeModalWidget() == nullptr;
            };
            // The test answers other questions from a timer; like a user, the next action waits for the answer.
            if (!QTest::qWaitFor(isOver))
                m_trouble = QStringLiteral("a dialog stays open: ") + QApplication::activeModalWidget()->objectName();
            return;
        }
        at -= std::size_t(userAction.share);
    }
}

/// Answers the question about a config that has other instances.
void RandomUser::answerQuestion() {
    while (auto* question = m_window.findChild<QMessageBox*>(QStringLiteral("shareQuestion"))) {
        // The question is repeated until an answer changes the config, so the first answers are not random: any two walks with
        // consecutive seeds start with all three answers.
        static const std::vector<const char*> buttons{"changeForAll", "makeCopy", nullptr};
        const char* name = oneOf(buttons);
        if (m_answers.empty()) name = m_seed % 2 != 0 ? "makeCopy" : nullptr;
        else if (m_seed % 2 == 0 && !m_answers.contains("changeForAll")) name = "changeForAll";
        question->setObjectName({}); // it is deleted later
        ++m_answers[name ? name : "cancel"];
        if (name) question->findChild<QAbstractButton*>(QLatin1String(name))->click();
        else question->reject();
    }
}

/// Accepts a dialog, such as that of Ring of Sensors, or leaves it.
void RandomUser::answerDialogs() {
    while (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        if (qobject_cast<QMessageBox*>(dialog)) return;
        const auto* box = dialog->findChild<QDialogButtonBox*>();
        const auto all = box ? box->buttons() : QList<QAbstractButton*>();
        const auto accepts = std::ranges::find_if(all, [&](QAbstractButton* button) {
            return box->buttonRole(button) == QDialogButtonBox::AcceptRole && button->isEnabled();
        });
        if (accepts != all.end() && below(2) == 0) (*accepts)->click();
        else dialog->reject();
    }
}

// ---- parts of the window ----

OutlinePanel& RandomUser::outline() const { return *m_window.findChild<OutlinePanel*>(); }
View& RandomUser::view() const { return m_window.viewport().views().current(); }

void RandomUser::trigger(const char* action) {
    QAction& wanted = m_window.actions().at(action);
    if (wanted.isEnabled()) wanted.trigger();
}

std::string RandomUser::number() {
    static const std::vector<std::string> shapes{"%", "%.5", "-%", "0.0%", "% cm", "0.%", "1e-%", "% deg"};
    std::string text = oneOf(shapes);
    return text.replace(text.find('%'), 1, std::to_string(below(9) + 1));
}

std::vector<QModelIndex> RandomUser::rows() const {
    std::vector<QModelIndex> all;
    listRows(outline().model(), {}, all);
    return all;
}

bool RandomUser::selectObject(const std::function<bool(const std::string&)>& fits) {
    OutlineModel& model = outline().model();
    std::vector<std::string> paths;
    for (const QModelIndex& index : rows())
        if (const std::string& path = model.rowAt(index)->path; !fits || fits(path)) paths.push_back(path);
    if (paths.empty()) return false;
    const QModelIndex index = model.indexOf(oneOf(paths));
    OutlineView& tree = outline().tree();
    tree.reveal(index);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, below(6) == 0 ? Qt::ControlModifier : Qt::NoModifier,
                      tree.visualRect(index).center());
    tree.setFocus();
    return true;
}

bool RandomUser::selectRobot() {
    const LoadedProject& loaded = *m_window.document().loaded();
    return selectObject([&](const std::string& path) {
        const auto& robots = loaded.experiment->robots;
        return std::any_of(robots.begin(), robots.end(), [&](const RobotSpec& robot) { return robot.name == path; });
    });
}

void RandomUser::choose(QMenu& menu, bool deep) {
    std::vector<QAction*> entries;
    const std::function<void(QMenu&)> list = [&](QMenu& from) {
        for (QAction* action : from.actions()) {
            if (action->menu() && deep) list(*action->menu());
            else if (!action->menu() && !action->isSeparator() && action->isEnabled()) entries.push_back(action);
        }
    };
    list(menu);
    if (!entries.empty()) oneOf(entries)->trigger();
}

// ---- in the Scene tree ----

void RandomUser::rename() {
    if (!selectObject()) return;
    OutlineView& tree = outline().tree();
    QTest::keyClick(&tree, Qt::Key_F2);
    auto* line = tree.findChild<QLineEdit*>(QStringLiteral("renameEditor"));
    if (!line) return; // a row without a name of its own
    line->selectAll();
    static const std::vector<QString> names{QStringLiteral("scout"),  QStringLiteral("hull2"),   QStringLiteral("x"),
                                            QStringLiteral("robot0"), QStringLiteral("9 lives"), QString()};
    QTest::keyClicks(line, oneOf(names) + (below(2) ? QString::number(below(40)) : QString()));
    QTest::keyClick(line, below(5) ? Qt::Key_Return : Qt::Key_Escape);
    QCoreApplication::processEvents(); // the delegate commits its text through the event loop
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void RandomUser::removeObject() {
    if (selectObject()) QTest::keyClick(&outline().tree(), Qt::Key_Delete);
}

void RandomUser::duplicateObject() {
    if (selectObject()) trigger("edit.duplicate");
}

void RandomUser::cutObject() {
    if (selectObject()) trigger("edit.cut");
}

void RandomUser::copyObject() {
    if (selectObject()) trigger("edit.copy");
}

void RandomUser::pasteObject() {
    if (selectObject()) trigger("edit.paste");
}

void RandomUser::dragRow() {
    OutlineModel& model = outline().model();
    OutlineView& tree = outline().tree();
    const std::vector<QModelIndex> all = rows();
    if (all.size() < 2) return;
    const std::unique_ptr<QMimeData> mime(model.mimeData({oneOf(all)}));
    if (!mime) return;
    // Onto a row, or between two: most positions are not allowed, so it tries several.
    for (int tries = 0; tries < 12; ++tries) {
        const QModelIndex onto = oneOf(all);
        tree.reveal(onto);
        const QRect box = tree.visualRect(onto);
        const int edge = int(below(3)) - 1; // above it, on it, below it
        const QPoint at(box.center().x(), box.center().y() + edge * (box.height() / 2 - 1));
        const QModelIndex parent = edge == 0 ? onto : onto.parent();
        if (!model.canDropMimeData(mime.get(), Qt::MoveAction, edge == 0 ? -1 : onto.row() + (edge > 0), 0, parent)) continue;
        drop(*tree.viewport(), at, *mime, Qt::MoveAction);
        return;
    }
}

void RandomUser::insertKind() {
    if (!selectObject()) return;
    for (QAction* action : m_window.menuBar()->actions()) {
        if (!action->menu() || !action->text().contains(QStringLiteral("Insert"))) continue;
        Q_EMIT action->menu()->aboutToShow();
        choose(*action->menu(), true);
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

/// With what is selected beside it: Make Part, Mirror, Repeat and Ring of Sensors, whose dialogs step() answers.
void RandomUser::useParts() {
    static const std::vector<const char*> commands{"parts.make",    "parts.mirrorX", "parts.mirrorY",
                                                   "parts.mirrorZ", "parts.repeat",  "sensors.ring"};
    if (!selectObject([](const std::string& path) { return path.find('.') != std::string::npos; })) return;
    trigger(oneOf(commands));
}

void RandomUser::insertFromLibrary() {
    auto* library = m_window.findChild<LibraryPanel*>();
    const std::vector<LibraryItem>& items = library->model().items();
    if (items.empty() || !selectObject()) return;
    library->insert(LibraryItem(oneOf(items)));
}

void RandomUser::dropFromLibrary() {
    LibraryModel& model = m_window.findChild<LibraryPanel*>()->model();
    if (model.rowCount() == 0) return;
    const std::unique_ptr<QMimeData> mime(model.mimeData({model.index(int(below(std::size_t(model.rowCount()))), 0)}));
    const QSize size = view().size();
    drop(view(), QPointF(double(below(std::size_t(size.width()))), double(below(std::size_t(size.height())))), *mime,
         Qt::CopyAction);
}

// ---- in property rows ----

void RandomUser::typeValue() {
    if (!selectObject()) return;
    auto* panel = m_window.findChild<PropertiesPanel*>();
    const std::vector<ValueField*> fields = shown<ValueField>(*panel);
    if (fields.empty()) return;
    ValueField* field = oneOf(fields);
    field->setFocus();
    field->selectAll();
    static const std::vector<std::string> odd{"",   "nonsense", "$wheelRadius", "$(1+1)", "1, 2, 3", "3 } Robot x {",
                                              "\"", "red",      "true"};
    const std::string text = below(4) == 0 ? oneOf(odd) : number();
    if (text.empty()) QTest::keyClick(field, Qt::Key_Delete);
    else QTest::keyClicks(field, QString::fromStdString(text));
    const QPointer<ValueField> there = field; // an edit can replace the rows
    QTest::keyClick(field, below(6) ? Qt::Key_Return : Qt::Key_Escape);
    if (there && there->refused()) QTest::keyClick(there.data(), Qt::Key_Escape);
    outline().tree().setFocus();
}

void RandomUser::openRowMenu() {
    if (!selectObject()) return;
    auto* panel = m_window.findChild<PropertiesPanel*>();
    const std::vector<PropertyRow*> all = shown<PropertyRow>(*panel);
    if (all.empty()) return;
    QTest::mouseClick(oneOf(all)->findChild<QWidget*>(QStringLiteral("mark")), Qt::LeftButton);
    auto* menu = panel->findChild<QMenu*>(QStringLiteral("rowMenu"));
    if (!menu) return;
    static const std::vector<QString> actionNames{QStringLiteral("rowReset"), QStringLiteral("rowPush"),
                                                  QStringLiteral("rowPull")};
    QAction* wanted = menu->findChild<QAction*>(oneOf(actionNames));
    const bool can = wanted && wanted->isEnabled();
    if (can) wanted->trigger();
    else choose(*menu, false);
    delete menu;
}

void RandomUser::rotateChoice() {
    if (!selectObject()) return;
    const std::vector<QComboBox*> boxes = shown<QComboBox>(*m_window.findChild<PropertiesPanel*>());
    if (!boxes.empty()) QTest::keyClick(oneOf(boxes), below(2) ? Qt::Key_Down : Qt::Key_Up);
}

void RandomUser::scrubRow() {
    if (!selectObject()) return;
    const std::vector<ScrubLabel*> labels = shown<ScrubLabel>(*m_window.findChild<PropertiesPanel*>());
    if (labels.empty()) return;
    const QPointer<ScrubLabel> label = oneOf(labels);
    const QPointF from = label->rect().center();
    mouse(*label, QEvent::MouseButtonPress, from, Qt::LeftButton);
    QPointF to = from;
    for (int i = 0; i < 4 && label; ++i) {
        to += QPointF(double(below(60)) - 30, 0);
        mouse(*label, QEvent::MouseMove, to, Qt::LeftButton);
    }
    if (label && below(3) == 0) QTest::keyClick(label.data(), Qt::Key_Escape);
    if (label) mouse(*label, QEvent::MouseButtonRelease, to, Qt::NoButton);
}

} // namespace trundle
