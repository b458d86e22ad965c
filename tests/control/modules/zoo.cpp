// A controller and a device that misbehave on demand: `Action` in `Phase`, in update number `At`. The environment variables
// TRUNDLE_ZOO_LOAD and TRUNDLE_ZOO_UNLOAD name actions for loading and unloading the library.
#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <thread>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <threads.h>
#include <unistd.h>
#include <xmmintrin.h>

#include <trundle/controller.h>
#include <trundle/device.h>

namespace {

volatile int g_zero = 0, g_number = 12345;

int deeper(int n) {
    volatile char room[4096];
    room[n % 4096] = 1;
    return n > g_zero ? deeper(n + 1) + room[n % 4096] : 0; // not a tail call, so it cannot be compiled to a loop
}

/// Overflows the stack inside the C library, which needs much of it for one call.
int formatDeeper(int n) {
    char room[200];
    const int length = std::snprintf(room, sizeof room, "%.150f", n * 1.1);
    return n > g_zero ? formatDeeper(n + 1) + length + room[n % 100] : 0;
}

/// Signals to a waiting test that the action has begun.
void say() {
    static constexpr char kText[] = "zoo: begun\n";
    (void)!write(2, kText, sizeof kText - 1);
}

void loop() {
    say();
    for (;;) usleep(1000);
}

void busError() {
    char name[] = "/tmp/trundle-zoo-XXXXXX";
    const int file = mkstemp(name);
    unlink(name);
    auto* const page = static_cast<volatile char*>(mmap(nullptr, 4096, PROT_READ, MAP_SHARED, file, 0));
    g_zero = page[0]; // SIGBUS: the mapping is longer than the file
}

void blockAll() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

void handleAll(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGALRM, SIGSEGV, SIGABRT, SIGFPE}) std::signal(signal, handler);
}

void closeFrom(int first) {
    for (int file = first; file < 1024; ++file) close(file);
}

/// What a library built with -ffast-math does when it is loaded.
void flushDenormals() { _mm_setcsr(_mm_getcsr() | 0x8040); }

