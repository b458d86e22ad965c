// A sensor that measures the distance straight ahead: a start for your own. Once it is built, an experiment beside this folder
// loads it with
//
//     #loadModule my_sensor/build/my_sensor
//
// and the RobotConfig of its robot has it with
//
//     MySensor eye { Body=chassis Pos=0.15,0,0.05 }
//
// The lines of a Sensor (Body, Pos, HPR, UpdatePeriod, Latency) and the noise of a range come from the SDK.
#include <trundle/sensor.h>

struct MySensor : trundle::Sensor, trundle::RangeNoise {
    double maxRange = 2; // m

    static void describe(trundle::Describe<MySensor>& d) {
        d.help("Measures the distance straight ahead.");
        describeSensor(d);
        d.field("MaxRange", &MySensor::maxRange, trundle::metres().above(0).atMost(100), "Nothing beyond is seen.");
        describeNoise(d);
        d.output("distance", &MySensor::distance, "m", "To what is straight ahead; MaxRange if nothing is.");
    }

    void begin(trundle::Mount&) override {
        ray.count = 1;
        ray.range = maxRange;
        distance.set(maxRange);
    }

    void measure(trundle::Sensing& world, std::vector<double>& reading) override {
        reading.resize(1);
        world.castFan(ray, pose(world), {reading, {}, {}});
        reading = {apply(reading[0], 0, maxRange, world, 0)};
    }

    void publish(std::span<const double> reading, double) override { distance.set(reading[0]); }

    trundle::Fan ray;
    trundle::OutputSlot<double> distance;
};

TRUNDLE_MODULE(registry) { registry.device<MySensor>("MySensor"); }
