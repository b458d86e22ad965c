// The numbers of a run stay what they are: state hashes of shipped experiments and of worlds with every part of the physics, as constants,
// and the same for any number of threads.
//
// A change that is not meant to change results keeps all of them. One that is (a device, a joint, a solver) changes some; then the new ones
// come here, and RESULTS.md says what became different. They hold for ODE and C library of Debian 12 on x86-64 with AVX2 and FMA: other
// versions round other last bits.

#include "flow/cli.h"

namespace {

/// On other processors the C library takes other functions, with other last bits: there two runs are compared.
bool hasConstants() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

struct World {
    const char* name;
    const char* file; ///< below configs/experiments; null: `text`
    const char* text;
    const char* seconds;
    const char* hash;
};

const char* const kShapes =
    "#import common/materials.sim\n#import common/surfaces.sim\n#import arenas/medium_arena.sim\n"
    "Static arena { Config=MediumArena }\n"
    "RobotConfig Crate { Body b { Box g { Size=0.12,0.1,0.08 Mass=0.3 Surface=plastic Material=red } } }\n"
    "RobotConfig Ball { Body b { Sphere g { Radius=0.05 Mass=0.2 Surface=rubber Material=red } } }\n"
    "RobotConfig Can { Body b { Cylinder g { Radius=0.04 Length=0.1 Mass=0.2 Surface=plastic Material=red } } }\n"
    "RobotConfig Chain { Body a { Box g { Size=0.1,0.1,0.1 Mass=1 Surface=plastic Material=red } }\n"
    "  Body c { Pos=0.2,0,0 Box g { Size=0.1,0.1,0.1 Mass=0.5 Surface=plastic Material=red } }\n"
    "  Body d { Pos=0.4,0,0 Sphere g { Radius=0.05 Mass=0.5 Surface=rubber Material=red } }\n"
    "  Ball j { Parent=a Child=c Anchor=0.1,0,0 }\n  Universal k { Parent=c Child=d Anchor=0.3,0,0 Axis=0,1,0 Axis2=0,0,1 } }\n"
    "RobotConfig Wedge { Body b { Mesh m { File=\"ramp.obj\" Mass=1 Material=red Surface=plastic } } }\n";

const char* const kDriving = "#import robots/simple_robot.sim\n#import robots/evbot.sim\n#import arenas/medium_arena.sim\n"
                             "#loadModule controllers/random_drive\n#loadModule controllers/bump_and_turn\n"
                             "Static arena { Config=MediumArena }\n";

const World kWorlds[] = {
    {"swarm of 100", "swarm.sim", nullptr, "4", "887f46e78c0f1383"},
    {"radios, one robot among motes", "network_navigation.sim", nullptr, "8", "6512f11109414210"},
    {"radios, carriers", "sensor_network_amr.sim", nullptr, "6", "b4489e465edc85c0"},
    {"lidar and IMU", "wall_follow.sim", nullptr, "6", "ff7421bcf2209a3e"},
    {"ground sensors", "line_follow.sim", nullptr, "6", "fc88f72ee363dbe3"},
    {"infrared and light", "braitenberg.sim", nullptr, "6", "000f3c416b0b24ea"},
    {"robots with cameras that take no pictures", nullptr,
     "#import robots/camera_robot.sim\n#import arenas/colour_yard.sim\n#loadModule controllers/random_drive\n"
     "Static yard { Config=ColourYard }\nGrid g { Config=CameraRobot Count=3,3 Spacing=0.5 RandomDrive b {} }\n",
     "4", "1f9a9c53061f9918"},
    {"batteries that run empty", nullptr,
     "RobotConfig Fed { Config=SimpleRobot Battery battery { Capacity=2000mAh Cells=10 Chemistry=NiMH InternalResistance=0.3 "
     "BaseLoad=2 StartLevel=0.0002 } }\nGrid g { Config=Fed Count=3,2 Spacing=0.8 BumpAndTurn b { Speed=0.4 } }\n",
     "12", "877d45b58005859d"},
    {"a gripper, a servo, a hoist", nullptr,
     "RobotConfig Crane {\n  Body palm { Pos=0,0,0.2 Box block { Size=0.2,0.3,0.02 Mass=2 } }\n"
     "  Body left { Pos=0,0.06,0.05 Box pad { Size=0.06,0.02,0.06 Mass=0.1 Surface=rubber } }\n"
     "  Body right { Pos=0,-0.06,0.05 Box pad { Size=0.06,0.02,0.06 Mass=0.1 Surface=rubber } }\n"
     "  Body arm { Pos=0.1,0,0.5 HPR=0,30,0 Box beam { Size=0.2,0.02,0.02 Mass=0.3 } }\n"
     "  Slider rail { Parent=world Child=palm Axis=0,0,1 Friction=2 }\n  Slider openLeft { Parent=palm Child=left Axis=0,1,0 }\n"
     "  Slider openRight { Parent=palm Child=right Axis=0,-1,0 }\n  Hinge elbow { Parent=palm Child=arm Anchor=0,0,0.5 "
     "Axis=0,1,0 }\n"
     "  LinearMotor hoist { Joint=rail MaxForce=15 MaxSpeed=0.05 TimeConstant=0.5 }\n"
     "  Servo bend { Joint=elbow MaxTorque=0.2 MaxSpeed=2 }\n"
     "  Gripper hand { Left=openLeft Right=openRight Force=10 }\n}\n"
     "RobotConfig Load { Body body { Box box { Size=0.04,0.1,0.06 Mass=0.5 Surface=rubber } } }\n"
     "Robot crane { Config=Crane }\nRobot load { Config=Load Pos=0.005,0.004,0.03 HPR=3,0,0 }\n",
     "3", "6037a5fb0bf7107a"},
    {"robots that crowd", nullptr, "Grid g { Config=SimpleRobot Count=6,5 Spacing=0.5 RandomDrive b { Speed=0.6 TurnRate=2 } }\n",
     "8", "bade3b0aa19bbce4"},
    {"robots that crowd, a crate and a ball, on wheels", nullptr,
     "Engine=wheeled\nRobotConfig Crate { Body b { Box g { Size=0.12,0.1,0.08 Mass=0.3 Surface=plastic Material=red } } }\n"
     "RobotConfig Ball { Body b { Sphere g { Radius=0.05 Mass=0.2 Surface=rubber Material=red } } }\n"
     "Grid g { Config=SimpleRobot Count=6,5 Spacing=0.5 RandomDrive b { Speed=0.6 TurnRate=2 } }\n"
     "Robot crate { Config=Crate Pos=0.25,0.25,0.04 }\nRobot ball { Config=Ball Pos=-0.25,0.25,0.05 }\n",
     "8", "39fbe852ca29f00e"},
    {"quick solver, long ticks", nullptr,
     "Solver=quick Tick=0.03\nGrid g { Config=SimpleRobot Count=3,3 Spacing=0.6 RandomDrive b {} }\nRobot e { Config=EvBot "
     "Pos=1.4,1.4,0 BumpAndTurn b {} }\n",
     "6", "41aa7dac38769ed0"},
    {"a pile, chains, a hull", nullptr,
     "Grid a { Config=Crate Count=3,3 Spacing=0.11 Pos=0,0,0.1 }\nGrid b { Config=Ball Count=3,3 Spacing=0.12 Pos=0.02,0,0.4 }\n"
     "Grid c { Config=Can Count=3,3 Spacing=0.1 Pos=0,0.03,0.6 HPR=0,50,20 }\n"
     "Grid d { Config=Chain Count=2,2 Spacing=0.8,0.4 Pos=0,1,0.5 HPR=20,30,0 }\nRobot w { Config=Wedge Pos=-1,-1,0.5 "
     "HPR=30,40,50 }\n",
     "2", "1d95b0059f5849f7"},
    {"springs and stops", nullptr,
     "RobotConfig Cart { Body hull { Pos=0,0,0.25 Box g { Size=0.5,0.3,0.1 Mass=4 Surface=plastic Material=red } }\n"
     "  Repeat corner { Count=2,2 Pos=$(0.4*index - 0.2),$(0.36*index2 - 0.18),0 Body wheel { Pos=0,0,0.1 Cylinder tyre { "
     "Radius=0.1 Length=0.04 HPR=0,0,90 Mass=0.4 Surface=rubber Material=black } }\n"
     "    Suspension strut { Parent=hull Child=wheel Axis=0,0,1 Axis2=0,1,0 Stiffness=800 Damping=30 Travel=0.05 } }\n"
     "  Body mast { Pos=0,0,0.5 Box g { Size=0.02,0.02,0.3 Mass=0.1 Surface=plastic Material=red } }\n"
     "  Hinge flex { Parent=hull Child=mast Anchor=0,0,0.35 Axis=1,0,0 Stiffness=3 Damping=0.01 LowStop=-20deg HighStop=20deg } "
     "}\n"
     "Grid g { Config=Cart Count=2,2 Spacing=0.8 Pos=0,0,0.1 HPR=20,4,3 }\n",
     "3", "902bdc89c50dfeeb"},
};

} // namespace

class StateHashesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

private Q_SLOTS:
    void initTestCase() {
        QVERIFY(writeFile(m_folder.filePath("ramp.obj"),
                          "v 0 -0.3 0\nv 0.8 -0.3 0\nv 0.8 0.3 0\nv 0 0.3 0\nv 0.8 -0.3 0.1\nv 0.8 0.3 0.1\n"
                          "f 1 3 2\nf 1 4 3\nf 1 2 5\nf 2 3 6\nf 2 6 5\nf 3 4 6\nf 1 5 6\nf 1 6 4\n"));
    }

    void staysTheSame_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < int(std::size(kWorlds)); ++i) QTest::newRow(kWorlds[i].name) << i;
    }
    void staysTheSame() {
        QFETCH(int, index);
        const auto hash = [&] { return hashOf(kWorlds[index], 1); };
        QCOMPARE(hash(), hasConstants() ? QByteArray(kWorlds[index].hash) : hash());
    }

    void isTheSameOnAnyThreads_data() { staysTheSame_data(); }
    void isTheSameOnAnyThreads() {
        QFETCH(int, index);
        const bool isLong = qEnvironmentVariableIsSet("TRUNDLE_LONG");
        const QByteArray one = hasConstants() && !isLong ? QByteArray(kWorlds[index].hash) : hashOf(kWorlds[index], 1, isLong);
        QVERIFY(!one.isEmpty());
        for (const int threads : {2, 3, 4}) QCOMPARE(hashOf(kWorlds[index], threads, isLong), one);
    }

private:
    /// `isLong`: after 100 s, 10,000 ticks of most worlds.
    [[nodiscard]] QByteArray hashOf(const World& world, int threads, bool isLong = false) const {
        QString file = m_folder.filePath("world.sim");
        if (world.file) file = configPath(QStringLiteral("experiments/") + world.file);
        else {
            const QByteArray text = world.text;
            if (!writeFile(file, (text.contains("SimpleRobot") ? kDriving : text.contains("#import") ? "" : kShapes) + text))
                return {};
        }
        const QStringList run{"run",        file,
                              "--hash",     "--quiet",
                              "--duration", isLong ? "100" : world.seconds,
                              "--log-dir",  m_folder.filePath("logs"),
                              "--set",      "Threads=" + QString::number(threads)};
        return cli(run).out.split(' ').value(1);
    }
};

QTEST_GUILESS_MAIN(StateHashesTest)
#include "state_hashes_test.moc"
