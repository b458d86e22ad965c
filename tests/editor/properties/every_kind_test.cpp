// Inserts every registered kind as the Insert menu does, and edits each of its property rows with keys and clicks.
#include "properties_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QToolButton>

#include "editor/properties/editors/row_editor.h"
#include "editor/properties/property_row.h"
#include "model/provenance.h"
#include "project/objects/value_text.h"

using namespace trundle;

namespace {

const std::string kWorld = R"(
Material blue { ColorRGB=0,0,1 }
Surface slick { Friction=0 }
AntennaPattern lobe { Model=cosine }
StaticConfig Yard { Box wall { Size=1,0.1,0.3 Pos=0,2,0.15 Material=grey Surface=slick } }
StaticConfig Hall { Box wall { Size=1,0.1,0.3 Pos=0,3,0.15 Material=grey Surface=slick } }
PartConfig Peg { Body peg { Box box { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=1 Material=grey Surface=slick } } }
PartConfig Knob { Body knob { Box box { Size=0.1,0.1,0.1 Pos=0,0,0.2 Mass=1 Material=grey Surface=slick } } }
RobotConfig Other { Body body { Box box { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=1 Material=grey Surface=slick } } }
RobotConfig Seer {
  Body body { Box box { Size=0.1,0.1,0.1 Pos=0,0,0.05 Mass=1 Material=grey Surface=slick } }
  Camera eye { Body=body }
}
Static yard { Config=Yard }
Robot robot0 { Config=Rover Pos=0,0,0 }
Robot robot1 { Config=Rover Pos=1,0,0 }
Robot seer { Config=Seer Pos=0,-1,0 }
View other { }
)";

/// The path of a parent in which the kind is allowed.
std::string parentOf(const Kind& kind) {
    const auto in = [&](const char* parent) { return std::count(kind.parents.begin(), kind.parents.end(), parent) > 0; };
    if (in("RobotConfig")) return "RobotConfig.Rover";
    if (in("")) return "";
    if (in("Body")) return "RobotConfig.Rover.chassis";
    if (in("StaticConfig")) return "StaticConfig.Yard";
    return in("Robot") ? "robot0" : "";
}

/// Valid numbers of a property, the most likely first.
std::vector<double> legalNumbers(const Property& p) {
    std::vector<double> numbers;
    for (double n : {1.0, 2.0, 0.5, 0.25, 3.0, 0.05, 0.02, 10.0, 0.0, -1.0, 2e6}) {
        const bool low = p.minExclusive ? n > p.minimum : n >= p.minimum;
        const bool high = p.maxExclusive ? n < p.maximum : n <= p.maximum;
        const bool whole = p.type != PropertyType::Integer || n == std::floor(n);
        if (low && high && whole) numbers.push_back(n);
    }
    return numbers;
}

} // namespace

class EveryKindTest : public QObject {
    Q_OBJECT

