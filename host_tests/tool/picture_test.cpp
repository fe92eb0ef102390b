// osem image and osem slice: the PNG files, decoded by a library that did not write them.
#include <array>

#include "support.hpp"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace osem::tool_test {

namespace {

using Pixel = std::array<int, 3>;

const Pixel white = {255, 255, 255};
const Pixel black = {0, 0, 0};
const Pixel boundary = {70, 130, 180};

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;

    const Pixel& at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
    int count(const Pixel& pixel) const {
        int n = 0;
        for (const Pixel& p : pixels) n += p == pixel ? 1 : 0;
        return n;
    }
};

class Pictures : public Tool {
  protected:
    Picture decoded(const std::string& name) const {
        const std::string bytes = read_file(path(name));
        EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
        Picture picture;
        int channels = 0;
        stbi_uc* data = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                              static_cast<int>(bytes.size()), &picture.width, &picture.height,
                                              &channels, 3);
        EXPECT_NE(data, nullptr);
        for (int i = 0; data != nullptr && i < picture.width * picture.height; ++i) {
            picture.pixels.push_back({data[3 * i], data[3 * i + 1], data[3 * i + 2]});
        }
        stbi_image_free(data);
        return picture;
    }

    Picture slice(const std::string& name, const std::string& axis, const std::string& at) const {
        EXPECT_TRUE(succeeded(
            osem({"slice", path(name + ".osem"), "-o", path("slice.png"), "--axis", axis, "--at", at})));
        return decoded("slice.png");
    }

    Picture image(const std::string& name, const std::string& view, const std::string& size) const {
        EXPECT_TRUE(succeeded(
            osem({"image", path(name + ".osem"), "-o", path("image.png"), "--view", view, "--size", size})));
        return decoded("image.png");
    }
};

TEST_F(Pictures, ASliceShowsEachLeafAsASquare) {
    make_box("box", {0.0625, 0.0625, 0.0625}, {0.9375, 0.9375, 0.9375});
    for (const char* axis : {"x", "y", "z"}) {
        const Picture middle = slice("box", axis, "0.5");
        ASSERT_EQ(middle.width, 256);
        ASSERT_EQ(middle.height, 256);
        EXPECT_EQ(middle.count(black), 6 * 6 * 32 * 32);
        EXPECT_EQ(middle.count(boundary), (8 * 8 - 6 * 6) * 32 * 32);
        EXPECT_EQ(middle.at(31, 31), boundary);
        EXPECT_EQ(middle.at(32, 32), black);
        EXPECT_EQ(slice("box", axis, "0").count(boundary), 256 * 256);
    }
}

TEST_F(Pictures, ASliceOnALeafBorderShowsThePositiveSide) {
    make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    EXPECT_EQ(slice("box", "z", "0.25").count(black), 128 * 128);
    EXPECT_EQ(slice("box", "z", "0.7499").count(black), 128 * 128);
    EXPECT_EQ(slice("box", "z", "0.75").count(white), 256 * 256);
    EXPECT_EQ(slice("box", "z", "0.2499").count(white), 256 * 256);
}

TEST_F(Pictures, ASliceLooksAgainstItsAxisUpwards) {
    // Low in x and y, high in z; each axis shows the other two, rightwards and upwards.
    make_box("box", {0, 0, 0.5}, {0.5, 0.25, 1});
    const Picture x =
        slice("box", "x", "0.1"); // y to the right, z upwards: above on the left, a quarter wide
    EXPECT_EQ(x.at(0, 0), black);
    EXPECT_EQ(x.at(63, 127), black);
    EXPECT_EQ(x.at(64, 127), white);
    EXPECT_EQ(x.at(63, 128), white);
    const Picture y = slice("box", "y", "0.1"); // x to the right, z upwards: above on the left, half wide
    EXPECT_EQ(y.at(127, 127), black);
    EXPECT_EQ(y.at(128, 127), white);
    EXPECT_EQ(y.at(127, 128), white);
    const Picture z = slice("box", "z", "0.6"); // x to the right, y upwards: below on the left
    EXPECT_EQ(z.at(0, 255), black);
    EXPECT_EQ(z.at(127, 192), black);
    EXPECT_EQ(z.at(127, 191), white);
    EXPECT_EQ(z.at(128, 192), white);
}

