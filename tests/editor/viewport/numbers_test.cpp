// Numbers of a drag: what the handles of a gizmo make of the mouse and of typed numbers. The text of edited vectors: only changed numbers are rewritten, with as few digits as the step allows.
#include <QtTest>

#include "editor/viewport/gizmo/gizmo_drag.h"
#include "lang/number_text.h"

using namespace trundle;

namespace {

/// A gizmo that is moved and turned, so that no axis is one of the world.
GizmoPose turned() {
    GizmoPose place;
    place.origin = {1, -2, 0.5};
    place.axes = rotationFromHpr({0.4, 0.7, -0.3}).toRotationMatrix();
    place.forward = place.axes * Vec3(1, 2, -2).normalized();
    return place;
}

/// A ray that hits this point of the gizmo's frame.
ViewRay rayTo(const GizmoPose& place, const Vec3& point) {
    const Vec3 at = place.origin + place.axes * point, direction = (place.axes * Vec3(1, 2, -2)).normalized();
    return {at - 10 * direction, direction};
}

void typeAll(GizmoDrag& drag, const char* text) {
    for (const char* c = text; *c; ++c) QVERIFY(drag.type(*c, QString(QLatin1Char(*c))));
}

} // namespace

class NumbersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aNumberHasAsFewDigitsAsItsStepAllows() {
        QCOMPARE(steppedNumber(0.35000000000000003, 1e-6), std::string("0.35"));
        QCOMPARE(steppedNumber(-1.5, 1e-6), std::string("-1.5"));
        QCOMPARE(steppedNumber(-1e-9, 1e-6), std::string("0"));
        QCOMPARE(steppedNumber(12, 1e-6), std::string("12"));
        QCOMPARE(steppedNumber(100, 1), std::string("100"));
        QCOMPARE(steppedNumber(0.123456789, 1e-3), std::string("0.123"));
        QCOMPARE(steppedNumber(1234567.5, 1e-4), std::string("1234567.5"));
        QCOMPARE(steppedNumber(1e300, 1e-6).size(), std::size_t(301));
    }

    void rewritesOnlyChangedNumbers_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        // From 0.1, 0.2, 0.3 to 0.1, 0.25, 0.3.
        QTest::newRow("plain") << "0.1,0.2,0.3"
                               << "0.1,0.25,0.3";
        QTest::newRow("blanks stay") << "0.1 ,  0.2,\n  0.3"
                                     << "0.1 ,  0.25,\n  0.3";
        QTest::newRow("formulas stay") << "$x, 0.2, $(a/2)"
                                       << "$x, 0.25, $(a/2)";
        QTest::newRow("a formula that changes becomes a number") << "0.10, $(a + 1), .3"
                                                                 << "0.10, 0.25, .3";
        QTest::newRow("units stay") << "10cm, 20 cm, 300 mm"
                                    << "10cm, 25 cm, 300 mm";
        QTest::newRow("digits stay") << "1e-1, +0.2, 0.300"
                                     << "1e-1, 0.25, 0.300";
        QTest::newRow("nothing there") << ""
                                       << "0.1,0.25,0.3";
        QTest::newRow("two only") << "0.1,0.2"
                                  << "0.1,0.25,0.3";
        QTest::newRow("no value at all") << "} what {"
                                         << "0.1,0.25,0.3";
    }
    void rewritesOnlyChangedNumbers() {
        QFETCH(const QString, text);
        QFETCH(const QString, expected);
        const double before[] = {0.1, 0.2, 0.3}, after[] = {0.1, 0.25, 0.3};
        QCOMPARE(QString::fromStdString(withNumbers(text.toStdString(), before, after, "m", 1e-6)), expected);
    }

    /// A ring turns on past half a turn and past a whole one, in both directions, by any axis.
    void aRingTurnsOn() {
        const GizmoPose place = turned();
        for (int axis = 0; axis < 3; ++axis)
            for (const double way : {1.0, -1.0}) {
                const auto at = [&](double degrees) {
                    const double a = degrees * std::numbers::pi / 180;
                    Vec3 point = Vec3::Zero();
                    point[(axis + 1) % 3] = std::cos(a);
                    point[(axis + 2) % 3] = std::sin(a);
                    return rayTo(place, point);
                };
                GizmoDrag drag({GizmoHandle::Kind::Ring, axis, 1}, place, at(30), {});
                for (int tens = 1; tens <= 50; ++tens) {
                    drag.to(at(30 + way * 10 * tens), {}, 0, 0);
                    QVERIFY(std::abs(drag.degrees() - way * 10 * tens) < 1e-6);
                }
                drag.to(at(30 + way * 497), {}, 0, 15); // in steps
                QVERIFY(std::abs(drag.degrees() - way * 495) < 1e-6);
                const Vec3 moved = drag.motion() * Vec3(place.origin + place.axes.col((axis + 1) % 3));
                const double a = way * 495 * std::numbers::pi / 180;
                const Vec3 expected =
                    place.origin + std::cos(a) * place.axes.col((axis + 1) % 3) + std::sin(a) * place.axes.col((axis + 2) % 3);
                QVERIFY((moved - expected).norm() < 1e-9);
            }
    }

    /// Axis, plane and screen move by what the mouse moves in their own directions only.
    void aDragFollowsTheMouse() {
        const GizmoPose place = turned();
        const Vec3 by(0.32, -0.21, 0.44);
        for (int axis = 0; axis < 3; ++axis) {
            GizmoDrag along({GizmoHandle::Kind::Axis, axis, 1}, place, rayTo(place, Vec3::Zero()), {});
            along.to(rayTo(place, Vec3::Unit(axis) * by[axis]), {}, 0, 0);
            QVERIFY((along.amount() - Vec3::Unit(axis) * by[axis]).norm() < 1e-9);
            QVERIFY((along.motion().position - place.axes.col(axis) * by[axis]).norm() < 1e-9);
            Vec3 inPlane = by;
            inPlane[axis] = 0;
            GizmoDrag plane({GizmoHandle::Kind::Plane, axis, 1}, place, rayTo(place, Vec3::Zero()), {});
            plane.to(rayTo(place, inPlane), {}, 0, 0);
            QVERIFY((plane.amount() - inPlane).norm() < 1e-9);
            plane.to(rayTo(place, inPlane), {}, 0.1, 0);
            for (int k = 0; k < 3; ++k) QVERIFY(std::abs(plane.amount()[k] - 0.1 * std::round(inPlane[k] / 0.1)) < 1e-12);
        }
    }

    void typedNumbers_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("axis");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QList<double>>("amount");
        const auto row = [](const char* name, GizmoHandle::Kind kind, int axis, const char* typed, QList<double> amount) {
            QTest::newRow(name) << int(kind) << axis << typed << amount;
        };
        using Kind = GizmoHandle::Kind;
        row("x", Kind::Axis, 0, "1.5", {1.5, 0, 0});
        row("z with a unit", Kind::Axis, 2, "-20 cm", {0, 0, -0.2});
        row("plane x", Kind::Plane, 0, "1,2", {0, 1, 2});
        row("plane y", Kind::Plane, 1, "1,2", {1, 0, 2});
        row("plane z", Kind::Plane, 2, "1,2", {1, 2, 0});
        row("plane, one number", Kind::Plane, 1, "3", {3, 0, 0});
        row("plane with units", Kind::Plane, 2, "10cm,-2 mm", {0.1, -0.002, 0});
        row("screen", Kind::Screen, 0, "1,2,3", {1, 2, 3});
        row("screen, the first left out", Kind::Screen, 0, ",2", {0, 2, 0});
        row("arithmetic", Kind::Axis, 0, "-(2+3)/4", {-1.25, 0, 0});
        row("arithmetic in a plane", Kind::Plane, 2, "1/4,2*3", {0.25, 6, 0});
        row("an exponent", Kind::Axis, 0, "1e12 m", {1e12, 0, 0});
    }
    void typedNumbers() {
        QFETCH(int, kind);
        QFETCH(int, axis);
        QFETCH(QString, typed);
        QFETCH(QList<double>, amount);
        const GizmoPose place = turned();
        GizmoDrag drag({static_cast<GizmoHandle::Kind>(kind), axis, 1}, place, rayTo(place, Vec3::Zero()), {});
        typeAll(drag, typed.toLatin1().constData());
        const Vec3 expected(amount[0], amount[1], amount[2]);
        QCOMPARE(drag.fault(), QString());
        QVERIFY((drag.amount() - expected).norm() < 1e-12);
        QVERIFY((drag.motion().position - place.axes * expected).norm() < 1e-12);
        while (!drag.typed().empty()) QVERIFY(drag.type(Qt::Key_Backspace, {}));
        QVERIFY(drag.amount().norm() < 1e-12); // the mouse counts again
        GizmoDrag ring({GizmoHandle::Kind::Ring, axis, 1}, place, rayTo(place, Vec3::Unit((axis + 1) % 3)), {});
        typeAll(ring, "2rad");
        QVERIFY(std::abs(ring.degrees() - 360 / std::numbers::pi) < 1e-9);
    }

    void whatIsNoNumberHasAReason_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("part");
        using Kind = GizmoHandle::Kind;
        QTest::newRow("no unit") << int(Kind::Axis) << "3 ft"
                                 << "ft";
        QTest::newRow("of another quantity") << int(Kind::Axis) << "5 kg"
                                             << "kg";
        QTest::newRow("an angle is no length") << int(Kind::Axis) << "5 deg"
                                               << "deg";
        QTest::newRow("a length is no angle") << int(Kind::Ring) << "5 m"
                                              << "m";
        QTest::newRow("a word") << int(Kind::Axis) << "track"
                                << "track";
        QTest::newRow("nothing to divide by") << int(Kind::Axis) << "1/0"
                                              << "zero";
        QTest::newRow("a unit of a divisor") << int(Kind::Axis) << "-(2+3)/4 m"
                                             << "1/m";
        QTest::newRow("a comma for decimals") << int(Kind::Axis) << "0,35"
                                              << "point for decimals";
        QTest::newRow("too many") << int(Kind::Plane) << "1,2,3"
                                  << "2 numbers";
        QTest::newRow("not whole") << int(Kind::Axis) << "(1+"
                                   << "";
        QTest::newRow("a sign") << int(Kind::Axis) << "-"
                                << "";
        QTest::newRow("no size") << int(Kind::Size) << "-1"
                                 << "above 0";
    }
    void whatIsNoNumberHasAReason() {
        QFETCH(int, kind);
        QFETCH(QString, typed);
        QFETCH(QString, part);
        GizmoPose place = turned();
        place.sizes[0].name = QStringLiteral("Radius");
        GizmoDrag drag({static_cast<GizmoHandle::Kind>(kind), 0, 1}, place, rayTo(place, Vec3::UnitY()), {});
        typeAll(drag, typed.toLatin1().constData());
        QCOMPARE(drag.typed(), typed.toStdString()); // no character is lost
        QVERIFY2(!drag.fault().isEmpty() && drag.fault().contains(part), qPrintable(drag.fault()));
        while (!drag.typed().empty()) QVERIFY(drag.type(Qt::Key_Backspace, {}));
        QCOMPARE(drag.fault(), QString());
    }

    void whatADragSays_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("axis");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, GizmoHandle::Kind kind, int axis, const char* typed, const char* said) {
            QTest::newRow(name) << int(kind) << axis << typed << QString::fromUtf8(said);
        };
        using Kind = GizmoHandle::Kind;
        row("x", Kind::Axis, 0, "", "X  0.1235 m");
        row("z", Kind::Axis, 2, "", "Z  0.5 m");
        row("plane y", Kind::Plane, 1, "", "X  0.1235 m   Z  0.5 m");
        row("screen", Kind::Screen, 0, "1,2,3", "X  1 m   Y  2 m   Z  3 m   › 1,2,3");
        row("typed", Kind::Axis, 1, "25 cm", "Y  0.25 m   › 25 cm");
        row("a unit that is not whole yet: the mouse counts", Kind::Axis, 0, "25 c", "X  0.1235 m   › 25 c");
        row("ring", Kind::Ring, 1, "12.346", "Y  12.35°   › 12.346");
    }
    void whatADragSays() {
        QFETCH(int, kind);
        QFETCH(int, axis);
        QFETCH(QString, typed);
        const GizmoPose place = turned();
        GizmoDrag drag({static_cast<GizmoHandle::Kind>(kind), axis, 1}, place, rayTo(place, Vec3::Zero()), {});
        if (static_cast<GizmoHandle::Kind>(kind) == GizmoHandle::Kind::Axis)
            drag.to(rayTo(place, Vec3::Unit(axis) * (axis == 2 ? 0.5 : 0.12345678)), {}, 0, 0);
        if (static_cast<GizmoHandle::Kind>(kind) == GizmoHandle::Kind::Plane)
            drag.to(rayTo(place, {0.12345678, 0, 0.5}), {}, 0, 0);
        typeAll(drag, typed.toLatin1().constData());
        QTEST(drag.readOut(), "said");
    }

    void keysThatAreNumbers() {
        const GizmoPose place = turned();
        GizmoDrag drag({GizmoHandle::Kind::Axis, 0, 1}, place, rayTo(place, Vec3::Zero()), {});
        for (const char* refused : {" ", "\t", "\r", "12", ""}) QVERIFY2(!drag.type(0, QLatin1String(refused)), refused);
        QVERIFY(drag.type(Qt::Key_Backspace, {})); // nothing to take back
        for (const char* taken : {"-", "1", ".", "5", " ", "c", "m", ","}) QVERIFY2(drag.type(0, QLatin1String(taken)), taken);
        QCOMPARE(drag.typed(), std::string("-1.5 cm,"));
        QVERIFY(drag.type(Qt::Key_Backspace, {}));
        QCOMPARE(drag.typed(), std::string("-1.5 cm"));
        QVERIFY(drag.type(0, QStringLiteral("µ")) && drag.type(Qt::Key_Backspace, {})); // two bytes
        QCOMPARE(drag.typed(), std::string("-1.5 cm"));
    }

    /// A size that is typed is the size itself. A handle on one side moves that side; the other side stays.
    void sizesOfShapes_data() {
        QTest::addColumn<int>("sides");
        QTest::addColumn<bool>("aboutCentre");
        QTest::addColumn<bool>("oneSided");
        QTest::newRow("both") << int(Sides::Both) << false << true;
        QTest::newRow("both, about the centre") << int(Sides::Both) << true << false;
        QTest::newRow("radius") << int(Sides::Middle) << false << false;
        QTest::newRow("upper") << int(Sides::Upper) << true << true;
        QTest::newRow("lower") << int(Sides::Lower) << true << true;
    }
    void sizesOfShapes() {
        QFETCH(int, sides);
        QFETCH(bool, aboutCentre);
        QFETCH(bool, oneSided);
        GizmoPose place = turned();
        place.half = {0.1, 0.2, 0.3};
        place.sizes[1] = {QStringLiteral("Length"), 2, static_cast<Sides>(sides)};
        for (const int side : {1, -1}) {
            GizmoDrag drag({GizmoHandle::Kind::Size, 1, side}, place, rayTo(place, {0, 0.2 * side, 0}), {});
            drag.to(rayTo(place, {0, 0.26 * side, 0}), {}, 0, 0, aboutCentre);
            const double grown = oneSided ? 0.03 : 0.06; // half the extent
            QVERIFY((drag.amount() - Vec3(0, grown, 0)).norm() < 1e-9);
            const Vec3 moved = oneSided ? Vec3(place.axes.col(1) * grown * side) : Vec3::Zero();
            QVERIFY((drag.motion().position - moved).norm() < 1e-9);
            QCOMPARE(drag.readOut(), oneSided ? QStringLiteral("Length  0.46 m") : QStringLiteral("Length  0.52 m"));
            drag.to(rayTo(place, {0, 0.26 * side, 0}), {}, 0.05, 0, aboutCentre); // the size in steps
            QVERIFY(std::abs(2 * drag.amount().y() - (oneSided ? 0.05 : 0.1)) < 1e-9);
            typeAll(drag, "0.5");
            QVERIFY(std::abs(drag.amount().y() - 0.05) < 1e-12); // from 0.4 to 0.5
            QCOMPARE(drag.readOut(), QStringLiteral("Length  0.5 m   › 0.5"));
            for (int i = 0; i < 3; ++i) drag.type(Qt::Key_Backspace, {});
            typeAll(drag, "-1"); // no size: the mouse counts
            QVERIFY(std::abs(2 * drag.amount().y() - (oneSided ? 0.05 : 0.1)) < 1e-9);
        }
    }

    void anglesKeepTheirUnit() {
        const double before[] = {0, 0, 90}, after[] = {45, 0, 90};
        QCOMPARE(withNumbers("0 deg, 0, 90", before, after, "deg", 1e-4), std::string("45 deg, 0, 90"));
        QCOMPARE(withNumbers("0 rad,0,90", before, after, "deg", 1e-4), std::string("0.785398 rad,0,90"));
    }
};

QTEST_APPLESS_MAIN(NumbersTest)
#include "numbers_test.moc"
