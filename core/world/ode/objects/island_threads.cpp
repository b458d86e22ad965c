#include "world/ode/objects/island_threads.h"

#include "world/ode/objects/ode_fault.h"

namespace trundle {

namespace {

/// Held for some ten instructions: sleeping would cost more.
class SpinLock {
public:
    void lock() {
        for (int polls = 0; m_held.exchange(true, std::memory_order_acquire);)
            while (m_held.load(std::memory_order_relaxed))
                if (++polls % 1000 == 0) std::this_thread::yield();
                else relaxProcessor();
    }
    void unlock() { m_held.store(false, std::memory_order_release); }

private:
    std::atomic<bool> m_held{false};
};

} // namespace

thread_local IslandThreads::Worker* IslandThreads::t_worker = nullptr;

struct IslandThreads::Functions {
    static IslandThreads& self(dThreadingImplementationID threads) { return *reinterpret_cast<IslandThreads*>(threads); }
    static SpinLock* locks(dMutexGroupID group) { return reinterpret_cast<SpinLock*>(group); }
    static Call* call(dCallReleaseeID posted) { return reinterpret_cast<Call*>(posted); }
    static Wait* wait(dCallWaitID wait) { return reinterpret_cast<Wait*>(wait); }

    static dMutexGroupID makeLocks(dThreadingImplementationID, dmutexindex_t count, const char* const*) {
        return reinterpret_cast<dMutexGroupID>(new SpinLock[count]);
    }
    static void freeLocks(dThreadingImplementationID, dMutexGroupID group) { delete[] locks(group); }
    static void lock(dThreadingImplementationID, dMutexGroupID group, dmutexindex_t index) { locks(group)[index].lock(); }
    static void unlock(dThreadingImplementationID, dMutexGroupID group, dmutexindex_t index) { locks(group)[index].unlock(); }

    static dCallWaitID makeWait(dThreadingImplementationID) { return reinterpret_cast<dCallWaitID>(new Wait); }
    static void resetWait(dThreadingImplementationID, dCallWaitID of) { wait(of)->isOver = false; }
    static void freeWait(dThreadingImplementationID, dCallWaitID of) { delete wait(of); }

