#pragma once
// The memory through which a run and a host process talk. Exactly one of the two has the turn and may touch the mailboxes. The
// run reads nothing from here twice and trusts no value: code of a module in the host may write anything into it.

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/platform/wait_word.h"

namespace trundle {

inline constexpr std::uint32_t kHostMagic = 0x54534854; // "THST"

enum class Turn : std::uint32_t { Run = 0, Host = 1 };

/// What a host process does in the code of a module.
enum class HostPhase : std::uint32_t { None, Load, Setup, Update, Set, Destructor, Unload, SaveState, LoadState, Act, Sense };

/// Why a host process ended, written by its handlers of signals and of exit().
struct CrashRecord {
    static constexpr std::size_t kMostFrames = 48;
    struct Frame {
        std::uint32_t library = 0; ///< in the order in which the libraries were loaded
        std::uint64_t offset = 0;  ///< of the return address in it
    };

    std::atomic<std::uint32_t> complete{0};
    std::int32_t signal = 0;         ///< 0: exit()
    std::uint32_t ofThread = 0;      ///< 1: in a thread that a module has started
    std::uint32_t ofSensorImage = 0; ///< 1: it wrote to a sensor value
    std::uint32_t frameCount = 0;
    std::array<Frame, kMostFrames> frames{};
    std::array<char, 512> exception{}; ///< text of an uncaught exception
};

struct Mailbox {
    static constexpr std::uint32_t kCapacity = 1u << 20;
    std::atomic<std::uint32_t> size{0}; ///< complete messages: readable even after a crash of the writer
    std::uint32_t more = 0;             ///< 1: the message continues in the next turn
    alignas(64) std::array<char, kCapacity> bytes;
};

struct ControlPage {
    std::uint32_t magic = kHostMagic;
    std::uint64_t generation = 0;
    alignas(64) WaitWord turn{0};
    alignas(64) std::atomic<std::uint32_t> runSleeps{0}, hostSleeps{0}; ///< 1: has to be woken
    // Of the call in progress.
    alignas(64) std::atomic<std::uint32_t> phase{0};
    std::atomic<std::uint32_t> controller{0};
    CrashRecord crash;
    Mailbox toHost, toRun;
    /// Calls of Python, written by its fault handler: at the end, so that it cannot write beyond.
    alignas(64) std::array<char, 16384> report{};
};

/// Messages to a host. Each is answered by records, the last of which is Done.
enum class HostRequest : std::uint32_t {
    Load,
    Map,
    Start,
    Update,
    Set,
    Stop,
    Unload,
    SaveState,
    LoadState,
    StartDevice,
    Act,
    Sense // of a module in Python: python_devices.h
};

/// Records to a run: a kind, a controller, and bytes. After a request of the second group the host waits for a reply.
enum class HostRecord : std::uint32_t {
    Done = 1,
    Updated, ///< of one controller
    Print,
    WriteLog,
    Finish,
    GaveUp,
    DeviceCommand, ///< a call of a device: device_calls.h
    OpenLog = 100,
    Capture,
    SavePicture,
    ObjectName,
    FindRadio,
    SendPacket,
    ReceivePacket,
    Claim,
    DeviceQuery ///< a call of a device that has a result
};

struct RecordHeader {
    std::uint32_t kind = 0, controller = 0;
    std::uint64_t bytes = 0;
};

} // namespace trundle
