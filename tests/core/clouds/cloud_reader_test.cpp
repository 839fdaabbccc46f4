// Tests readers of point clouds: PCD, PLY and text.
#include "core/clouds/cloud_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/clouds/made_cloud.h"
#include "tests/support/bytes/lzf_bytes.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using Points = std::vector<CloudPoint>;

template <class T>
std::string bytesOf(T value, bool bigEndian = false)
{
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (bigEndian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

struct Clouds : testing::Test {
    Result<Points> read(const std::string& content)
    {
        auto cloud = openCloud(directory.write("a", content));
        if (!cloud) return cloud.error();
        format = (*cloud)->format();
        Points all;
        for (Points block;;) {
            const auto more = (*cloud)->next(block);
            if (!more) return more.error();
            if (!*more) break;
            EXPECT_LE(block.size(), kCloudBlock);
            all.insert(all.end(), block.begin(), block.end());
        }
        leftOut = (*cloud)->leftOut();
        remark = (*cloud)->remark();
        return all;
    }
    testing::AssertionResult refuses(const std::string& content,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(content), directory.file("a"), parts);
    }

    static std::string header(const std::string& fields, const std::string& count,
                              const std::string& data)
    {
        return "# .PCD v0.7\nVERSION 0.7\nFIELDS " + fields + "\nWIDTH " + count
             + "\nHEIGHT 1\nPOINTS " + count + "\nDATA " + data + "\n";
    }

    std::string format, remark;
    std::uint64_t leftOut = 0;
    TemporaryDirectory directory;
};

TEST_F(Clouds, asciiPcdFindsItsFieldsByName)
{
    const auto points =
        read(header("intensity z x y\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 2 1 1 1", "2", "ascii")
             + "9 9 3 1 2\r\n9 9 6 4.5 -5e-1\n");
    ASSERT_TRUE(points) << points.error().text;
    EXPECT_EQ(*points, (Points{{1, 2, 3}, {4.5, -0.5, 6}}));
}

TEST_F(Clouds, binaryPcdHasEveryNumberType)
{
    std::string content =
        header("x rgb y z\nSIZE 8 4 2 1\nTYPE F U I I\nCOUNT 1 1 1 1", "2", "binary");
    content += bytesOf(1.25) + bytesOf(7U) + bytesOf(std::int16_t{-300}) + bytesOf(std::int8_t{-5});
    content += bytesOf(-2.5) + bytesOf(7U) + bytesOf(std::int16_t{300}) + bytesOf(std::int8_t{5});
    const auto points = read(content);
    ASSERT_TRUE(points) << points.error().text;
    EXPECT_EQ(*points, (Points{{1.25, -300, -5}, {-2.5, 300, 5}}));
    EXPECT_EQ(format, "PCD, binary");
}

/// Returns points with repeated and with new numbers, across blocks of points and windows of the decoder.
Points manyPoints(std::size_t count)
{
    Points points;
    points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto n = static_cast<double>(i);
        points.push_back(
            {0.25 * static_cast<double>(i % 7), 0.5 * n, std::floor(std::fmod(n * n, 97.0))});
    }
    return points;
}

std::string compressed(const Points& points)
{
    std::string fields;
    for (const auto member : {&CloudPoint::x, &CloudPoint::y, &CloudPoint::z})
        for (const CloudPoint& p : points) fields += bytesOf(static_cast<float>(p.*member));
    const std::string packed = lzfBytes(fields);
    EXPECT_LT(packed.size(), fields.size());
    return bytesOf(static_cast<std::uint32_t>(packed.size()))
         + bytesOf(static_cast<std::uint32_t>(fields.size())) + packed;
}

