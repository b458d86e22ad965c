// A tick takes no memory from the heap once a run is under way: all of malloc is counted, that of ODE, of the C++ library and of modules too.

#include <algorithm>
#include <cerrno>
#include <cstdlib>

#include <dlfcn.h>
#include <execinfo.h>

#include <ode/ode.h>

#include "devices/sensor_world.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TRUNDLE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TRUNDLE_SANITIZED 1
#endif
#endif

namespace {

/// The calls that led to an allocation, from the caller of malloc on.
struct Site {
    static constexpr int kFrames = 18;
    void* frames[kFrames];
    int count;
};
constexpr int kMaxSites = 6, kFramesThatDiffer = 4;
thread_local bool t_counts = false;
thread_local int t_taken = 0, t_sites = 0;
thread_local Site t_site[kMaxSites]; ///< each once

void count() {
    if (!t_counts) return;
    t_counts = false;
    ++t_taken;
    if (t_sites < kMaxSites) {
        Site& here = t_site[t_sites];
        here.count = backtrace(here.frames, Site::kFrames);
        const auto isHere = [&](const Site& s) { return std::equal(s.frames + 2, s.frames + 2 + kFramesThatDiffer, here.frames + 2); };
        if (std::none_of(t_site, t_site + t_sites, isHere)) ++t_sites;
    }
    t_counts = true;
}

} // namespace

#ifdef TRUNDLE_SANITIZED
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t), void (*)(const volatile void*));
#else
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
    count();
    return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
    count();
    return __libc_calloc(number, size);
}
void* realloc(void* block, std::size_t size) {
    count();
    return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    count();
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    count();
    *block = __libc_memalign(alignment, size);
    return *block ? 0 : ENOMEM;
}
}
#endif

using namespace trundle;
using namespace trundle::test;

