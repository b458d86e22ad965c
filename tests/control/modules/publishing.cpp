// A controller that publishes a counter and finishes the run after the configured count.
#include <cstdint>

#include <trundle/controller.h>

namespace {

struct Counter : trundle::Controller {
    std::int64_t end = 0;
    std::string what = "count", reason = "counted enough";
    bool early = false;

    static void describe(trundle::Describe<Counter>& d) {
        d.help("Counts its turns.");
        d.field("End", &Counter::end, trundle::number().within(0, 1e6),
                "It finishes the run in the turn of this number; 0: never.");
        d.field("What", &Counter::what, trundle::text(), "The signal that it publishes.");
        d.field("Reason", &Counter::reason, trundle::text(), "Why the run ends.");
        d.field("Early", &Counter::early, trundle::flag(), "It finishes the run in setup.");
        d.output("count", "", "Turns so far.", 1, TRUNDLE_INTEGER_SIGNAL);
        d.output("where", "m", "A pair.", 2);
    }
    void setup(trundle::RobotPorts& robot) override {
        count = robot.publish(what.c_str());
        where = robot.publish("where");
        where.set(1, 5);
        where.set(2, 99); // beyond its end
        if (early) finish(reason);
    }
    void update(trundle::Seconds) override {
        count.set(count.get() + 1);
        if (end > 0 && count.get() >= static_cast<double>(end)) finish(reason);
    }
    trundle::Slot count, where;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Counter>("Counter"); }