TEST_F(Pictures, ASliceIsAsWideAsTheTreeIsDeepUpTo2048) {
    const std::vector<double> low = {0.25, 0.25, 0.25};
    const std::vector<double> high = {0.75, 0.75, 0.75};
    make_box("nine", low, high, {"--depth", "9"});
    EXPECT_EQ(slice("nine", "z", "0.5").width, 512);
    // The box ends in the middle of a pixel of 2^-11, which is then half black, half white.
    make_box("deep", low, {0.75 + 1.0 / 4096, 0.75, 0.75}, {"--depth", "12"});
    const Picture deep = slice("deep", "z", "0.5");
    ASSERT_EQ(deep.width, 2048);
    EXPECT_EQ(deep.at(1535, 1024), black);
    EXPECT_EQ(deep.at(1536, 1024), (Pixel{128, 128, 128}));
    EXPECT_EQ(deep.at(1537, 1024), white);
}

TEST_F(Pictures, ASliceOutsideTheRootIsRefused) {
    make_box("box", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, {}, "-1,-1,-1,2");
    const auto before = files();
    for (const char* at : {"-1.001", "1", "1e300"}) {
        EXPECT_TRUE(failed(
            osem({"slice", path("box.osem"), "-o", path("out.png"), "--axis", "y", "--at", at}), 2, "--at"));
    }
    EXPECT_EQ(files(), before);
    EXPECT_EQ(slice("box", "y", "-1").count(white), 256 * 256);
    EXPECT_EQ(slice("box", "y", "-.5").count(black), 128 * 128);
}

// Pixels that are not background in the middle row or column; the background is one colour along a row.
int covered(const Picture& picture, bool along_row) {
    int n = 0;
    const int middle = picture.width / 2;
    for (int i = 0; i < picture.width; ++i) {
        const int x = along_row ? i : middle;
        const int y = along_row ? middle : i;
        n += picture.at(x, y) != picture.at(0, y) ? 1 : 0;
    }
    return n;
}

TEST_F(Pictures, AViewShowsTheBoxFromItsSide) {
    make_box("box", {0, 0.25, 0.5}, {1, 0.75, 0.75});
    // The longest extent fills 1 / 1.1 of the picture: 200 of 220 pixels.
    struct Expected {
        const char* view;
        double width;
        double height;
    };
    for (const Expected& e :
         {Expected{"front", 200, 50}, Expected{"back", 200, 50}, Expected{"left", 200, 100},
          Expected{"right", 200, 100}, Expected{"top", 200, 100}, Expected{"bottom", 200, 100},
          Expected{"-90,0", 200, 50}}) {
        const Picture picture = image("box", e.view, "220");
        ASSERT_EQ(picture.width, 220);
        ASSERT_EQ(picture.height, 220);
        EXPECT_NEAR(covered(picture, true), e.width, 2) << e.view;
        EXPECT_NEAR(covered(picture, false), e.height, 2) << e.view;
    }
}

TEST_F(Pictures, TheNearerSurfaceHidesTheOther) {
    // A small boundary box in front of (below in y) a large black plate.
    make_box("plate", {0, 0.5, 0}, {1, 1, 1}, {"--depth", "4"});
    make_box("small", {0.26, 0.01, 0.26}, {0.74, 0.24, 0.74}, {"--depth", "4"});
    ASSERT_TRUE(succeeded(osem({"union", path("plate.osem"), path("small.osem"), "-o", path("both.osem")})));
    const auto bluish = [](const Pixel& p) { return p[2] > p[0]; };
    const Picture front = image("both", "front", "200");
    EXPECT_TRUE(bluish(front.at(100, 100)));
    EXPECT_FALSE(bluish(front.at(30, 100)));
    const Picture back = image("both", "back", "200");
    EXPECT_FALSE(bluish(back.at(100, 100)));
}

TEST_F(Pictures, AnEmptyTreeIsABackground) {
    make_box("box", {0, 0, 0}, {1, 1, 1});
    ASSERT_TRUE(succeeded(osem({"complement", path("box.osem"), "-o", path("none.osem")})));
    const Picture picture = image("none", "iso", "16");
    ASSERT_EQ(picture.width, 16);
    EXPECT_EQ(covered(picture, true), 0);
}

} // namespace

} // namespace osem::tool_test