namespace {

/// Counts what the calling thread takes from the heap while it exists.
class AllocationCount {
public:
    AllocationCount() {
        t_taken = t_sites = 0;
        t_counts = true;
    }
    ~AllocationCount() { t_counts = false; }
    AllocationCount(const AllocationCount&) = delete;
    AllocationCount& operator=(const AllocationCount&) = delete;
    [[nodiscard]] static int taken() { return t_taken; }
};

/// Prints where memory was taken, for addr2line.
void printPlaces() {
    for (const Site& site : std::span(t_site, std::size_t(t_sites))) {
        QByteArray text;
        for (int i = 2; i < site.count; ++i) {
            Dl_info of{};
            const bool known = dladdr(site.frames[i], &of) != 0;
            const auto offset = reinterpret_cast<quintptr>(site.frames[i]) - reinterpret_cast<quintptr>(known ? of.dli_fbase : nullptr);
            text += " " + QByteArray(known ? of.dli_fname : "?").split('/').last() + "+0x" + QByteArray::number(offset, 16);
        }
        qInfo("at%s", text.constData());
    }
}

/// Nothing is built, named, sorted or copied anew for a tick. What is left is growth: a list that was never as long before (contacts in a
/// crowd), the damper that a motor gets when it first comes near its limit, a message that is printed. So robots that drive take nothing
/// from their third tick on, and crowds almost nothing.
struct Case {
    const char* name;
    const char* text;
    int before, ticks; ///< those before are not counted
    int most = 0;      ///< allocations in all of them
};

const char* const kHead = "#import robots/simple_robot.sim\n#import robots/lidar_robot.sim\n#import robots/round_robot.sim\n"
                          "#import arenas/medium_arena.sim\n#loadModule controllers/random_drive\n"
                          "#loadModule controllers/linear_motion\n#loadModule controllers/bump_and_turn\n"
                          "Static arena { Config=MediumArena side=11 }\n";

const Case kCases[] = {
    {"one robot drives", "Robot r { Config=SimpleRobot LinearMotion b { Distance=3 Speed=0.2 } }\n", 3, 997},
    {"ten wander, bump, touch", "Grid g { Config=SimpleRobot Count=5,2 Spacing=0.7 RandomDrive b { Speed=0.5 } }\n", 3000, 1000,
     8},
    {"fifty in a crowd", "Grid g { Config=SimpleRobot Count=10,5 Spacing=0.36 RandomDrive b { Speed=0.5 TurnRate=2 } }\n", 6000,
     1000, 8},
    {"range sensors, IMU, ground and light", "Grid g { Config=RoundRobot Count=3,3 Spacing=0.4 RandomDrive b { Speed=0.1 } }\n",
     600, 400},
    {"lidars", "Grid g { Config=LidarRobot Count=2,2 Spacing=0.8 RandomDrive b { Speed=0.1 TurnRate=0.5 } }\n", 600, 400, 2},
    {"compass, satellites, battery",
     "RobotConfig Full { Config=SimpleRobot Compass north { Body=chassis Noise=0.01 } Gps gps { Body=chassis Noise=0.02 }\n"
     "  Battery battery { Capacity=2000mAh Cells=10 Chemistry=NiMH InternalResistance=0.3 BaseLoad=2 } }\n"
     "Grid g { Config=Full Count=3,2 Spacing=0.8 BumpAndTurn b { Speed=0.4 } }\n",
     600, 400},
    {"a gripper, a servo, a hoist",
     "RobotConfig Crane {\n  Body palm { Pos=0,0,0.2 Box block { Size=0.2,0.3,0.02 Mass=2 } }\n"
     "  Body left { Pos=0,0.06,0.05 Box pad { Size=0.06,0.02,0.06 Mass=0.1 Surface=rubber } }\n"
     "  Body right { Pos=0,-0.06,0.05 Box pad { Size=0.06,0.02,0.06 Mass=0.1 Surface=rubber } }\n"
     "  Body arm { Pos=0.1,0,0.5 HPR=0,30,0 Box beam { Size=0.2,0.02,0.02 Mass=0.3 } }\n"
     "  Slider rail { Parent=world Child=palm Axis=0,0,1 Friction=2 }\n  Slider openLeft { Parent=palm Child=left Axis=0,1,0 }\n"
     "  Slider openRight { Parent=palm Child=right Axis=0,-1,0 }\n  Hinge elbow { Parent=palm Child=arm Anchor=0,0,0.5 "
     "Axis=0,1,0 }\n"
     "  LinearMotor hoist { Joint=rail MaxForce=15 MaxSpeed=0.05 TimeConstant=0.5 }\n"
     "  Servo bend { Joint=elbow MaxTorque=0.2 MaxSpeed=2 }\n  Gripper hand { Left=openLeft Right=openRight Force=10 }\n}\n"
     "Robot crane { Config=Crane Pos=0,0,0.1 }\n",
     600, 400},
};

} // namespace

class AllocationsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        (void)backtrace(t_site[0].frames, Site::kFrames); // loads what it needs
#ifdef TRUNDLE_SANITIZED
        QVERIFY(__sanitizer_install_malloc_and_free_hooks([](const volatile void*, std::size_t) { count(); },
                                                          [](const volatile void*) {}) != 0);
#endif
    }

    void countsWhatIsTaken() {
        void* volatile taken[3]; // so that no compiler leaves them out
        {
            const AllocationCount counting;
            taken[0] = ::operator new(8);
            taken[1] = std::malloc(8);
            taken[2] = dAlloc(8);
        }
        QCOMPARE(AllocationCount::taken(), 3);
        ::operator delete(taken[0]);
        std::free(taken[1]);
        dFree(taken[2], 8);
    }

    void aTickTakesNothing_data() {
        QTest::addColumn<int>("index");
        for (int i = 0; i < int(std::size(kCases)); ++i) QTest::newRow(kCases[i].name) << i;
    }
    void aTickTakesNothing() {
        QFETCH(int, index);
        const Case& c = kCases[index];
        SensorWorld world(std::string(kHead) + c.text);
        QVERIFY2(world.ok(), world.failure().c_str());
        QVERIFY(world.run(c.before));
        bool ran = false;
        int taken = 0;
        {
            const AllocationCount counting;
            ran = world.run(c.ticks);
            taken = AllocationCount::taken();
        }
        QVERIFY(ran);
        if (taken > c.most) printPlaces();
        QVERIFY2(taken <= c.most, QByteArray::number(taken) + " allocations");
    }
};

QTEST_GUILESS_MAIN(AllocationsTest)
#include "allocations_test.moc"
