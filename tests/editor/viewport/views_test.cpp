// The views of a panel: their states, what they frame and show, their buttons, the bar above them and the banner over them.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QWidgetAction>
#include <QtTest>

#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view_window.h"

using namespace trundle;

namespace {

const QByteArray kYard =
    R"(RobotConfig Cart { Body base { Box hull { Size=0.4,0.4,0.2 Pos=0,0,0.1 Mass=2 }
  Sphere bead { Radius=0.001 Pos=0,0,0.3 Mass=0.1 } }
  Camera eye { Body=base Pos=0.2,0,0.3 } }
RobotConfig Bare { Body base { Box hull { Size=0.4,0.4,0.2 Pos=0,0,0.1 Mass=2 } } }
Light lamp { Direction=0,0,-1 }
View first { Eye=3,-4,3 Target=0,0,0.2 FieldOfView=40 }
View second { Eye=-2,0,1 Target=0,0,0.3 FieldOfView=50 }
Robot cart { Config=Cart }
Grid herd { Config=Bare Count=2 Spacing=1 Pos=4,0,0 }
Region zone { Pos=2,3,0.2 Size=1,0.5,0.4 }
)";

} // namespace

class ViewsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ViewWindow> m_window;

    ViewGrid& views() { return m_window->panel->views(); }
    template <class Widget> Widget* child(const char* name) { return m_window->panel->findChild<Widget*>(QLatin1String(name)); }
    QString kindText() { return m_window->view().findChild<QToolButton*>(QStringLiteral("viewKind"))->text(); }

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<ViewWindow>(nullptr);
        QVERIFY(m_window->open(kYard));
        m_window->look({0.7, -4.5, 3.5}, {0.7, 0, 0});
    }
    void cleanup() { m_window.reset(); }

    /// The kind and the camera of each view, whatever it was before.
    void statesAreRestored() {
        const std::pair<ViewKind, const char*> kinds[] = {{ViewKind::Perspective, "Perspective"},
                                                          {ViewKind::Orthographic, "Parallel"},
                                                          {ViewKind::Top, "Top"},
                                                          {ViewKind::Front, "Front"},
                                                          {ViewKind::Side, "Side"},
                                                          {ViewKind::Follow, "Follow"},
                                                          {ViewKind::Chase, "Chase"}};
        views().setViewCount(4);
        for (std::size_t shift = 0; shift < 7; ++shift) {
            for (int i = 0; i < 4; ++i) {
                const auto& [kind, name] = kinds[(shift + std::size_t(i)) % 7];
                views().view(i).camera().setKind(kind);
                QCOMPARE(views().view(i).findChild<QToolButton*>(QStringLiteral("viewKind"))->text(), QLatin1String(name));
            }
            const std::vector<ViewState> states = views().viewStates();
            std::vector<double> distances;
            for (int i = 0; i < 4; ++i) {
                distances.push_back(views().view(i).camera().free().distance());
                views().view(i).camera().setKind(kinds[(shift + std::size_t(i) + 3) % 7].first);
                views().view(i).camera().change([](ViewCamera& camera) { camera.zoom(0.3, camera.middle()); });
            }
            views().setViewStates(states, 4);
            for (int i = 0; i < 4; ++i) {
                QCOMPARE(views().view(i).camera().free().kind(), kinds[(shift + std::size_t(i)) % 7].first);
                QVERIFY(std::abs(views().view(i).camera().free().distance() - distances[std::size_t(i)]) < 1e-6);
            }
        }
    }

    /// A View by its name, as it is in the text; what was made of it with its field of view.
    void statesOfNamedViewsAreRestored() {
        CameraControl& camera = m_window->view().camera();
        camera.showNamed("first");
        std::vector<ViewState> states = views().viewStates();
        m_window->trigger("view.top");
        views().setViewStates(states, 1);
        QCOMPARE(camera.named(), std::string("first"));
        QVERIFY(std::abs(camera.view().fieldOfView - 40 * M_PI / 180) < 1e-9);
        camera.change([](ViewCamera& free) { free.zoom(0.5, free.middle()); });
        states = views().viewStates();
        m_window->trigger("view.top");
        views().setViewStates(states, 1);
        QCOMPARE(camera.named(), std::string());
        QVERIFY(std::abs(camera.view().fieldOfView - 40 * M_PI / 180) < 1e-9);
    }

    /// An open brace above it hides a View from the model; it stays chosen, and where it is, until the text is whole.
    void aViewStaysChosenWhileATextIsBroken() {
        const auto put = [this](const QByteArray& text) {
            return m_window->document.edits()
                .replaceText(QStringLiteral("Type"), m_window->document.texts().files().front(), text.toStdString())
                .ok();
        };
        const CameraControl& camera = m_window->view().camera();
        QVERIFY(views().showView(QStringLiteral("second")));
        QVERIFY(put(QByteArray(kYard).replace("View first", "Light sun {\nView first")));
        QVERIFY(m_window->document.loaded()->diagnostics.hasErrors());
        QCOMPARE(camera.named(), std::string("second"));
        QVERIFY((camera.view().eye - Vec3(-2, 0, 1)).norm() < 1e-9);
        QVERIFY(put(QByteArray(kYard).replace("Eye=-2,0,1", "Eye=-3,0,1")));
        QCOMPARE(camera.named(), std::string("second"));
        QVERIFY((camera.view().eye - Vec3(-3, 0, 1)).norm() < 1e-9);
        QVERIFY(put(QByteArray(kYard).replace("View second", "View third")));
        QCOMPARE(camera.named(), std::string());
    }

    void countsOfViews_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<QList<int>>("shown");
        QTest::newRow("1") << 1 << QList<int>{0};
        QTest::newRow("2") << 2 << QList<int>{0, 1};
        QTest::newRow("3") << 3 << QList<int>{0, 1, 3};
        QTest::newRow("4") << 4 << QList<int>{0, 1, 2, 3};
    }
    /// The current view is one that is shown.
    void countsOfViews() {
        QFETCH(int, count);
        QFETCH(QList<int>, shown);
        views().setViewCount(4);
        views().view(2).setFocus();
        Q_EMIT views().view(2).activated();
        QCOMPARE(&views().current(), &views().view(2));
        views().setViewCount(count);
        for (int i = 0; i < 4; ++i) QCOMPARE(views().view(i).isVisible(), shown.contains(i));
        QVERIFY(views().current().isVisible());
        QCOMPARE(&views().current() == &views().view(2), count == 4);
    }

    /// A view by the name of its kind, in any letters, or of a View; not of what else lights the scene.
    void viewsByName() {
        for (const auto& [name, kind] :
             {std::pair("TOP", ViewKind::Top), {"parallel", ViewKind::Orthographic}, {"Chase", ViewKind::Chase}}) {
            QVERIFY(views().showView(QLatin1String(name)));
            QCOMPARE(m_window->view().camera().free().kind(), kind);
        }
        QVERIFY(views().showView(QStringLiteral("second")));
        QVERIFY((m_window->view().camera().view().eye - Vec3(-2, 0, 1)).norm() < 1e-9);
        QCOMPARE(kindText(), QStringLiteral("second"));
        QVERIFY(!views().showView(QStringLiteral("lamp")) && !views().showView(QStringLiteral("third")));
        QVERIFY(views().showView(QStringLiteral("Perspective")));
        m_window->view().camera().lookThrough("cart/eye");
        QCOMPARE(kindText(), QStringLiteral("Camera"));
    }

    /// Their menus list what there is each time they open.
    void menusOfAView() {
        auto* button = m_window->view().findChild<QToolButton*>(QStringLiteral("viewKind"));
        for (int i = 0; i < 2; ++i) {
            Q_EMIT button->menu()->aboutToShow();
            const auto namesOf = [&](const char* name) {
                QStringList names;
                for (const QAction* action : button->menu()->findChild<QMenu*>(QLatin1String(name))->actions())
                    names << action->text();
                return names.join(u' ');
            };
            QCOMPARE(namesOf("namedViews"), QStringLiteral("first second"));
            QCOMPARE(namesOf("throughMenu"), QStringLiteral("cart/eye"));
        }
    }

    /// Regions too; what is tiny is not approached to nothing.
    void framesWhatIsSelected() {
        const auto isFramed = [&](const Bounds& box) {
            QRectF around;
            for (int i = 0; i < 8; ++i) {
                const auto at = m_window->view().camera().pixelOf(box.corner(i));
                if (!at) return false;
                around |= QRectF(*at, QSizeF(1, 1));
            }
            const QRectF all(m_window->view().rect());
            return all.contains(around) && std::max(around.width() / all.width(), around.height() / all.height()) > 0.3;
        };
        for (const char* path : {"zone", "cart", "herd_1"}) {
            m_window->selection.select(path);
            views().frameSelection();
            Bounds box;
            if (path == std::string("zone")) box.add(Vec3(1.5, 2.75, 0)), box.add(Vec3(2.5, 3.25, 0.4));
            else box = m_window->panel->world().boundsOf(*m_window->panel->world().find(path));
            QVERIFY2(isFramed(box), path);
        }
        m_window->selection.select("cart.base.bead");
        views().frameSelection();
        QVERIFY((m_window->view().camera().free().middle() - Vec3(0, 0, 0.3)).norm() < 0.01);
        QVERIFY(m_window->view().camera().free().distance() > 0.2 && m_window->view().camera().free().distance() < 1);
    }

    /// On the floor in the middle of the view; towards the horizon at the distance of the camera.
    void whereThingsAreInserted() {
        m_window->look({-5, -4, 3}, {-5, 1, 0});
        QVERIFY((*views().insertionPoint() - Vec3(-5, 1, 0)).norm() < 1e-3);
        m_window->look({-5, -4, 1}, {-5, 0, 0.9});
        QVERIFY((*views().insertionPoint() - m_window->view().camera().free().middle()).norm() < 1e-9);
    }

    /// The bar shows the axes and the steps; a box sets its own step alone.
    void theBarShowsTheSettings() {
        ViewSettings& settings = m_window->panel->settings();
        auto *axes = child<QToolButton>("axes"), *steps = child<QToolButton>("steps");
        for (const auto& [which, name] :
             {std::pair(AxesOf::Local, "Local"), {AxesOf::Parent, "Parent"}, {AxesOf::World, "World"}}) {
            settings.setAxes(which);
            QCOMPARE(axes->text(), QLatin1String(name));
        }
        for (const AxesOf next : {AxesOf::Parent, AxesOf::Local, AxesOf::World}) {
            m_window->trigger("tool.frame");
            QVERIFY(settings.axes() == next);
        }
        settings.setSteps(0.2, 7.5);
        QCOMPARE(steps->text(), QStringLiteral("0.2 m · 7.5°"));
        QList<QDoubleSpinBox*> boxes;
        for (QAction* action : steps->defaultAction()->menu()->actions())
            if (const auto* form = qobject_cast<QWidgetAction*>(action))
                boxes = form->defaultWidget()->findChildren<QDoubleSpinBox*>();
        QCOMPARE(boxes.size(), 2);
        const bool isMoveFirst = boxes[0]->objectName() == QStringLiteral("moveStep");
        QDoubleSpinBox *move = boxes[isMoveFirst ? 0 : 1], *turn = boxes[isMoveFirst ? 1 : 0];
        QVERIFY(move->value() == 0.2 && turn->value() == 7.5);
        turn->setValue(30);
        QVERIFY(settings.moveStep() == 0.2 && settings.rotationStep() == 30);
        move->setValue(0.01);
        QVERIFY(settings.moveStep() == 0.01 && settings.rotationStep() == 30);
    }

    /// The steps are typed as their menu opens, one after the other.
    void stepsFromTheKeyboard() {
        m_window->trigger("tool.snapSteps");
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        auto *move = menu->findChild<QDoubleSpinBox*>(QStringLiteral("moveStep")),
             *turn = menu->findChild<QDoubleSpinBox*>(QStringLiteral("turnStep"));
        QCOMPARE(menu->focusWidget(), move);
        QTest::keyClicks(move, QStringLiteral("0.3"));
        QTest::keyClick(move, Qt::Key_Tab);
        QCOMPARE(menu->focusWidget(), turn);
        QTest::keyClicks(turn, QStringLiteral("20"));
        menu->close();
        QCOMPARE(m_window->panel->settings().moveStep(), 0.3);
        QCOMPARE(m_window->panel->settings().rotationStep(), 20.0);
    }

    /// A tool that Esc leaves gets the keys, wherever it was chosen; the others leave the arrow keys to the tree.
    void aStartedToolHasTheKeyboard() {
        auto* other = new QLineEdit(m_window->panel.get());
        other->show();
        for (const auto& [tool, takes] : {std::pair("tool.connectHinge", true),
                                          {"tool.drawWalls", true},
                                          {"tool.measure", true},
                                          {"tool.move", false},
                                          {"tool.select", false}}) {
            other->setFocus();
            m_window->trigger(tool);
            QVERIFY2((m_window->panel->window()->focusWidget() == &m_window->view()) == takes, tool);
        }
    }

    /// Why what is selected cannot be edited, and a way out where there is one.
    void theBanner() {
        const auto* banner = child<QWidget>("viewportBanner");
        const auto* button = child<QPushButton>("bannerButton");
        const auto shownText = [&] { return banner->isVisible() ? banner->findChild<QLabel*>()->text() : QString(); };
        m_window->selection.select("herd_1");
        QCOMPARE(shownText(), QString());
        m_window->trigger("tool.move");
        QVERIFY2(shownText().startsWith(QStringLiteral("herd_1 is a member of herd")), qPrintable(shownText()));
        QVERIFY(button->isVisible() && button->text() == QStringLiteral("Replace by Single Instances"));
        m_window->selection.select("cart");
        QCOMPARE(shownText(), QString());
        m_window->trigger("tool.scale");
        m_window->selection.select("cart.base");
        QVERIFY2(shownText().contains(QStringLiteral("has no size of its own")), qPrintable(shownText()));
        QVERIFY(!button->isVisible());
        m_window->panel->world().setLocked({"cart"});
        m_window->selection.select("cart");
        QCOMPARE(shownText(), QStringLiteral("cart is locked."));
        m_window->panel->world().setLocked({});
        m_window->selection.select("herd");
        m_window->trigger("tool.select");
        m_window->trigger("tool.move");
        QCOMPARE(shownText(), QString());
        m_window->session.step();
        QVERIFY(QTest::qWaitFor(
            [&] { return m_window->session.state() == RunState::Paused && m_window->panel->world().isRunning(); }, 60000));
        m_window->selection.select("cart");
        m_window->selection.select("cart.base");
        QCOMPARE(shownText(), QStringLiteral("During a run only whole robots can be moved; reset to edit the start."));
    }

    /// However the one before was looked at, another document without a View is shown whole.
    void anotherDocumentIsShownWhole() {
        m_window->trigger("view.side");
        m_window->view().camera().change([](ViewCamera& camera) { camera.zoom(0.1, camera.middle()); });
        QVERIFY(m_window->open("RobotConfig Bare { Body base { Box hull { Size=0.4,0.4,0.2 Mass=2 } } }\n"
                               "Grid herd { Config=Bare Count=9 Spacing=2 Pos=40,0,0 }\n"));
        QCOMPARE(m_window->view().camera().free().kind(), ViewKind::Perspective);
        for (int i = 0; i < 8; ++i)
            QVERIFY(m_window->view().rect().contains(m_window->at(m_window->panel->world().bounds().corner(i))));
    }

    /// The view of a robot that another document does not have is a free one.
    void anotherDocumentIsNotFollowed() {
        for (const char* action : {"view.follow", "view.chase"}) {
            m_window->trigger(action);
            QVERIFY(m_window->open(kYard));
            QCOMPARE(m_window->view().camera().free().kind(), ViewKind::Perspective);
            QCOMPARE(m_window->view().camera().named(), std::string("first")); // its first View
        }
    }
};

QTEST_MAIN(ViewsTest)
#include "views_test.moc"
