// Noise and lens distortion of camera images, without drawing one.
#include <set>

#include <QtTest>

#include "render/sensor_model.h"

using namespace trundle;

namespace {

constexpr std::uint32_t kWidth = 60, kHeight = 40;
constexpr std::size_t kPixels = std::size_t(kWidth) * kHeight;

CameraModel camera(CameraMode mode, double noise) {
    CameraModel camera;
    camera.path = "robot/eye";
    camera.width = kWidth;
    camera.height = kHeight;
    camera.mode = mode;
    camera.noise = noise;
    return camera;
}

CameraImage grey(std::uint8_t value) {
    CameraImage image;
    image.pixels.assign(kPixels * 3, value);
    return image;
}

} // namespace

class SensorModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Each pixel has an error of its own, proportional to its depth; what nothing was seen of stays infinite.
    void depthNoiseIsOfEachPixel() {
        const CameraModel model = camera(CameraMode::Depth, 0.1);
        for (const float depth : {0.5f, 3.0f}) {
            CameraImage image = grey(0);
            image.depth.assign(kPixels, depth);
            image.depth[7] = std::numeric_limits<float>::infinity();
            addNoise(model, 1, image);
            QVERIFY(std::isinf(image.depth[7]));
            std::set<float> values(image.depth.begin(), image.depth.end());
            QVERIFY(values.size() > kPixels - 20); // hardly any two are equal
            double sum = 0, squares = 0;
            for (std::size_t i = 8; i < kPixels; ++i) {
                const double error = (image.depth[i] - depth) / depth;
                sum += error, squares += error * error;
            }
            const double count = double(kPixels) - 8;
            QVERIFY(std::abs(sum / count) < 0.01);
            QVERIFY(std::abs(std::sqrt(squares / count) / 0.1 - 1) < 0.05);
        }
    }

    void greyNoiseIsTheSameInAllColours() {
        CameraImage image = grey(128), coloured = grey(128);
        addNoise(camera(CameraMode::Grey, 0.1), 1, image);
        addNoise(camera(CameraMode::Colour, 0.1), 1, coloured);
        std::set<std::uint8_t> values;
        std::size_t unequal = 0;
        for (std::size_t i = 0; i < kPixels; ++i) {
            QCOMPARE(image.pixels[3 * i], image.pixels[3 * i + 1]);
            QCOMPARE(image.pixels[3 * i], image.pixels[3 * i + 2]);
            values.insert(image.pixels[3 * i]);
            unequal += coloured.pixels[3 * i] != coloured.pixels[3 * i + 1];
        }
        QVERIFY(values.size() > 60);
        QVERIFY(unequal > kPixels / 2);
    }

    /// Where no ray of the lens arrives there is no depth, no object and no light.
    void whatTheLensDoesNotShowIsEmpty() {
        LensMap lens;
        lens.width = lens.height = 4;
        lens.sources.assign(kPixels, LensMap::Source{1.5f, 2.5f});
        lens.sources[7] = {-1, -1};
        DataImage data{4, 4, std::vector<float>(16, 3), std::vector<std::uint32_t>(16, 5)};
        data.depth[2 * 4 + 1] = 2;
        for (const CameraMode mode : {CameraMode::Depth, CameraMode::Segmentation}) {
            const CameraImage image = applySensorModel(camera(mode, 0), lens, data);
            QVERIFY(std::isinf(image.depth[7]) && image.depth[8] == 2);
            QVERIFY(image.pixels[3 * 7] == 0 && image.pixels[3 * 8] > 0);
            if (mode == CameraMode::Segmentation) QVERIFY(image.objects[7] == 0 && image.objects[8] == 5);
        }
        const Image drawn{4, 4, std::vector<std::uint8_t>(48, 200)};
        const CameraImage image = applySensorModel(camera(CameraMode::Colour, 0), lens, drawn);
        QVERIFY(image.pixels[3 * 7] == 0 && image.pixels[3 * 8] == 200);
    }

    /// Between four pixels: more of those that are nearer, across and down.
    void aLensMixesNeighbours() {
        Image drawn{2, 2, std::vector<std::uint8_t>(12, 0)};
        drawn.pixels[3] = 100;     // right above
        drawn.pixels[3 * 2] = 200; // left below
        LensMap lens;
        lens.width = lens.height = 2;
        lens.sources.assign(kPixels, LensMap::Source{0.75f, 1.25f}); // a quarter to the right, three quarters down
        const CameraImage image = applySensorModel(camera(CameraMode::Colour, 0), lens, drawn);
        QCOMPARE(int(image.pixels[0]), int(std::lround(0.25 * 0.25 * 100 + 0.75 * 0.75 * 200)));
        QCOMPARE(int(image.pixels[1]), 0);
    }

    /// Another camera, seed or image has other errors; the same has the same.
    void noiseIsOfOneCameraSeedAndImage() {
        const auto noisy = [](CameraMode mode, const char* path, std::uint64_t seed, std::uint64_t tick) {
            CameraModel model = camera(mode, 0.1);
            model.path = path;
            CameraImage image = grey(128);
            image.depth.assign(kPixels, 2);
            image.tick = tick;
            addNoise(model, seed, image);
            return image.pixels;
        };
        for (const CameraMode mode : {CameraMode::Colour, CameraMode::Grey, CameraMode::Depth}) {
            const auto one = noisy(mode, "robot1/eye", 1, 5);
            QVERIFY(one == noisy(mode, "robot1/eye", 1, 5));
            for (const auto& other : {noisy(mode, "robot10/eye", 1, 5), noisy(mode, "robot1/eye2", 1, 5),
                                      noisy(mode, "robot1/eye", 2, 5), noisy(mode, "robot1/eye", 1, 6)}) {
                std::size_t equal = 0;
                for (std::size_t i = 0; i < one.size(); ++i) equal += one[i] == other[i];
                QVERIFY2(equal < one.size() / 10, qPrintable(QString::number(equal)));
            }
        }
    }

    /// Each row: the distance of the first fold and how far from the centre it is shown. No ray arrives farther out, and none of the
    /// rays beyond is used although they would be shown inside.
    void aLensThatFoldsBackShowsItsInnerPart_data() {
        QTest::addColumn<double>("k1");
        QTest::addColumn<double>("k2");
        QTest::addColumn<double>("fold");
        QTest::newRow("folds once") << -0.5 << 0. << std::sqrt(2. / 3);
        QTest::newRow("folds and grows again") << -0.5 << 0.08 << std::sqrt((1.5 - std::sqrt(0.65)) / 0.8);
        QTest::newRow("grows again at once") << -0.9 << 0.36 << std::sqrt((2.7 - std::sqrt(0.09)) / 3.6);
        QTest::newRow("grows before it folds") << 0.4 << -0.5 << std::sqrt((1.2 + std::sqrt(11.44)) / 5);
        QTest::newRow("strong barrel") << -1. << 0.1 << std::sqrt(3 - std::sqrt(7.));
    }
    void aLensThatFoldsBackShowsItsInnerPart() {
        QFETCH(double, k1);
        QFETCH(double, k2);
        QFETCH(double, fold);
        const auto bent = [&](double r) { return r * (1 + k1 * r * r + k2 * r * r * r * r); };
        CameraModel model = camera(CameraMode::Colour, 0);
        model.fieldOfView = 2 * std::atan(1.6 * bent(fold)); // well beyond the fold at the sides
        model.k1 = k1;
        model.k2 = k2;
        const std::optional<LensMap> lens = lensMapOf(model);
        QVERIFY(lens);
        const double drawnFocal = 0.5 * lens->width / std::tan(0.5 * lens->fieldOfView),
                     focal = 0.5 * kWidth / (1.6 * bent(fold));
        int inner = 0, dark = 0;
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                const LensMap::Source& source = lens->sources[std::size_t(y) * kWidth + x];
                const double shown = std::hypot(x + 0.5 - 0.5 * kWidth, y + 0.5 - 0.5 * kHeight) / focal;
                QCOMPARE(source.x<0, shown> bent(fold));
                if (source.x < 0) {
                    ++dark;
                    continue;
                }
                const double r = std::hypot(source.x - 0.5 * lens->width, source.y - 0.5 * lens->height) / drawnFocal;
                QVERIFY2(r < fold + 1e-4, qPrintable(QString::number(r)));
                QVERIFY(std::abs(bent(r) - shown) < 1e-4);
                ++inner;
            }
        QVERIFY(inner > 500 && dark > 500);
    }
};

QTEST_APPLESS_MAIN(SensorModelTest)
#include "sensor_model_test.moc"
