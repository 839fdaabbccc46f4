#include "app/figures/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "app/figures/html_text.h"
#include "core/base/text.h"
#include "core/store/file_write.h"

#ifdef __has_feature  // clang
#if __has_feature(address_sanitizer)
/// Suppression hook of LeakSanitizer: fontconfig keeps its configuration and patterns until the process ends.
extern "C" const char*
__lsan_default_suppressions()  // NOLINT(clang-diagnostic-reserved-identifier)
{
    return "leak:libfontconfig\n";
}

/// Options of LeakSanitizer: it must not count the suppressed leaks among the output of a command.
extern "C" const char* __lsan_default_options()  // NOLINT(clang-diagnostic-reserved-identifier)
{
    return "print_suppressions=0";
}
#endif
#endif

namespace terratact {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* content, const unsigned char* data, unsigned length)
{
    static_cast<std::string*>(content)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void paint(cairo_surface_t* surface, const std::function<void(Canvas&)>& draw)
{
    const Context context(cairo_create(surface), cairo_destroy);
    cairo_set_source_rgb(context.get(), 1.0, 1.0, 1.0);
    cairo_paint(context.get());
    Canvas canvas(context.get());
    draw(canvas);
}

cairo_status_t renderPng(std::string& bytes, int width, int height,
                         const std::function<void(Canvas&)>& draw)
{
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height),
                          cairo_surface_destroy);
    paint(surface.get(), draw);
    return cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
}

cairo_status_t renderSvg(std::string& bytes, int width, int height,
                         const std::function<void(Canvas&)>& draw)
{
    const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width, height),
                          cairo_surface_destroy);
    paint(surface.get(), draw);
    cairo_surface_finish(surface.get());
    return cairo_surface_status(surface.get());
}

/// Puts the texts behind the root element's tag.
void addTexts(std::string& svg, const PictureText& text)
{
    std::string elements;
    if (!text.title.empty()) elements += "<title>" + htmlText(text.title) + "</title>\n";
    if (!text.description.empty()) elements += "<desc>" + htmlText(text.description) + "</desc>\n";
    if (!text.data.empty()) {
        elements += "<metadata>\n";
        std::istringstream lines(text.data);
        for (std::string line; std::getline(lines, line);) elements += htmlText(line) + '\n';
        elements += "</metadata>\n";
    }
    const std::size_t root = svg.find("<svg");
    const std::size_t end = root == std::string::npos ? root : svg.find('>', root);
    if (end != std::string::npos) svg.insert(end + 1, '\n' + elements);
}

constexpr double kPoint = 72.0 / 150.0;  // points per pixel

/// Returns a surface of PDF without the time of its creation, which would make equal files differ.
Surface pdfSurface(std::string& bytes, int width, int height)
{
    Surface surface(
        cairo_pdf_surface_create_for_stream(append, &bytes, kPoint * width, kPoint * height),
        cairo_surface_destroy);
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    return surface;
}

cairo_status_t renderPdf(std::string& bytes, int width, int height,
                         const std::function<void(Canvas&)>& draw)
{
    const Surface surface = pdfSurface(bytes, width, height);
    paint(surface.get(), [&](Canvas& canvas) { canvas.place({}, kPoint, draw); });
    cairo_surface_finish(surface.get());
    return cairo_surface_status(surface.get());
}

/// Returns false if no font is installed. Cairo then draws with its built-in font, which lacks the minus sign.
bool fontExists()
{
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
    const Context context(cairo_create(surface.get()), cairo_destroy);
    cairo_select_font_face(context.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    return cairo_scaled_font_get_type(cairo_get_scaled_font(context.get())) != CAIRO_FONT_TYPE_USER;
}

/// Writes what `render` appends to the bytes. Errors name the file.
Status writeDrawn(const std::string& path,
                  const std::function<cairo_status_t(std::string& bytes)>& render,
                  const FileWriter& write = {})
{
    if (!fontExists())
        return Error{path
                     + ": cannot be drawn: no font is installed, so no text could be read; "
                       "install one, such as fonts-dejavu-core"};
    std::string bytes;
    const cairo_status_t status = render(bytes);
    if (status != CAIRO_STATUS_SUCCESS)
        return Error{path + ": cannot be drawn: " + cairo_status_to_string(status)};
    return write ? write(path, bytes) : writeFileAtomically(path, bytes);
}

/// Removes the last character of a UTF-8 text.
void dropLast(std::string& text)
{
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80U)
        text.pop_back();
    if (!text.empty()) text.pop_back();
}

}  // namespace

