#pragma once
// Texts for the tests of the language: examples, and seeded random bytes and tokens.

#include <QByteArray>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/rng.h"
#include "lang/diagnostic_text.h"
#include "lang/tree.h"

namespace texts {

inline QByteArray q(std::string_view text) { return {text.data(), static_cast<qsizetype>(text.size())}; }

inline std::shared_ptr<const trundle::Tree> parsed(std::string text) {
    return trundle::parse(std::make_shared<const trundle::SourceText>("t.sim", std::move(text)), 0);
}

/// All diagnostics of a tree, rendered as text.
inline std::string messages(const trundle::Tree& tree) {
    trundle::SourceTable table;
    table.add(tree.sharedSource());
    std::string all;
    for (const trundle::Diagnostic& d : tree.diagnostics()) all += trundle::render(d, table);
    return all;
}

inline bool longRun() { return qEnvironmentVariableIntValue("TRUNDLE_LONG") != 0; }

/// Pseudo-random numbers below a bound, the same in every run.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : m_seed(seed) {}
    std::size_t below(std::size_t bound) {
        return static_cast<std::size_t>(trundle::randomBits(m_seed, 0, 0, m_index++) % bound);
    }
    bool chance(std::size_t one, std::size_t in) { return below(in) < one; }

private:
    std::uint64_t m_seed, m_index = 0;
};

inline std::string randomBytes(RandomNumbers& rng, std::size_t most) {
    std::string text;
    for (std::size_t n = rng.below(most); n > 0; --n) text += static_cast<char>(rng.below(256));
    return text;
}

/// Random tokens of this and similar languages.
inline std::string randomSoup(RandomNumbers& rng, std::size_t most) {
    static const std::vector<std::string_view> kPieces{"{",
                                                       "}",
                                                       "=",
                                                       ",",
                                                       ".",
                                                       "$",
                                                       "$(",
                                                       "(",
                                                       ")",
                                                       "+",
                                                       "-",
                                                       "*",
                                                       "/",
                                                       "^",
                                                       "\"",
                                                       "\"text\"",
                                                       "\\",
                                                       "//",
                                                       "// c\n",
                                                       "/*",
                                                       "*/",
                                                       "/* c */",
                                                       "#",
                                                       "#import",
                                                       "#import a.sim\n",
                                                       "\n#loadModule b.dll",
                                                       "Param",
                                                       "Param x = 1",
                                                       "true",
                                                       "false",
                                                       "world",
                                                       "Box",
                                                       "Robot r {",
                                                       "Pos = 1,2,3",
                                                       "Mass=2",
                                                       "Key",
                                                       "a.b.c = 3",
                                                       "x",
                                                       "1",
                                                       "-2.5",
                                                       "3cm",
                                                       "4 m/s",
                                                       "1e9",
                                                       "1e999",
                                                       ".5",
                                                       "0x1F",
                                                       "1.2.3",
                                                       " ",
                                                       " ",
                                                       "  ",
                                                       "\t",
                                                       "\n",
                                                       "\n",
                                                       "\r\n",
                                                       "\r",
                                                       "\xE2\x88\x92",
                                                       "\xE2\x88\x92"
                                                       "3",
                                                       "\xEF\xBB\xBF",
                                                       "\xC2\xA0",
                                                       "\xFF",
                                                       std::string_view("\0", 1),
                                                       "'a'",
                                                       "\xE2\x80\x9C"
                                                       "a\xE2\x80\x9D",
                                                       ";",
                                                       ":",
                                                       "==",
                                                       "[",
                                                       "]",
                                                       "%",
                                                       "\xC2\xB0",
                                                       "$name",
                                                       "$(a+1)",
                                                       "$(min(a,2)^-b)",
                                                       "file.csv",
                                                       "..",
                                                       "c-d",
                                                       "&",
                                                       "!",
                                                       "~",
                                                       "@",
                                                       "`",
                                                       "|",
                                                       "<",
                                                       ">"};
    std::string text;
    for (std::size_t n = rng.below(most); n > 0; --n) text += kPieces[rng.below(kPieces.size())];
    return text;
}

/// One to five small changes of bytes.
inline std::string mutated(RandomNumbers& rng, std::string text) {
    for (std::size_t n = 1 + rng.below(5); n > 0; --n) {
        const std::size_t at = rng.below(text.size() + 1);
        switch (rng.below(4)) {
        case 0: text.insert(at, 1, static_cast<char>(rng.below(256))); break;
        case 1:
            if (at < text.size()) text.erase(at, 1 + rng.below(4));
            break;
        case 2:
            if (at < text.size()) text[at] = static_cast<char>("{}=,.\"/* \n#$()"[rng.below(14)]);
            break;
        default: text.insert(at, text.substr(rng.below(text.size() + 1), rng.below(30))); break;
        }
    }
    return text;
}

inline constexpr std::string_view kRobot = R"(#import common/materials.sim
#import common/surfaces.sim

Surface plastic { Friction=0.2 Restitution=0.2 }     // chassis
Surface rubber  { Friction=1.0 Restitution=0.1 }     // tyres

RobotConfig SimpleRobot {
  Param wheelRadius = 0.05
  Param trackWidth  = 0.25

  Body chassis {
    // the plate
    Box hull      { Size=0.30,0.20,0.10  Pos=0,0,0.09  Mass=2.0  Material=lightgrey  Surface=plastic }
    Box bumper    { Size=2 cm, 0.30, 0.04  Pos=0.16,0,0.07  Mass=0.05  Material=red }
  }
  Body leftWheel  { Pos=0.06, $(trackWidth/2), $wheelRadius
    Cylinder tyre { Radius=$wheelRadius Length=0.03 HPR=0,0,90 Mass=0.15 Material=black Surface=rubber } }
  Hinge leftAxle  { Parent=chassis Child=leftWheel  Axis=0,1,0 }
  RotaryMotor leftMotor  { Joint=leftAxle  TorqueConstant=0.02 SpeedConstant=50 Resistance=2 GearRatio=30 MaxVoltage=12 }
  TouchSensor frontTouch { Geom=chassis.bumper }
}
)";

inline constexpr std::string_view kExperiment = R"(Tick = 0.01   Duration = 12
#import robots/simple_robot.sim
#loadModule controllers/linear_motion

Static arena { Config=MediumArena Pos=0,0,0 }
Robot robot0 {
  Config=SimpleRobot  Pos=-1.5,0,0  HPR=0,0,0
  leftMotor.Resistance = 3
  LinearMotion brain { Distance=1.0 Speed=0.2 }
}
PoseLog path { Robot=robot0 Interval=0.1 File=linear_motion.csv }
)";

inline std::string withCrLf(std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return out;
}

inline std::string withTabs(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const bool lineBegin = i == 0 || text[i - 1] == '\n' || text[i - 1] == '\t' || (out.size() && out.back() == '\t');
        if (lineBegin && text.substr(i, 2) == "  ") out += '\t', i += 2;
        else out += text[i++];
    }
    return out;
}

inline std::vector<std::string> examples() {
    const std::string robot(kRobot), experiment(kExperiment);
    return {robot,
            experiment,
            withCrLf(robot),
            withTabs(robot),
            "\xEF\xBB\xBF" + experiment,
            robot.substr(0, robot.size() - 1),
            withTabs(withCrLf(experiment)),
            "Box b {}",
            "Box b { }",
            "Box b {\n}",
            "Box b { // c\n}",
            "Box b { Mass=1 // c\n}",
            "A { B { C { x=1 } } }\n",
            "x = 1",
            "x = 1 // c",
            "// only a comment",
            "",
            "\n\n"};
}

} // namespace texts
