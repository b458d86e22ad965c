// trundle-host: runs controllers in a process of their own, for trundle and trundle-cli, which start it. Its descriptors 3, 4 and 5
// are the control page, the image of the sensors, read-only, and that of the commands.

#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include "base/platform/confinement.h"
#include "base/platform/helper_process.h"
#include "base/platform/limits.h"
#include "base/platform/shared_segment.h"
#include "host/crash_recorder.h"
#include "host/host_worker.h"
#include "host/python_start.h"

namespace {

constexpr int kControl = 3, kSensors = 4, kCommands = 5;
constexpr trundle::ResourceLimits kLimits{
    .memoryBytes = 4ull << 30, .fileBytes = 1ull << 30, .openFiles = 256, .coreDumps = false};

} // namespace

int main(int argc, char** argv) {
    auto control = trundle::SharedSegment::map(kControl, true);
    const bool isControl = (argc == 2 || argc == 3) && control && control.value().bytes() == sizeof(trundle::ControlPage);
    auto* const page = isControl ? static_cast<trundle::ControlPage*>(control.value().data()) : nullptr;
    if (!page || page->magic != trundle::kHostMagic) {
        std::fputs("trundle-host is started by trundle and trundle-cli, to run controllers\n", stderr);
        return 2;
    }
    if (!trundle::endWithParent(std::atoi(argv[1])) || !trundle::applyLimits(kLimits)) return 1;
    if (argc == 3) trundle::startPython(argv[2]);
    (void)trundle::confineProcess();
    trundle::HostWorker worker(*page, kSensors, kCommands);
    trundle::recordCrashes(*page, worker.calls());
    worker.run();
}
