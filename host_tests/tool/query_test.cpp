// osem query and osem collide, on boxes whose answers are plain to see.
#include "support.hpp"

namespace osem::tool_test {

namespace {

class Query : public Tool {
  protected:
    // The box is [0.25, 0.75)^3; at depth 3 a leaf's side is 1/8, 131072 lattice units, and no leaf is
    // boundary.
    void SetUp() override {
        Tool::SetUp();
        make_box("box", {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
    }
    Ran ask(std::vector<std::string> question) {
        question.insert(question.begin(), {"query", path("box.osem")});
        return osem(question);
    }
    std::map<std::string, std::string> answer(const std::vector<std::string>& question) {
        const Ran ran = ask(question);
        EXPECT_TRUE(succeeded(ran));
        return table(ran.out);
    }
    std::string contact(const std::string& offset) {
        const Ran ran = osem({"collide", path("box.osem"), path("box.osem"), "--offset", offset});
        EXPECT_TRUE(succeeded(ran));
        return table(ran.out)["contact"];
    }
};

TEST_F(Query, Point) {
    auto found = answer({"point", "0.3,0.5,0.74"});
    EXPECT_EQ(found["colour"], "black");
    EXPECT_EQ(found["cell"], "314572 524288 775946");
    EXPECT_EQ(found["leaf"], "262144 524288 524288 262144 black");
    EXPECT_EQ(found["visited"], "2");
    EXPECT_EQ(answer({"point", "0.75,0.5,0.5"})["colour"], "white");
    EXPECT_EQ(answer({"point", "0.25,0.25,0.25"})["colour"], "black");
    EXPECT_TRUE(failed(ask({"point", "-0.1,0,0"}), 2,
                       "the point -0.1,0,0 lies outside the root cube, which is 0,0,0,1"));
    EXPECT_TRUE(failed(ask({"point", "1e300,0,0"}), 2, "1e+300 is too far"));
    EXPECT_TRUE(failed(ask({"point", "0,0"}), 1, "X,Y,Z"));
}

TEST_F(Query, Box) {
    auto found = answer({"box", "0.3,0.3,0.3,0.7,0.7,0.7"});
    EXPECT_EQ(found["black"], "yes");
    EXPECT_EQ(found["mixed"], "no");
    EXPECT_EQ(found["low"], "314572 314572 314572");
    EXPECT_EQ(found["high"], "734004 734004 734004");
    found = answer({"box", "0,0,0,0.25,1,1"});
    EXPECT_EQ(found["touches"], "yes");
    EXPECT_EQ(found["clear"], "no");
    EXPECT_EQ(answer({"box", "0,0,0,0.2,1,1"})["clear"], "yes");
    EXPECT_TRUE(failed(ask({"box", "0,0,0,0,1,1"}), 2, "the box 0,0,0,0,1,1 holds no cell"));
    EXPECT_TRUE(failed(ask({"box", "0,0,0,2,1,1"}), 2, "the box 0,0,0,2,1,1 reaches outside the root"));
    EXPECT_TRUE(failed(ask({"box", "0,-0.1,0,1,1,1"}), 2, "the box 0,-0.1,0,1,1,1 reaches outside the root"));
}

TEST_F(Query, Ray) {
    auto found = answer({"ray", "-1,0.5,0.5", "1,0,0"});
    EXPECT_EQ(found["hit"], "yes");
    EXPECT_EQ(found["at"], "0.25,0.5,0.5");
    EXPECT_EQ(found["face"], "x");
    EXPECT_EQ(found["leaf"], "262144 524288 524288 262144 black");
    found = answer({"ray", "-1,0.5,0.5", "--to", "1,0.5,0.5"});
    EXPECT_EQ(found["t"], "1310720/2097152");
    EXPECT_EQ(answer({"ray", "-1,0.5,0.5", "--to", "0.2,0.5,0.5"})["hit"], "no");
    EXPECT_EQ(answer({"ray", "-1,0.5,0.5", "-1,0,0"})["hit"], "no");
    EXPECT_EQ(answer({"ray", "0.5,0.5,0.5", "0,0,1"})["face"], "none");

    const Ran all = ask({"ray", "0,0,0", "--to", "1,1,0.5", "--all"});
    ASSERT_TRUE(succeeded(all));
    const std::string lines = "from 0 0 0\nto 1048576 1048576 524288\n"
                              "crossing 262144/524288 0.5,0.5,0.25 z white black\n"
                              "crossing 786432/1048576 0.75,0.75,0.375 x black white\n"
                              "crossings 2\nvisited ";
    EXPECT_EQ(all.out.substr(0, lines.size()), lines);
    EXPECT_TRUE(failed(ask({"ray", "0,0,0"}), 1, "DIRECTION"));
    EXPECT_TRUE(failed(ask({"ray", "0,0,0", "1,0,0", "--to", "1,1,1"}), 1, "exclude each other"));
    EXPECT_TRUE(failed(ask({"ray", "0,0,0", "0,0,0"}), 1, "direction"));
}

TEST_F(Query, Neighbour) {
    auto found = answer({"neighbour", "0.3,0.3,0.3"});
    EXPECT_EQ(found["leaf"], "262144 262144 262144 262144 black");
    EXPECT_EQ(found["x-"], "0 262144 262144 262144 white");
    EXPECT_EQ(found["x+"], "524288 262144 262144 262144 black");
    found = answer({"neighbour", "0.1,0.1,0.1"});
    EXPECT_EQ(found["z-"], "outside");
    make_box("box", {0, 0, 0}, {0.5, 0.125, 0.125});
    const Ran ran = ask({"neighbour", "0.6,0,0", "--all"});
    ASSERT_TRUE(succeeded(ran));
    EXPECT_NE(ran.out.find("x- 0 0 0 524288 grey\n"
                           "x-leaf 393216 0 0 131072 black\n"
                           "x-leaf 393216 131072 0 131072 white\n"),
              std::string::npos)
        << ran.out;
}

TEST_F(Query, Nearest) {
    auto found = answer({"nearest", "0.5,0.5,1"});
    EXPECT_EQ(found["found"], "yes");
    EXPECT_EQ(found["distance_world"], "0.25");
    EXPECT_EQ(found["distance_squared"], "68719476736");
    EXPECT_EQ(found["leaf"], "262144 262144 524288 262144 black");
    EXPECT_EQ(answer({"nearest", "0.5,0.5,1", "--within", "0.25"})["found"], "yes");
    EXPECT_EQ(answer({"nearest", "0.5,0.5,1", "--within", "0.249"})["found"], "no");
    EXPECT_EQ(answer({"nearest", "0.5,0.5,0.5", "--colour", "white"})["distance_world"], "0.25");
    EXPECT_EQ(answer({"nearest", "0.5,0.5,0.5", "--colour", "boundary"})["found"], "no");
    EXPECT_TRUE(failed(ask({"nearest", "0,0,0", "--colour", "red"}), 1, "--colour"));
    EXPECT_EQ(ask({"nearest", "0,0,0", "--within", "-1"}).err,
              "osem: --within: expected a number that is not negative\n");
    EXPECT_TRUE(failed(ask({"nearest", "0,0,0", "--within", "far"}), 1, "--within"));
}

TEST_F(Query, Collide) {
    EXPECT_EQ(contact("0,0,0"), "certain");
    EXPECT_EQ(contact("0.49,-0.49,0.49"), "certain");
    EXPECT_EQ(contact("0.5,0,0"), "touch");
    EXPECT_EQ(contact("-0.5,0.5,-0.5"), "touch");
    EXPECT_EQ(contact("0.500001,0,0"), "clear");
    make_box("skewed", {1.3, 0.3, 0.3}, {1.7, 0.7, 0.7}, {"--depth", "3"}, "1,0,0,1");
    const Ran ran = osem({"collide", path("box.osem"), path("skewed.osem"), "--offset", "-0.6,0,0"});
    ASSERT_TRUE(succeeded(ran));
    auto found = table(ran.out);
    EXPECT_EQ(found["contact"], "possible");
    EXPECT_EQ(found["offset"], "419430 0 0");
    make_box("larger", {0, 0, 0}, {1, 1, 1}, {"--depth", "3"}, "0,0,0,2");
    EXPECT_TRUE(failed(osem({"collide", path("box.osem"), path("larger.osem")}), 2, "the cells differ"));
}

} // namespace

} // namespace osem::tool_test