/// A text without a terminating zero at the end of mapped memory.
const char* unended() {
    static constexpr char kText[] = "unended";
    auto* const pages = static_cast<char*>(mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    munmap(pages + 4096, 4096);
    return static_cast<char*>(std::memcpy(pages + 4096 - (sizeof kText - 1), kText, sizeof kText - 1));
}

/// A fixed-size array without a terminating zero, followed by other data.
const char* filled() {
    static char bytes[100'000];
    return static_cast<char*>(std::memset(bytes, 'x', sizeof bytes));
}

const char* nowhere() { return reinterpret_cast<const char*>(0x10); }
/// Control sequences and bytes that are not UTF-8, past print(); a character in two parts.
void printEscapes() {
    std::printf("printf \x1b]0;mine\x07 \xff\xfe end\n");
    std::cout << "cout \x1b[2J end" << std::endl;
    std::fprintf(stderr, "fprintf \xc2\x9b"
                         "31m end\n");
    (void)!write(2, "h\xc3", 2);
    (void)!write(2, "\xa9 end\n", 7);
}

void waitForAllChildren() {
    if (fork() == 0) syscall(SYS_exit_group, 0);
    while (wait(nullptr) > 0) {}
    std::fputs("none left\n", stderr);
}

void limited(int what, rlim_t most, const std::function<void()>& then) {
    rlimit before{}, lower{};
    getrlimit(static_cast<__rlimit_resource>(what), &before);
    lower = before;
    lower.rlim_cur = std::min(most, before.rlim_max);
    setrlimit(static_cast<__rlimit_resource>(what), &lower);
    then();
    setrlimit(static_cast<__rlimit_resource>(what), &before);
}

void allocateMuch() {
    limited(RLIMIT_AS, rlim_t(2) << 30, [] {
        std::vector<std::vector<char>> all;
        for (;;) all.emplace_back(256u << 20);
    });
}

struct NoException {};
using Action = std::function<void()>;
void act(const std::string& name);

/// Waits for the end of the thread, so the run is in the middle of the call.
void inThread(const char* name) {
    std::thread([name] { act(name); }).join();
}

/// A thread without the thread library: it shares the thread-local variables of its creator. Waits for its end.
void inBareThread(int (*routine)(void*)) {
    constexpr int kFlags = CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SIGHAND | CLONE_THREAD | CLONE_SYSVSEM;
    constexpr std::size_t kStack = 256 * 1024;
    char* const stack = static_cast<char*>(mmap(nullptr, kStack, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    static volatile pid_t s_thread = 1; // the kernel clears it when the thread ends
    clone(routine, stack + kStack, kFlags | CLONE_CHILD_CLEARTID, nullptr, nullptr, nullptr, const_cast<pid_t*>(&s_thread));
    while (s_thread != 0) usleep(1000);
}

const std::map<std::string, Action>& actions() {
    // Never destroyed: an action on unload runs after the destructors of function statics.
    static const auto& all = *new std::map<std::string, Action>{
        {"none", [] {}},
        {"say", say},
        {"loop", loop},
        {"segv", [] { *reinterpret_cast<volatile int*>(g_zero) = 1; }},
        {"jump", [] { reinterpret_cast<void (*)()>(g_zero)(); }},
        {"divide", [] { g_number = g_number / g_zero; }},
        {"trap", [] { __builtin_trap(); }},
        {"bus", busError},
        {"abort", [] { std::abort(); }},
        {"overflow", [] { g_zero = deeper(1); }},
        {"overrun",
         [] {
             for (volatile double* all = new double[10];; ++all) *all = 0.5;
         }},
        {"double free",
         [] {
             auto* p = static_cast<char*>(std::malloc(5000));
             char* volatile again = p;
             std::free(p);
             std::free(again);
         }},
        {"exit", [] { std::exit(0); }},
        {"_exit", [] { _exit(0); }},
        {"_Exit", [] { std::_Exit(0); }},
        {"quick_exit", [] { std::quick_exit(0); }},
        {"terminate", [] { std::terminate(); }},
        {"throw", [] { throw std::runtime_error("no \x1b[31mbattery\n\xff"); }},
        {"throw int", [] { throw 42; }},
        {"throw other", [] { throw NoException{}; }},
        {"throw much", [] { throw std::runtime_error(std::string(2'000'000, 'x')); }},
        {"throw past noexcept", []() noexcept { act("throw"); }},
        {"leave thread", [] { pthread_exit(nullptr); }},
        {"thread crashes", [] { inThread("segv"); }},
        {"thread throws", [] { inThread("throw int"); }},
        {"thread aborts", [] { inThread("abort"); }},
        {"thread jumps", [] { inThread("jump"); }},
        {"thread overflows", [] { inThread("overflow"); }},
        {"thread overflows in the C library", [] { inThread("format deeper"); }},
        {"thread exits", [] { inThread("exit"); }},
        {"thread _exits", [] { inThread("_exit"); }},
        {"thread quick_exits", [] { inThread("quick_exit"); }},
        {"standard thread overflows",
         [] {
             thrd_t thread{};
             thrd_create(
                 &thread, [](void*) { return deeper(1); }, nullptr);
             thrd_join(thread, nullptr);
         }},
        {"library code crashes in a thread", // no code of the module is on the thread's stack
         [] {
             pthread_t thread{};
             pthread_create(&thread, nullptr, reinterpret_cast<void* (*)(void*)>(dlsym(RTLD_DEFAULT, "strdup")),
                            const_cast<char*>(nowhere()));
             pthread_join(thread, nullptr);
         }},
        {"bare thread ends", [] { inBareThread([](void*) { return 0; }); }},
        {"bare thread crashes",
         [] {
             inBareThread([](void*) -> int {
                 act("segv");
                 return 0;
             });
         }},
        {"bare thread overflows", [] { inBareThread([](void*) { return deeper(1); }); }},
        {"thread of a thread crashes", [] { std::thread([] { inThread("segv"); }).join(); }},
        {"format deeper", [] { g_zero = formatDeeper(1); }},
        {"close standard",
         [] {
             for (const int file : {0, 1, 2}) close(file);
         }},
        {"close all", [] { closeFrom(3); }},
        {"replace standard",
         [] {
             const int file = open("/dev/null", O_RDWR);
             for (const int standard : {0, 1, 2}) dup2(file, standard);
         }},
        {"replace all",
         [] {
             const int file = open("/dev/null", O_RDWR);
             for (int other = 3; other < 200; ++other)
                 if (fcntl(other, F_GETFD) >= 0) dup2(file, other);
         }},
        {"allocate", allocateMuch},
        {"flood",
         [] {
             for (int i = 0; i < 20'000; ++i) {
                 std::printf("printf\n");
                 std::puts("puts");
                 std::cout << "cout\n";
                 (void)!write(1, "write\n", 6);
             }
         }},
        {"print escapes", printEscapes},
        {"print escapes and crash",
         [] {
             printEscapes();
             act("segv");
         }},
        {"print escapes and be killed",
         [] {
             printEscapes();
             kill(getpid(), SIGKILL);
         }},
        {"print escapes and leave",
         [] {
             printEscapes();
             syscall(SYS_exit_group, 7);
         }},
        {"close all and print escapes",
         [] {
             closeFrom(3);
             printEscapes();
         }},
        {"wait for all children", waitForAllChildren},
        {"round up", [] { std::fesetround(FE_UPWARD); }},
        {"round down", [] { std::fesetround(FE_DOWNWARD); }},
        {"round to zero", [] { std::fesetround(FE_TOWARDZERO); }},
        {"flush denormals", flushDenormals},
        {"trap floats",
         [] {
             volatile long double zero = g_zero;
             volatile long double pending = 1 / zero; // pending x87 exception: a trap as soon as traps are enabled
             (void)pending;
             feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_INEXACT);
         }},
        {"trapped division",
         [] {
             feenableexcept(FE_DIVBYZERO);
             volatile double zero = g_zero, one = 1;
             one = one / zero;
         }},
        {"ignore signals", [] { handleAll(SIG_IGN); }},
        {"handle signals", [] { handleAll([](int) {}); }},
        {"block signals", blockAll},
        {"ignore and loop",
         [] {
             handleAll(SIG_IGN);
             loop();
         }},
        {"block and loop",
         [] {
             blockAll();
             loop();
         }},
        {"crash at exit", [] { std::atexit([] { act("segv"); }); }},
        {"crash after all", [] { on_exit([](int, void*) { act("segv"); }, nullptr); }},
        {"quit", [] { kill(getpid(), SIGQUIT); }},
        {"change folder", [] { (void)!chdir("/"); }},
        {"set locale", [] { (void)(std::setlocale(LC_ALL, "de_DE.UTF-8") || std::setlocale(LC_ALL, "C.UTF-8")); }},
        {"umask", [] { umask(0077); }},
        {"fork", [] { (void)!fork(); }},
        {"fork without leave", [] { limited(RLIMIT_NPROC, 0, [] { (void)!fork(); }); }},
        {"break pipe",
         [] {
             int ends[2];
             if (pipe(ends) != 0) return;
             close(ends[0]);
             (void)!write(ends[1], "x", 1);
         }},
        {"terminate itself", [] { kill(getpid(), SIGTERM); }},
        {"user signal", [] { kill(getpid(), SIGUSR1); }},
        {"real-time signal", [] { kill(getpid(), SIGRTMIN + 3); }},
    };
    return all;
}

void act(const std::string& name) {
    const auto action = actions().find(name);
    if (action == actions().end()) throw std::runtime_error("the zoo has no '" + name + "'");
    action->second();
}

/// Static object: acts on load and unload, where exceptions must not escape.
struct ComesAndGoes {
    ComesAndGoes() {
        if (const char* name = std::getenv("TRUNDLE_ZOO_LOAD")) act(name);
    }
    ~ComesAndGoes() {
        if (const char* name = std::getenv("TRUNDLE_ZOO_UNLOAD")) act(name);
    }
} g_comesAndGoes;

struct Settings {
    std::string action = "none", phase = "update";
    double at = 50;
};

template <class T> void describeSettings(trundle::Describe<T>& d) {
    d.field("Action", static_cast<std::string T::*>(&T::action), trundle::text(), "What it does.");
    d.field("Phase", static_cast<std::string T::*>(&T::phase), trundle::text(), "When: setup, update, act, sense or destructor.");
    d.field("At", static_cast<double T::*>(&T::at), trundle::number(), "In which turn.");
}

/// Whether an earlier call of a module has changed the rounding mode, the traps or the denormal mode for this one.
bool hasForeignFloatingPoint() {
    constexpr unsigned kSettings = 0xffc0, kDefault = 0x1f80;
    return (_mm_getcsr() & kSettings) != kDefault;
}

/// A destructor cannot fail, so it reports.
void reportForeignFloatingPoint() {
    if (hasForeignFloatingPoint()) std::fputs("zoo: an earlier call has left its floating-point settings\n", stderr);
}

struct Zoo : trundle::Controller, Settings {
    int turns = 0;
    trundle::DifferentialDrivePort drive;
    trundle::SignalPort odometry;
    static void describe(trundle::Describe<Zoo>& d) {
        if (const char* name = std::getenv("TRUNDLE_ZOO_DESCRIBE")) act(name);
        describeSettings(d);
    }
    ~Zoo() override {
        reportForeignFloatingPoint();
        if (phase == "destructor") act(action);
    }
    void setup(trundle::RobotPorts& robot) override {
        drive = robot.differentialDrive("base");
        odometry = robot.signal("base", "odometry");
        if (phase == "setup" && !asksBadly(robot)) act(action);
    }
    bool asksBadly(trundle::RobotPorts& robot) const {
        if (action == "unended port") (void)robot.motor(unended());
        else if (action == "filled port") (void)robot.motor(filled());
        else if (action == "port from nowhere") (void)robot.motor(nowhere());
        else if (action == "unended signal") (void)robot.signal("base", unended());
        else if (action == "unended publish") (void)robot.publish(unended());
        else if (action == "unended has") (void)robot.has(unended(), filled());
        else return false;
        return true;
    }
    void update(trundle::Seconds) override {
        if (hasForeignFloatingPoint()) fail("an earlier call has left its floating-point settings");
        if (++turns != at || phase != "update") return;
        if (!ofPorts()) act(action);
    }
    /// Actions that need the robot's ports.
    bool ofPorts() {
        const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
        if (action == "command nan") drive.move(nan, nan);
        else if (action == "command infinity") drive.move(infinity, -infinity);
        else if (action == "write outputs") odometry.set(1u << 30, 1), odometry.set(0, nan);
        else if (action == "print badly")
            print("\x1b[2J\x07 \xff\xfe \xc2\x9b"
                  "31m ok");
        else if (action == "print much") {
            for (int i = 0; i < 100'000; ++i) print("line ", i);
        } else if (action == "print long") print(std::string(5'000'000, 'x'));
        else if (action == "log badly") {
            for (const char* name : {"../out.csv", "/out.csv", "path.csv", "", ".", "a\nb", ".trundle-logs"})
                openLog(name).write("x");
            for (int i = 0; i < 1100; ++i) openLog("many/" + std::to_string(i)).write("x");
        } else if (action == "fail badly") fail("\x1b[2J gone\n\xff");
        else if (action == "catch and fail") try { act("throw"); } catch (const std::exception&) { fail("caught it"); }
        else if (action == "fail and crash") fail("no way out"), act("segv");
        else if (action == "finish and crash") finish("all found"), act("segv");
        else if (action == "print lines and crash") print(std::string(2000, '\n')), act("segv");
        else if (action == "print from a thread") std::thread([this] { print("hello"); }).join();
        else return false;
        return true;
    }
};

struct ZooDevice : trundle::Device, Settings {
    int turns = 0;
    static void describe(trundle::Describe<ZooDevice>& d) {
        describeSettings(d);
        d.output("beat", "", "Turns.");
    }
    ~ZooDevice() override { // after the destructors of controllers
        reportForeignFloatingPoint();
        if (phase == "destructor") ::act(action);
    }
    void setup(trundle::Mount& mount) override {
        beat = mount.signal("beat");
        if (action == "unended signal") (void)mount.signal(unended());
        else if (action == "filled signal") (void)mount.signal(filled());
        else if (action == "unended field") (void)mount.peerNumber("thing", unended(), 1);
        else if (phase == "setup") ::act(action);
    }
    void act(trundle::Actuation&) override {
        if (++turns == at && phase == "act") ::act(action);
    }
    void sense(trundle::Sensing&) override {
        if (turns == at && phase == "sense") ::act(action);
    }
    trundle::Slot beat;
};

} // namespace

TRUNDLE_MODULE(registry) {
    registry.controller<Zoo>("Zoo");
    registry.device<ZooDevice>("ZooDevice");
}
