#pragma once

#include <qwt_plot.h>

#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate.h"
#include "core/terrain/outline.h"

class QwtPlotCurve;
class QwtPlotIntervalCurve;
class QwtPlotMarker;
class QwtPlotShapeItem;
class QwtPlotTextLabel;

namespace terratact {

class BinZones;
class ProbeMark;

/// Draws one TerrainEstimate under the robot: mean line, bars from the 0.1 to the 0.9 quantile, ceilings,
/// the robot's side view with the IMU at the origin.  Bins are told apart by shape and colour:
/// contact = square, arm = triangle, sampled = circle, prior only = open diamond in an amber zone.
/// One metre is as long upwards as forwards, whatever the size, so a step looks as steep as it is.
/// What is not finite, or beyond 100 m, is left out.  GUI thread only.
class TerrainProfileView final : public QwtPlot {
    Q_OBJECT
public:
    explicit TerrainProfileView(QWidget* parent = nullptr);

    /// note: written above the profile, what the reader must know before it; empty: nothing.
    void setEstimate(const TerrainEstimate& estimate, const QString& note = {});
    void clearEstimate(const QString& why);  ///< says why there is none; not a flat line
    void setOutline(const Outline& outline);
    void setTruth(const std::optional<Heights>& truth);
    void setProposedProbe(std::optional<int> bin);

    /// Canvas position of a point of the DEM frame [m].
    QPointF pixelOf(double x, double z) const;
    /// DEM frame point [m] under a canvas position.
    QPointF pointAt(QPointF pixel) const;
    /// One bin in words: "bin 0.4 m: +0.07 m, 80 % in +0.05 … +0.09, contact".
    QString binText(int bin) const;

    void updateLayout() override;
    QSize sizeHint() const override { return {760, 420}; }
    QSize minimumSizeHint() const override { return {420, 260}; }

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    enum Kind : std::size_t { Sampled, PriorOnly, Contact, Arm, kKinds };

    static Kind kindOf(const TerrainEstimate& estimate, int bin);
    void showEstimate();
    void showNote(const QString& note, const QColor& colour);
    void showTruth();
    void showProbe();
    void fitAxes();
    bool setScales();  ///< true when they had to change
    void describe();

    std::optional<TerrainEstimate> estimate_;
    std::optional<Heights> truth_;
    Outline outline_;
    std::optional<int> probe_;
    std::array<double, 4>
        fitted_{};  ///< bottom, top [m], width, height [px] the scales were made for

    // The plot owns its items once they are attached.
    std::array<QwtPlotCurve*, kKinds> points_{};
    std::array<QwtPlotIntervalCurve*, kKinds> bars_{};
    QwtPlotShapeItem* mean_ = nullptr;
    QwtPlotShapeItem* meanPrior_ = nullptr;
    QwtPlotShapeItem* ceilings_ = nullptr;
    QwtPlotShapeItem* truthLine_ = nullptr;
    std::vector<QwtPlotShapeItem*> robot_;
    BinZones* zones_ = nullptr;
    ProbeMark* probeMark_ = nullptr;
    QwtPlotTextLabel* note_ = nullptr;
};

}  // namespace terratact