    /// Enters other values with the row's own widgets until the document accepts one. Returns the values, for the message.
    static QString edit(PropertiesFixture& fixture, const QString& id) {
        const auto bytes = [&] {
            std::string all;
            for (std::size_t i = 0; i < fixture.document.texts().files().size(); ++i) all += fixture.text(i);
            return all;
        };
        const std::string before = bytes();
        const auto changed = [&] { return bytes() != before; };
        QString tried;
        const auto* row = qobject_cast<PropertyRow*>(fixture.row(qPrintable(id)));
        const Property p = *row->row().property();
        const EditorKind kind = row->row().editor();
        if (kind == EditorKind::Choice) {
            auto* box = fixture.field<QComboBox>(qPrintable(id));
            for (int i = 0; i < box->count() && !changed(); ++i) {
                box->setFocus();
                QTest::keyClick(box, i == 0 ? Qt::Key_Home : Qt::Key_Down);
                tried += box->currentText() + QLatin1Char('|');
            }
        } else if (kind == EditorKind::Flag) {
            QTest::keyClick(fixture.field<QCheckBox>(qPrintable(id)), Qt::Key_Space);
        } else if (kind == EditorKind::Numbers || kind == EditorKind::Colour) {
            const bool one = p.maxCount == 1;
            const QString first = fixture.shown(qPrintable(id), one ? "field" : "field0");
            for (double n : legalNumbers(p)) {
                const QString text = QString::fromStdString(plainNumber(n));
                if (changed() || text == first) continue;
                tried += text + QLatin1Char('|');
                fixture.type(qPrintable(id), text, one ? "field" : "field0");
            }
        } else if (kind == EditorKind::Reference) {
            auto* pick = fixture.field<QToolButton>(qPrintable(id), "pick");
            Q_EMIT pick->menu()->aboutToShow();
            for (qsizetype i = 0; i < pick->menu()->actions().size() && !changed(); ++i) {
                QAction* action = pick->menu()->actions().at(i);
                tried += action->text() + QLatin1Char('|');
                if (!action->isChecked()) action->trigger();
                if (!changed()) Q_EMIT pick->menu()->aboutToShow();
            }
        } else if (kind == EditorKind::File) {
            tried = QStringLiteral("other.") + QString::fromStdString(p.choices.empty() ? "txt" : p.choices.front());
            fixture.type(qPrintable(id), tried);
        } else {
            for (const char* text : {"other", "1", "1,2", "1,1,1", "90,180", "1,1,1,1", "robot1", "robot1/pose", "1,2,3",
                                     "seer/eye", "left,right", "-1"}) {
                if (changed()) break;
                tried += QLatin1String(text) + QLatin1Char('|');
                fixture.type(qPrintable(id), QLatin1String(text));
            }
        }
        return changed() ? QString() : tried + fixture.help();
    }

    /// Inserts the template of a kind. Returns why it cannot be.
    static QString insert(PropertiesFixture& fixture, const std::string& name) {
        const LoadedProject& loaded = *fixture.document.loaded();
        const Kind& kind = *loaded.registry->find(name);
        const std::string parent = parentOf(kind);
        const Result<EditPlan> plan = planInsert(loaded, parent, templateOf(loaded, kind, parent));
        if (!plan) return QString::fromStdString(plan.error().message);
        const Status done = fixture.document.edits().apply(QStringLiteral("Insert"), plan);
        return done ? QString() : QString::fromStdString(done.error().message);
    }

    static QString faults(const PropertiesFixture& fixture) {
        QStringList all;
        for (const Diagnostic& d : fixture.document.loaded()->diagnostics.all())
            if (d.severity == Severity::Error) all << QString::fromStdString(d.message);
        return all.join(QLatin1Char('\n'));
    }

