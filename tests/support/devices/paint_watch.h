#pragma once

#include <QImage>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace terratact::gui {

/// Draws nothing and counts requests with coordinates that are not finite or farther away than any picture is wide.
class PaintWatch final : public QPaintDevice {
public:
    static constexpr double kFar = 1e6;  ///< [px]

    explicit PaintWatch(QSize size) : size_(size) {}
    int hostile() const { return engine_.hostile; }
    QPaintEngine* paintEngine() const override { return &engine_; }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        constexpr int kDpi = 96;
        switch (metric) {
        case PdmWidth: return size_.width();
        case PdmHeight: return size_.height();
        case PdmWidthMM: return size_.width() * 254 / (10 * kDpi);
        case PdmHeightMM: return size_.height() * 254 / (10 * kDpi);
        case PdmDepth: return 32;
        case PdmDevicePixelRatio: return 1;
        case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return kDpi;
        default: return QPaintDevice::metric(metric);
        }
    }

private:
    struct Engine final : QPaintEngine {
        Engine() : QPaintEngine(AllFeatures) {}
        bool begin(QPaintDevice* /*device*/) override { return true; }
        bool end() override { return true; }
        Type type() const override { return User; }
        void updateState(const QPaintEngineState& /*state*/) override {}

        using QPaintEngine::drawEllipse;
        using QPaintEngine::drawLines;
        using QPaintEngine::drawPoints;
        using QPaintEngine::drawPolygon;
        using QPaintEngine::drawRects;
        void drawRects(const QRectF* rects, int count) override
        {
            std::for_each_n(rects, count, [this](const QRectF& rect) { poll(rect); });
        }
        void drawEllipse(const QRectF& rect) override { poll(rect); }
        void drawLines(const QLineF* lines, int count) override
        {
            std::for_each_n(lines, count, [this](const QLineF& line) {
                poll(line.p1());
                poll(line.p2());
            });
        }
        void drawPoints(const QPointF* points, int count) override { poll(points, count); }
        void drawPolygon(const QPointF* points, int count, PolygonDrawMode /*mode*/) override
        {
            poll(points, count);
        }
        void drawPath(const QPainterPath& path) override
        {
            for (int i = 0; i < path.elementCount(); ++i) poll(path.elementAt(i));
        }
        void drawPixmap(const QRectF& to, const QPixmap& /*map*/, const QRectF& /*from*/) override
        {
            poll(to);
        }
        void drawTiledPixmap(const QRectF& to, const QPixmap& /*map*/, const QPointF& from) override
        {
            poll(to);
            poll(from);
        }
        void drawImage(const QRectF& to, const QImage& /*image*/, const QRectF& /*from*/,
                       Qt::ImageConversionFlags /*flags*/) override
        {
            poll(to);
        }
        void drawTextItem(const QPointF& at, const QTextItem& /*item*/) override { poll(at); }

        void poll(const QPointF* points, int count)
        {
            std::for_each_n(points, count, [this](const QPointF& point) { poll(point); });
        }
        void poll(const QRectF& rect)
        {
            poll(rect.topLeft());
            poll(rect.bottomRight());
        }
        void poll(const QPointF& logical)
        {
            const QPointF point = state->transform().map(logical);
            const bool near = std::abs(point.x()) <= kFar && std::abs(point.y()) <= kFar;
            hostile += near ? 0 : 1;  // NaN counts as far
        }
        int hostile = 0;
    };

    QSize size_;
    mutable Engine engine_;
};

}  // namespace terratact::gui
