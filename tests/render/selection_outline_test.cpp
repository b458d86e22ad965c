// Lines around what is selected and what the pointer is on: where they are, how wide, and in which colour.
#include <QtTest>

#include "render/selection_outline.h"

using namespace trundle;

namespace {

constexpr std::uint32_t kWidth = 80, kHeight = 60;

/// A square of one channel: columns and rows 20 to 39.
std::vector<std::uint8_t> square(int channel) {
    std::vector<std::uint8_t> coverage(std::size_t(kWidth) * kHeight * 4, 0);
    for (std::uint32_t y = 20; y < 40; ++y)
        for (std::uint32_t x = 20; x < 40; ++x) coverage[(std::size_t(y) * kWidth + x) * 4 + std::size_t(channel)] = 255;
    return coverage;
}

Image black() { return {kWidth, kHeight, std::vector<std::uint8_t>(std::size_t(kWidth) * kHeight * 3, 0)}; }

/// Pixels of the line to the left, right, above and below of the square, as sums of their shares.
std::array<double, 4> widths(const Image& image) {
    const auto share = [&](std::uint32_t x, std::uint32_t y) { return image.at(x, y)[0] / 255.0; };
    std::array<double, 4> sums{};
    for (std::uint32_t i = 0; i < 20; ++i) {
        sums[0] += share(i, 30), sums[1] += share(40 + i, 30);
        sums[2] += share(30, i), sums[3] += share(30, 40 + i);
    }
    return sums;
}

} // namespace

class SelectionOutlineTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aLineIsAsWideAsItsStyleSays_data() {
        QTest::addColumn<int>("channel");
        QTest::addColumn<float>("width");
        QTest::addColumn<double>("expected"); // pixels from the middle of the object's last one
        for (const float width : {1.f, 2.f, 4.f, 7.5f}) {
            QTest::addRow("selected, %g", double(width)) << 0 << width << double(width);
            QTest::addRow("hovered, %g", double(width)) << 1 << width << 0.6 * double(width);
        }
        QTest::newRow("least") << 0 << 0.1f << 0.5;
        QTest::newRow("most") << 0 << 40.f << 16.;
    }
    void aLineIsAsWideAsItsStyleSays() {
        QFETCH(int, channel);
        QFETCH(float, width);
        QFETCH(double, expected);
        OutlineStyle style;
        style.width = width;
        Image image = black();
        drawOutlines(image, square(channel), style);
        for (const double sum : widths(image)) // half a pixel of it is on the object, where it is not drawn
            QVERIFY2(std::abs(sum + 0.5 - expected) < 0.02, qPrintable(QString::number(sum)));
        for (std::uint32_t y = 20; y < 40; ++y)
            for (std::uint32_t x = 20; x < 40; ++x) QVERIFY(image.at(x, y)[0] == 0); // nothing on the object itself
    }

    void eachHasItsColourAndTheSelectedOneIsInFront() {
        OutlineStyle style;
        style.selected = {200, 100, 50};
        style.hovered = {10, 220, 30};
        style.width = 4;
        const auto at = [](const Image& image) {
            const std::uint8_t* p = image.at(19, 30);
            return std::array<int, 3>{p[0], p[1], p[2]};
        };
        std::vector<std::uint8_t> both = square(0);
        for (std::size_t i = 0; i < both.size(); i += 4) both[i + 1] = both[i];
        Image selected = black(), hovered = black(), image = black();
        drawOutlines(selected, square(0), style);
        drawOutlines(hovered, square(1), style);
        drawOutlines(image, both, style);
        QCOMPARE(at(selected), (std::array<int, 3>{200, 100, 50}));
        QCOMPARE(at(hovered), (std::array<int, 3>{10, 220, 30}));
        QCOMPARE(at(image), at(selected));
    }

    void aCoverageOfAnotherSizeDrawsNothing() {
        std::vector<std::uint8_t> coverage = square(0);
        coverage.pop_back();
        Image image = black();
        drawOutlines(image, coverage, {});
        QVERIFY(image == black());
    }

    /// At the rims of the image there is no line along them.
    void whatIsCutOffHasNoLineThere() {
        std::vector<std::uint8_t> coverage(std::size_t(kWidth) * kHeight * 4, 0);
        for (std::size_t i = 0; i < coverage.size(); i += 4) coverage[i] = 255;
        Image image = black();
        drawOutlines(image, coverage, {});
        QVERIFY(image == black());
    }
};

QTEST_APPLESS_MAIN(SelectionOutlineTest)
#include "selection_outline_test.moc"
