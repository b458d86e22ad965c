// Fitting the sun's shadow map to a view.
#include <QtTest>

#include <numbers>
#include <random>
#include <set>

#include "scene/queries/sun_fit.h"

using namespace trundle;

namespace {

constexpr std::uint32_t kPixels = 1024;

Bounds boxAt(const Vec3& middle, double half) { return {middle - Vec3::Constant(half), middle + Vec3::Constant(half)}; }

CameraView lookingAt(const Vec3& eye, const Vec3& target) {
    CameraView view;
    view.eye = eye;
    view.target = target;
    return view;
}

/// Coordinates of a point in the shadow map: 0 to 1 along each side and in depth.
Vec3 onMap(const SunFit& fit, const Vec3& point) {
    const Vec3 p = fit.axes.transpose() * point;
    return {(p.x() - fit.origin.x()) / fit.width, (p.y() - fit.origin.y()) / fit.height, (fit.origin.z() - p.z()) / fit.depth};
}

} // namespace

class SunFitTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void mapCoversVisibleObjects() {
        std::mt19937 random(5);
        const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
        int checked = 0;
        for (int round = 0; round < 40; ++round) {
            const Vec3 sun = Vec3(any(-1, 1), any(-1, 1), any(0.3, 1)).normalized();
            std::vector<Bounds> boxes;
            for (int i = 0; i < 12; ++i) boxes.push_back(boxAt({any(-4, 4), any(-4, 4), any(0, 1)}, any(0.05, 0.4)));
            const CameraView view = lookingAt({any(-6, 6), any(-6, 6), any(0.3, 5)}, {any(-2, 2), any(-2, 2), 0});
            const std::optional<SunFit> fit = fitSun(sun, boxes, view, 400, 300, kPixels);
            if (!fit) continue;
            QVERIFY((fit->axes * fit->axes.transpose() - Mat3::Identity()).norm() < 1e-12);
            QVERIFY(fit->axes.determinant() > 0);
            for (const Bounds& box : boxes) {
                for (int i = 0; i < 8; ++i) {
                    const Vec3 corner = box.corner(i);
                    const auto at = project(view, 400, 300, corner);
                    if (!at || at->x < 0 || at->x > 400 || at->y < 0 || at->y > 300) continue;
                    const Vec3 where = onMap(*fit, corner);
                    for (int k = 0; k < 3; ++k) QVERIFY2(where[k] >= 0 && where[k] <= 1, qPrintable(QString::number(where[k])));
                    ++checked;
                }
            }
        }
        QVERIFY(checked > 500);
    }

    void includesShadowCastersOutsideView() {
        // High behind the camera, with its shadow in the middle of the image.
        const Vec3 sun = Vec3(0, -1, 1).normalized();
        const CameraView view = lookingAt({0, -1, 0.5}, {0, 0, 0});
        const auto fit = fitSun(sun, {boxAt({0, -3, 3}, 0.1), boxAt({0, 0, 0.1}, 0.1)}, view, 400, 300, kPixels);
        QVERIFY(fit);
        const Vec3 where = onMap(*fit, {0, -3, 3});
        QVERIFY(where.z() > 0 && where.z() < 1);
        QVERIFY(std::abs(onMap(*fit, {0, 0, 0}).x() - where.x()) < 1e-9); // on the same light ray
    }

    /// A mast behind the camera, alone: the map reaches as far as its shadow.
    void coversTheShadowOfWhatIsBehindTheCamera() {
        const Vec3 sun = Vec3(0, -2, 1).normalized();
        const CameraView view = lookingAt({0, -1, 0.5}, {0, 0.5, 0});
        const auto fit = fitSun(sun, {{Vec3(-0.1, -3.1, 0), Vec3(0.1, -2.9, 3)}}, view, 400, 300, kPixels);
        QVERIFY(fit);
        for (const double y : {0.0, 0.5, 1.5}) {
            const Vec3 ground(0, y, 0), where = onMap(*fit, ground);
            QVERIFY(project(view, 400, 300, ground)->y < 300);
            QVERIFY2(where.x() > 0 && where.x() < 1 && where.y() > 0 && where.y() < 1, qPrintable(QString::number(y)));
        }
    }

    void nearByItIsFiner() {
        std::vector<Bounds> boxes;
        for (int x = -20; x <= 20; ++x) boxes.push_back(boxAt({double(x), 0, 0.1}, 0.1));
        const Vec3 sun = Vec3(-0.5, -0.3, 0.8).normalized();
        const auto all = fitSun(sun, boxes, lookingAt({0, -40, 30}, Vec3::Zero()), 400, 300, kPixels);
        const auto one = fitSun(sun, boxes, lookingAt({0, -0.5, 0.8}, Vec3::Zero()), 400, 300, kPixels);
        QVERIFY(all && one);
        QVERIFY(one->texel(kPixels) < 0.2 * all->texel(kPixels));
    }

    void shadowMapIsStable() {
        const Vec3 sun = Vec3(-0.5, -0.3, 0.8).normalized();
        const std::vector<Bounds> boxes{boxAt({0, 0, 0.5}, 0.5), boxAt({2, 1, 0.5}, 0.5), boxAt({-30, 0, 5}, 5)};
        std::set<double> sizes;
        for (int i = 0; i < 50; ++i) {
            const auto fit = fitSun(sun, boxes, lookingAt({0.01 * i, -3, 2}, {0.01 * i, 0, 0}), 400, 300, kPixels);
            QVERIFY(fit);
            sizes.insert(fit->width);
            const double pixels = fit->origin.x() / (fit->width / kPixels);
            QVERIFY(std::abs(pixels - std::round(pixels)) < 1e-6);
        }
        QVERIFY(sizes.size() <= 3);
    }

    void whereNothingIsThereIsNoMap() {
        const CameraView view = lookingAt({0, -3, 2}, Vec3::Zero());
        QVERIFY(!fitSun(Vec3::UnitZ(), {}, view, 400, 300, kPixels));
        QVERIFY(!fitSun(Vec3::UnitZ(), {Bounds{}}, view, 400, 300, kPixels));
        QVERIFY(fitSun(Vec3::UnitZ(), {boxAt(Vec3::Zero(), 0)}, view, 400, 300, kPixels)); // a point still gets an area
    }

    /// Of a view in parallel projection, in a picture that is high.
    void mapCoversAHighPicture() {
        const Vec3 sun = Vec3(-0.5, -0.3, 0.8).normalized();
        std::vector<Bounds> boxes;
        for (int x = -3; x <= 3; ++x)
            for (int y = -3; y <= 3; ++y) boxes.push_back(boxAt({double(x), double(y), 0.2}, 0.2));
        for (const double width : {0., 2.5}) {
            CameraView view = lookingAt({0.3, -4, 5}, {0.3, 0, 0});
            view.orthographicWidth = width;
            const auto fit = fitSun(sun, boxes, view, 300, 900, kPixels);
            QVERIFY(fit);
            int checked = 0;
            for (const Bounds& box : boxes)
                for (int i = 0; i < 8; ++i) {
                    const auto at = project(view, 300, 900, box.corner(i));
                    if (!at || at->x < 0 || at->x > 300 || at->y < 0 || at->y > 900) continue;
                    const Vec3 where = onMap(*fit, box.corner(i));
                    QVERIFY(where.minCoeff() >= 0 && where.maxCoeff() <= 1);
                    ++checked;
                }
            QVERIFY(checked > 50);
        }
    }

    /// What casts no shadow into the picture changes nothing, on whichever side it is; what is seen in part is not drawn as a whole.
    void whatIsBesideThePictureDoesNotCount() {
        const Vec3 sun = Vec3(-0.2, -0.3, 0.9).normalized();
        const CameraView view = lookingAt({0, -2, 2}, Vec3::Zero());
        const Bounds near = boxAt({0, 0, 0.1}, 0.1);
        const auto one = fitSun(sun, {near}, view, 400, 300, kPixels);
        QVERIFY(one);
        for (const Vec3& at : {Vec3(60, 0, 0.2), Vec3(-60, 0, 0.2), Vec3(0, 90, 0.2), Vec3(0, -60, 0.2)}) {
            const auto both = fitSun(sun, {near, boxAt(at, 0.1)}, view, 400, 300, kPixels);
            QVERIFY(both);
            const double grown = at.y() > 0 ? 2 : 1.2; // far ahead it may be in the picture
            QVERIFY2(both->width < grown * one->width && both->height < 40 * one->height, qPrintable(QString::number(at.x())));
            if (at.y() <= 0) QVERIFY(std::abs(both->height - one->height) < 0.2 * one->height && both->depth < 2 * one->depth);
        }
        const CameraView down = lookingAt({0, 0, 3}, Vec3::Zero());
        const auto part = fitSun(sun, {{Vec3(-500, -500, 0), Vec3(500, 500, 0.01)}}, down, 400, 300, kPixels);
        QVERIFY(part && part->width < 10 && part->height < 10);
    }

    /// Nothing is cut off at either end of its depth.
    void theDepthHasAMargin() {
        const Vec3 sun = Vec3(0, 0, 1);
        const auto fit = fitSun(sun, {boxAt({0, 0, 1}, 1)}, lookingAt({0, -6, 4}, {0, 0, 1}), 400, 300, kPixels);
        QVERIFY(fit);
        QVERIFY(fit->origin.z() > 2.004 && fit->origin.z() - fit->depth < -0.004);
    }
};

QTEST_APPLESS_MAIN(SunFitTest)
#include "sun_fit_test.moc"
