// osem image and osem slice: the PNG files, decoded by a library that did not write them.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

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
    make_box("nine", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}, {"--depth", "9"});
    EXPECT_EQ(slice("nine", "z", "0.5").width, 512);
    // The box ends in the middle of a pixel of 2^-11, which is then half black, half white.
    make_box("deep", {0.25, 0.46875, 0.46875}, {0.75 + 1.0 / 4096, 0.53125, 0.53125}, {"--depth", "12"});
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

// Two steps, a leaf apart in height and of one colour, from above.
TEST_F(Pictures, AStepIsSeenAlongItsAxis) {
    make_box("high", {0, 0, 0}, {0.5, 1, 0.5});
    make_box("low", {0.5, 0, 0}, {1, 1, 0.375});
    ASSERT_TRUE(succeeded(osem({"union", path("high.osem"), path("low.osem"), "-o", path("steps.osem")})));
    const Picture picture = image("steps", "top", "220");
    int rim = 255;
    for (int x = 108; x < 112; ++x) rim = std::min(rim, picture.at(x, 110)[0]);
    EXPECT_LT(rim + 5, picture.at(60, 110)[0]);
    EXPECT_LT(rim + 5, picture.at(160, 110)[0]);
}

TEST_F(Pictures, AnEmptyTreeIsABackground) {
    make_box("box", {0, 0, 0}, {1, 1, 1});
    ASSERT_TRUE(succeeded(osem({"complement", path("box.osem"), "-o", path("none.osem")})));
    const Picture picture = image("none", "iso", "16");
    ASSERT_EQ(picture.width, 16);
    EXPECT_EQ(covered(picture, true), 0);
}

// Whether something is drawn at a pixel of a shaded picture.
bool drawn(const Picture& picture, int x, int y, int background_column = 0) {
    return picture.at(x, y) != picture.at(background_column, y);
}

TEST_F(Pictures, ACubeFromItsDiagonalIsAHexagonOfThreeEvenFaces) {
    make_box("box", {0, 0, 0}, {0.5, 0.5, 0.5});
    const Picture picture = image("box", "iso", "440");
    // A cube of side s is sqrt(8 / 3) s high in this view, and its outline holds sqrt(3) s^2.
    const double side = 440 / 1.1 / std::sqrt(8.0 / 3);
    std::map<Pixel, int> colours;
    int area = 0;
    for (int y = 0; y < 440; ++y) {
        for (int x = 0; x < 440; ++x) {
            if (!drawn(picture, x, y)) continue;
            ++area;
            ++colours[picture.at(x, y)];
        }
    }
    EXPECT_NEAR(area, std::sqrt(3.0) * side * side, 1500); // the outline is 1500 pixels long
    std::vector<int> counts;
    for (const auto& colour : colours) counts.push_back(colour.second);
    std::sort(counts.rbegin(), counts.rend());
    ASSERT_GE(counts.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(counts[i], side * side / std::sqrt(3.0), 1500);
}

// Where the unit cube's points are seen from azimuth -60, elevation 20 in a picture fitted to it.
struct CubeView {
    using Place = std::array<double, 2>;
    double low[2] = {1e9, 1e9};
    double high[2] = {-1e9, -1e9};
    int size;

    explicit CubeView(int pixels) : size(pixels) {
        for (int corner = 0; corner < 8; ++corner) {
            const Place p = flat(corner & 1, corner >> 1 & 1, corner >> 2);
            for (unsigned k = 0; k < 2; ++k) {
                low[k] = std::min(low[k], p[k]);
                high[k] = std::max(high[k], p[k]);
            }
        }
    }
    static Place flat(double x, double y, double z) {
        const double a = std::acos(-1.0) / -3;
        const double e = std::acos(-1.0) / 9;
        return {-std::sin(a) * x + std::cos(a) * y,
                std::sin(e) * (std::cos(a) * x + std::sin(a) * y) - std::cos(e) * z};
    }
    Place pixel(double x, double y, double z) const {
        const double scale = size / 1.1 / std::max(high[0] - low[0], high[1] - low[1]);
        const Place p = flat(x, y, z);
        return {size / 2.0 + scale * (p[0] - (low[0] + high[0]) / 2),
                size / 2.0 + scale * (p[1] - (low[1] + high[1]) / 2)};
    }
};

int darkest(const Picture& picture, const CubeView::Place& place) {
    int value = 255;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            value = std::min(value,
                             picture.at(static_cast<int>(place[0]) + x, static_cast<int>(place[1]) + y)[0]);
        }
    }
    return value;
}