void Canvas::apply(Colour colour)
{
    const auto part = [&](unsigned shift) { return ((colour.rgb >> shift) & 0xffU) / 255.0; };
    cairo_set_source_rgba(context_, part(16), part(8), part(0), colour.alpha);
}

void Canvas::apply(const TextStyle& style)
{
    cairo_select_font_face(context_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context_, style.size);
    apply(style.colour);
}

void Canvas::stroke(const Stroke& stroke)
{
    apply(stroke.colour);
    cairo_set_line_width(context_, stroke.width);
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(context_, stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0.0);
    cairo_stroke(context_);
}

void Canvas::path(const std::vector<Point>& points)
{
    cairo_new_path(context_);
    for (const Point& p : points) cairo_line_to(context_, p.x, p.y);
}

void Canvas::fillRectangle(Point topLeft, Point bottomRight, Colour fill)
{
    apply(fill);
    cairo_rectangle(context_, topLeft.x, topLeft.y, bottomRight.x - topLeft.x,
                    bottomRight.y - topLeft.y);
    cairo_fill(context_);
}

void Canvas::line(Point from, Point to, const Stroke& how)
{
    polyline({from, to}, how);
}

void Canvas::polyline(const std::vector<Point>& points, const Stroke& how)
{
    path(points);
    stroke(how);
}

void Canvas::polygon(const std::vector<Point>& points, Colour fill, const Stroke& outline)
{
    path(points);
    cairo_close_path(context_);
    apply(fill);
    cairo_fill_preserve(context_);
    stroke(outline);
}

void Canvas::marker(Shape shape, Point c, double size, Colour fill, const Stroke& outline,
                    std::optional<Colour> upper)
{
    const double r = 0.5 * size;
    switch (shape) {
    case Shape::Circle:
        cairo_new_path(context_);
        cairo_arc(context_, c.x, c.y, r, 0.0, 2.0 * std::numbers::pi);
        break;
    case Shape::Square:
        path({{c.x - r, c.y - r}, {c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}});
        break;
    case Shape::Triangle:
        path({{c.x, c.y - r}, {c.x + r, c.y + 0.8 * r}, {c.x - r, c.y + 0.8 * r}});
        break;
    case Shape::TriangleDown:
        path({{c.x, c.y + r}, {c.x + r, c.y - 0.8 * r}, {c.x - r, c.y - 0.8 * r}});
        break;
    case Shape::Diamond:
        path({{c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}});
        break;
    }
    cairo_close_path(context_);
    apply(fill);
    cairo_fill_preserve(context_);
    if (upper) {
        cairo_save(context_);
        const std::unique_ptr<cairo_path_t, decltype(&cairo_path_destroy)> whole(
            cairo_copy_path(context_), cairo_path_destroy);
        cairo_clip(context_);
        cairo_rectangle(context_, c.x - r, c.y - r, 2.0 * r, r);
        apply(*upper);
        cairo_fill(context_);
        cairo_restore(context_);
        cairo_append_path(context_, whole.get());
    }
    stroke(outline);
}

void Canvas::text(Point at, std::string_view words, const TextStyle& style, bool upwards)
{
    const double width = textWidth(words, style);
    const double back = style.align == Align::Left   ? 0.0
                      : style.align == Align::Centre ? 0.5 * width
                                                     : width;
    cairo_save(context_);
    cairo_translate(context_, at.x, at.y);
    if (upwards) cairo_rotate(context_, -0.5 * std::numbers::pi);
    cairo_move_to(context_, -back, 0.0);
    cairo_show_text(context_, std::string(words).c_str());
    cairo_restore(context_);
}

double Canvas::textWidth(std::string_view words, const TextStyle& style)
{
    apply(style);
    cairo_text_extents_t extents;
    cairo_text_extents(context_, std::string(words).c_str(), &extents);
    return extents.x_advance;
}