    static void post(dThreadingImplementationID threads, int* fault, dCallReleaseeID* posted, ddependencycount_t open,
                     dCallReleaseeID next, dCallWaitID over, dThreadedCallFunction* run, void* context, dcallindex_t index,
                     const char*) {
        self(threads).post(fault, posted, static_cast<std::ptrdiff_t>(open), call(next), wait(over), run, context, index);
    }
    static void changeOpen(dThreadingImplementationID threads, dCallReleaseeID of, ddependencychange_t change) {
        IslandThreads& me = self(threads);
        me.release(t_worker ? *t_worker : *me.m_workers[0], *call(of), -static_cast<std::ptrdiff_t>(change));
    }
    static void waitFor(dThreadingImplementationID threads, int* status, dCallWaitID over, const dThreadedWaitTime*,
                        const char*) {
        self(threads).workOff();
        if (status) *status = wait(over)->isOver;
    }
    static unsigned count(dThreadingImplementationID threads) { return self(threads).m_team.size(); }
    static int preallocate(dThreadingImplementationID, ddependencycount_t) { return 1; }
};

IslandThreads::IslandThreads(WorkTeam& team) : m_team(team) {
    for (unsigned i = 0; i < team.size(); ++i) m_workers.push_back(std::make_unique<Worker>());
}

void IslandThreads::giveTo(dWorldID world) {
    static const dThreadingFunctionsInfo table{sizeof(dThreadingFunctionsInfo),
                                               &Functions::makeLocks,
                                               &Functions::freeLocks,
                                               &Functions::lock,
                                               &Functions::unlock,
                                               &Functions::makeWait,
                                               &Functions::resetWait,
                                               &Functions::freeWait,
                                               &Functions::post,
                                               &Functions::changeOpen,
                                               &Functions::waitFor,
                                               &Functions::count,
                                               &Functions::preallocate};
    dWorldSetStepThreadingImplementation(world, &table, reinterpret_cast<dThreadingImplementationID>(this));
}

IslandThreads::Call* IslandThreads::take(Worker& worker) {
    if (worker.unused.empty()) return &worker.calls.emplace_back();
    Call* call = worker.unused.back();
    worker.unused.pop_back();
    return call;
}

void IslandThreads::post(int* fault, dCallReleaseeID* posted, std::ptrdiff_t open, Call* next, Wait* wait,
                         dThreadedCallFunction* run, void* context, dcallindex_t index) {
    Call& call = *take(t_worker ? *t_worker : *m_workers[0]);
    call.run = run;
    call.context = context;
    call.index = index;
    call.next = next;
    call.wait = wait;
    call.fault = fault;
    call.hasRun = false;
    call.isOwn = !t_worker;
    if (call.isOwn) m_own.push_back(&call);
    call.open.store(open, std::memory_order_relaxed);
    call.failed.store(false, std::memory_order_relaxed);
    if (fault) *fault = 0;
    if (posted) *posted = reinterpret_cast<dCallReleaseeID>(&call);
    if (open == 0) (t_worker ? t_worker->ready : m_first).push_back(&call);
}

/// It waits for so many fewer, or for more. A call that has run may wait, too, for calls that it posted: only then it is over, and what
/// waits for it has one less to wait for.
void IslandThreads::release(Worker& worker, Call& released, std::ptrdiff_t count) {
    for (Call* call = &released; call->open.fetch_sub(count, std::memory_order_acq_rel) == count; count = 1) {
        if (!call->hasRun) {
            (t_worker ? worker.ready : m_first).push_back(call);
            return;
        }
        const bool failed = call->failed.load(std::memory_order_relaxed);
        if (call->fault) *call->fault = failed ? 1 : 0;
        if (call->wait) call->wait->isOver = true;
        Call* const next = call->next;
        if (!call->isOwn) worker.unused.push_back(call);
        if (!next) return;
        if (failed) next->failed.store(true, std::memory_order_relaxed);
        call = next;
    }
}

void IslandThreads::work(unsigned index, std::size_t every) {
    prepareThread();
    Worker& worker = *m_workers[index];
    const std::uint64_t before = odeMessages();
    t_worker = &worker;
    m_arrivals.fetch_add(1, std::memory_order_acq_rel);
    try {
        for (std::size_t i = index; i < m_first.size(); i += every) {
            worker.ready.push_back(m_first[i]);
            while (!worker.ready.empty() && !m_faulted.load(std::memory_order_relaxed)) {
                Call& call = *worker.ready.back();
                worker.ready.pop_back();
                call.hasRun = true;
                call.open.store(1, std::memory_order_relaxed); // itself
                if (call.run(call.context, call.index, reinterpret_cast<dCallReleaseeID>(&call)) == 0) call.failed = true;
                release(worker, call, 1);
            }
        }
    } catch (const OdeFault&) { m_faulted = true; }
    m_arrivals.fetch_add(1, std::memory_order_acq_rel);
    t_worker = nullptr;
    if (std::this_thread::get_id() != m_caller) m_messages.fetch_add(odeMessages() - before, std::memory_order_relaxed);
}

/// Throws OdeFault in place of the thread where it happened; then the calls that are left are lost, and this is not used any more.
void IslandThreads::workOff() {
    m_caller = std::this_thread::get_id();
    if (m_shared && m_first.size() > 1) m_team.run(m_team.size(), [this](unsigned worker) { work(worker, m_team.size()); });
    else work(0, 1);
    addOdeMessages(m_messages.exchange(0, std::memory_order_relaxed));
    m_first.clear();
    if (m_faulted) throw OdeFault{};
    for (Call* const call : m_own) m_workers[0]->unused.push_back(call);
    m_own.clear();
}

} // namespace trundle
