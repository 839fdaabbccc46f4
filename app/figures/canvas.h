#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/store/file_group.h"

struct _cairo;  // NOLINT(clang-diagnostic-reserved-identifier): the library's own name of cairo_t

namespace terratact {

/// A position in a picture [px], y down.
struct Point {
    double x = 0.0;
    double y = 0.0;
};

/// Colour 0xRRGGBB with opacity.
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

/// Draws lines, areas, markers and text on a white sheet.
class Canvas {
public:
    explicit Canvas(_cairo* context) : context_(context) {}

    void fillRectangle(Point topLeft, Point bottomRight, Colour fill);
    void line(Point from, Point to, const Stroke& stroke);
    void polyline(const std::vector<Point>& points, const Stroke& stroke);
    void polygon(const std::vector<Point>& points, Colour fill, const Stroke& stroke);
    /// Draws a marker filled with `fill` and outlined; `size`: width [px]. `upper`: another fill of the upper half.
    void marker(Shape shape, Point centre, double size, Colour fill, const Stroke& outline,
                std::optional<Colour> upper = {});
    /// Draws text with its base line at `at`; `upwards` turns it by 90° to read upwards.
    void text(Point at, std::string_view words, const TextStyle& style, bool upwards = false);
    double textWidth(std::string_view words, const TextStyle& style);
    /// Returns the text, elided with "…" if it is wider than `width`.
    std::string fitted(std::string words, double width, const TextStyle& style);
    /// Breaks the text into lines no wider than `width`; a longer word is broken.
    std::vector<std::string> wrapped(std::string_view words, double width, const TextStyle& style);
    /// Runs `draw` with its origin at `at` and scaled by `scale`.
    void place(Point at, double scale, const std::function<void(Canvas&)>& draw);

private:
    void apply(Colour colour);
    void apply(const TextStyle& style);
    void stroke(const Stroke& stroke);
    void path(const std::vector<Point>& points);

    _cairo* context_;
};

/// Returns "+0.1", "0.0", "−0.2" with sign and U+2212.
std::string signedNumber(double value, int digits);

/// Texts that an SVG file holds beside its drawing, as plain text. Empty: it holds none.
struct PictureText {
    std::string title;        ///< <title>
    std::string description;  ///< <desc>: what it shows, for those who cannot see it
    std::string data;         ///< <metadata>: the numbers of the picture
};

/// Draws a picture and writes it to `path` as PNG, SVG or PDF by the file ending. The file is written under a temporary
/// name and renamed. width, height: [px]; a PDF has 150 px per inch. write: writes the file instead. Errors name the
/// file: the ending is unknown, or the file is not writable.
Status writePicture(const std::string& path, int width, int height,
                    const std::function<void(Canvas&)>& draw, const PictureText& text = {},
                    const FileWriter& write = {});

/// Draws one page, or a part of it.
using PageDrawing = std::function<void(Canvas&)>;

/// Writes pages of one size as PDF. width, height: [px] at 150 px per inch. layout: gets a canvas that measures texts
/// and returns the pages. The file names no time, so the same pages and fonts give the same bytes. It is written under
/// a temporary name and renamed. Errors name the file.
Status writePages(const std::string& path, int width, int height, const std::string& title,
                  const std::function<std::vector<PageDrawing>(Canvas& measuring)>& layout);

/// Returns the picture as the text of an SVG file.
std::string svgText(int width, int height, const std::function<void(Canvas&)>& draw);

/// A legend entry: its text and the drawing of its sample.
struct KeyEntry {
    std::string words;
    std::function<void(Canvas&, Point)> sample;  ///< centred, at most 30 px wide
};

/// Draws the entries in rows of 24 px from `topLeft`, none beyond `right` [px]. Returns the number of rows.
int drawKey(Canvas& canvas, Point topLeft, double right, const std::vector<KeyEntry>& entries);

}  // namespace terratact
