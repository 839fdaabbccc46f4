#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/report/report_document.h"
#include "app/figures/wording.h"
#include "core/strip/strip.h"

namespace terratact {

/// Returns pictures of the ground felt along the way. Each shows a piece of at most kStripPiece of
/// one section: left, right, and bands of the 0.1 to 0.9 quantiles. Axes are equal [m], with a
/// scale. Sides differ by colour, line and band. Shapes show how a bin was felt. A bracket marks
/// the newest estimate, so all else is remembered. The pictures keep the strip. only: number of the
/// only section to draw, from 1; empty: all. wording: makes the texts.
std::vector<DocumentPicture> stripPictures(const std::shared_ptr<const Strip>& strip,
                                           std::optional<int> only = {},
                                           const Wording& wording = inEnglish);
inline constexpr double kStripPiece = 6.0;  ///< [m]

/// Returns the pictures with a note as a part of a document.
DocumentPart stripPart(const std::shared_ptr<const Strip>& strip, std::optional<int> only = {},
                       const Wording& wording = inEnglish);

/// Texts of a file of the strip.
struct StripText {
    std::string title;  ///< what drive it is of
    std::string data;   ///< its numbers, which an SVG keeps (app/recording/export/strip_export.h)
};

/// Writes the pictures one below the other as .png or .svg, or on pages as .pdf or .html. An SVG keeps text.data in its
/// <metadata>. Errors name the file: another ending, no ground, higher than 20000 px, not writable.
Status writeStripPicture(const std::string& path, const std::shared_ptr<const Strip>& strip,
                         const StripText& text, std::optional<int> only = {},
                         const Wording& wording = inEnglish);

}  // namespace terratact
