// Suggestions for misspelt words.
#include <QTest>
#include <cctype>
#include <set>

#include "base/rng.h"
#include "base/spelling.h"

using namespace trundle;

namespace {

// Property keys and kinds of the language, as one registry holds them.
const std::vector<std::string> kWords{"Tick",
                                      "Duration",
                                      "Seed",
                                      "Gravity",
                                      "Solver",
                                      "Iterations",
                                      "Isolation",
                                      "Title",
                                      "Description",
                                      "Material",
                                      "ColorRGB",
                                      "Texture",
                                      "TextureScale",
                                      "TextureMap",
                                      "Shininess",
                                      "Opacity",
                                      "Emission",
                                      "Surface",
                                      "Friction",
                                      "Restitution",
                                      "RollingFriction",
                                      "Softness",
                                      "RobotConfig",
                                      "StaticConfig",
                                      "SelfCollision",
                                      "Static",
                                      "Robot",
                                      "Config",
                                      "Pos",
                                      "HPR",
                                      "Grid",
                                      "Scatter",
                                      "Count",
                                      "Spacing",
                                      "Area",
                                      "MinDistance",
                                      "Heading",
                                      "PoseLog",
                                      "SignalLog",
                                      "ContactLog",
                                      "EnergyLog",
                                      "Signals",
                                      "Interval",
                                      "File",
                                      "Body",
                                      "Mass",
                                      "CenterOfMass",
                                      "Inertia",
                                      "Box",
                                      "Sphere",
                                      "Cylinder",
                                      "Capsule",
                                      "Convex",
                                      "Mesh",
                                      "Plane",
                                      "Heightfield",
                                      "Size",
                                      "Radius",
                                      "Length",
                                      "Scale",
                                      "Density",
                                      "Collide",
                                      "Visible",
                                      "Shape",
                                      "Hinge",
                                      "Slider",
                                      "Ball",
                                      "Universal",
                                      "Fixed",
                                      "Suspension",
                                      "Parent",
                                      "Child",
                                      "Anchor",
                                      "Axis",
                                      "Axis2",
                                      "LowStop",
                                      "HighStop",
                                      "Damping",
                                      "Stiffness",
                                      "Travel",
                                      "RotaryMotor",
                                      "Joint",
                                      "TorqueConstant",
                                      "SpeedConstant",
                                      "BackEmfConstant",
                                      "Resistance",
                                      "GearRatio",
                                      "MaxVoltage",
                                      "Inductance",
                                      "Efficiency",
                                      "RotorInertia",
                                      "DifferentialDrive",
                                      "LeftMotor",
                                      "RightMotor",
                                      "WheelRadius",
                                      "WheelSeparation",
                                      "Control",
                                      "MaxAcceleration",
                                      "MaxAngularAcceleration",
                                      "Encoder",
                                      "CountsPerRevolution",
                                      "Quadrature",
                                      "Index",
                                      "TouchSensor",
                                      "Geom",
                                      "MinForce",
                                      "UpdatePeriod",
                                      "Budget"};

std::set<std::string> typosOf(const std::string& word) {
    std::set<std::string> typos;
    for (std::size_t i = 0; i <= word.size(); ++i) {
        for (const char c : std::string_view("aeilnqrstx")) {
            typos.insert(word.substr(0, i) + c + word.substr(i));
            if (i < word.size()) typos.insert(word.substr(0, i) + c + word.substr(i + 1));
        }
        if (i < word.size()) typos.insert(word.substr(0, i) + word.substr(i + 1));
        if (i + 1 < word.size()) typos.insert(word.substr(0, i) + word[i + 1] + word[i] + word.substr(i + 2));
        std::string other = word;
        if (i < word.size())
            other[i] = static_cast<char>(std::islower(static_cast<unsigned char>(other[i]))
                                             ? std::toupper(static_cast<unsigned char>(other[i]))
                                             : std::tolower(static_cast<unsigned char>(other[i])));
        typos.insert(other);
    }
    return typos;
}

} // namespace

class SpellingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ranksRightWordFirst() {
        int right = 0, all = 0;
        std::string missed;
        for (const std::string& word : kWords) {
            for (const std::string& typo : typosOf(word)) {
                if (typo.empty() || std::find(kWords.begin(), kWords.end(), typo) != kWords.end()) continue;
                ++all;
                const auto near = nearestWords(typo, kWords);
                if (!near.empty() && near[0] == word) ++right;
                else if (missed.size() < 600) missed += typo + "->" + (near.empty() ? "nothing" : near[0]) + " ";
            }
        }
        QVERIFY2(right >= 0.97 * all,
                 qPrintable(QString("%1 of %2; missed %3").arg(right).arg(all).arg(QString::fromStdString(missed))));
    }

    void caseCostsLessThanALetter() {
        QVERIFY(spellingDistance("mass", "Mass") < spellingDistance("Mess", "Mass"));
        QCOMPARE(spellingDistance("Mass", "Mass"), 0.0);
        QCOMPARE(spellingDistance("Pso", "Pos"), 1.0);
        QCOMPARE(spellingDistance("", "Pos"), 3.0);
        QCOMPARE(nearestWords("MASS", kWords).at(0), std::string("Mass"));
        QCOMPARE(nearestWords("hpr", kWords).at(0), std::string("HPR"));
        QCOMPARE(nearestWords("wheelradius", kWords).at(0), std::string("WheelRadius"));
    }

    void splitsWordsIntoParts() {
        QCOMPARE(nearestWords("Color", kWords).at(0), std::string("ColorRGB"));
        QCOMPARE(nearestWords("Rad", kWords).at(0), std::string("Radius"));
        QCOMPARE(nearestWords("CountsPerRev", kWords).at(0), std::string("CountsPerRevolution"));
    }

    void nothingWhereNothingIsNear() {
        QVERIFY(nearestWords("Xylophone", kWords).empty());
        QVERIFY(nearestWords("q", kWords).empty());
        QVERIFY(nearestWords("", kWords).empty());
        QVERIFY(nearestWords(std::string(1000000, 'a'), kWords).empty());
        QVERIFY(nearestWords("Mass", {}).empty());
    }

    void keepsOrderOfTiesWithoutDuplicates() {
        const std::vector<std::string> words{"bat", "cat", "bat", "hat", "rat"};
        QCOMPARE(nearestWords("xat", words), (std::vector<std::string>{"bat", "cat", "hat"}));
        QCOMPARE(nearestWords("xat", words, 1).size(), std::size_t(1));
    }
};

QTEST_APPLESS_MAIN(SpellingTest)
#include "spelling_test.moc"
