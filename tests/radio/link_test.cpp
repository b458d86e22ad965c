// The link budget compared with the closed form: positions, rotated antennas, powers.
#include <QtTest>

#include <random>

#include "radio/air.h"
#include "radio/propagation.h"

using namespace air;

namespace {

Vec3 anywhere(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> along(-size, size);
    return {along(random), along(random), along(random)};
}

/// 2 (n + 1) cos^n of the angle between the antenna's axis and the direction to the other antenna, in dBi.
double lobeGain(const Vec3& hpr, const Vec3& way, double n) {
    const double h = hpr.x(), p = hpr.y();
    const Vec3 axis(std::cos(h) * std::cos(p), std::sin(h) * std::cos(p), -std::sin(p));
    const double cosine = axis.dot(way) / way.norm();
    return cosine > 0 ? std::max(-30., 10 * std::log10(2 * (n + 1)) + 10 * n * std::log10(cosine)) : -30;
}

/// Half-wave dipole along the antenna's z.
double dipoleGain(const Vec3& hpr, const Vec3& way) {
    const Mat3 r = (Eigen::AngleAxisd(hpr.x(), Vec3::UnitZ()) * Eigen::AngleAxisd(hpr.y(), Vec3::UnitY()) *
                    Eigen::AngleAxisd(hpr.z(), Vec3::UnitX()))
                       .toRotationMatrix();
    const double cosine = r.col(2).dot(way) / way.norm(), sine = std::sqrt(1 - cosine * cosine);
    return std::max(-30., 10 * std::log10(1.6409224) + 20 * std::log10(std::abs(std::cos(M_PI / 2 * cosine) / sine)));
}

} // namespace

class LinkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// No link beyond the range reaches the power, with the best draw of shadowing and the best of a second ray; just inside one may.
    void noLinkIsBeyondTheRange() {
        const auto rangeOf = [](const MediumSettings& settings) { return LinkModel(settings).range(0, -90); };
        MediumSettings ideal, shadowed, steep;
        shadowed.shadowing = 8;
        steep.shadowing = 8;
        steep.model = PropagationModel::LogDistance;
        steep.exponent = 3.5;
        const double lossAtOne = 20 * std::log10(4 * M_PI / wavelength(ideal.frequency));
        QVERIFY(std::abs(rangeOf(ideal) / std::pow(10, (90 - lossAtOne) / 20) - 1) < 1e-6);
        QVERIFY(std::abs(rangeOf(shadowed) / std::pow(10, (90 + 4 * 8 - lossAtOne) / 20) - 1) < 1e-6); // drawn up to 4 sigma
        QVERIFY(std::abs(rangeOf(steep) / std::pow(10, (90 + 4 * 8 - lossAtOne) / 35) - 1) < 1e-6);
        MediumSettings ground = ideal;
        ground.model = PropagationModel::TwoRay;
        QVERIFY(rangeOf(ground) > 1.99 * rangeOf(ideal)); // two rays in phase: twice the field
    }

    /// To 1 m it is free space, whatever the exponent; so is the range of weak senders.
    void theExponentActsBeyondAMetre() {
        for (const double exponent : {0.5, 2., 4., 6.}) {
            MediumSettings settings;
            settings.model = PropagationModel::LogDistance;
            settings.exponent = exponent;
            const double lambda = wavelength(settings.frequency);
            for (const double distance : {0.05, 0.1, 0.3, 0.999})
                QVERIFY(std::abs(logDistanceLoss(distance, lambda, exponent) - freeSpaceLoss(distance, lambda)) < 1e-9);
            QVERIFY(std::abs(logDistanceLoss(10, lambda, exponent) - freeSpaceLoss(1, lambda) - 10 * exponent) < 1e-9);
            for (const double distance : {0.3, 0.8, 1.3, 20.}) {
                const double loss = logDistanceLoss(distance, lambda, exponent);
                QVERIFY(std::abs(LinkModel(settings).range(0, -loss) / distance - 1) < 1e-6);
            }
        }
    }

    /// Of frames that begin in the same microsecond a radio follows the strongest, in whatever order they were sent.
    void theStrongestOfSimultaneousFramesIsFollowed() {
        for (const std::vector<double>& places : {std::vector<double>{1, 4, 9}, {4, 1, 9}, {9, 4, 1}}) {
            MediumSettings settings;
            settings.collisions = true;
            Medium medium(settings);
            const RadioId ear = open(medium, "ear", {0, 0, 0});
            std::vector<RadioId> senders;
            for (std::size_t i = 0; i < places.size(); ++i)
                senders.push_back(open(medium, "sender" + std::to_string(i), {places[i], 0, 0}));
            for (const RadioId sender : senders) send(medium, sender, 5 + sender);
            medium.advance(10000);
            QCOMPARE(medium.pending(ear), std::size_t{1});
            RadioPacket packet;
            QVERIFY(medium.receive(ear, packet));
            const auto nearest = static_cast<std::size_t>(std::ranges::min_element(places) - places.begin());
            QCOMPARE(packet.from, medium.radio(senders[nearest]).address);
            QVERIFY(isConserved(medium));
        }
    }

    /// The ground's permittivity is that of the settings.
    void theGroundReflectsAsItIs() {
        for (const double permittivity : {0., 3., 15., 60.}) {
            MediumSettings settings;
            settings.model = PropagationModel::TwoRay;
            settings.permittivity = permittivity;
            Medium medium(settings);
            const Vec3 a(0, 0, 0.3), b(17, 4, 1.2);
            const RadioId from = open(medium, "a", a), to = open(medium, "b", b);
            QCOMPARE(medium.link(from, to).pathLoss, twoRayLoss(a, b, wavelength(settings.frequency), permittivity));
        }
    }

    /// Antennas with gain reach beyond the range of isotropic ones, whichever of the two has it.
    void antennasReachFurther() {
        const auto lobe = std::make_shared<const AntennaPattern>(AntennaPattern::of(AntennaModel::Cosine, 12));
        for (const int with : {0, 1, 2}) {
            Medium medium{MediumSettings{}};
            RadioDefinition sender = radioNamed("a"), receiver = radioNamed("b");
            if (with == 1) sender.antenna = lobe;
            if (with == 2) receiver.antenna = lobe;
            const double range = LinkModel(MediumSettings{}).range(0, sender.minReceivePower);
            const RadioId from = open(medium, sender, Vec3::Zero());
            (void)open(medium, receiver, Vec3(2 * range, 0, 0), Vec3(M_PI, 0, 0));
            QVERIFY(send(medium, from));
            medium.advance(100'000);
            QCOMPARE(count(medium, ReceptionOutcome::Delivered), std::uint64_t(with ? 1 : 0));
        }
    }

    void turnedAntennasMatchTheClosedForm() {
        std::mt19937_64 random(20261122);
        const auto lobe = std::make_shared<const AntennaPattern>(AntennaPattern::of(AntennaModel::Cosine));
        const auto dipole = std::make_shared<const AntennaPattern>(AntennaPattern::of(AntennaModel::Dipole));
        for (int i = 0; i < 1000; ++i) {
            Medium medium({});
            RadioDefinition a = radioNamed("a"), b = radioNamed("b");
            a.antenna = lobe;
            b.antenna = dipole;
            a.maxOutputPower = std::uniform_real_distribution<double>(-25, 0)(random);
            const Vec3 from = anywhere(random, 20), to = anywhere(random, 20), turnA = anywhere(random, 3),
                       turnB = anywhere(random, 3);
            const RadioId first = open(medium, a, from, turnA), second = open(medium, b, to, turnB);
            const double distance = (to - from).norm();
            const double expected = a.maxOutputPower + lobeGain(turnA, to - from, 2) + dipoleGain(turnB, from - to) -
                                    20 * std::log10(4 * M_PI * distance * 2.45e9 / 299792458.);
            const LinkBudget link = medium.link(first, second);
            QVERIFY2(std::abs(link.power - expected) < 0.01,
                     qPrintable(QString("%1 %2 %3").arg(i).arg(link.power).arg(expected)));
            QCOMPARE(medium.link(second, first).power - b.maxOutputPower + a.maxOutputPower, link.power);
        }
    }

    void bothWaysAreTheSame_data() {
        QTest::addColumn<int>("model");
        QTest::newRow("ideal") << static_cast<int>(PropagationModel::Ideal);
        QTest::newRow("two_ray") << static_cast<int>(PropagationModel::TwoRay);
        QTest::newRow("log_distance") << static_cast<int>(PropagationModel::LogDistance);
    }
    void bothWaysAreTheSame() {
        QFETCH(int, model);
        std::mt19937_64 random(5);
        MediumSettings settings;
        settings.model = static_cast<PropagationModel>(model);
        settings.exponent = 2.7;
        settings.shadowing = 4;
        settings.wallLoss = 3;
        Medium medium(settings);
        medium.setWalls([](RadioId a, const Vec3&, RadioId b, const Vec3&) { return static_cast<int>((a * 7 + b) % 3); });
        std::vector<RadioId> radios;
        for (int i = 0; i < 20; ++i) {
            RadioDefinition d = radioNamed("robot" + std::to_string(i) + "/radio");
            d.antenna = std::make_shared<const AntennaPattern>(AntennaPattern::of(static_cast<AntennaModel>(i % 6)));
            radios.push_back(open(medium, d, anywhere(random, 30), anywhere(random, 3)));
        }
        for (const RadioId a : radios)
            for (const RadioId b : radios)
                if (a != b) QVERIFY(medium.link(a, b).power == medium.link(b, a).power); // to the last bit
    }

    void othersChangeNoLink() {
        MediumSettings settings;
        settings.model = PropagationModel::LogDistance;
        settings.shadowing = 5;
        Medium alone(settings), crowd(settings);
        const RadioId a = open(alone, "a/radio", {0, 0, 0}), b = open(alone, "b/radio", {5, 0, 0});
        for (int i = 0; i < 5; ++i) open(crowd, "other" + std::to_string(i), {1. * i, 3, 0});
        const RadioId b2 = open(crowd, "b/radio", {5, 0, 0}), a2 = open(crowd, "a/radio", {0, 0, 0});
        QCOMPARE(crowd.link(a2, b2).power, alone.link(a, b).power);
        QVERIFY(std::abs(alone.link(a, b).shadow) > 1e-6);
    }

    void observingChangesNothing() {
        MediumSettings settings;
        settings.model = PropagationModel::LogDistance;
        settings.shadowing = 5;
        Medium looked(settings), quiet(settings);
        for (Medium* m : {&looked, &quiet}) open(*m, "a", {0, 0, 0}), open(*m, "b", {5, 0, 0});
        for (int step = 0; step <= 10; ++step) {
            for (Medium* m : {&looked, &quiet}) m->place(1, {{5 + step * .3, 0, 0}, Quat::Identity()});
            (void)looked.link(0, 1);
        }
        QCOMPARE(looked.link(0, 1).power, quiet.link(0, 1).power);
    }

    void radiosDifferByTheirOffsets() {
        MediumSettings settings;
        settings.offsets = 2;
        Medium medium(settings);
        double squares = 0;
        for (int i = 0; i < 400; ++i) open(medium, "mote" + std::to_string(i), {1. * i, 0, 0});
        for (RadioId i = 0; i + 1 < 400; ++i) squares += std::pow(medium.link(i, i + 1).power + 40.2311, 2);
        QVERIFY(std::abs(std::sqrt(squares / 399) - 2) < 0.25);
    }

    void omitsRadiosOutOfRange() {
        // distances below and above the range, with and without the grid that skips distant radios
        Medium medium({});
        const RadioId sender = open(medium, "sender", {0, 0, 0});
        for (int i = 0; i < 300; ++i) open(medium, "mote" + std::to_string(i), {(i % 20) * 60. - 500, (i / 20) * 70. - 400, 0});
        std::uint64_t reach = 0;
        for (RadioId i = 1; i < medium.radioCount(); ++i) reach += medium.link(sender, i).power >= -94;
        QVERIFY(send(medium, sender));
        medium.advance(10000);
        QVERIFY(reach > 50 && reach < 299);
        QCOMPARE(count(medium, ReceptionOutcome::Delivered), reach);
        QCOMPARE(count(medium, ReceptionOutcome::TooWeak), 300 - reach);
        QVERIFY(isConserved(medium));
    }
};

QTEST_APPLESS_MAIN(LinkTest)
#include "link_test.moc"
