#include "model/kinds/radio_fields.h"

namespace trundle {

void AntennaPatternFields::describe(Describe<AntennaPatternFields>& d) {
    d.help("How strongly an antenna sends and receives in each direction of its own frame: it looks along +x, its up is +z.");
    d.field("Model", &AntennaPatternFields::model, oneOf("isotropic|dipole|inverted_f|patch|yagi|cosine"),
            "A formula; the axis of a dipole is z, the others point along x.");
    d.field("PeakGain", &AntennaPatternFields::peakGain, unitOf("dBi").within(-30, 60),
            "In its best direction; where absent, what a model without losses has.");
    d.field("BeamWidth", &AntennaPatternFields::beamWidth, degrees().within(1, 179),
            "Of a patch, yagi or cosine, between the points of half power.");
    const Quantity pairs = number().within(-360, 360).counted(2, 10000);
    d.field("Azimuth", &AntennaPatternFields::azimuth, pairs,
            "Measured, at elevation 0: an angle (deg, to the left), its gain (dBi), the next angle ...");
    d.field("Elevation", &AntennaPatternFields::elevation, pairs,
            "Measured, at azimuth 0, beyond 90 behind: an angle (deg, upwards), its gain (dBi), the next angle ...");
    d.field("File", &AntennaPatternFields::file, trundle::file("csv"),
            "Measured all around: lines of azimuth, elevation (deg) and gain (dBi) that fill a grid.");
}

void RadioMediumFields::describe(Describe<RadioMediumFields>& d) {
    d.help("The air between Transceivers. Without one it is ideal.");
    d.field("Model", &RadioMediumFields::model, oneOf("ideal|two_ray|log_distance"),
            "What is lost on the way: free space, with the ground's reflection at z = 0, or by an exponent.");
    d.field("Mac", &RadioMediumFields::mac, oneOf("none|csma"),
            "none sends at once; csma listens first, acknowledges and repeats, as IEEE 802.15.4 does.");
    d.field("Frequency", &RadioMediumFields::frequency, hertz().within(1e6, 1e11), "Of the waves.");
    d.field("Exponent", &RadioMediumFields::exponent, number().within(1, 10), "Of log_distance beyond 1 m.");
    d.field("Shadowing", &RadioMediumFields::shadowing, decibels().within(0, 30),
            "Standard deviation of each link's own loss; the same both ways, and it stays put.");
    d.field("CorrelationDistance", &RadioMediumFields::correlation, metres().within(0, 1e4),
            "How far one end moves until its shadowing is another; 0 = never.");
    d.field("GroundPermittivity", &RadioMediumFields::permittivity, number().within(0, 1000),
            "Of two_ray's ground, relative; 0 = reflects everything.");
    d.field("WallLoss", &RadioMediumFields::wallLoss, decibels().within(0, 200), "Of each solid between two antennas.");
    d.field("NoiseFloor", &RadioMediumFields::noiseFloor, decibelMilliwatts().within(-200, 0), "Noise in the channel.");
    d.field("PacketErrors", &RadioMediumFields::packetErrors, flag(),
            "Frames are lost by the bit errors of IEEE 802.15.4; else all arrive that are above MinReceivePower.");
    d.field("ImplementationLoss", &RadioMediumFields::implementationLoss, decibels().within(0, 30),
            "What a receiver needs above the theory of PacketErrors.");
    d.field("Collisions", &RadioMediumFields::collisions, flag(), "Frames that overlap disturb each other.");
    d.field("CaptureMargin", &RadioMediumFields::captureMargin, decibels().within(-30, 60),
            "A frame this much above all others survives a collision; not with PacketErrors, which model this in detail.");
    d.field("CarrierSense", &RadioMediumFields::carrierSense, decibelMilliwatts().within(-200, 0),
            "Power that csma takes for a busy channel.");
    d.field("Offsets", &RadioMediumFields::offsets, decibels().within(0, 20),
            "Standard deviation of each radio's output power and of its RSSI.");
    d.field("ClockDrift", &RadioMediumFields::clockDrift, unitOf("ppm").within(0, 1e5),
            "Standard deviation of each radio's clock rate, in millionths.");
}

} // namespace trundle