    /// True if the property is only valid together with another value of the object.
    static bool needsCompany(const Kind& kind, const std::string& property) {
        for (const Alternatives& choice : kind.alternatives)
            if (std::count(choice.names.begin(), choice.names.end(), property)) return true;
        if (kind.role == Role::Config && property == "Config") return true; // the blocks of a variant have names of their own
        if (kind.name == "Universal" && property.starts_with("Axis")) return true; // the axes must be perpendicular
        if (property == "NoContact") return true; // a pair
        if (kind.name == "Scatter" && property == "Config") return true; // large scenery finds no free places
        if (kind.name == "Gear") return true;                                      // its joints and the ratio must fit each other
        return property == "Density" || (property == "Mass" && kind.role != Role::Log); // mutually exclusive
    }

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void rows_data() {
        QTest::addColumn<QString>("name");
        const FixtureApplication application;
        for (const Kind* kind : application.builtIn()->all())
            QTest::newRow(kind->name.c_str()) << QString::fromStdString(kind->name);
    }
    void rows() {
        QFETCH(QString, name);
        PropertiesFixture fixture;
        for (const char* file : {"mesh.obj", "other.obj", "hills.png", "other.png", "other.jpg"}) fixture.write(file, "x");
        fixture.write("other.csv", "azimuth,elevation,gain\n0,0,0\n");
        QVERIFY(fixture.open(kWorld));
        QCOMPARE(fixture.document.loaded()->diagnostics.errorCount(), 0u);
        const Kind kind = *fixture.application.builtIn()->find(name.toStdString());
        if (kind.role != Role::Settings) {
            for (int i = 0; i < 2 && kind.name == "LinearMotor"; ++i) QCOMPARE(insert(fixture, "Slider"), QString()); // to choose from
            for (int i = 0; i < 2 && kind.name == "OmniDrive"; ++i) QCOMPARE(insert(fixture, "RotaryMotor"), QString());
            QCOMPARE(insert(fixture, kind.name), QString());
            QCOMPARE(faults(fixture), QString());
            QVERIFY(!fixture.selection.empty());
            const std::vector<std::string> made = fixture.selection.paths();
            for (const std::string& path : made) { // objects that it requires may have been inserted too
                fixture.selection.select(path);
                if (fixture.panel.findChild<QLabel*>(QStringLiteral("objectKind"))
                        ->text()
                        .contains(QLatin1Char('>') + name + QLatin1Char('<')))
                    break;
            }
        }
        fixture.picture(qPrintable(name));
        const std::string object = fixture.selection.current();
        std::vector<std::string> files;
        for (std::size_t i = 0; i < fixture.document.texts().files().size(); ++i) files.push_back(fixture.text(i));
        for (const Property& p : kind.properties) {
            const QString id = QString::fromStdString(p.name);
            QVERIFY2(fixture.row(p.name.c_str()), p.name.c_str());
            const std::string path = object.empty() ? p.name : object + "." + p.name;
            const auto provenance = provenanceOf(*fixture.document.loaded()->outline, path);
            QVERIFY2(provenance, path.c_str());
            const auto* row = qobject_cast<PropertyRow*>(fixture.row(p.name.c_str()));
            QCOMPARE(row->row().given(), provenance->origin != Origin::Default);
            const std::size_t done = fixture.document.edits().history().position();
            const QString refused = edit(fixture, id);
            if (!refused.isEmpty() && needsCompany(kind, p.name)) {
                QVERIFY2(refused.size() > 10, qPrintable(id)); // the message gives a reason
                continue;
            }
            QVERIFY2(refused.isEmpty(), qPrintable(id + QStringLiteral(": ") + refused));
            QCOMPARE(fixture.document.edits().history().position(), done + 1);
            if (!needsCompany(kind, p.name)) QCOMPARE(faults(fixture), QString());
            fixture.document.edits().undo();
            for (std::size_t i = 0; i < files.size(); ++i) QCOMPARE(fixture.text(i), files[i]);
        }
    }

    void aKindAddedWhileItRuns() {
        struct Sonar {
            std::string body, mode = "wide";
            double range = 3;
            std::array<double, 3> pos{0, 0, 0};
            bool loud = false;
            static void describe(Describe<Sonar>& d) {
                d.help("Hears walls.");
                d.field("Body", &Sonar::body, reference("Body").required(), "Where it sits.");
                d.field("Pos", &Sonar::pos, metres().within(-10, 10), "Where on it.");
                d.field("Range", &Sonar::range, metres().above(0).atMost(20).live(), "How far it hears.");
                d.field("Mode", &Sonar::mode, oneOf("wide|narrow"), "Its beam.");
                d.field("Loud", &Sonar::loud, flag(), "Audible.");
            }
        };
        PropertiesFixture fixture;
        fixture.application.add(kindOf<Sonar>("Sonar", Role::Device, {"RobotConfig"}));
        QVERIFY(fixture.open(kWorld));
        const Result<EditPlan> plan = planInsert(*fixture.document.loaded(), "RobotConfig.Rover", "Sonar front { Body=chassis }");
        QVERIFY(plan.ok() && fixture.document.edits().apply(QStringLiteral("Insert"), plan).ok());
        fixture.selection.select("robot0.front");
        const std::string before = fixture.text();
        fixture.type("Range", QStringLiteral("150 cm"));
        QVERIFY2(fixture.text().find("front.Range=150 cm") != std::string::npos, fixture.text().c_str());
        QVERIFY(fixture.help().startsWith(QStringLiteral("How far it hears.")));
        QTest::keyClick(fixture.field<QCheckBox>("Loud"), Qt::Key_Space);
        QVERIFY(fixture.text().find("front.Loud=true") != std::string::npos);
        fixture.type("Range", QStringLiteral("21"));
        QVERIFY(fixture.field("Range")->refused());
        fixture.picture("Sonar");
        fixture.document.edits().undo();
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
    }
};

QTEST_MAIN(EveryKindTest)
#include "every_kind_test.moc"
