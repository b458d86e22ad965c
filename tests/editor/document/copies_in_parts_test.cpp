// Copies of configs that Parts use: the configs that have those Parts change with them, so they are copied or asked about first.

#include <QTest>

#include "editor/document/prepared_edit.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "sample_document.h"

using namespace trundle;
using namespace sample;

namespace {

const char* const kNested = R"(Material m { }
Surface s { }
PartConfig Wheel { Body w { Sphere t { Radius=0.1 Mass=1 Material=m Surface=s } } } // the wheel
PartConfig Side { Body rail { Box b { Size=0.1,0.1,0.1 Mass=1 Material=m Surface=s } }
  Part front { Config=Wheel Pos=0.2,0,0 }
  Part back  { Config=Wheel Pos=-0.2,0,0 } }
RobotConfig Kit { Body chassis { Box b { Size=0.1,0.1,0.1 Mass=1 Material=m Surface=s } }
  Part left  { Config=Side Pos=0,0.2,0 }
  Part right { Config=Side Pos=0,-0.2,0 } }
Robot rover { Config=Kit }
Robot other { Config=Kit Pos=0,2,0 }
)";

/// Answers the questions by config; asks for those that are not listed with ChangeForAll.
class Answers {
public:
    Answers(Document& document, std::vector<QString> copied) {
        document.structure().setShareQuestionHandler(
            [this, copied](const ShareQuestion& question, const StructureEdits::ShareAnswer& answer) {
                asked += question.config;
                answer(std::ranges::find(copied, question.config) == copied.end() ? ShareChoice::ChangeForAll
                                                                                  : ShareChoice::MakeCopy);
            });
    }
    QStringList asked;
};

Status insertBox(Document& d, const std::string& at) {
    return d.structure().apply(u"Insert"_qs, {at}, [=](const LoadedProject& loaded, const auto& renamed) {
        return planInsert(loaded, renamed(at), "Box cap { Size=0.1,0.1,0.1 Mass=1 Material=m Surface=s }");
    });
}

} // namespace

class CopiesInPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_application = makeApplication(); }

    /// A copy for one Part of a shared PartConfig changes that: it is asked about, and what has it in turn.
    void asksAboutWhatHasThePart() {
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/nested.sim", kNested);
        {
            Document d(*m_application);
            QVERIFY(d.opening().open(file).ok());
            const Answers answers(d, {u"Wheel"_qs});
            QVERIFY(insertBox(d, "rover.right.back.w").ok());
            QCOMPARE(answers.asked, (QStringList{u"Wheel"_qs, u"Side"_qs}));
            const std::string text = *d.texts().text(file);
            QVERIFY2(holds(text, "Part back  { Config=Wheel2 Pos=-0.2,0,0 }") && holds(text, "Part front { Config=Wheel Pos") &&
                         !holds(text, "Side2"),
                     text.c_str());
            QCOMPARE(messages(*d.loaded()), "");
            QCOMPARE(d.edits().history().entries().size(), 1u);
            d.edits().undo();
            QCOMPARE(*d.texts().text(file), kNested);
        }
        Document fresh(*m_application);
        QVERIFY(fresh.opening().open(file).ok());
        const Answers answers(fresh, {u"Wheel"_qs, u"Side"_qs, u"Kit"_qs});
        QStringList notices;
        connect(&fresh, &Document::notice, this, [&](const QString& text) { notices += text; });
        const Status inserted = insertBox(fresh, "rover.right.back.w");
        QCOMPARE(notices,
                 (QStringList{u"Kit is unchanged: rover uses Kit2, a copy of it in nested.sim; right uses Side2, a copy of "
                              "Side; back uses Wheel2, a copy of Wheel"_qs}));
        QVERIFY2(inserted.ok(), inserted.ok() ? "" : inserted.error().message.c_str());
        QCOMPARE(answers.asked, (QStringList{u"Wheel"_qs, u"Side"_qs, u"Kit"_qs}));
        const std::string text = *fresh.texts().text(file);
        QVERIFY2(holds(text, "Robot rover { Config=Kit2 }") && holds(text, "Robot other { Config=Kit Pos") &&
                     holds(text, "Part right { Config=Side2 Pos=0,-0.2,0 }") && holds(text, "Config=Wheel2"),
                 text.c_str());
        QCOMPARE(messages(*fresh.loaded()), "");
        QVERIFY(placeOf(*fresh.loaded(), "rover.right.back.w.cap"));
        for (const char* path : {"rover.right.front.w.cap", "rover.left.back.w.cap", "other.right.back.w.cap"})
            QVERIFY(!placeOf(*fresh.loaded(), path));
    }

    /// Where the PartConfig of a renamed object is changed for all, what names the object changes with it.
    void aRenameAsksAboutOneConfig() {
        const std::string text = "Material m { }\nSurface s { }\nPartConfig Wheel {\n"
                                 "  Body w { Sphere t { Radius=0.1 Mass=1 Material=m Surface=s } }\n"
                                 "  Hinge axle { Parent=$base Child=w Axis=0,1,0 }\n}\n"
                                 "RobotConfig Kit {\n  Body chassis { Box b { Size=0.1,0.1,0.1 Mass=1 Material=m Surface=s } }\n"
                                 "  Part left { Config=Wheel Pos=0,0.2,0 base=chassis }\n"
                                 "  Part right { Config=Wheel Pos=0,-0.2,0 base=chassis }\n"
                                 "  Encoder count { Joint=left.axle CountsPerRevolution=512 }\n}\n"
                                 "Robot rover { Config=Kit }\nRobot other { Config=Kit Pos=0,2,0 }\n";
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/kit.sim", text);
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        const Answers answers(d, {u"Kit"_qs});
        const Status renamed = d.structure().rename(u"Rename"_qs, "rover.left.axle", "turn");
        QVERIFY2(renamed.ok(), renamed.ok() ? "" : renamed.error().message.c_str());
        QCOMPARE(answers.asked, (QStringList{u"Wheel"_qs}));
        const std::string after = *d.texts().text(file);
        QVERIFY2(holds(after, "Hinge turn {") && holds(after, "Joint=left.turn ") && !holds(after, "Kit2"), after.c_str());
        QCOMPARE(messages(*d.loaded()), "");
    }

    /// Of a shipped robot all configs on the way are copied, without questions, for all that the file has of them.
    void copiesAllShippedConfigsOnTheWay() {
        const DocumentFixture fixture;
        const std::string file = fixture.write(
            "configs/cars.sim", "#import robots/car.sim\n\nRobot car { Config=Car }\nRobot b { Config=Car Pos=0,1,0 }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        const Answers answers(d, {});
        QVERIFY(d.structure()
                    .apply(u"Remove"_qs, {"car.frontRight.wheel.wheel.mark"},
                           [](const LoadedProject& loaded, const auto& renamed) {
                               return planRemove(loaded, {renamed("car.frontRight.wheel.wheel.mark")});
                           })
                    .ok());
        QVERIFY(answers.asked.empty());
        QCOMPARE(messages(*d.loaded()), "");
        const std::string text = *d.texts().text(file);
        for (const char* made : {"RobotConfig Car2", "PartConfig CarFront2", "PartConfig CarWheel2", "Robot car { Config=Car2 }",
                                 "Robot b { Config=Car2 Pos"})
            QVERIFY2(holds(text, made), (made + (" is not in\n" + text.substr(text.find("Robot car")))).c_str());
        for (const char* path : {"car.frontRight.wheel.wheel.mark", "b.frontRight.wheel.wheel.mark"})
            QVERIFY2(!placeOf(*d.loaded(), path), path);
        QVERIFY(placeOf(*d.loaded(), "car.backRight.wheel.wheel.mark")); // of another config
        QCOMPARE(d.edits().history().entries().size(), 1u);
    }

    /// A value of a shipped PartConfig changes what the robots of the file have of it.
    void aValueOfAShippedPartReachesTheRobots() {
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/cars.sim", "#import robots/car.sim\n\nRobot car { Config=Car }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        QVERIFY(d.structure().setValues(u"Set"_qs, {{"PartConfig.CarWheel.wheel.tyre.Mass", "0.2"}}).ok());
        QCOMPARE(messages(*d.loaded()), "");
        int wheels = 0;
        for (const BodySpec& body : d.loaded()->experiment->robots.at(0).config->bodies)
            for (const GeomSpec& geom : body.geoms)
                if (geom.name == "tyre") wheels += geom.mass == 0.2;
        QCOMPARE(wheels, 4);
        QCOMPARE(d.edits().history().entries().size(), 1u);
    }

    /// In the model of a shipped robot: the override of a Part is written in a copy of the config that has the Part, and so are the
    /// values of the Part itself.
    void aValueInAPartOfAShippedRobotIsCopied_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("written");
        QTest::addColumn<QString>("selected");
        QTest::newRow("in a Part") << u"RobotConfig.Car.frontRight.knuckle.block.Mass"_qs << u"0.05"_qs
                                   << u"Mirror=y radius=$radius body=chassis knuckle.block.Mass=0.05 }"_qs
                                   << u"RobotConfig.Car2.frontRight.knuckle.block"_qs;
        QTest::newRow("in a Part of a Part") << u"RobotConfig.Car.frontRight.wheel.wheel.tyre.Mass"_qs << u"0.2"_qs
                                             << u"Mirror=y radius=$radius body=chassis wheel.wheel.tyre.Mass=0.2 }"_qs
                                             << u"RobotConfig.Car2.frontRight.wheel.wheel.tyre"_qs;
        QTest::newRow("a Part") << u"RobotConfig.Car.frontRight.Pos"_qs << u"0.3,-0.1,0.05"_qs
                                << u"Part frontRight { Config=CarFront Pos=0.3,-0.1,0.05 Mirror=y"_qs
                                << u"RobotConfig.Car2.frontRight"_qs;
        QTest::newRow("a Param of a Part") << u"RobotConfig.Car.frontRight.radius"_qs << u"0.06"_qs
                                           << u"Mirror=y radius=0.06 body=chassis }"_qs << u"RobotConfig.Car2.frontRight"_qs;
        QTest::newRow("in a Part of a PartConfig")
            << u"PartConfig.CarFront.wheel.wheel.tyre.Mass"_qs << u"0.2"_qs
            << u"carrier=knuckle radius=$radius wheel.tyre.Mass=0.2 }"_qs << u"PartConfig.CarFront2.wheel.wheel.tyre"_qs;
    }
    void aValueInAPartOfAShippedRobotIsCopied() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        QFETCH(QString, written);
        QFETCH(QString, selected);
        const DocumentFixture fixture;
        const std::string before = "#import robots/car.sim\n\nRobot car { Config=Car }\n";
        const std::string file = fixture.write("configs/cars.sim", before);
        for (const bool isDrag : {false, true}) {
            Document d(*m_application);
            QVERIFY(d.opening().open(file).ok());
            QSignalSpy selects(&d, &Document::selectionRequested);
            for (const QString& step : isDrag ? QStringList{value + u"1"_qs, value} : QStringList{value}) {
                const Status set =
                    d.structure().setValues(u"Set"_qs, {{path.toStdString(), step.toStdString()}}, isDrag ? "drag" : "");
                QVERIFY2(set.ok(), why(set).c_str());
            }
            QCOMPARE(messages(*d.loaded()), "");
            const std::string text = *d.texts().text(file);
            QVERIFY2(holds(text, written.toStdString()) && holds(text, "Robot car { Config=Car2 }"), text.c_str());
            QCOMPARE(d.edits().history().entries().size(), 1u);
            if (!isDrag) QCOMPARE(selects.last()[0].value<std::vector<std::string>>(), std::vector{selected.toStdString()});
            d.edits().undo();
            QCOMPARE(*d.texts().text(file), before);
        }
    }

    /// A value that is pushed from one robot into a nested Part of a shipped robot: the user chooses who gets it, as elsewhere.
    void pushingIntoAShippedPartAsks_data() {
        QTest::addColumn<QStringList>("copied");
        QTest::addColumn<QStringList>("asked");
        QTest::addColumn<QStringList>("heavy");
        const QString right = u"frontRight"_qs, left = u"frontLeft"_qs;
        QTest::newRow("for one") << QStringList{u"CarWheel"_qs, u"CarFront"_qs} << QStringList{u"CarWheel"_qs, u"CarFront"_qs}
                                 << QStringList{right};
        QTest::newRow("for both sides") << QStringList{u"CarWheel"_qs} << QStringList{u"CarWheel"_qs, u"CarFront"_qs}
                                        << QStringList{left, right};
        QTest::newRow("for all") << QStringList{} << QStringList{u"CarWheel"_qs}
                                 << QStringList{u"backLeft"_qs, u"backRight"_qs, left, right};
    }
    void pushingIntoAShippedPartAsks() {
        QFETCH(QStringList, copied);
        QFETCH(QStringList, asked);
        QFETCH(QStringList, heavy);
        const DocumentFixture fixture;
        const std::string before = "#import robots/car.sim\n\nRobot car { Config=Car frontRight.wheel.wheel.tyre.Mass=0.2 }\n";
        const std::string file = fixture.write("configs/cars.sim", before);
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        const Answers answers(d, {copied.begin(), copied.end()});
        const Status pushed = d.structure().pushOverride(u"Push"_qs, "car.frontRight.wheel.wheel.tyre.Mass");
        QVERIFY2(pushed.ok(), why(pushed).c_str());
        QCOMPARE(answers.asked, asked);
        QCOMPARE(messages(*d.loaded()), "");
        QVERIFY2(holds(*d.texts().text(file), "Robot car { Config=Car2 }"), d.texts().text(file)->c_str());
        QStringList found;
        for (const BodySpec& body : d.loaded()->experiment->robots.at(0).config->bodies)
            for (const GeomSpec& geom : body.geoms)
                if (geom.name == "tyre" && geom.mass == 0.2) found += QString::fromStdString(body.name).section(u'.', 0, 0);
        found.sort();
        QCOMPARE(found, heavy);
        QCOMPARE(d.edits().history().entries().size(), 1u);
        d.edits().undo();
        QCOMPARE(*d.texts().text(file), before);
    }

    /// In the shipped config itself: what was selected is selected in the copy.
    void pushingInAShippedPartSelectsTheCopy() {
        const DocumentFixture fixture;
        const std::string file = fixture.write("configs/cars.sim", "#import robots/car.sim\n\nRobot car { Config=Car }\n");
        Document d(*m_application);
        QVERIFY(d.opening().open(file).ok());
        Selection selection;
        QObject::connect(&d, &Document::selectionRequested, &selection, &Selection::set);
        d.edits().restoreSelection(selection);
        selection.set({"PartConfig.CarFront.strut"});
        const Answers answers(d, {u"CarStrut"_qs});
        const Status pushed = d.structure().pushOverride(u"Push"_qs, "PartConfig.CarFront.strut.load");
        QVERIFY2(pushed.ok(), why(pushed).c_str());
        QCOMPARE(answers.asked, QStringList{u"CarStrut"_qs}); // which CarBack has too
        QCOMPARE(messages(*d.loaded()), "");
        const std::string text = *d.texts().text(file);
        QVERIFY2(holds(text, "Part strut { Config=CarStrut2 body=$body }") && holds(text, "Param load      = 7.07") &&
                     !holds(text, "CarBack2"),
                 text.c_str());
        QCOMPARE(selection.current(), std::string("PartConfig.CarFront2.strut"));
    }

    /// Of two shipped configs the second cannot be copied, since too many others have it.
    void aCopyDoesNotStayWithoutItsValue() {
        std::string shipped = "PartConfig Wheel { Body w { Sphere t { Radius=0.1 Mass=1 } } }\n"
                              "RobotConfig Plain { Body hull { Box b { Size=0.1,0.1,0.1 Mass=1 } } }\n",
                    own = "#import robots/many.sim\n\nRobot plain { Config=Plain Pos=0,-1,0 }\n";
        for (int i = 0; i <= PreparedEdit::kMaxCopies; ++i) {
            const std::string number = std::to_string(i);
            shipped += "RobotConfig Cart" + number + " { Part wheel { Config=Wheel } }\n";
            own += "Robot cart" + number + " { Config=Cart" + number + " Pos=" + number + ",0,0 }\n";
        }
        const DocumentFixture fixture;
        (void)fixture.write("shipped/robots/many.sim", shipped);
        const std::string file = fixture.write("configs/carts.sim", own);
        Locations places = findLocations();
        places.configs = fixture.path("shipped");
        const std::unique_ptr<Application> application = makeApplication(places);
        Document d(*application);
        QVERIFY(d.opening().open(file).ok());
        QCOMPARE(messages(*d.loaded()), "");
        const std::vector<ValueEdit> both{{"RobotConfig.Plain.hull.b.Mass", "2"}, {"PartConfig.Wheel.w.t.Mass", "2"}};
        const std::string refusal = why(d.structure().setValues(u"Set"_qs, both));
        QVERIFY2(holds(refusal, "too many configs"), refusal.c_str());
        QCOMPARE(*d.texts().text(file), own);
        QVERIFY(d.edits().history().entries().empty());
        QVERIFY(!d.texts().isModified());
        QVERIFY(d.structure().setValues(u"Set"_qs, {both[0]}).ok()); // alone it can be set
        QVERIFY(holds(*d.texts().text(file), "Robot plain { Config=Plain2 "));
    }

private:
    std::unique_ptr<Application> m_application;
};

QTEST_GUILESS_MAIN(CopiesInPartsTest)
#include "copies_in_parts_test.moc"
