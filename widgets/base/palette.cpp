#include "widgets/base/palette.h"

namespace terratact {
namespace {

/// Red light keeps dark adaptation, because rods hardly respond to red. The reds are bright enough to read. Day's
/// differences of hue become differences of brightness, shape and words.
Theme nightRed()
{
    const QColor black(0x00, 0x00, 0x00), ember(0x16, 0x02, 0x00), dim(0x3a, 0x06, 0x03);
    const QColor line(0x70, 0x10, 0x08), low(0xf0, 0x40, 0x28), clear(0xff, 0x70, 0x58);
    const QColor bright(0xff, 0x7d, 0x70);
    Theme t;
    t.window = black;
    t.card = QColor(0x0a, 0x01, 0x00);
    t.cardBorder = QColor(0x50, 0x0a, 0x05);
    t.header = ember;
    t.headerText = clear;
    t.source = bright;
    t.tip = ember;
    t.text = clear;
    t.muted = low;
    t.grid = QColor(0x30, 0x06, 0x03);
    t.button = {QColor(0x28, 0x04, 0x02), clear};
    t.buttonBorder = QColor(0x90, 0x18, 0x0c);
    t.off = {QColor(0x10, 0x01, 0x00), low};
    t.offBorder = QColor(0x38, 0x06, 0x03);
    t.primary = {QColor(0x58, 0x08, 0x04), bright};
    t.stop = {QColor(0xff, 0x30, 0x18), black};
    t.stopped = {QColor(0x4a, 0x04, 0x02), bright};
    t.stopBorder = bright;
    t.decide = t.primary;
    t.caution = {QColor(0x48, 0x06, 0x02), bright};
    t.good = clear;
    t.warning = QColor(0xff, 0x58, 0x40);
    t.bad = QColor(0xff, 0x48, 0x30);
    t.accent = bright;
    t.chip = {dim, clear};
    t.chipBorder = line;
    t.chipOffText = QColor(0xff, 0x50, 0x38);
    t.chipGood = {dim, clear};
    t.chipWarning = {QColor(0x48, 0x08, 0x04), bright};
    t.chipBad = {QColor(0x5c, 0x06, 0x02), bright};
    t.chipAccent = {QColor(0x48, 0x08, 0x04), bright};
    t.banner = {QColor(0x60, 0x06, 0x02), bright};
    t.done = {QColor(0x58, 0x08, 0x04), bright};
    t.clear = {dim, bright};
    t.blocked = {QColor(0x70, 0x08, 0x04), bright};
    t.open = {QColor(0x48, 0x08, 0x04), bright};
    t.felt = {bright, black};
    t.sampled = QColor(0xe0, 0x34, 0x20);
    t.contact = bright;
    t.arm = QColor(0xff, 0x5c, 0x44);
    t.prior = QColor(0xb8, 0x28, 0x18);
    t.priorZone = QColor(0x1c, 0x03, 0x01);
    t.ceiling = QColor(0x90, 0x18, 0x0c);
    t.truth = QColor(0xb0, 0x20, 0x10);
    t.robotBody = QColor(0x2c, 0x05, 0x02);
    t.robotTrack = QColor(0x3a, 0x08, 0x04);
    t.robotFlipper = QColor(0x4a, 0x0a, 0x05);
    t.robotLine = QColor(0xa0, 0x1c, 0x10);
    t.force = QColor(0x80, 0x16, 0x0c);
    return t;
}

Theme highContrast()
{
    const QColor black(0x00, 0x00, 0x00), white(0xff, 0xff, 0xff), yellow(0xff, 0xe0, 0x00);
    const QColor green(0x7d, 0xff, 0x9a), rose(0xff, 0xa0, 0xa0), violet(0xff, 0x9a, 0xe0);
    Theme t;
    t.window = t.card = t.header = t.tip = t.priorZone = black;
    t.cardBorder = t.headerText = t.text = t.muted = t.buttonBorder = t.stopBorder = white;
    t.source = yellow;
    t.grid = QColor(0x48, 0x48, 0x48);
    t.button = {black, white};
    t.off = {black, QColor(0xb0, 0xb0, 0xb0)};
    t.offBorder = QColor(0x80, 0x80, 0x80);
    t.primary = {yellow, black};
    t.stop = {QColor(0xb0, 0x00, 0x00), white};
    t.stopped = {white, QColor(0xa0, 0x00, 0x00)};
    t.decide = {violet, black};
    t.caution = {yellow, black};
    t.good = green;
    t.warning = yellow;
    t.bad = rose;
    t.accent = violet;
    t.chip = {black, white};
    t.chipBorder = white;
    t.chipOffText = QColor(0xc8, 0xc8, 0xc8);
    t.chipGood = {black, green};
    t.chipWarning = {yellow, black};
    t.chipBad = {white, QColor(0xa0, 0x00, 0x00)};
    t.chipAccent = {black, violet};
    t.banner = {white, QColor(0xa0, 0x00, 0x00)};
    t.done = {QColor(0x00, 0x4a, 0x8c), white};
    t.clear = {green, black};
    t.blocked = t.chipBad;
    t.open = {yellow, black};
    t.felt = {QColor(0x3f, 0xa0, 0xff), black};
    t.sampled = green;
    t.contact = QColor(0x3f, 0xa0, 0xff);
    t.arm = violet;
    t.prior = QColor(0xff, 0xd0, 0x00);
    t.priorZone = QColor(0x26, 0x22, 0x00);
    t.ceiling = QColor(0xc0, 0xc0, 0xc0);
    t.truth = rose;
    t.robotBody = QColor(0x30, 0x30, 0x30);
    t.robotTrack = QColor(0x40, 0x40, 0x40);
    t.robotFlipper = QColor(0x58, 0x58, 0x58);
    t.robotLine = white;
    t.force = QColor(0x90, 0x90, 0x90);
    return t;
}

}  // namespace

Theme themeOf(ThemeName name)
{
    switch (name) {
    case ThemeName::Day: return {};
    case ThemeName::NightRed: return nightRed();
    case ThemeName::HighContrast: return highContrast();
    }
    return {};
}

}  // namespace terratact
