#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/figures/wording.h"

namespace terratact {

class Canvas;

/// Returns an untrusted text for HTML: one line without characters that printable() refuses, with < > & " ' as
/// entities.
std::string htmlText(std::string_view text);

/// Returns the head of a page without scripts and without links to other files, up to its <body>. style: CSS that is
/// added to the common style. wording: whose language the page names.
std::string htmlHead(std::string_view title, const Wording& wording = inEnglish,
                     std::string_view style = {});

/// Returns a picture as SVG inside a page. prefix: unique in the page, because each picture counts its glyphs from 0.
std::string htmlPicture(int width, int height, const std::function<void(Canvas&)>& draw,
                        std::string_view prefix);

}  // namespace terratact
