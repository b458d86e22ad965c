// What is known of the calls of a run, from any thread.
#include <QtTest>

#include <barrier>
#include <cfenv>
#include <thread>

#include "base/call_monitor.h"

using namespace trundle;

class CallMonitorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatARunIsDoing() {
        CallMonitor monitor;
        QVERIFY(!monitor.target() && std::string(monitor.doing()).empty() && !monitor.clusterBody());
        monitor.setModule("Driver", "libdriver.so");
        const CallTarget* driver = monitor.add({"the controller", "robot0", "Driver", "", 3});
        const CallTarget* other = monitor.add({"the device", "robot0", "Lamp", "liblamp.so"});
        QVERIFY(driver->module == "libdriver.so" && other->module == "liblamp.so" && driver->controllerOf == 3);
        {
            const MonitoredCall outer(monitor, driver, "update");
            QVERIFY(monitor.target() == driver && std::string(monitor.doing()) == "update");
            const std::uint64_t before = monitor.sequence();
            {
                const MonitoredCall inner(monitor, other, "sense");
                QVERIFY(monitor.target() == other && std::string(monitor.doing()) == "sense");
                QCOMPARE(monitor.sequence(), before + 1);
            }
            QVERIFY(monitor.target() == driver && std::string(monitor.doing()) == "update");
            QCOMPARE(monitor.sequence(), before + 2);
        }
        QVERIFY(!monitor.target());
        {
            const MonitoredCall outer(monitor, driver, "update");
            {
                MonitoredCalls calls(monitor, "act");
                for (const CallTarget* target : {other, driver, other}) {
                    const std::uint64_t before = monitor.sequence();
                    calls.next(target);
                    QVERIFY(monitor.target() == target && std::string(monitor.doing()) == "act" && monitor.sequence() > before);
                    std::fesetround(FE_UPWARD);
                    calls.restoreFloatingPoint();
                    QCOMPARE(std::fegetround(), FE_TONEAREST);
                }
            }
            QVERIFY(monitor.target() == driver && std::string(monitor.doing()) == "update");
        }
        QVERIFY(!monitor.target());
        monitor.addCode(100, 200, driver);
        monitor.addCode(200, 300, other);
        monitor.addCode(150, 160, other); // loaded later at the same place
        QVERIFY(monitor.libraryAt(100) == driver && monitor.libraryAt(199) == driver && monitor.libraryAt(200) == other);
        QVERIFY(monitor.libraryAt(155) == other && !monitor.libraryAt(99) && !monitor.libraryAt(300));
        for (int i = 0; i < 300; ++i) monitor.addCode(1000, 1001, driver); // more than fit
        QVERIFY(monitor.libraryAt(150) == other);
        monitor.setBodies({"robot0/hull", "robot1/hull"});
        monitor.recordCluster(17, 1);
        monitor.recordTicks(250, 2.5);
        QVERIFY(monitor.clusterContacts() == 17 && std::string(monitor.clusterBody()) == "robot1/hull");
        QVERIFY(monitor.ticks() == 250 && monitor.time() == 2.5);
        monitor.recordCluster(17, 2);
        QVERIFY(!monitor.clusterBody());
    }

    /// Each sees its own call, and others see that of the first thread that is in one.
    void callsOfSeveralThreads() {
        CallMonitor monitor;
        const CallTarget* first = monitor.add({"the device a", "robot0", "Lamp", ""});
        const CallTarget* second = monitor.add({"the device b", "robot1", "Lamp", ""});
        std::barrier both(2);
        const CallTarget* seen = nullptr;
        std::thread other([&] {
            {
                MonitoredCalls calls(monitor, "sense", 1);
                calls.next(second);
                seen = monitor.target();
                both.arrive_and_wait(); // 1: it is in its call
                both.arrive_and_wait(); // 2: the other one has looked
            }
            both.arrive_and_wait(); // 3
        });
        both.arrive_and_wait();
        QVERIFY(seen == second && monitor.target() == second && std::string(monitor.doing()) == "sense");
        const std::uint64_t before = monitor.sequence();
        {
            MonitoredCalls calls(monitor, "act");
            calls.next(first);
            QVERIFY(monitor.target() == first && std::string(monitor.doing()) == "act" && monitor.sequence() > before);
        }
        QVERIFY(monitor.target() == second);
        both.arrive_and_wait();
        both.arrive_and_wait();
        other.join();
        QVERIFY(!monitor.target());
    }
};

QTEST_APPLESS_MAIN(CallMonitorTest)
#include "call_monitor_test.moc"
