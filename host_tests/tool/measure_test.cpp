// osem measure and osem components on boxes, whose measures are products of their sides, and on the bundled
// part, whose genus is known.
#include <cmath>
#include <sstream>

#include "measure/wide.hpp"
#include "support.hpp"

namespace osem::tool_test {

namespace {

std::vector<double> numbers(const std::string& text) {
    std::istringstream stream(text);
    std::vector<double> values;
    for (double value = 0; stream >> value;) values.push_back(value);
    return values;
}

// A box's share of the integrals of 1, x, y, z, xx, yy, zz, xy, yz, zx.
std::vector<double> box_integrals(const std::vector<double>& low, const std::vector<double>& high) {
    const auto power = [&](unsigned a, int n) {
        return (std::pow(high[a], n + 1) - std::pow(low[a], n + 1)) / (n + 1);
    };
    const auto integral = [&](int x, int y, int z) { return power(0, x) * power(1, y) * power(2, z); };
    return {integral(0, 0, 0), integral(1, 0, 0), integral(0, 1, 0), integral(0, 0, 1), integral(2, 0, 0),
            integral(0, 2, 0), integral(0, 0, 2), integral(1, 1, 0), integral(0, 1, 1), integral(1, 0, 1)};
}

TEST_F(Tool, MeasureOfTwoBoxesFollowsFromTheirSides) {
    const std::vector<double> low[2] = {{0.125, 0.25, 0.5}, {0.5, 0.125, 0}};
    const std::vector<double> high[2] = {{0.375, 1, 0.75}, {0.875, 0.25, 0.25}};
    make_box("a", low[0], high[0]);
    make_box("b", low[1], high[1]);
    ASSERT_TRUE(succeeded(osem({"union", path("a.osem"), path("b.osem"), "-o", path("c.osem")})));
    const Ran ran = osem({"measure", path("c.osem")});
    ASSERT_TRUE(succeeded(ran));
    auto report = table(ran.out);
    std::vector<double> m = box_integrals(low[0], high[0]);
    const std::vector<double> other = box_integrals(low[1], high[1]);
    for (std::size_t i = 0; i < m.size(); ++i) m[i] += other[i];
    for (const std::string solid : {"inner", "outer"}) {
        EXPECT_EQ(numbers(report[solid + "_volume"]).at(0), std::ldexp(m[0], 60));
        EXPECT_EQ(numbers(report[solid + "_volume_world"]).at(0), m[0]);
        const std::vector<double> first = numbers(report[solid + "_first"]);
        const std::vector<double> second = numbers(report[solid + "_second"]);
        const std::vector<double> centroid = numbers(report[solid + "_centroid_world"]);
        const std::vector<double> inertia = numbers(report[solid + "_inertia_world"]);
        ASSERT_EQ(first.size(), 3U);
        ASSERT_EQ(second.size(), 6U);
        ASSERT_EQ(centroid.size(), 3U);
        ASSERT_EQ(inertia.size(), 6U);
        double about[6]; // products of inertia about the centroid
        for (unsigned p = 0; p < 6; ++p) {
            const unsigned a = p % 3;
            const unsigned b = p < 3 ? a : (a + 1) % 3;
            about[p] = m[4 + p] - m[1 + a] * m[1 + b] / m[0];
            EXPECT_NEAR(second[p] / std::ldexp(12 * m[4 + p], 100), 1, 1e-12);
        }
        for (unsigned a = 0; a < 3; ++a) {
            EXPECT_NEAR(first[a] / std::ldexp(2 * m[1 + a], 80), 1, 1e-12);
            EXPECT_NEAR(centroid[a], m[1 + a] / m[0], 1e-12);
            EXPECT_NEAR(inertia[a], about[(a + 1) % 3] + about[(a + 2) % 3], 1e-12);
            EXPECT_NEAR(inertia[3 + a], -about[3 + a], 1e-12);
        }
        EXPECT_EQ(report[solid + "_area_world"], "0.4375 0.3125 0.46875");
        EXPECT_EQ(report[solid + "_euler_closed"], "2");
        EXPECT_EQ(report[solid + "_pieces"], "2");
        EXPECT_EQ(report[solid + "_cavities"], "0");
        EXPECT_EQ(report[solid + "_tunnels"], "0");
    }
}

// Far from the origin and small: what cancels has cancelled in integers.
TEST_F(Tool, InertiaOfASmallBoxInACorner) {
    const double side = std::ldexp(1, -16);
    make_box("box", {1 - side, 1 - side, 1 - 2 * side}, {1, 1, 1}, {"--depth", "16"});
    const Ran ran = osem({"measure", path("box.osem")});
    ASSERT_TRUE(succeeded(ran));
    const std::vector<double> inertia = numbers(table(ran.out)["inner_inertia_world"]);
    ASSERT_EQ(inertia.size(), 6U);
    const double mass = 2 * side * side * side;
    EXPECT_DOUBLE_EQ(inertia[0], mass * 5 * side * side / 12);
    EXPECT_DOUBLE_EQ(inertia[1], mass * 5 * side * side / 12);
    EXPECT_DOUBLE_EQ(inertia[2], mass * 2 * side * side / 12);
    for (unsigned p = 3; p < 6; ++p) EXPECT_EQ(inertia[p], 0);
}

TEST_F(Tool, AnEmptySolidHasNoCentroid) {
    make_box("box", {0.01, 0.01, 0.01}, {0.02, 0.02, 0.02});
    const Ran ran = osem({"measure", path("box.osem")});
    ASSERT_TRUE(succeeded(ran));
    auto report = table(ran.out);
    EXPECT_EQ(report["inner_volume"], "0");
    EXPECT_EQ(report.count("inner_centroid_world"), 0U);
    EXPECT_EQ(report["inner_euler_closed"], "0");
    EXPECT_EQ(report["outer_centroid_world"], "0.0625 0.0625 0.0625");
}

TEST_F(Tool, TheBracketHasFourTunnels) {
    const std::string bracket = std::string(OSEM_SAMPLES_DIR) + "/bracket.poly";
    ASSERT_TRUE(succeeded(
        osem({"convert", bracket, "--frame", "0,0,0,128", "--depth", "7", "-o", path("bracket.osem")})));
    const Ran ran = osem({"measure", path("bracket.osem")});
    ASSERT_TRUE(succeeded(ran));
    auto report = table(ran.out);
    for (const std::string solid : {"inner", "outer"}) {
        EXPECT_EQ(report[solid + "_euler_closed"], "-3");
        EXPECT_EQ(report[solid + "_euler_open"], "-3");
        EXPECT_EQ(report[solid + "_tunnels"], "4");
    }
}

class ToolComponents : public Tool {
  protected:
    // A box with a cavity of one leaf.
    void make_hollow() {
        make_box("outside", {0.125, 0.125, 0.125}, {0.75, 0.75, 0.75});
        make_box("inside", {0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
        ASSERT_TRUE(succeeded(
            osem({"difference", path("outside.osem"), path("inside.osem"), "-o", path("hollow.osem")})));
    }
    std::string components(const std::string& name, const std::vector<std::string>& options = {}) {
        std::vector<std::string> arguments = {"components", path(name + ".osem")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = osem(arguments);
        EXPECT_TRUE(succeeded(ran));
        return ran.out;
    }
};

TEST_F(ToolComponents, ASealedCavityIsTold) {
    make_hollow();
    EXPECT_EQ(components("hollow").substr(0, 13), "components 1\n");
    const std::string around = components("hollow", {"--of", "void"});
    EXPECT_EQ(around.substr(0, 13), "components 2\n");
    EXPECT_NE(
        around.find("\n1 18014398509481984 0.015625 1 262144 262144 262144 524288 524288 524288 sealed\n"),
        std::string::npos)
        << around;
    EXPECT_NE(around.find(" 0 0 0 1048576 1048576 1048576 border\n"), std::string::npos) << around;
    EXPECT_EQ(table(osem({"measure", path("hollow.osem")}).out)["inner_cavities"], "1");
}

TEST_F(ToolComponents, ConnectivityAndSideAreTheCallers) {
    make_box("a", {0, 0, 0}, {0.25, 0.25, 0.25});
    make_box("b", {0.25, 0.25, 0}, {0.5, 0.5, 0.25});
    ASSERT_TRUE(succeeded(osem({"union", path("a.osem"), path("b.osem"), "-o", path("c.osem")})));
    const auto count = [&](const std::vector<std::string>& options) {
        return table(components("c", options))["components"];
    };
    EXPECT_EQ(count({}), "1");
    EXPECT_EQ(count({"--connectivity", "18"}), "1");
    EXPECT_EQ(count({"--connectivity", "6"}), "2");
    make_box("thin", {0.1, 0.1, 0.1}, {0.12, 0.12, 0.9});
    EXPECT_EQ(components("thin"), "components 0\n");
    EXPECT_EQ(components("thin", {"--inner"}), "components 0\n");
    EXPECT_EQ(table(components("thin", {"--outer"}))["components"], "1");
    EXPECT_TRUE(failed(osem({"components", path("c.osem"), "--inner", "--outer"}), 1, "--outer"));
    EXPECT_TRUE(failed(osem({"components", path("c.osem"), "--connectivity", "8"}), 1, "--connectivity"));
}

TEST(Wide, TextAndSignsOfWideIntegers) {
    using host::decimal;
    EXPECT_EQ(decimal(Wide{0, 0}), "0");
    EXPECT_EQ(decimal(Wide{1, 0}), "18446744073709551616");
    EXPECT_EQ(decimal(Wide{UINT64_MAX, UINT64_MAX}), "340282366920938463463374607431768211455");
    const Wide seven = {0, 7};
    const Wide nine = {0, 9};
    EXPECT_EQ(host::approximate(host::difference(seven, nine)), -2);
    EXPECT_EQ(host::sum(host::difference(seven, nine), nine), seven);
    EXPECT_EQ(host::product(Wide{1, UINT64_MAX}, UINT32_MAX),
              host::difference(Wide{2 * std::uint64_t{UINT32_MAX}, 0}, Wide{0, UINT32_MAX}));
    EXPECT_TRUE(host::below(Wide{1, 2}, Wide{2, 1}));
    EXPECT_FALSE(host::below(Wide{2, 1}, Wide{2, 1}));
}

} // namespace

} // namespace osem::tool_test