TEST_F(Pictures, AWireframeOfACubeHasItsNineVisibleEdges) {
    make_box("box", {0, 0, 0}, {0.5, 0.5, 0.5}); // one leaf
    const CubeView view(400);
    for (const char* lines : {"leaves", "outline"}) {
        ASSERT_TRUE(succeeded(osem({"image", path("box.osem"), "-o", path("wire.png"), "--style", "wireframe",
                                    "--view", "-60,20", "--size", "400", "--lines", lines})));
        const Picture picture = decoded("wire.png");
        int visible = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
            for (unsigned corner = 0; corner < 4; ++corner) {
                const unsigned u = (axis + 1) % 3;
                const unsigned v = (axis + 2) % 3;
                // Edges of the corner at x = 0, y = 1, z = 0, away from the viewer, are hidden.
                const auto hidden_at = [](unsigned a) { return a == 1 ? 1U : 0U; };
                const bool hidden = (corner & 1U) == hidden_at(u) && corner >> 1U == hidden_at(v);
                visible += hidden ? 0 : 1;
                for (const double t : {0.3, 0.45, 0.7}) {
                    double at[3];
                    at[axis] = t;
                    at[u] = corner & 1U;
                    at[v] = corner >> 1U;
                    const int value = darkest(picture, view.pixel(at[0], at[1], at[2]));
                    EXPECT_TRUE(hidden ? value == 255 : value < 130)
                        << value << ' ' << axis << ' ' << corner << ' ' << t;
                }
            }
        }
        EXPECT_EQ(visible, 9);
    }
}

TEST_F(Pictures, ASolidBesideItsExactTreeHasTheSameOutline) {
    make_box("box", {0.25, 0.25, 0.5}, {0.75, 0.5, 0.75});
    for (const std::vector<std::string>& look :
         {std::vector<std::string>{}, {"--style", "wireframe", "--lines", "outline"}}) {
        for (const char* view : {"iso", "front", "20,-30"}) {
            std::vector<std::string> line = {
                "image",          path("box.osem"), "--with", path("box.off"), "-o",
                path("pair.png"), "--view",         view,     "--size",        "200"};
            line.insert(line.end(), look.begin(), look.end());
            ASSERT_TRUE(succeeded(osem(line)));
            const Picture pair = decoded("pair.png");
            ASSERT_EQ(pair.width, 400);
            ASSERT_EQ(pair.height, 200);
            int different = 0;
            std::set<Pixel> colours;
            for (int y = 0; y < 200; ++y) {
                for (int x = 0; x < 200; ++x) {
                    const bool same = look.empty() ? drawn(pair, x, y) == drawn(pair, 200 + x, y, 200)
                                                   : pair.at(x, y) == pair.at(200 + x, y);
                    different += same ? 0 : 1;
                    colours.insert(pair.at(x, y));
                }
            }
            EXPECT_EQ(different, 0) << view;
            EXPECT_GT(colours.size(), 1U) << view;
        }
    }
}

TEST_F(Pictures, AConservativeTreeCoversItsSolidHolesIncluded) {
    const std::string part = OSEM_SAMPLES_DIR "/bracket.poly";
    ASSERT_TRUE(succeeded(osem({"convert", part, "-o", path("part.osem"), "--depth", "6"})));
    ASSERT_TRUE(succeeded(osem({"image", path("part.osem"), "--with", part, "-o", path("pair.png"), "--view",
                                "front,top,right", "--size", "200"})));
    const Picture pair = decoded("pair.png");
    ASSERT_EQ(pair.width, 400);
    ASSERT_EQ(pair.height, 600);
    int solid = 0;
    int tree = 0;
    for (int y = 0; y < 600; ++y) {
        for (int x = 0; x < 200; ++x) {
            if (y % 200 < 24 && x < 80) continue; // labels
            const bool left = drawn(pair, x, y, 199);
            const bool right = drawn(pair, 200 + x, y, 199);
            EXPECT_TRUE(right || !left) << x << ' ' << y;
            solid += left ? 1 : 0;
            tree += right ? 1 : 0;
        }
    }
    EXPECT_GT(solid, 10000);
    EXPECT_LT(tree - solid, solid / 10);
}