TEST_F(Clouds, compressedPcdEqualsItsBinary)
{
    const Points points = manyPoints(10'000);
    const auto packed = read(header("x y z", "10000", "binary_compressed") + compressed(points));
    ASSERT_TRUE(packed) << packed.error().text;
    EXPECT_EQ(*packed, points);
    EXPECT_EQ(*read(pcdText(points)), points);
}

TEST_F(Clouds, damagedCompressionIsNamed)
{
    const std::string whole =
        header("x y z", "500", "binary_compressed") + compressed(manyPoints(500));
    EXPECT_TRUE(refuses(whole.substr(0, whole.size() - 9), {"compressed bytes", "cut"}));
    std::string copy = whole;
    const std::size_t body = header("x y z", "500", "binary_compressed").size() + 8;
    copy[body] = '\x3f';
    copy[body + 1] = '\x7f';
    EXPECT_TRUE(refuses(copy, {"copy from before their beginning at byte"}));
    EXPECT_TRUE(refuses(header("x y z", "3000000", "binary_compressed")
                            + bytesOf(std::uint32_t{100}) + bytesOf(std::uint32_t{36'000'000})
                            + std::string(100, '\0'),
                        {"has 100 bytes that unpack to 36000000, which is no cloud"}));
    EXPECT_TRUE(refuses(header("x y z", "501", "binary_compressed") + compressed(manyPoints(500)),
                        {"declares 501 points of 12 bytes, but 6000 bytes"}));
}

TEST_F(Clouds, plyReadsAllThreeFormats)
{
    const std::string head =
        "comment c\nelement camera 1\nproperty list uchar int ids\nelement vertex 2\n"
        "property double x\nproperty uchar red\nproperty float y\nproperty short z\n"
        "element face 0\nproperty list uchar int vertex_indices\nend_header\n";
    const Points wanted{{1.5, -2, 3}, {0.125, 4, -5}};
    const auto text =
        read("ply\nformat ascii 1.0\n" + head + "2 5 6\n1.5 255 -2 3\n0.125 0 4 -5\n");
    ASSERT_TRUE(text) << text.error().text;
    EXPECT_EQ(*text, wanted);
    for (const bool big : {false, true}) {
        std::string body = bytesOf(std::uint8_t{2}) + bytesOf(5, big) + bytesOf(6, big);
        for (const CloudPoint& p : wanted)
            body += bytesOf(p.x, big) + "r" + bytesOf(static_cast<float>(p.y), big)
                  + bytesOf(static_cast<std::int16_t>(p.z), big);
        const std::string content = std::string("ply\r\nformat binary_") + (big ? "big" : "little")
                                  + "_endian 1.0\n" + head + body;
        const auto points = read(content);
        ASSERT_TRUE(points) << points.error().text;
        EXPECT_EQ(*points, wanted);
        EXPECT_TRUE(
            refuses(content.substr(0, content.size() - 1), {"1 vertices before the end", "cut"}));
    }
}

TEST_F(Clouds, textHasManyForms)
{
    const Points wanted{{1, 2, 3}, {-4, 5.5, 6}};
    for (const char* content :
         {"1 2 3\n-4 5.5 6\n", "1,2,3\n-4,5.5,6", "x;y;z\n1;2;3\n-4;5.5;6\n",
          "2\n1 2 3 9\n-4 5.5 6 9\n", "# made\n//X Y Z I\n1\t2\t3\t0\n\n-4\t5.5\t6\t0\n",
          "t,z_m,y_m,x_m\n0,3,2,1\n0,6,5.5,-4\n", "1, 2, 3\n-4 , 5.5 , 6\n",
          "x;y;z\n1,0;2,0;3\n-4;5,5;6,0\n", "1,0 2 3\n-4 5,5 6,0\n", "1\t2,0\t3\n-4\t5,5\t6\n",
          "y,x,z,Scalar field\n2,1,3,0\n5.5,-4,6,0\n"}) {
        const auto points = read(content);
        ASSERT_TRUE(points) << content << points.error().text;
        EXPECT_EQ(*points, wanted) << content;
    }
}

TEST_F(Clouds, pointsThatAreNotFiniteAreLeftOut)
{
    const auto points = read("nan 1 2\n1 inf 2\n1 2 3\n1e9 2 3\n1,,3\n");
    ASSERT_TRUE(points) << points.error().text;
    EXPECT_EQ(*points, (Points{{1, 2, 3}}));
    EXPECT_EQ(leftOut, 4U);
}

TEST_F(Clouds, everyRefusalSaysWhatToDo)
{
    EXPECT_TRUE(refuses("", {"is empty"}));
    EXPECT_TRUE(refuses("LASF\1\2", {"LAS", "convert it to PLY or PCD"}));
    EXPECT_TRUE(refuses(std::string("\x89MCAP0\r\n", 8), {"--topic"}));
    EXPECT_TRUE(refuses(std::string("\0\1\2", 3), {"no PCD, PLY or text"}));
    EXPECT_TRUE(refuses("x,y,z\n1,2\n", {"line 2: has 2 fields"}));
    EXPECT_TRUE(refuses("1 2 3\n1 2 three\n", {"line 2: z is 'three'", "no number"}));
    EXPECT_TRUE(refuses("# nothing\n", {"holds no point"}));
    EXPECT_TRUE(refuses(std::string(70'000, '1'), {"line 1: is longer than 65536 bytes"}));
    EXPECT_TRUE(
        refuses(header("x y z", "2", "binary_zip"), {"line 7: DATA is 'binary_zip'", "expected"}));
    EXPECT_TRUE(refuses(header("x y z", "2", "binary") + "short", {"ends within", "cut"}));
    EXPECT_TRUE(refuses(header("x y z", "2", "ascii") + "1 2 3\n", {"1 points before the 2"}));
    EXPECT_TRUE(refuses(header("x y", "2", "ascii"), {"line 3: FIELDS has no z"}));
    EXPECT_TRUE(refuses(header("x y z", "1", "ascii") + "1 2 3\n\n4 5 6\n",
                        {"line 10: is behind the 1 points", "correct POINTS"}));
    EXPECT_TRUE(refuses("# .PCD v0.7\nFIELDS x y z\nWIDTH 2\nHEIGHT 2\nPOINTS 5\nDATA ascii\n",
                        {"line 5: POINTS is 5", "WIDTH and HEIGHT are 2 and 2", "correct"}));
    EXPECT_TRUE(refuses("1,2.5;3;4\n", {"x is '1,2.5'", "no number"}));
    EXPECT_TRUE(refuses(header("x y z\nSIZE 4 4", "2", "ascii"),
                        {"line 4: FIELDS names 3 fields, but SIZE has 2 values"}));
    EXPECT_TRUE(
        refuses(header("x y z\nSIZE 4 4 2", "2", "ascii"), {"line 3: field z is no number"}));
    EXPECT_TRUE(refuses(header("x y z\nSIZE 4 4 9", "2", "ascii"), {"line 4: SIZE of field 'z'"}));
    EXPECT_TRUE(refuses(header("x y z\nTYPE F F D", "2", "ascii"), {"line 4: TYPE of field 'z'"}));
    EXPECT_TRUE(
        refuses(header("x y z\nCOUNT 1 1 n", "2", "ascii"), {"line 4: COUNT of field 'z'"}));
    EXPECT_TRUE(refuses(header("x y z", "many", "ascii"), {"line 4: WIDTH is 'many'"}));
    EXPECT_TRUE(refuses("VERSION 0.7\nFIELDS x y z\n", {"no line DATA"}));
    EXPECT_TRUE(refuses("ply\nformat binary 2.0\n", {"line 2: format is 'binary'"}));
    EXPECT_TRUE(refuses("ply\nformat ascii 1.0\nend_header\n", {"no element vertex"}));
    std::string many = "ply\nformat ascii 1.0\n";
    for (int i = 0; i < 17; ++i) many += "element e" + std::to_string(i) + " 0\n";
    EXPECT_TRUE(refuses(many, {"line 19: element 'e16' is one more than the 16 that are read"}));
    EXPECT_TRUE(refuses("ply\nformat ascii 1.0\nelement vertex x\n",
                        {"element 'vertex' has the number 'x'"}));
    EXPECT_TRUE(refuses("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n",
                        {"line 4: property"}));
}

TEST_F(Clouds, bytesBehindTheLastPointAreNamed)
{
    const std::string binary = header("x y z", "1", "binary") + std::string(12, '\0');
    ASSERT_TRUE(read(binary));
    EXPECT_EQ(remark, "");
    EXPECT_TRUE(refuses(binary + "1234567",
                        {"7 bytes behind the 1 points of 12 bytes", "cut the file there"}));
    EXPECT_TRUE(refuses(binary + std::string(70'000, '\0'), {"70000 bytes behind"}));
    ASSERT_TRUE(read(binary + std::string(7, '\0')));
    EXPECT_NE(remark.find("7 zeros behind the 1 points"), std::string::npos) << remark;
    const std::string packed =
        header("x y z", "500", "binary_compressed") + compressed(manyPoints(500));
    ASSERT_TRUE(read(packed + std::string(9, '\0')));
    EXPECT_NE(remark.find("9 zeros behind"), std::string::npos) << remark;
    EXPECT_TRUE(refuses(packed + "x", {"has 1 bytes behind the", "compressed bytes"}));
    const std::string properties = "property float x\nproperty float y\nproperty float z\n";
    const std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + properties
                          + "element face 0\nend_header\n" + std::string(12, '\0');
    ASSERT_TRUE(read(ply));
    EXPECT_TRUE(refuses(ply + "xy", {"has 2 bytes behind the 1 vertices"}));
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 1\n" + properties + "end_header\n1 2 3\n";
    ASSERT_TRUE(read(text + "\n"));
    EXPECT_TRUE(refuses(text + "4 5 6\n", {"line 9: is behind the 1 vertices", "correct"}));
}

TEST_F(Clouds, aHeaderThatLiesCostsNoMemory)
{
    EXPECT_TRUE(refuses(header("x y z", "900000000000", "binary") + "123456789012", {"cut"}));
    EXPECT_TRUE(refuses(header("x y z\nCOUNT 1 1 99999999", "9", "binary"), {"COUNT"}));
}

}  // namespace
}  // namespace terratact
