// Tests numbers of DBC signals as text.
#include "core/wire/dbc/dbc_number.h"

#include <gtest/gtest.h>

#include <bit>

#include "core/wire/dbc/dbc.h"

namespace terratact {
namespace {

DbcSignal scaled(double scale, double offset, DbcSignal::Type type = DbcSignal::Type::Unsigned)
{
    DbcSignal signal;
    signal.length = 64;
    signal.scale = scale;
    signal.offset = offset;
    signal.type = type;
    return signal;
}

TEST(DbcNumberTexts, haveAllTheirDigits)
{
    DbcSignal whole = scaled(1.0, 0.0);
    EXPECT_EQ(exactText(whole, 9223372036854788153U), "9223372036854788153");
    EXPECT_EQ(shownText(whole, 9223372036854788153U), "9223372036854788153");
    whole.type = DbcSignal::Type::Signed;
    EXPECT_EQ(exactText(whole, ~std::uint64_t{0}), "-1");
    EXPECT_EQ(exactText(whole, std::uint64_t{1} << 63U), "-9223372036854775808");
    const DbcSignal tenths = scaled(0.1, -40.0);
    EXPECT_EQ(exactText(tenths, 3), "-39.7");
    EXPECT_EQ(exactText(tenths, 9223372036854788153U), "922337203685478775.3");
    EXPECT_EQ(exactText(tenths, 400), "0.0");
    DbcSignal fine = scaled(1.0 / 256.0, 0.0);
    EXPECT_EQ(exactText(fine, 3), "0.01171875");
    EXPECT_EQ(shownText(fine, std::uint64_t{3}), "0.0117");
    fine.scale = 1.0 / 3.0;
    EXPECT_EQ(exactText(fine, 1), "0.3333333333333333");
    const DbcSignal real = scaled(1.0, 0.0, DbcSignal::Type::Double);
    EXPECT_EQ(exactText(real, std::bit_cast<std::uint64_t>(1234.56789012345)), "1234.56789012345");
    EXPECT_EQ(exactText(real, 0x7FF8'0000'0000'0000), "nan");
    EXPECT_EQ(exactText(real, 0x7FF0'0000'0000'0000), "inf");
    EXPECT_EQ(shownText(real, std::uint64_t{0xFFF0'0000'0000'0000}), "-inf");
}

}  // namespace
}  // namespace terratact
