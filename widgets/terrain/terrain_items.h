#pragma once

#include <qwt_legend.h>
#include <qwt_plot_item.h>
#include <qwt_plot_shapeitem.h>
#include <qwt_plot_textlabel.h>
#include <qwt_text.h>

#include <QFont>
#include <array>
#include <optional>
#include <vector>

#include "core/infer/estimate/touch.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

/// Returns the font at a size [px at 100 %].
QFont sized(QFont font, int pixels, bool bold = false);

/// Returns styled text for a plot.
QwtText inked(const QString& words, const QColor& colour, const QFont& font);

/// Sets a text at the top of the canvas; an empty one hides the label.
void setLabel(QwtPlotTextLabel& label, QwtText words);

/// A line in metres; the legend shows a sample.
class LineItem final : public QwtPlotShapeItem {
public:
    using QwtPlotShapeItem::QwtPlotShapeItem;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// The legend. It hides in a low view, or where it would take much of the terrain's room.
class Key final : public QwtLegend {
public:
    explicit Key(const QWidget& view) : view_(view) {}
    bool isEmpty() const override;

private:
    const QWidget& view_;
};

/// A text at the upper edge of the plot, wrapped to as many lines as it needs.
class Note final : public QwtPlotTextLabel {
    QRectF textRect(const QRectF& plot, const QSizeF& oneLine) const override;
};

/// The legend entry of the bars; it draws nothing in the plot.
class BandKey final : public QwtPlotItem {
public:
    BandKey();
    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
    QwtGraphic legendIcon(int index, const QSizeF& size) const override;
};

/// Lines between the bins; at the bins' centres they would hide the bars.
class BinBorders final : public QwtPlotItem {
public:
    BinBorders();
    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;
};

/// Hatched zones of bins that are not felt, each run with its word, and the felt horizon as a line.
/// Where two sides are shown, a zone of one side alone is paler. Its word begins with the side's
/// letter.
class BinZones final : public QwtPlotItem {
public:
    /// What this pose does not feel of one side.
    struct Unfelt {
        std::array<bool, kBins> shown{};
        TouchMap touch = unrecordedTouch();
        std::optional<double> horizon{};  ///< [m]; empty: nothing ahead is felt, or not recorded
        QString letter{};                 ///< of the side; empty: one plane
        bool operator==(const Unfelt&) const = default;
    };
    BinZones();
    Unfelt full;                   ///< of the side that is drawn in full
    std::optional<Unfelt> light;   ///< of the side that is drawn lighter
    std::optional<QPointF> arm{};  ///< [m] the arm's tip, whose mark no word covers
    bool isShown() const;
    /// Returns the rectangles of the words in the last drawing [px].
    const std::vector<QRectF>& words() const { return words_; }
    void drawWords(QPainter& painter, const QwtScaleMap& x, const QwtScaleMap& y,
                   const QRectF& canvas) const;

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    /// Touch of a bin that this pose does not feel, per side; empty: it is felt, or the side is not shown.
    struct Kind {
        std::optional<Touch> full, light;
        bool operator==(const Kind&) const = default;
        explicit operator bool() const { return full || light; }
        Touch shown() const { return full ? *full : *light; }
    };
    Kind kindOf(std::size_t bin) const;
    QString wordOf(const Kind& kind) const;
    /// A run of bins of one kind.
    struct Zone {
        Kind kind;
        QRectF place;  ///< [px]
    };
    std::vector<Zone> zonesOn(const QwtScaleMap& x, const QRectF& canvas) const;
    void drawZone(QPainter& painter, const Zone& zone) const;
    void drawWord(QPainter& painter, const Zone& zone, const QRectF& canvas) const;
    void drawHorizons(QPainter& painter, const QwtScaleMap& x, const QRectF& canvas) const;
    const Unfelt& nearest() const;  ///< side with the nearer horizon
    void drawHorizonWord(QPainter& painter, const Unfelt& side, const QString& letter, double px,
                         const QRectF& canvas) const;
    QRectF free(QRectF place, const QRectF& canvas) const;

    mutable std::vector<QRectF> words_;
    mutable QRectF imu_;  ///< the IMU's mark and word, which no word covers
    mutable QRectF arm_;  ///< the arm's tip
};

/// The words of the zones, above the robot. The zones must outlive it.
class ZoneWords final : public QwtPlotItem {
public:
    explicit ZoneWords(const BinZones& zones);
    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    const BinZones& zones_;
};

/// Returns the area [px] of the mark of the arm's tip at a point [m].
QRectF armTipArea(const QPointF& at, const QwtScaleMap& x, const QwtScaleMap& y,
                  const QRectF& canvas);

/// The arm's last link, upright, with its tip on the bin. It is dashed and open until a probe is approved. Its word
/// avoids the words of the zones, which are drawn before it and must outlive it.
class ArmMark final : public QwtPlotItem {
public:
    explicit ArmMark(const BinZones& zones);
    /// Returns the rectangle of its word in the last drawing [px].
    const QRectF& word() const { return word_; }
    const QRectF& tip() const { return tip_; }  ///< area of its tip in the last drawing [px]
    ArmTip::State state = ArmTip::State::Proposed;
    double at = 0.0, down = 0.0;  ///< [m]
    QString letter;               ///< of the side that it touches; empty: the middle

    void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y,
              const QRectF& canvas) const override;

private:
    QRectF placeOfWord(const QRectF& above, double px, double tip, const QRectF& canvas) const;
    double beginOfLine(double px, double top) const;
    QString words() const;

    const BinZones& zones_;
    mutable QRectF word_, tip_;
};

}  // namespace terratact
