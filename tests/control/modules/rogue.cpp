// A controller that attacks what is around it: the process that runs it, that which started it, and the memory that they share.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <trundle/controller.h>

namespace {

struct OpenEncoder : trundle::EncoderPort {
    explicit OpenEncoder(const trundle::EncoderPort& port) : EncoderPort(port) {}
    void write(double value) { m_signals.count.set(value); }
};

/// Calls `use` with each writable mapping whose name contains `name`.
void forMappings(const std::string& name, const std::function<void(char*, std::size_t)>& use) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        unsigned long begin = 0, end = 0;
        char rights[8] = {};
        if (std::sscanf(line.c_str(), "%lx-%lx %7s", &begin, &end, rights) != 3) continue;
        if (rights[1] == 'w' && line.find(name) != std::string::npos) use(reinterpret_cast<char*>(begin), end - begin);
    }
}

void refused(const char* what, bool succeeded) {
    if (succeeded) throw std::runtime_error(std::string(what) + " was possible");
}

void makeWritable(const std::string& name) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        unsigned long begin = 0, end = 0;
        if (line.find(name) == std::string::npos || std::sscanf(line.c_str(), "%lx-%lx", &begin, &end) != 2) continue;
        refused("writing to the sensors", mprotect(reinterpret_cast<void*>(begin), end - begin, PROT_READ | PROT_WRITE) == 0);
    }
}

void forkBomb() {
    for (int i = 0; i < 100'000; ++i)
        if (fork() == 0)
            for (;;) (void)!fork();
}

void threadBomb() {
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 64 * 1024);
    for (int i = 0; i < 3000; ++i) {
        pthread_t thread{};
        if (pthread_create(
                &thread, &small,
                [](void*) -> void* {
                    for (;;) pause();
                },
                nullptr) != 0)
            return;
    }
}

void keepThread() {
    std::thread([] {
        for (;;) usleep(100);
    }).detach();
}

/// Values of all slots that it can reach, every 50 us, after its update has returned.
void keepWriting() {
    std::thread([] {
        for (;;) {
            forMappings("trundle-commands", [](char* begin, std::size_t bytes) { std::memset(begin, 0x41, bytes); });
            usleep(50);
        }
    }).detach();
}

const std::map<std::string, std::function<void()>>& actions() {
    static const auto& all = *new std::map<std::string, std::function<void()>>{
        {"none", [] {}},
        {"stop itself", [] { raise(SIGSTOP); }},
        {"leave", [] { syscall(SYS_exit_group, 0); }},
        {"kill itself", [] { kill(getpid(), SIGKILL); }},
        {"kill the parent", [] { refused("killing the program", kill(getppid(), SIGKILL) == 0); }},
        {"kill all", [] { refused("killing all", kill(-1, SIGKILL) == 0); }},
        {"kill the group", [] { refused("killing a group", kill(0, SIGKILL) == 0); }},
        {"trace me", [] { refused("tracing", ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0); }},
        {"trace the parent", [] { refused("tracing", ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0); }},
        {"execute", [] { refused("another program", execl("/bin/sh", "sh", "-c", "sleep 1000", nullptr) == 0); }},
        {"system", [] { refused("a command", std::system("true") == 0); }},
        {"fork bomb", forkBomb},
        {"thread bomb", threadBomb},
        {"keep a thread", keepThread},
        {"keep writing", keepWriting},
        {"close 0 to 63",
         [] {
             for (int file = 0; file < 64; ++file) close(file);
         }},
        {"raise limits",
         [] {
             const rlimit all{RLIM_INFINITY, RLIM_INFINITY};
             (void)setrlimit(RLIMIT_AS, &all);
             (void)setrlimit(RLIMIT_NOFILE, &all);
         }},
        {"outlive the parent", [] { refused("outliving the program", prctl(PR_SET_PDEATHSIG, 0) == 0); }},
        {"read the input", [] { refused("reading the user's input", getchar() != EOF); }},
        {"change folder", [] { (void)!chdir("/proc"); }},
        {"make sensors writable", [] { makeWritable("trundle-sensors"); }},
        {"overwrite commands",
         [] { forMappings("trundle-commands", [](char* begin, std::size_t bytes) { std::memset(begin, 0x41, bytes); }); }},
        {"overwrite control",
         [] { forMappings("trundle-control", [](char* begin, std::size_t bytes) { std::memset(begin, 0xff, bytes); }); }},
        {"overwrite mailbox", // its own record is the only valid one afterwards
         [] {
             forMappings("trundle-control",
                         [](char* begin, std::size_t bytes) { std::memset(begin + bytes / 2, 0xff, bytes / 2); });
         }},
        {"unmap control", [] { forMappings("trundle-control", [](char* begin, std::size_t bytes) { munmap(begin, bytes); }); }},
        {"shrink segments",
         [] {
             for (int file = 3; file < 6; ++file) refused("shrinking", ftruncate(file, 0) == 0);
         }},
        {"eat memory",
         [] {
             std::vector<std::unique_ptr<char[]>> all;
             for (;;) all.push_back(std::make_unique_for_overwrite<char[]>(512u << 20));
         }},
    };
    return all;
}

struct Rogue : trundle::Controller {
    std::string action = "none";
    double at = 50;
    int turns = 0;
    trundle::DifferentialDrivePort drive;
    trundle::EncoderPort encoder;

    static void describe(trundle::Describe<Rogue>& d) {
        d.field("Action", &Rogue::action, trundle::text(), "What it does.");
        d.field("At", &Rogue::at, trundle::number(), "In which turn.");
    }
    void setup(trundle::RobotPorts& robot) override {
        drive = robot.differentialDrive("base");
        encoder = robot.encoder("leftEncoder");
    }
    void update(trundle::Seconds) override {
        drive.move(0.1, 0.2);
        if (++turns != at) return;
        if (action == "write a sensor") OpenEncoder(encoder).write(12345);
        else if (action == "print without end") printWithoutEnd();
        else if (action == "open logs without end") openLogsWithoutEnd();
        else actions().at(action)();
    }
    // Both hand over to the program again and again, so that no single wait is long.
    void printWithoutEnd() const {
        for (;;) print(std::string(1000, 'x'));
    }
    void openLogsWithoutEnd() const {
        for (;;) (void)openLog("../refused.csv");
    }
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Rogue>("Rogue"); }