std::string Canvas::fitted(std::string words, double width, const TextStyle& style)
{
    if (textWidth(words, style) <= width) return words;
    while (!words.empty() && textWidth(words + "…", style) > width) dropLast(words);
    return words + "…";
}

std::vector<std::string> Canvas::wrapped(std::string_view words, double width,
                                         const TextStyle& style)
{
    std::vector<std::string> lines;
    std::string line;
    const auto fits = [&](const std::string& text) { return textWidth(text, style) <= width; };
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(' '), words.size());
        std::string word(words.substr(0, end));
        words.remove_prefix(std::min(end + 1, words.size()));
        if (const std::string longer = fmt::format("{} {}", line, word);
            !line.empty() && fits(longer)) {
            line = longer;
            continue;
        }
        if (!line.empty()) lines.push_back(line);
        line = word;
        while (!fits(line)) {
            std::string head = line;
            while (!head.empty() && !fits(head)) dropLast(head);
            if (head.empty()) break;  // not even one letter fits
            line.erase(0, head.size());
            lines.push_back(std::move(head));
        }
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

void Canvas::place(Point at, double scale, const std::function<void(Canvas&)>& draw)
{
    cairo_save(context_);
    cairo_translate(context_, at.x, at.y);
    cairo_scale(context_, scale, scale);
    draw(*this);
    cairo_restore(context_);
}

std::string signedNumber(double value, int digits)
{
    const std::string text = fmt::format("{:+.{}f}", value, digits);
    if (text.find_first_of("123456789") == std::string::npos) return text.substr(1);
    return text[0] == '-' ? "−" + text.substr(1) : text;
}

Status writePicture(const std::string& path, int width, int height,
                    const std::function<void(Canvas&)>& draw, const PictureText& text,
                    const FileWriter& write)
{
    const auto render = path.ends_with(".svg") ? renderSvg
                      : path.ends_with(".png") ? renderPng
                      : path.ends_with(".pdf") ? renderPdf
                                               : nullptr;
    if (!render)
        return Error{path
                     + ": a picture's file ends in .png, .svg or .pdf; that of a report or a strip "
                       "also in .html"};
    const auto bytesOf = [&](std::string& bytes) {
        const cairo_status_t status = render(bytes, width, height, draw);
        if (render == renderSvg) addTexts(bytes, text);
        return status;
    };
    return writeDrawn(path, bytesOf, write);
}

Status writePages(const std::string& path, int width, int height, const std::string& title,
                  const std::function<std::vector<PageDrawing>(Canvas& measuring)>& layout)
{
    return writeDrawn(path, [&](std::string& bytes) {
        const Surface surface = pdfSurface(bytes, width, height);
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE,
                                       printable(title).c_str());
        const Context context(cairo_create(surface.get()), cairo_destroy);
        Canvas canvas(context.get());
        for (const PageDrawing& draw : layout(canvas)) {
            canvas.place({}, kPoint, draw);
            cairo_show_page(context.get());
        }
        const cairo_status_t drawn = cairo_status(context.get());
        cairo_surface_finish(surface.get());
        return drawn != CAIRO_STATUS_SUCCESS ? drawn : cairo_surface_status(surface.get());
    });
}

std::string svgText(int width, int height, const std::function<void(Canvas&)>& draw)
{
    std::string text;
    if (const cairo_status_t status = renderSvg(text, width, height, draw);
        status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(cairo_status_to_string(status));
    return text;
}

int drawKey(Canvas& canvas, Point topLeft, double right, const std::vector<KeyEntry>& entries)
{
    constexpr double kSample = 34.0, kGap = 22.0, kRow = 24.0;
    const TextStyle style{.colour = {0x16222e}, .size = 14.0};
    int rows = 1;
    Point at = topLeft;
    for (const KeyEntry& entry : entries) {
        const double width = kSample + canvas.textWidth(entry.words, style);
        if (at.x + width > right && at.x > topLeft.x) {
            at = {topLeft.x, at.y + kRow};
            ++rows;
        }
        entry.sample(canvas, {at.x + 15.0, at.y + 0.5 * kRow});
        canvas.text({at.x + kSample, at.y + 0.5 * kRow + 5.0}, entry.words, style);
        at.x += width + kGap;
    }
    return rows;
}

}  // namespace terratact
