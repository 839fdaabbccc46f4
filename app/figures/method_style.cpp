#include "app/figures/method_style.h"

namespace terratact {

MethodStyle styleOf(Method method)
{
    switch (method) {
    case Method::Pa: return {{0x7b8794}, Shape::Circle, 12.0, "PA"};
    case Method::Pac: return {{0x1558a6}, Shape::Square, 11.0, "PAC"};
    case Method::Pafc: return {{0x12804a}, Shape::Diamond, 15.0, "PAFc"};
    case Method::Pafac: return {{0x8e3fbf}, Shape::Triangle, 14.0, "PAFAc"};
    case Method::Clearance: return {{0xb8560b}, Shape::Circle, 12.0, "clearance"};
    case Method::Joint: return {{0x0b7f8c}, Shape::Square, 11.0, "joint"};
    case Method::Local: return {{0xb01e4f}, Shape::Diamond, 15.0, "local"};
    case Method::Trail: return {{0x1d1d1d}, Shape::Triangle, 14.0, "trail"};
    }
    return {};
}

MethodStyle styleOf(const std::string& label)
{
    const std::size_t slash = label.find('/');
    if (const auto method = methodFromName(label.substr(0, slash))) {
        MethodStyle look = styleOf(*method);
        if (slash == std::string::npos) return look;
        look.words += label.substr(slash);
        look.shape = label.size() % 2 == 0 ? Shape::Triangle : Shape::Square;
        return look;
    }
    if (label == "flat") return {{0xb0a18a}, Shape::Circle, 10.0, label, true};
    if (label == "linear") return {{0x8fa3b5}, Shape::Square, 9.0, label, true};
    if (label == "nearest") return {{0x9a8fa8}, Shape::Triangle, 11.0, label, true};
    return {{0x5f6b66}, Shape::Diamond, 12.0, label, true};
}

void drawMarker(Canvas& canvas, const MethodStyle& look, Point at, double scale)
{
    const Colour white{0xffffff};
    canvas.marker(look.shape, at, scale * look.size, look.hollow ? white : look.colour,
                  look.hollow ? Stroke{look.colour, 2.0, {}} : Stroke{white, 1.5, {}});
}

}  // namespace terratact
