// A mistake is reported once, at the value that is wrong: at that of an instance rather than in the config that it uses.
#include <set>

#include <QTest>

#include "reported.h"
#include "schema/value_reader.h"

using namespace trundle;
using sample::reported;
using sample::Resolved;

namespace {

const std::string kHead = "Material g { } Surface s { }\n";
const std::string kBox = "Box h { Size=0.1,0.1,0.1 Mass=1 Material=g Surface=s }";
const std::string kLook = "Material red { }\nRobotConfig A { Param m = red Body b { "
                          "Box h { Size=1,1,1 Mass=1 Material=$m Surface=s } "
                          "Box k { Size=1,1,1 Mass=1 Material=$m Surface=s } } }\n";

} // namespace

class MessagePlacesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void messages_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char* name, const std::string& text, const char* message) {
            QTest::newRow(name) << QString::fromStdString(kHead + text) << message;
        };
        const std::string post =
            "StaticConfig P { Param h = 0.1 { Min=0.05 Max=1 } Box w { Size=0.1,0.1,$h Material=g Surface=s } }\n";
        row("a grid", post + "Grid n { Config=P Count=5 Spacing=1 h=$(1.5+index) }\n",
            "E203 h is 1.5, it must be from 0.05 to 1 | $(1.5+index) | its values are described here: { Min=0.05 Max=1 } | "
            "in its member n_0: n");
        row("a later member", post + "Grid n { Config=P Count=5 Spacing=1 h=$(0.5+0.5*index) }\n",
            "E203 h is 1.5, it must be from 0.05 to 1 | $(0.5+0.5*index) | its values are described here: { Min=0.05 Max=1 } | "
            "in its "
            "member n_2: n");
        row("a scatter of robots",
            "RobotConfig K { Param m = 1 { Max=2 } Body b { " + kBox +
                " } Body c { Mass=$m Sphere s { Radius=1 Material=g Surface=s } } }\n"
                "Scatter n { Config=K Count=5 Area=-50,-50,50,50 m=$(2+index) }\n",
            "E203 m is 3, it must be at most 2 | $(2+index) | its values are described here: { Max=2 } | in its member n_1: n");

        const std::string boxes =
            "Box a { Size=1,1,1 Pos=$v Material=g Surface=s } Box b { Size=1,1,1 Pos=$v Material=g Surface=s }";
        row("a list", "StaticConfig P { Param v = 1,2,3 " + boxes + " }\nStatic n { Config=P v=1,2 }\n",
            "E204 Pos has 2 elements, it takes three numbers | 1,2 | it is used here: $v");
        row("a list for a number",
            "StaticConfig P { Param h = 1 Box a { Size=0.1,$h,$h Material=g Surface=s } }\nStatic n { Config=P h=1,2 }\n",
            "E204 Size has 5 elements, it takes three numbers | 1,2 | it is used here: 0.1,$h,$h");
        row("a list for a name",
            "StaticConfig P { Param c = g Box a { Size=1,1,1 Material=$c Surface=s } }\nStatic n { Config=P c=g,g,g }\n",
            "E204 Material has 3 elements, it takes a name | g,g,g | it is used here: $c");
        row("a list of a part",
            "PartConfig W { Param v = 1,2,3 Box a { Size=$v Material=g Surface=s } }\nStaticConfig P { Part w { Config=W v=1,2 } "
            "}\n",
            "E204 Size has 2 elements, it takes three numbers | 1,2 | it is used here: $v");
        row("a list of the text",
            "StaticConfig P { Param h = 1 Box a { Size=$h,$h Material=g Surface=s } }\nStatic n { Config=P h=2 }\n",
            "E204 Size has 2 elements, it takes three numbers | $h,$h");

        const auto hinge = [](const std::string& stops, const std::string& more) {
            return "RobotConfig A { Param m = 10 Param k = 10 Body b { " + kBox + " } Hinge h { Parent=world Child=b " + stops +
                   " } }\n" + more;
        };
        row("stops", hinge("LowStop=20 HighStop=10", ""),
            "E307 the LowStop of Hinge h is above its HighStop | 20 | fix exchange them");
        row("a stop of a robot", hinge("LowStop=-10 HighStop=10", "Robot n { Config=A h.LowStop=50 }\n"),
            "E307 the LowStop of Hinge h is above its HighStop | 50");
        row("the other stop of a robot", hinge("LowStop=-10 HighStop=10", "Robot n { Config=A h.HighStop=-50 }\n"),
            "E307 the LowStop of Hinge h is above its HighStop | -50");
        row("a stop by a Param", hinge("LowStop=-10 HighStop=$m", "Robot n { Config=A m=-50 }\n"),
            "E307 the LowStop of Hinge h is above its HighStop | -50 | it is used here: $m");
        row("one of two stops by Params", hinge("LowStop=$(-1*m) HighStop=$k", "Robot n { Config=A k=-50 }\n"),
            "E307 the LowStop of Hinge h is above its HighStop | -50 | it is used here: $k");
        row("a stop of a part",
            "PartConfig W { Param k = 10 Body b { " + kBox +
                " } Hinge h { Parent=world Child=b LowStop=-10 HighStop=$k } }\n"
                "RobotConfig A { Part w { Config=W k=-50 } }\n",
            "E307 the LowStop of Hinge h is above its HighStop | -50 | it is used here: $k");
        row("a stop by a default", hinge("LowStop=20 HighStop=$m", ""),
            "E307 the LowStop of Hinge h is above its HighStop | $m | the value is given here: 10");

        const std::string three =
            "RobotConfig A { Param p = b Body b { " + kBox + " } Body b2 { " + kBox + " } Body b3 { " + kBox +
            " }\n Slider h { Parent=$p Child=b2 } Slider h2 { Parent=b Child=b3 } Slider h3 { Parent=b Child=b2 }\n"
            " Gear g { Joint=h Other=h2 Ratio=1 } }\n";
        const char* const twice =
            "E334 two joints join the same bodies, h and h3: they act against each other; keep one of them | h3\n";
        const auto overridden = [&](const char* name, const char* config, const std::string& message) {
            row(name, three + config, (twice + message).c_str());
        };
        overridden("a parent of a variant", "RobotConfig B { Config=A h3.Parent=b2 }\n",
                   "E307 the child of Slider h3 is its parent as well | b2");
        overridden("a parent of a robot", "Robot n { Config=A h2.Parent=b3 }\n",
                   "E307 the child of Slider h2 is its parent as well | b3");
        overridden("a child of a robot", "Robot n { Config=A h2.Child=b }\n",
                   "E307 the child of Slider h2 is its parent as well | b");
        overridden("a joint of a gear", "Robot n { Config=A g.Joint=h2 }\n", "E307 Gear g couples h2 with itself | h2");
        overridden("a parent by a Param", "Robot n { Config=A p=b2 }\n",
                   "E307 the child of Slider h is its parent as well | b2 | it is used here: $p");
        row("a ratio with a unit", sample::with(three, "Ratio=1", "Ratio=5 mm"),
            (twice + std::string("E206 Ratio has no unit, it cannot be in mm | mm | fix 0.005")).c_str());

        const std::string lane = "RobotConfig A { Body b { " + kBox +
                                 " } }\nRobot out { Config=A Pos=9,9,9 }\n"
                                 "Repeat lane { Count=2 Pos=0,$index,0 Robot r { Config=A } ";
        row("a body with the name of the Repeat", lane + "Hinge h { Parent=world Child=lane.r.b } }\n",
            "E208 Child names lane.r.b, but there is no such body of a robot (robot.body) | lane.r.b | fix r.b");
        row("a body of a member", lane + "Hinge h { Parent=world Child=r.chassis } }\n",
            "E208 Child names r.chassis, but there is no such body of a robot (robot.body); there is r.b | r.chassis");
        row("robots of a member", lane + "Region n { Size=1,1,1 Robots=rrrrr } }\n",
            "E208 Robots names rrrrr, but there is no such robot; there are r and out | rrrrr");
        row("a robot of a member", lane + "Region n { Size=1,1,1 Robots=outt } }\n",
            "E208 Robots names outt, but there is no such robot | outt | fix out");

        row("a robot of several", lane + "Region n { Size=1,1,1 Robots=r, outt } }\n",
            "E208 Robots names outt, but there is no such robot | outt | fix out");
        const std::string two =
            "RobotConfig A { Body b { " + kBox + " } }\nRobot r { Config=A }\nRobot q { Config=A Pos=9,9,9 }\n";
        const char* const noLook =
            "E208 Material names redd, but there is no such Material | redd | it is used here: $m | fix red";
        row("a Material of a robot by a Param", kLook + "Robot n { Config=A m=redd }\n", noLook);
        row("a Material of a variant by a Param", kLook + "RobotConfig B { Config=A m=redd }\nRobot n { Config=B }\n", noLook);
        row("a Material by a default", sample::with(kLook, "m = red", "m = redd"), noLook);
        row("a Surface of a part by a Param",
            "Surface ice { }\nPartConfig P { Param m = ice Box b { Size=1,1,1 Material=g Surface=$m } }\n"
            "StaticConfig A { Part p { Config=P m=icce } }\nStatic n { Config=A }\n",
            "E208 Surface names icce, but there is no such Surface | icce | it is used here: $m | fix ice");
        const std::string wheels = "PartConfig Wheel { Body w { " + kBox + " } }\nRobotConfig A { Param kind = Wheel Body b { " +
                                   kBox + " } Part l { Config=$kind } }\n";
        row("a Config of a variant by a Param", wheels + "RobotConfig B { Config=A kind=Wheal }\nRobot n { Config=B }\n",
            "E208 Config names Wheal, but there is no such PartConfig | Wheal | it is used here: $kind | fix Wheel");
        row("a Config of another kind by a Param", wheels + "Robot n { Config=A kind=A }\n",
            "E208 Config names A, a RobotConfig; a Part takes a PartConfig | A | it is used here: $kind");
        row("one name of two", two + "Region n { Size=1,1,1 Robots=r, qq }\n",
            "E208 Robots names qq, but there is no such robot | qq | fix q");
        row("robots apart", two + "NoContact=r, s\n",
            "E208 NoContact names s, but there is no such robot; there are r and q | s");
        row("a log of two", two + "PoseLog n { Robot=r, qq }\n", "E208 Robot names qq, but there is no such robot | qq | fix q");
        row("bodies apart",
            "RobotConfig n { SelfCollision=true Body left { " + kBox + " } Body right { " + kBox + " } NoContact=left, rigt }\n",
            "E208 NoContact names rigt, but there is no such Body | rigt | fix right");
        row("a name that a Param takes further down", "RobotConfig n { Body left { " + kBox + " } Param left = 3 }\n",
            "E303 the name left is taken already | left | first defined here: left");
        row("a number of the first member",
            "PartConfig W { Param r = 1 { Min=1 } Sphere b { Radius=$r Material=g Surface=s } }\n"
            "StaticConfig P { Repeat n { Count=3 Part w { Config=W r=$(2*index) Pos=$(9*index),0,0 } } }\n",
            "E203 r is 0, it must be at least 1 | $(2*index) | its values are described here: { Min=1 } | in its member n_0: n");
        row("a robot for its body", two + "Ball n { Parent=r Child=q.b }\n",
            "E208 Parent names r, a robot; it takes one of its bodies | r | fix r.b");
        row("a body apart from a Part",
            "PartConfig W { Body b { " + kBox + " } }\nRobotConfig n { SelfCollision=true Part left { Config=W } Body hull { " +
                kBox + " } Fixed f { Parent=hull Child=left.b } NoContact=hull,lft }\n",
            "E208 NoContact names lft, but there is no such Body | lft | fix left");

        const std::string legs = "PartConfig A { Body b { " + kBox +
                                 " } Fixed f { Parent=$on Child=b } }\n"
                                 "PartConfig B { Body b { " +
                                 kBox +
                                 " } Fixed f { Parent=$to Child=b } }\n"
                                 "RobotConfig K { Body hull { " +
                                 kBox + " } Part leg { Config=A on=hull Pos=1,0,0 } }\n";
        const char* const needs = "E209 Part leg needs to: what PartConfig B is joined to | B | it is used here: to";
        row("another config of a part of a variant", legs + "RobotConfig n { Config=K leg.Config=B }\n", needs);
        row("another config of a part of a robot", legs + "Robot n { Config=K leg.Config=B }\n", needs);
        row("a part with a RobotConfig", legs + "RobotConfig n { Part leg { Config=K to=hull } }\n",
            "E208 Config names K, a RobotConfig; a Part takes a PartConfig | K");
        row("the default of a reference",
            "PartConfig A { Param on = hul Body b { " + kBox +
                " } Fixed f { Parent=$on Child=b } }\n"
                "RobotConfig n { Body hull { " +
                kBox + " } Part leg { Config=A Pos=1,0,0 } }\n",
            "E208 Parent names hul, but there is no such Body | hul | it is used here: $on | fix hull");
        const char* const noMember = "but Repeat lane has no member lane_2; the last one is lane_1 | lane_2.r | fix lane_1.r";
        row("a region with a member that there is not", lane + "}\nRegion n { Size=1,1,1 Robots=out,lane_2.r }\n",
            (std::string("E208 Robots names lane_2.r, ") + noMember).c_str());
        row("a log of a member that there is not", lane + "}\nPoseLog n { Robot=lane_2.r }\n",
            (std::string("E208 Robot names lane_2.r, ") + noMember).c_str());
        row("members apart that there are not", lane + "}\nNoContact=out,lane_2.r\n",
            (std::string("E208 NoContact names lane_2.r, ") + noMember).c_str());
        row("all robots of a Repeat", lane + "}\nRegion n { Size=1,1,1 Robots=lane.rr }\n",
            "E208 Robots names lane.rr, but there is no such robot | lane.rr | fix lane.r");
        row("a Repeat for its robots", lane + "}\nRegion n { Size=1,1,1 Robots=lane }\n",
            "E208 Robots names lane, a Repeat; it takes a robot | lane | fix lane.r");

        const auto ofTwo = [](const std::string& child) {
            return "PartConfig A { Body left { " + kBox + " } Body right { " + kBox +
                   " } Fixed f { Parent=left Child=right } }\n" + "RobotConfig n { Body hull { " + kBox +
                   " } Part side { Config=A } Fixed g { Parent=hull Child=" + child + " } }\n";
        };
        const std::string crowd = "RobotConfig C { Body b { " + kBox +
                                  " } }\nRobot r { Config=C Pos=5,0,0 }\n"
                                  "Scatter n { Config=C Count=20 Area=-0.1,-0.1,0.1,0.1 }\n";
        const char* const full = "E317 no free place for member 2 of Scatter n after 10000 tries; make Area larger, or Count or "
                                 "MinDistance smaller | n";
        row("a joint to a robot without a place", crowd + "Ball j { Parent=r.b Child=n_0.b }\n", full);
        row("a region of a robot without a place", crowd + "Region z { Size=1,1,1 Robots=n_3 }\n", full);
        const auto other = [](const std::string& given) {
            return "PartConfig A { Param len = 1  Body b { " + kBox +
                   " } Fixed f { Parent=$on Child=b } }\n"
                   "PartConfig B { Param rad = 1  Body b { Sphere s { Radius=$rad Mass=1 Material=g Surface=s } } Fixed f { "
                   "Parent=$to Child=b } }\n"
                   "RobotConfig K { Body c { " +
                   kBox + " } Part a { Config=A on=c len=2 b.h.Mass=3 Pos=1,0,0 } }\nRobot n { Config=K a.Config=B " + given +
                   " }\n";
        };
        row("another config with its values", other("a.to=c a.rad=2 a.b.s.Mass=2"), "");
        row("another config with a value of the first", other("a.to=c a.len=2"),
            "E314 PartConfig B has no len; it has rad and to | len");
        row("another config with what the first has", other("a.to=c a.b.h.Mass=2"), "E314 Body b has no h; it has s | h");
        row("a member behind the last one",
            "RobotConfig K { Body c { " + kBox + " } Repeat leg { Count=4 Body b { " + kBox +
                " } Fixed f { Parent=c Child=b } } }\n"
                "Robot n { Config=K leg_4.b.h.Mass=2 }\n",
            "E314 Repeat leg has no member leg_4; the last one is leg_3 | leg_4 | fix leg_3");
        row("a variant with Config misspelt", "RobotConfig n { Confg=K left.r=3 cm }\n",
            "E201 RobotConfig n has no property Confg | Confg | fix Config");
        const std::string wheel = "PartConfig W { Body w { " + kBox + " } Hinge axle { Parent=$carrier Child=w } }\n";
        row("a Param that is given and not declared",
            "PartConfig W { Body w { Sphere s { Radius=$r Mass=$(2*r) Material=g Surface=s } } }\nRobotConfig n { Body c { " +
                kBox + " } Part a { Config=W r=0.1 } Part b { Config=W r=0.2 Pos=1,0,0 } }\n",
            "E211 there is no Param r; PartConfig W declares it with Param r = ... | r | used here by Part a: a\n"
            "E211 there is no Param r; PartConfig W declares it with Param r = ... | r | used here by Part a: a");
        row("a Param of the top level, given by a Part",
            "Param r = 1\nPartConfig W { Body w { Sphere s { Radius=$r Mass=1 Material=g Surface=s } } }\nRobotConfig n { Body c "
            "{ " +
                kBox + " } Part a { Config=W r=0.1 } }\n",
            "E201 Part a has no property r; it has Config, Pos, HPR, In and Mirror | r");
        const std::string kit = wheel + "RobotConfig K { Body c { " + kBox + " } Part a { Config=W carrier=c } }\n";
        row("a block for a path, of a variant", kit + "RobotConfig n { Config=K a { w.h.Mass=2 } }\n",
            "E301 there is no kind a; values of what is in a config are set by path: a.w.h.Mass=2 | a | fix set them by path");
        row("a block for a path, of a robot", kit + "Robot n { Config=K a { w.h.Mass=2 Pos=1,0,0 } }\n",
            "E301 there is no kind a; values of what is in a config are set by path: a.w.h.Mass=2 a.Pos=1,0,0 | a | fix set them "
            "by path");
        row("a Part joined to itself", wheel + "RobotConfig n { Body c { " + kBox + " } Part a { Config=W carrier=a } }\n",
            "E208 Parent names a, a Part; it takes a Body: c or world | a | it is used here: $carrier");
        row("a kind with a small letter", "RobotConfig n { Body c { " + kBox + " } cylinder { Radius=3 } }\n",
            "E301 there is no kind cylinder | cylinder | fix Cylinder");
        row("a Part without a Config", wheel + "RobotConfig n { Body c { " + kBox + " } Part a { carrier=c } }\n",
            "E209 Part a needs Config (name of the PartConfig it is created from) | a");
        row("a variant of a PartConfig with a misspelt Param",
            wheel + "PartConfig V { Config=W carier=hub Body hub { " + kBox + " } }\nRobotConfig n { Body c { " + kBox +
                " } Part a { Config=V } }\n",
            "E201 PartConfig V has no property carier | carier | fix carrier");
        row("what a Part needs that is no body",
            "PartConfig E { Encoder e { Joint=$of } }\n" + wheel + "RobotConfig n { Body c { " + kBox +
                " } Part a { Config=W carrier=c } Hinge h { Parent=world Child=c } Part b { Config=E } }\n",
            "E209 Part b needs of: what PartConfig E is joined to | b | it is used here: of | fix of=h");
        row("the world for a device of a Part in scenery",
            "PartConfig E { Camera e { Body=world } }\nStaticConfig n { " + kBox.substr(0, kBox.find("Mass=")) +
                "Material=g Surface=s } Part a { Config=E } }\nStatic s { Config=n }\n",
            "");
        row("the world for a device of a Part in a robot",
            "PartConfig E { Camera e { Body=world } }\nRobotConfig n { Body c { " + kBox + " } Part a { Config=E } }\n",
            "E208 Body cannot be the world | world | used here by Part a: a");
        row("a Param without its sign",
            "RobotConfig n { Param x = 1  Body c { Box b { Size=x,1,1 Mass=1 Material=g Surface=s } } }\n",
            "E202 the 1st element of Size is a word (x), it must be a number; the Param of that name is $x | x | fix $x");
        row("the other end of a joint is not meant", two + "Hinge j { Parent=r.b Child=z.b }\n",
            "E208 Child names z.b, but there is no such body of a robot (robot.body) | z.b | fix q.b");
        row("one of two bodies of a Part", ofTwo("side.wheel"),
            "E208 Child names side.wheel, but there is no such Body; there are side.left and side.right | side.wheel");
        row("one of two bodies of a Part, misspelt", ofTwo("side.lft"),
            "E208 Child names side.lft, but there is no such Body | side.lft | fix side.left");
        row("a misspelt Part", ofTwo("sid.right"),
            "E208 Child names sid.right, but there is no such Body | sid.right | fix side.right");
        row("the body of a Part that has one",
            "PartConfig A { Body b { " + kBox + " } }\nRobotConfig n { Body hull { " + kBox +
                " } Part side { Config=A } Fixed g { Parent=hull Child=side.wheel } }\n",
            "E208 Child names side.wheel, but there is no such Body; there is side.b | side.wheel");

        const auto members = [](const std::string& count, const std::string& given) {
            return "RobotConfig n { Param m = 1  Repeat few { Count=10 Body b { " + kBox + " } }\n  Repeat row { Count=" + count +
                   " Body b { " + kBox + " } } }\nRobot r { Config=n " + given + " }\n";
        };
        row("too many members", members("150000", {}),
            "E312 with RobotConfig n there would be configs of more than 200000 objects | n | most are in Repeat row: 150000");
        row("too many members by a value", members("$m", "m=200000"),
            "E312 RobotConfig n would hold more than 200000 objects | n | most are in Repeat row: $m | with the values of Robot "
            "r: r");
        row("PartConfigs in a circle", "PartConfig A { Part n { Config=B } }\nPartConfig B { Part n { Config=A } }\n",
            "E302 PartConfigs contain each other in a circle: A > B > A | A");

        row("Params in a circle by a value of a variant",
            "RobotConfig B { Param w = 1  Body c { Box b { Size=$w,1,1 Mass=1 Material=g Surface=s } } }\n"
            "RobotConfig n { Config=B w=$(w + 1) }\nRobot r { Config=n }\n",
            "E212 Params need each other in a circle: w > w | $(w + 1) | the Param is declared here: w");
        row("an element", "Region n { Size=1,1,0 }\n", "E203 the 3rd element of Size is 0, it must be above 0 | 0");
        row("a count", post + "Grid n { Config=P Count=2,zero Spacing=1 }\n",
            "E202 the 2nd element of Count is a word (zero), it must be a whole number | zero");
        row("the numbers of members without a count",
            post + "Grid n { Config=P Count=2,0.5 Spacing=1 h=$(0.1+0.1*index2+index) }\n",
            "E202 the 2nd element of Count is a number (0.5), it must be a whole number | 0.5");
        row("a second number", post + "Grid n { Config=P Count=2 Spacing=1 h=$(0.1+index2) }\n",
            "E211 there is no Param index2; it is there in a Repeat or Grid with two numbers, Count=5,2 | index2");
        row("a Repeat with a number for its name", "StaticConfig P { Repeat 3 { " + kBox + " } }\n",
            "E101 how often is written in the block: `Repeat name { Count=3` | 3");
        row("a Repeat without blocks", "StaticConfig P { Repeat post { Count=3 Pos=$(index),0,0 } " + kBox + " }\n",
            "E209 Repeat post has no blocks, so nothing is repeated | post");
        const std::string part = "PartConfig Wheel { Body b { " + kBox + " } }\n";
        row("a PartConfig in place of a kind", part + "RobotConfig n { Wheel left { Pos=0,0,1 } }\n",
            "E301 Wheel is a PartConfig, not a kind; a Part uses it: `Part left { Config=Wheel` | Wheel | fix Part left { "
            "Config=Wheel");
        row("a RobotConfig in place of a kind", "RobotConfig n { Body b { " + kBox + " } }\nn rover { Pos=0,0,1 }\n",
            "E301 n is a RobotConfig, not a kind; a Robot uses it: `Robot rover { Config=n` | n | fix Robot rover { Config=n");
        row("a PartConfig at the top level", part + "Wheel left { Pos=0,0,1 }\n",
            "E301 Wheel is a PartConfig, not a kind; a Part uses it: `Part left { Config=Wheel`, in a config | Wheel");
        row("a PartConfig behind an =", part + "RobotConfig n { left = Wheel { } }\n",
            "E101 a block begins with its kind: `Wheel left {` | left = Wheel | fix Wheel left");
        row("pi", "Param pi = 3\n", "E303 the name pi is taken by the number pi, which this Param replaces in $( ) | pi");
        row("a function",
            "StaticConfig P { Param sin = 4 Box a { Size=$sin,1,1 Material=g Surface=s } }\nStatic n { Config=P sin=3 }\n",
            "E303 the name sin is taken by a function of $( ), sin(...) | sin");
    }
    void messages() {
        QFETCH(QString, text);
        QTEST(reported(sample::resolved(text.toStdString())), "message");
    }

    /// Each robot that gives it is named, however often its config uses it.
    void aWrongNameOfSeveralRobots() {
        const Resolved r = sample::resolved(kHead + kLook +
                                            "Robot n { Config=A m=redd }\nRobot o { Config=A m=redd }\n"
                                            "Grid p { Config=A m=redd Count=2 Spacing=9 }\n");
        std::set<SourceRange> places;
        for (const Diagnostic& d : r.diagnostics.all()) places.insert(d.range);
        QVERIFY2(places.size() == 3 && r.diagnostics.all().size() == 3, r.messages().c_str());
        for (const SourceRange& place : places) QCOMPARE(r.slice(place), std::string("redd"));
    }

    void aNameOnTheCommandLine() {
        const Resolved r = sample::resolved(kHead + "RobotConfig A { Param m = g Body b { Box h { Size=1,1,1 Mass=1 Material=$m "
                                                    "Surface=s } } }\nRobot a { Config=A }\n",
                                            {"a.m=grass"});
        QCOMPARE(reported(r),
                 QStringLiteral("E208 Material names grass, but there is no such Material; there are g and default | "
                                "grass | it is used here: $m"));
        QVERIFY(r.texts->commandLine(r.diagnostics.all().at(0).range.file));
    }

    /// All members of a Grid are there, those behind a wrong one too.
    void membersBehindAWrongOne() {
        const Resolved r =
            sample::resolved(kHead + "StaticConfig P { Param h = 0.1 { Max=1 } Box w { Size=0.1,0.1,0.1 Pos=0,0,$h } }\n"
                                     "Grid n { Config=P Count=5 Spacing=1 h=$(0.4+0.4*index) }\n");
        QCOMPARE(r.experiment->statics.size(), std::size_t{5});
    }
};

QTEST_APPLESS_MAIN(MessagePlacesTest)
#include "message_places_test.moc"
