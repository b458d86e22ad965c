#pragma once
// Performs random user actions in a window: keys, mouse, menus, drops and runs. The actions depend on the seed and on what
// the window shows.

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <QModelIndex>
#include <QPointF>
#include <QString>

#include "editor/viewport/gizmo/gizmo.h"

class QMenu;
class QWidget;

namespace trundle {

class MainWindow;
class OutlinePanel;
class View;

class RandomUser {
public:
    RandomUser(MainWindow& window, unsigned seed);

    /// Performs one action and completes it: no half-typed text or unfinished drag remains.
    void step();
    [[nodiscard]] const char* doing() const { return m_doing; }        ///< the last step
    [[nodiscard]] const QString& trouble() const { return m_trouble; } ///< why it failed; empty if it did not
    /// How often each button of the question about a shared config was pressed.
    [[nodiscard]] const std::map<std::string, int>& answers() const { return m_answers; }

private:
    struct UserAction {
        int share; ///< weight among all actions
        const char* name;
        void (RandomUser::*go)();
    };
    static const std::vector<UserAction> kActions;

    // in the Scene tree
    void rename();
    void removeObject();
    void duplicateObject();
    void cutObject();
    void copyObject();
    void pasteObject();
    void dragRow();
    void insertKind();
    void insertFromLibrary();
    void dropFromLibrary();
    // in property rows
    void typeValue();
    void openRowMenu();
    void rotateChoice();
    void scrubRow();
    void useParts();
    // in the 3D view
    void moveByGizmo();
    void rotateByGizmo();
    void sizeByGizmo();
    void nudge();
    void dropToFloor();
    // in the text
    void typeText();
    void pasteText();
    void deleteText();
    void commandText();
    // runs
    void runAWhile();
    void stepOnce();
    void runAndPause();
    void pushRobot();
    void keepPoses();
    void resetRun();
    // history
    void undo();
    void redo();
    void leap();
    void save();

    [[nodiscard]] std::size_t below(std::size_t count) { return m_random() % count; }
    template <class T> const T& oneOf(const std::vector<T>& all) { return all[below(all.size())]; }
    [[nodiscard]] OutlinePanel& outline() const;
    [[nodiscard]] View& view() const;
    [[nodiscard]] std::vector<QModelIndex> rows() const; ///< of objects
    /// Clicks a random row of the tree for which `fits` is true. False if there is none.
    bool selectObject(const std::function<bool(const std::string& path)>& fits = {});
    bool selectRobot();
    bool dragHandle(const char* tool, GizmoHandle handle);
    void trigger(const char* action);
    void mouse(QWidget& on, int type, const QPointF& at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {});
    void choose(QMenu& menu, bool deep);
    void caretSomewhere();
    void fixText();
    void waitForRun();
    void answerQuestion();
    void answerDialogs();
    [[nodiscard]] std::string number();

    void waitFor(const std::function<bool()>& done, const char* what);

    MainWindow& m_window;
    unsigned m_seed;
    std::mt19937 m_random;
    const char* m_doing = "";
    QString m_trouble;
    std::map<std::string, int> m_answers;
};

} // namespace trundle
