#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

struct _cairo;  // NOLINT(clang-diagnostic-reserved-identifier): the library's own name of cairo_t

namespace terratact {

/// A place in a picture [px], y down.
struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// 0xRRGGBB, and how opaque.
struct Colour {
    unsigned rgb = 0;
    double alpha = 1.0;
};

struct Stroke {
    Colour colour;
    double width = 1.0;          ///< [px]
    std::vector<double> dashes;  ///< [px] on, off, …; empty: solid
};

enum class Align { Left, Centre, Right };

struct TextStyle {
    Colour colour;
    double size = 14.0;  ///< [px]
    bool bold = false;
    Align align = Align::Left;
};

enum class Shape { Circle, Square, Triangle, TriangleDown, Diamond };

/// What our figures are drawn with: lines, areas, markers and text on a white sheet.
class Canvas {
public:
    explicit Canvas(_cairo* context) : context_(context) {}

    void fillRectangle(Point topLeft, Point bottomRight, Colour fill);
    void line(Point from, Point to, const Stroke& stroke);
    void polyline(const std::vector<Point>& points, const Stroke& stroke);
    void polygon(const std::vector<Point>& points, Colour fill, const Stroke& stroke);
    /// Filled with `fill` under an outline; `size`: [px] across.
    void marker(Shape shape, Point centre, double size, Colour fill, const Stroke& outline);
    /// On its base line at `at`; turned by a quarter to read upwards where `upwards`.
    void text(Point at, std::string_view words, const TextStyle& style, bool upwards = false);
    double textWidth(std::string_view words, const TextStyle& style);
    /// The words, cut and ended with "…" where they would be wider than `width`.
    std::string fitted(std::string words, double width, const TextStyle& style);
    /// The words in lines that are no wider than `width`; a longer word is broken.
    std::vector<std::string> wrapped(std::string_view words, double width, const TextStyle& style);
    /// What `draw` draws, with its origin at `at` and `scale` times as large.
    void place(Point at, double scale, const std::function<void(Canvas&)>& draw);

private:
    void apply(Colour colour);
    void apply(const TextStyle& style);
    void stroke(const Stroke& stroke);
    void path(const std::vector<Point>& points);

    _cairo* context_;
};

/// "+0.1", "0.0", "−0.2": with its sign and a true minus.
std::string signedNumber(double value, int digits);

/// Draws a picture and puts it at `path`, PNG, SVG or PDF by the file's ending; width, height: [px], 150 of which
/// are an inch of a PDF.  Written to a temporary name, then renamed.  Errors name the file: another ending, or it
/// cannot be written.
Status writePicture(const std::string& path, int width, int height,
                    const std::function<void(Canvas&)>& draw);

/// The same picture as the text of an SVG file.
std::string svgText(int width, int height, const std::function<void(Canvas&)>& draw);

/// One entry of a figure's key: how to draw its sample at a place, and what it means.
struct KeyEntry {
    std::string words;
    std::function<void(Canvas&, Point)> sample;  ///< centred, at most 30 px wide
};

/// The entries in rows from `topLeft`, none beyond `right` [px], 24 px per row; returns the rows.
int drawKey(Canvas& canvas, Point topLeft, double right, const std::vector<KeyEntry>& entries);

}  // namespace terratact