TEST_F(Pictures, ViewsFillAGridRowByRow) {
    make_box("box", {0, 0.25, 0.5}, {1, 0.75, 0.75});
    const std::vector<std::string> views = {"iso", "-90,0", "top"};
    ASSERT_TRUE(succeeded(osem(
        {"image", path("box.osem"), "-o", path("sheet.png"), "--view", "iso,-90,0,top", "--size", "100"})));
    const Picture sheet = decoded("sheet.png");
    ASSERT_EQ(sheet.width, 200);
    ASSERT_EQ(sheet.height, 200);
    for (int tile = 0; tile < 4; ++tile) {
        Picture single;
        if (tile < 3) single = image("box", views[static_cast<std::size_t>(tile)], "100");
        int different = 0;
        int label = 0;
        for (int y = 0; y < 100; ++y) {
            for (int x = 0; x < 100; ++x) {
                const Pixel& expected = tile < 3 ? single.at(x, y) : white;
                const bool differs = sheet.at(tile % 2 * 100 + x, tile / 2 * 100 + y) != expected;
                (y < 16 && x < 60 ? label : different) += differs ? 1 : 0;
            }
        }
        EXPECT_EQ(different, 0) << tile;
        EXPECT_EQ(label > 0, tile < 3) << tile;
    }
}

TEST_F(Pictures, AMeshIsDrawnAloneAndTheSameEveryTime) {
    make_box("box", {0, 0.25, 0.5}, {1, 0.75, 0.75});
    for (const char* name : {"one.png", "two.png"}) {
        ASSERT_TRUE(succeeded(
            osem({"image", path("box.off"), "-o", path(name), "--view", "front", "--size", "220"})));
    }
    EXPECT_EQ(read_file(path("one.png")), read_file(path("two.png")));
    const Picture picture = decoded("one.png");
    EXPECT_NEAR(covered(picture, true), 200, 2);
    EXPECT_NEAR(covered(picture, false), 50, 2);
}

TEST_F(Pictures, ViewsAndCompanionsThatAreNoneAreRefused) {
    make_box("box", {0, 0, 0}, {0.5, 0.5, 0.5});
    const auto before = files();
    for (const char* view : {"", "iso,", "iso,side", "10", "10,91", "iso,10"}) {
        EXPECT_TRUE(
            failed(osem({"image", path("box.osem"), "-o", path("out.png"), "--view", view}), 1, "--view"))
            << view;
    }
    EXPECT_TRUE(failed(osem({"image", path("box.off"), "--with", path("box.off"), "-o", path("out.png")}), 1,
                       "--with"));
    EXPECT_EQ(files(), before);
}

TEST_F(Pictures, OptionsThatWouldDoNothingAreRefused) {
    make_box("box", {0, 0, 0}, {0.5, 0.5, 0.5});
    const auto before = files();
    const auto refused = [this](const std::string& file, const std::vector<std::string>& options,
                                const std::string& part) {
        std::vector<std::string> line = {"image", path("box.osem"), "-o", path(file)};
        line.insert(line.end(), options.begin(), options.end());
        return failed(osem(line), 1, part);
    };
    EXPECT_TRUE(refused("out.png", {"--lines", "outline"}, "--lines: is for --style wireframe"));
    EXPECT_TRUE(refused("out.png", {"--style", "shaded", "--lines", "leaves"}, "--lines"));
    EXPECT_TRUE(refused("out.png", {"--style", "wireframe", "--shade", "smooth"}, "--shade"));
    for (const char* name : {"out.jpg", "out", "png", "out.png.gz", "box.osem"}) {
        EXPECT_TRUE(refused(name, {}, "ends in .png")) << name;
    }
    EXPECT_EQ(files(), before);
    EXPECT_TRUE(succeeded(osem({"image", path("box.osem"), "-o", path("OUT.PNG"), "--size", "16"})));
}

} // namespace

} // namespace osem::tool_test
