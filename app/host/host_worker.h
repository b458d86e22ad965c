#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <string>

#include "base/call_monitor.h"
#include "base/platform/shared_segment.h"
#include "control/controller_instance.h"
#include "control/host/controller_record.h"
#include "control/host/message_link.h"
#include "control/module_store.h"
#include "host/host_outputs.h"
#include "host/record_sender.h"

namespace trundle {

/// Handles the requests of a run: loads a module and calls its controllers. Uses the thread that called run().
class HostWorker final : private MessageLink, public RecordSender {
public:
    /// `sensors`, `commands`: descriptors of the images, which get their size later.
    HostWorker(ControlPage& page, int sensors, int commands);

    [[noreturn]] void run();
    [[nodiscard]] const CallMonitor& calls() const { return *m_calls; }

    void record(HostRecord kind, std::uint32_t controller, std::string_view bytes) override;
    [[nodiscard]] std::string ask(HostRecord kind, std::uint32_t controller, std::string_view bytes) override;

private:
    struct Controller {
        ControllerRecord record;
        std::unique_ptr<ControllerInstance> instance;
        std::shared_ptr<HostRadios> radios;
        const CallTarget* target = nullptr;
    };

    [[nodiscard]] bool awaitTurn() override;
    [[nodiscard]] std::string receive();
    void handle(HostRequest request, WireReader& in);
    void load(const std::string& library);
    void map();
    void start(WireReader& in);
    void update(WireReader& in);
    void set(WireReader& in);
    void saveState(std::uint32_t number);
    void loadState(WireReader& in);
    void stop(std::uint32_t number);
    void unload();
    void done(const Status& status, std::string_view more = {});
    void reportIgnored();
    void enter(HostPhase phase, std::uint32_t controller);

    const int m_sensorFile, m_commandFile;
    const long m_thread;
    static constexpr std::int64_t kNone = -1;
    std::atomic<std::int64_t> m_ignoredOf{kNone}; ///< a controller for which another thread has asked for something
    bool m_saidIgnored = false;
    SharedSegment m_sensors, m_commands;
    std::shared_ptr<CallMonitor> m_calls = std::make_shared<CallMonitor>();
    std::unique_ptr<ModuleStore> m_store; ///< before the controllers, which it must outlive
    std::map<std::uint32_t, Controller> m_controllers;
};

} // namespace trundle
